// Live examples. Before the first click, a page shows the path that C# recorded. The first click loads the library: live-runtime.js, the npm package in one file.
const LiveExamples = (function () {
  const SAMPLES = 121, TIME_STEP = 0.01;

  // Returns the description with the values of its sliders.
  function described(example, values) {
    const changed = JSON.parse(JSON.stringify(example));
    example.sliders.forEach((slider, i) => {
      if (values[i] === undefined || values[i] === null) return;
      const path = slider.path.split("."), last = path.pop();
      path.reduce((at, name) => at[name], changed)[last] = values[i] / (slider.divide || 1);
    });
    return changed;
  }

  // Returns the present value of a slider in its own unit.
  function valueOf(example, slider) {
    return slider.path.split(".").reduce((at, name) => at[name], example) * (slider.divide || 1);
  }

  // Runs an example: the path as rows t, x, y, z, and the results by name. LiveRun.cs computes the same in C#.
  function run(physics, example) {
    const scene = physics.scene(example.scene || {}), ball = scene.ball(), numbers = {};
    try {
      if (example.aim) {
        const aim = scene.aim(example.aim);
        ball.launch(example.aim.from, aim.velocity, aim.spin);
        Object.assign(numbers, { status: aim.status, elevation: aim.elevation, azimuth: aim.azimuth, topSpin: aim.topSpin, sideSpin: aim.sideSpin, arrives: aim.time });
      } else {
        ball.place(example.from || [0, scene.radius, 0]);
        if (example.kick) ball.kick(example.kick);
      }
      const rows = ball.lookAhead(example.seconds, SAMPLES, { timeStep: TIME_STEP, stopAt: example.stop }), events = ball.lookAheadEvents();
      const last = 4 * (SAMPLES - 1), along = (x, z) => Math.sqrt((x - rows[1]) * (x - rows[1]) + (z - rows[3]) * (z - rows[3]));
      const ground = events.filter(e => e.kind === "impact" && e.name === "ground"), others = events.filter(e => e.kind === "impact" && e.name !== "ground");
      const landing = ground[0], goal = events.find(e => e.kind === "goal");
      let apex = rows[2], rise = null;
      for (let i = 0; i < rows.length; i += 4) {
        apex = Math.max(apex, rows[i + 2]);
        if (landing && rows[i] > landing.time) rise = Math.max(rise === null ? rows[i + 2] : rise, rows[i + 2]);
      }
      const v = landing && landing.velocityBefore;
      Object.assign(numbers, {
        apex, rise, bounces: ground.length, end: along(rows[last + 1], rows[last + 3]), time: rows[last],
        carry: landing ? along(landing.position[0], landing.position[2]) : null, hang: landing ? landing.time : null, bend: landing ? rows[1] - landing.position[0] : null,
        speed: landing ? Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) : null,
        goal: goal ? goal.time : "no", hits: others.length === 0 ? "nothing" : [...new Set(others.map(e => e.name))].join(", "),
      });
      if (example.keeper) {
        const answer = ball.keeper(example.keeper);
        Object.assign(numbers, { saved: answer.saves ? "yes" : "no", latest: answer.latestReaction });
      }
      return { rows: Array.from(rows), shown: example.show.map(name => [name, numbers[name]]) };
    } finally {
      ball.free();
      scene.free();
    }
  }

  return { described, valueOf, run };
})();

if (typeof document !== "undefined") (function () {
  const NAMES = {
    apex: ["greatest height", "m"], carry: ["first bounce after", "m"], hang: ["in the air", "s"], bend: ["to the left", "m"], speed: ["speed at the first bounce", "m/s"], rise: ["height after the bounce", "m"],
    bounces: ["bounces", ""], end: ["distance at the end", "m"], time: ["ends after", "s"], goal: ["goal", "s"], hits: ["hits", ""], status: ["status", ""], elevation: ["elevation", "°"], azimuth: ["azimuth", "°"],
    topSpin: ["topspin", "rad/s"], sideSpin: ["sidespin", "rad/s"], arrives: ["arrives after", "s"], saved: ["saved", ""], latest: ["dives by", "s"],
  };
  const text = (name, value) => value === null || value === undefined ? "–" : typeof value === "string" ? value : name === "bounces" ? String(value) : `${value.toFixed(2)} ${NAMES[name][1]}`.trim();
  const still = matchMedia("(prefers-reduced-motion: reduce)");

  // Loads the library once for all examples of the page.
  let loading = null;
  function physics() {
    return loading ??= new Promise((done, failed) => {
      const script = document.createElement("script");
      script.src = "live-runtime.js";
      script.onload = done;
      script.onerror = () => failed(new Error("live-runtime.js is missing."));
      document.head.append(script);
    }).then(async () => {
      const files = {};
      await Promise.all(Object.entries(LIVE_RUNTIME).map(async ([name, packed]) => {
        const letters = atob(packed), bytes = new Uint8Array(letters.length);
        for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
        files[name] = await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
      }));
      const { load } = await import(URL.createObjectURL(new Blob([files["index.js"]], { type: "text/javascript" })));
      return load({ files });
    }).catch(error => { loading = null; throw error; });
  }

  class Live {
    constructor(figure) {
      const data = JSON.parse(figure.querySelector("script").textContent);
      Object.assign(this, { figure, example: data.example, rows: data.rows, recorded: data.rows, canvas: figure.querySelector("canvas"), numbers: figure.querySelector("dl"), hint: figure.querySelector(".hint"), begin: 0 });
      this.sliders = [...figure.querySelectorAll("input")];
      for (const slider of this.sliders) {
        slider.addEventListener("input", () => this.change());
        slider.addEventListener("pointerdown", () => this.start());
      }
      this.canvas.addEventListener("click", () => this.change());
      this.label();
      this.draw(0);
    }

    label() { this.sliders.forEach(slider => { slider.previousElementSibling.textContent = `${Number(slider.value)} ${slider.dataset.unit}`.trim(); }); }

    start() {
      if (this.physics || this.waits) return this.waits;
      this.hint.textContent = "Loading the library…";
      return this.waits = physics().then(loaded => {
        this.physics = loaded;
        this.hint.textContent = "Computed in this page.";
        this.figure.dataset.loaded = "yes";
      }).catch(error => { this.hint.textContent = `The library does not run here: ${error.message}`; this.waits = null; });
    }

    async change() {
      this.label();
      await this.start();
      if (!this.physics) return;
      const values = this.sliders.map(slider => Number(slider.value));
      try {
        const { rows, shown } = LiveExamples.run(this.physics, LiveExamples.described(this.example, values));
        this.rows = rows;
        this.hint.textContent = "Computed in this page.";
        this.numbers.replaceChildren(...shown.map(([name, value]) => {
          const pair = document.createElement("div"), term = document.createElement("dt"), data = document.createElement("dd");
          term.textContent = NAMES[name][0];
          data.textContent = text(name, value);
          data.value = value;
          pair.append(term, data);
          return pair;
        }));
        this.figure.dataset.shown = JSON.stringify(shown);
      } catch (error) {
        this.hint.textContent = error.message;
      }
      this.begin = performance.now();
      if (still.matches) this.draw(Infinity);
    }

    // A row as a point of the plot.
    seen(rows, i) { return this.example.view === "side" ? [-rows[i + 3], rows[i + 2]] : this.example.view === "time" ? [rows[i], rows[i + 2]] : [-rows[i + 3], -rows[i + 1]]; }

    draw(seconds) {
      const { canvas, rows, recorded } = this, ratio = devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
      if (width === 0) return;
      if (canvas.width !== Math.round(width * ratio)) { canvas.width = Math.round(width * ratio); canvas.height = Math.round(height * ratio); }
      const pen = canvas.getContext("2d"), style = getComputedStyle(document.documentElement), colour = name => style.getPropertyValue(name).trim();
      pen.setTransform(ratio, 0, 0, ratio, 0, 0);
      pen.clearRect(0, 0, width, height);
      let [left, right, low, high] = [0, 1, this.example.view === "above" ? -1 : 0, 1];
      const fit = ([x, y]) => { left = Math.min(left, x); right = Math.max(right, x); low = Math.min(low, y); high = Math.max(high, y); };
      for (const of of [rows, recorded]) for (let i = 0; i < of.length; i += 4) fit(this.seen(of, i));
      const goals = (this.example.scene || {}).goals || [], walls = (this.example.scene || {}).obstacles || [], isAbove = this.example.view === "above";
      for (const goal of goals) fit(isAbove ? [-goal.center[2], 4] : [-goal.center[2], 2.6]), fit([-goal.center[2] + 1, isAbove ? -4 : 0]);
      const pad = 26, across = (width - 2 * pad) / (right - left), up = (height - 2 * pad) / (high - low);
      const scaleX = this.example.view === "time" ? across : Math.min(across, up), scaleY = this.example.view === "time" ? up : scaleX;
      const base = isAbove ? height / 2 + (high + low) / 2 * scaleY : height - pad + low * scaleY;
      const at = ([x, y]) => [pad + (x - left) * scaleX, base - y * scaleY];
      const line = (points, ink, thick, dash = []) => {
        pen.beginPath();
        points.forEach((p, i) => pen[i === 0 ? "moveTo" : "lineTo"](...at(p)));
        Object.assign(pen, { strokeStyle: ink, lineWidth: thick, lineJoin: "round" });
        pen.setLineDash(dash);
        pen.stroke();
        pen.setLineDash([]);
      };
      line([[left, 0], [right, 0]], colour("--edge"), 1);
      pen.fillStyle = colour("--faint");
      pen.font = "11px system-ui, sans-serif";
      const tick = [0.5, 1, 2, 5, 10, 20, 50, 100].find(t => t * scaleX > 56) || 200;
      for (let x = Math.ceil(left / tick) * tick; x <= right; x += tick) {
        const [px, py] = at([x, isAbove ? low : 0]);
        pen.fillText(`${x} ${this.example.view === "time" ? "s" : "m"}`, px, Math.min(height - 6, py + 16));
      }
      for (const goal of goals) line(isAbove ? [[-goal.center[2], -3.66], [-goal.center[2], 3.66]] : [[-goal.center[2], 0], [-goal.center[2], 2.44]], colour("--ink"), 4);
      for (const wall of walls) {
        const [x, y, z] = wall.center, [a, b, c] = wall.halfSize;
        line(isAbove ? [[-z - c, -x - a], [-z - c, -x + a], [-z + c, -x + a], [-z + c, -x - a], [-z - c, -x - a]] : [[-z - c, y - b], [-z - c, y + b], [-z + c, y + b], [-z + c, y - b]], colour("--faint"), 2);
      }
      if (rows !== recorded) line(recorded.filter((_, i) => i % 4 === 0).map((_, i) => this.seen(recorded, 4 * i)), colour("--faint"), 1.2, [4, 4]);
      const points = rows.filter((_, i) => i % 4 === 0).map((_, i) => this.seen(rows, 4 * i));
      line(points, colour("--link"), 2);
      let i = 0;
      while (i < points.length - 1 && rows[4 * (i + 1)] < seconds) i++;
      const next = Math.min(i + 1, points.length - 1), gap = rows[4 * next] - rows[4 * i], share = gap > 0 ? Math.min(1, Math.max(0, (seconds - rows[4 * i]) / gap)) : 0;
      const [x, y] = at([0, 1].map(k => points[i][k] + share * (points[next][k] - points[i][k])));
      pen.beginPath();
      pen.arc(x, y, 5, 0, 2 * Math.PI);
      pen.fillStyle = colour("--page");
      pen.fill();
      Object.assign(pen, { strokeStyle: colour("--ink"), lineWidth: 2 });
      pen.stroke();
      this.figure.dataset.time = Math.min(seconds, rows[rows.length - 4]).toFixed(2);
    }

    // Long paths move faster than in reality, so that a round takes at most six seconds.
    frame(now) {
      const length = this.rows[this.rows.length - 4], pace = Math.max(1, length / 6), round = length / pace + 1;
      this.draw(Math.min(length, ((now - this.begin) / 1000 % round) * pace));
    }
  }

  const lives = [...document.querySelectorAll("figure.live")].map(figure => new Live(figure)), seen = new Set();
  const watch = new IntersectionObserver(entries => {
    for (const entry of entries) {
      const live = lives.find(one => one.figure === entry.target);
      if (entry.isIntersecting) seen.add(live); else seen.delete(live);
      if (still.matches && entry.isIntersecting) live.draw(Infinity);
    }
    if (seen.size > 0 && !still.matches) requestAnimationFrame(move);
  });
  let moving = false;
  function move() {
    if (moving) return;
    moving = true;
    requestAnimationFrame(function next(now) {
      for (const live of seen) live.frame(now);
      if (seen.size > 0) requestAnimationFrame(next); else moving = false;
    });
  }
  lives.forEach(live => watch.observe(live.figure));
})();
