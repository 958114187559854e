// Draws a picture at a time. For tests, the canvas attribute data-drawn lists the drawn items.
const LEAST_BALL = 5;
const COLOURS = ["#0072b2", "#e07b00", "#009e73", "#c8382b", "#9b5fa8", "#56b4e9", "#b58900", "#d55e9c"];
const COLOURS_IN_THE_DARK = ["#56b4e9", "#f2a33a", "#2ec795", "#ef6a5e", "#cf98dc", "#a5dcff", "#d9b44a", "#f08cc8"];
const EVENT_COLOURS = { impact: "#ffd23f", slide: "#e07b00", roll: "#4fd1a5", rest: "#e5484d", net: "#9ad0f5", goal: "#ff5ad1", leave: "#c9a5ff" };
// The width of a bulge of a net, and of the meshes, in m.
const BULGE_WIDTH = 0.75, MESH = 0.24;

class Stage {
  constructor(canvas) {
    this.canvas = canvas;
    this.g = canvas.getContext("2d");
    this.camera = new Camera();
    this.back = document.createElement("canvas");
    this.backKey = "";
    this.figures = [];
    this.ahead = [];
    this.bulges = new Map();
  }

  resize() {
    const scale = Math.min(2, window.devicePixelRatio || 1);
    const [w, h] = [this.canvas.clientWidth, this.canvas.clientHeight];
    for (const canvas of [this.canvas, this.back]) {
      canvas.width = Math.round(w * scale);
      canvas.height = Math.round(h * scale);
      canvas.getContext("2d").setTransform(scale, 0, 0, scale, 0, 0);
    }
    this.backKey = "";
    this.camera.size(w, h);
  }

  theme() {
    const style = getComputedStyle(document.documentElement);
    this.dark = style.getPropertyValue("--dark").trim() === "1";
    this.series = this.dark ? COLOURS_IN_THE_DARK : COLOURS;
    this.colour = {};
    for (const name of ["ink", "sky", "marking", "frame", "frame-shade", "net", "obstacle", "obstacle-edge", "shadow"]) {
      this.colour[name] = style.getPropertyValue("--" + name).trim();
    }
    this.backKey = "";
  }

  show(picture) {
    this.picture = picture;
    this.shapes = picture.shapes.map(s => ({ ...s, lines: s.lines.map(points), faces: s.faces.map(points) }));
    this.nets = this.shapes.filter(s => s.kind === "net").flatMap(s => s.faces.map(face => new NetSheet(face)));
    // A moving person moves until he meets the ball.
    const met = name => Math.min(Infinity, ...(picture.shots || []).flatMap(shot => shot.events).filter(e => e.kind === "impact" && e.surface === name).map(e => e.time));
    this.people = this.shapes.filter(s => s.kind === "people").flatMap((s, i) => s.lines.map((l, j) => ({ limbs: limbsOf(l[0], l[1], l[2], l[3], s.name, i + j), feet: l[0], velocity: s.velocity, until: met(s.name) })));
    this.targets = points(picture.targets || []);
    this.stadium = new Stadium(this.level ? picture.goals : null);
    this.camera.groundAt = (x, z) => this.groundAt(x, z);
    this.backKey = "";
  }

  get level() {
    const g = this.picture.ground;
    return !!g && Math.max(...g.heights) - Math.min(...g.heights) < 1e-9;
  }

  groundAt(x, z) {
    const g = this.picture.ground;
    if (!g) return 0;
    const u = clamp((x - g.x) / g.cell, 0, g.columns - 1.001), w = clamp((z - g.z) / g.cell, 0, g.rows - 1.001);
    const [i, j] = [Math.floor(u), Math.floor(w)], h = (a, b) => g.heights[b * g.columns + a];
    const [s, r] = [u - i, w - j];
    return (1 - r) * ((1 - s) * h(i, j) + s * h(i + 1, j)) + r * ((1 - s) * h(i, j + 1) + s * h(i + 1, j + 1));
  }

  // Draws all visible shots at a time; hover is the point of a path under the pointer.
  draw(shots, time, hover) {
    const { camera } = this;
    this.paintBack();
    this.drawn = { time: Math.round(time * 1e4) / 1e4, shots: shots.length, pieces: 0, balls: 0, marks: 0, faces: 0, figures: 0, lines: this.backDrawn.lines, ground: this.backDrawn.ground };
    this.g.drawImage(this.back, 0, 0, camera.width, camera.height);
    const balls = shots.map(shot => ({ shot, at: shot.track.at(time) }));
    const people = [...this.people.map(p => movedTo(p, time)), ...this.figures];
    shots.forEach(shot => this.drawPathShadow(shot));
    people.forEach(p => this.blob(p.feet, 0.42, 0.34, this.groundAt(p.feet[0], p.feet[2])));
    balls.forEach(ball => this.drawShadow(ball));

    // Paint from far to near.
    const items = [];
    const item = (p, paint) => { const z = camera.see(p)[2]; if (z > NEAR) items.push({ z, paint }); };
    this.shapes.filter(s => s.kind === "frame" || s.kind === "obstacle").forEach(s => this.addShape(s, time, item));
    this.nets.forEach((net, i) => item(net.middle, () => this.drawn.lines += net.paint(this.g, camera, this.bulges.get(i), this.colour.net)));
    people.forEach(p => item(add(p.feet, [0, 0.9, 0]), () => { paintFigure(this.g, camera, p.limbs, this.dark ? "rgba(4,10,30,0.22)" : null); this.drawn.figures++; }));
    shots.forEach(shot => { this.addPath(shot, time, item); this.addMarks(shot, time, item); });
    this.ahead.forEach((dot, i) => item(dot.p, () => this.drawAhead(dot, i)));
    balls.forEach(ball => item(ball.at.p, () => this.drawBallOf(ball)));
    items.sort((a, b) => b.z - a.z).forEach(i => i.paint());
    this.shapes.filter(s => s.kind === "guide").forEach(s => s.lines.forEach(line => this.drawn.lines += this.line(this.g, line, this.series[1], 0, 2)));
    this.targets.forEach(p => this.drawTarget(p));
    if (hover) this.ring(hover.p, this.colour.ink, 6);
    const seen = balls.length > 0 && camera.project(balls[0].at.p);
    this.drawn.ball = seen ? seen.slice(0, 2).map(Math.round) : null;
    this.drawn.eye = Math.round(1000 * (camera.eye[1] - this.groundAt(camera.eye[0], camera.eye[2]))) / 1000;
    this.drawn.bulges = this.bulges.size;
    this.canvas.dataset.drawn = JSON.stringify(this.drawn);
  }

  // Repaint the static objects only if the camera has moved.
  paintBack() {
    const key = this.camera.key;
    if (key === this.backKey) return;
    this.backKey = key;
    this.backDrawn = { lines: 0, ground: 0 };
    const g = this.back.getContext("2d");
    this.stadium.paint(g, this.camera, this.dark);
    if (this.level) this.stadium.grass(g, this.camera, this.dark, this.picture.ground.heights[0], this.backDrawn);
    else if (this.picture.ground) this.uneven(g, this.picture.ground);
    this.shapes.filter(s => s.kind === "marking").forEach(s => s.lines.forEach(line => this.backDrawn.lines += this.marking(g, line)));
  }

  uneven(g, ground) {
    const { camera } = this, look = this.dark ? NIGHT : LIGHT;
    const cells = [];
    const at = (i, j) => [ground.x + i * ground.cell, ground.heights[j * ground.columns + i], ground.z + j * ground.cell];
    for (let j = 0; j + 1 < ground.rows; j++) {
      for (let i = 0; i + 1 < ground.columns; i++) {
        const corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        cells.push({ corners, z: len(sub(lerp(corners[0], corners[2], 0.5), camera.eye)), i, j });
      }
    }
    cells.sort((a, b) => b.z - a.z);
    for (const cell of cells) {
      const screen = camera.clipped(cell.corners, true);
      if (screen.length < 3) continue;
      trace(g, screen);
      g.fillStyle = Math.floor((cell.j * ground.cell + 1e-9) / Math.max(5, ground.cell)) % 2 ? look.grass : look.grass2;
      g.fill();
      g.strokeStyle = g.fillStyle;
      g.lineWidth = 0.8;
      g.stroke();
      // The light comes from the upper left.
      const n = unit(cross(sub(cell.corners[3], cell.corners[0]), sub(cell.corners[1], cell.corners[0])));
      const shade = dot(n, unit([-0.8, 1, 0.3])) - unit([-0.8, 1, 0.3])[1];
      g.fillStyle = shade > 0 ? `rgba(255,255,255,${clamp(0.9 * shade, 0, 0.5)})` : `rgba(0,0,0,${clamp(-1.2 * shade, 0, 0.6)})`;
      g.fill();
      this.backDrawn.ground++;
    }
  }

  // Draws a line through points with a width in metres and a minimum width in pixels; returns the number of lines drawn.
  line(g, places, colour, width, least = 1) {
    const screen = this.camera.clipped(places, false);
    if (screen.length < 2) return 0;
    g.beginPath();
    screen.forEach((s, i) => { if (i) g.lineTo(s[0], s[1]); else g.moveTo(s[0], s[1]); });
    g.strokeStyle = colour;
    g.lineWidth = Math.max(least, Math.min(14, width * screen[0][2]));
    g.lineCap = "round";
    g.lineJoin = "round";
    g.stroke();
    return 1;
  }

  // Draws a line on the grass in perspective; it is twelve centimetres wide.
  marking(g, line) {
    const half = line.map((p, i) => {
      const along = sub(line[Math.min(i + 1, line.length - 1)], line[Math.max(i - 1, 0)]), flat = Math.hypot(along[0], along[2]) || 1;
      return [0.06 * along[2] / flat, 0, -0.06 * along[0] / flat];
    });
    g.fillStyle = this.colour.marking;
    g.strokeStyle = this.colour.marking;
    g.lineWidth = 0.7;
    for (let i = 0; i + 1 < line.length; i++) {
      const screen = this.camera.clipped([add(line[i], half[i]), add(line[i + 1], half[i + 1]), sub(line[i + 1], half[i + 1]), sub(line[i], half[i])], true);
      if (screen.length < 3) continue;
      trace(g, screen);
      g.fill();
      g.stroke();
    }
    return 1;
  }

  addShape(shape, time, item) {
    const moved = p => add(p, mul(time, shape.velocity));
    const colour = this.colour[shape.kind];
    for (const line of shape.lines.map(l => l.map(moved))) {
      if (line.length === 1) {
        item(line[0], () => this.disc(line[0], shape.radius, colour));
        continue;
      }
      const parts = Math.ceil(len(sub(line[1], line[0])) / 1.3);
      for (let i = 0; i < parts; i++) {
        const [a, b] = [lerp(line[0], line[1], i / parts), lerp(line[0], line[1], (i + 1) / parts)];
        item(lerp(a, b, 0.5), () => this.rod(a, b, shape.radius, colour, i === 0, i === parts - 1));
      }
    }
    for (const face of shape.faces.map(f => f.map(moved))) {
      const normal = cross(sub(face[1], face[0]), sub(face[2], face[1]));
      const middle = mul(1 / face.length, face.reduce(add));
      const away = dot(normal, sub(this.camera.eye, middle)) < 0;
      if (away && shape.faces.length > 1) continue;
      item(middle, () => {
        const screen = this.camera.clipped(face, true);
        if (screen.length < 3) return;
        trace(this.g, screen);
        this.g.globalAlpha = shape.faces.length > 1 ? 0.95 : 0.6;
        this.g.fillStyle = colour;
        this.g.fill();
        const light = dot(unit(normal), unit([-0.4, 0.8, 0.5]));
        this.g.fillStyle = light > 0 ? `rgba(255,255,255,${0.35 * light})` : `rgba(0,0,0,${-0.35 * light})`;
        this.g.fill();
        this.g.globalAlpha = 1;
        this.g.strokeStyle = this.colour["obstacle-edge"];
        this.g.lineWidth = 1;
        this.g.stroke();
        this.drawn.faces++;
      });
    }
  }

  // Draws a round rod, lit from the upper left. Its ends are round, and its joints seamless.
  rod(from, to, radius, colour, begins, ends) {
    const [a, b] = [this.camera.project(from), this.camera.project(to)];
    if (!a || !b) return;
    const { g } = this, [ra, rb] = [Math.max(0.9, radius * a[2]), Math.max(0.9, radius * b[2])];
    const d = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
    // The direction across the rod on the screen, towards the light.
    let [x, y] = [(a[1] - b[1]) / d, (b[0] - a[0]) / d];
    if (-0.5 * x - y < 0) [x, y] = [-x, -y];
    const across = g.createLinearGradient(a[0] + ra * x, a[1] + ra * y, a[0] - ra * x, a[1] - ra * y);
    across.addColorStop(0, colour);
    across.addColorStop(0.55, colour);
    across.addColorStop(1, this.colour["frame-shade"]);
    g.fillStyle = across;
    // Extend each part by a pixel, so that no gap is visible between two parts.
    const [u, v] = [(b[0] - a[0]) / d * 0.6, (b[1] - a[1]) / d * 0.6];
    trace(g, [[a[0] + ra * x - u, a[1] + ra * y - v], [b[0] + rb * x + u, b[1] + rb * y + v], [b[0] - rb * x + u, b[1] - rb * y + v], [a[0] - ra * x - u, a[1] - ra * y - v]]);
    g.fill();
    for (const [end, r, on] of [[a, ra, begins], [b, rb, ends]]) {
      if (!on) continue;
      g.beginPath();
      g.arc(end[0], end[1], r, 0, 2 * Math.PI);
      g.fill();
    }
    this.drawn.faces++;
  }

  addPath(shot, time, item) {
    const path = shot.track.path;
    for (let i = 0; i + 1 < path.length; i++) {
      const [a, b] = [path[i], path[i + 1]];
      const past = a.t <= time;
      if (!past && shot.unfolds) break;
      item(lerp(a.p, b.p, 0.5), () => {
        const [s, e] = [this.camera.project(a.p), this.camera.project(b.p)];
        if (!s || !e || (shot.compares && Math.floor(a.t / 0.08) % 2)) return;
        const { g } = this;
        g.globalAlpha = past ? 0.95 : 0.45;
        g.beginPath();
        g.moveTo(s[0], s[1]);
        g.lineTo(e[0], e[1]);
        g.strokeStyle = shot.colour;
        g.lineWidth = clamp(0.05 * s[2], shot.compares ? 1.6 : 2.4, shot.compares ? 3 : 5);
        g.lineCap = shot.compares ? "butt" : "round";
        g.stroke();
        g.globalAlpha = 1;
        this.drawn.pieces++;
      });
    }
  }

  // Draws the path ahead as dots that become fainter.
  drawAhead(dot, i) {
    const s = this.camera.project(dot.p);
    if (!s) return;
    const { g } = this;
    g.globalAlpha = clamp(1 - dot.t / (dot.until || 2.2), 0.15, 1);
    g.beginPath();
    g.arc(s[0], s[1], clamp(0.075 * s[2], 1.7, 6), 0, 2 * Math.PI);
    g.fillStyle = dot.colour || "#fff36b";
    g.fill();
    g.globalAlpha = 1;
    this.drawn.ahead = i + 1;
  }

  drawPathShadow(shot) {
    if (!this.picture.ground) return;
    const places = shot.track.path.filter(k => !shot.unfolds || k.t <= this.drawn.time).map(k => [k.p[0], this.groundAt(k.p[0], k.p[2]) + 0.01, k.p[2]]);
    this.g.globalAlpha = 0.5;
    this.drawn.lines += this.line(this.g, places, this.colour.shadow, 0, 1.4);
    this.g.globalAlpha = 1;
  }

  // Draws a soft round shadow on the ground.
  blob(p, radius, strength, ground) {
    if (!this.picture.ground) return;
    const { g } = this;
    for (const [size, alpha] of [[1.25, 0.35], [1, 0.4], [0.7, 0.45]]) {
      const rim = Array.from({ length: 16 }, (_, i) => [p[0] + size * radius * Math.cos(i * Math.PI / 8), ground + 0.01, p[2] + size * radius * Math.sin(i * Math.PI / 8)]);
      const screen = this.camera.clipped(rim, true);
      if (screen.length < 3) continue;
      trace(g, screen);
      g.globalAlpha = alpha * strength;
      g.fillStyle = "#06120a";
      g.fill();
    }
    g.globalAlpha = 1;
  }

  // Draws the shadow below the ball, which shows its height: the higher the ball, the wider and fainter the shadow. A plumb line joins both.
  drawShadow({ shot, at }) {
    if (!this.picture.ground) return;
    const ground = this.groundAt(at.p[0], at.p[2]), height = Math.max(0, at.p[1] - ground - shot.radius);
    const least = LEAST_BALL / Math.max(1e-9, this.camera.pixelsAt(at.p));
    this.blob(at.p, Math.max(shot.radius, least) * (1.15 + 0.16 * height), 1.5 / (1 + 0.22 * height), ground);
    if (height < 0.5) return;
    const [a, b] = [this.camera.project([at.p[0], ground, at.p[2]]), this.camera.project(at.p)];
    if (!a || !b) return;
    this.g.beginPath();
    this.g.moveTo(a[0], a[1]);
    this.g.lineTo(b[0], b[1]);
    this.g.setLineDash([2, 5]);
    this.g.strokeStyle = "rgba(255,255,255,0.5)";
    this.g.lineWidth = 1;
    this.g.stroke();
    this.g.setLineDash([]);
  }

  drawBallOf({ shot, at }) {
    const s = this.camera.project(at.p);
    if (!s) return;
    const flat = shot.squashAt?.(at.t);
    this.g.save();
    if (flat) squash(this.g, this.camera, flat, s[0], s[1]);
    drawBall(this.g, this.camera, at.q, s[0], s[1], Math.max(LEAST_BALL, shot.radius * s[2]), shot.colour);
    this.g.restore();
    if (flat) this.drawn.squash = Math.min(this.drawn.squash ?? 1, Math.round(1e3 * flat.along) / 1e3);
    this.drawn.balls++;
  }

  // Adds the whole seconds and the events of a path. Nearer objects hide them.
  addMarks(shot, time, item) {
    if (shot.plain) return;
    const { g } = this;
    let last = null;
    for (let t = 1; t < shot.track.end && !shot.compares; t++) {
      const p = shot.track.at(t).p, s = this.camera.project(p);
      if (!s || (last && Math.hypot(s[0] - last[0], s[1] - last[1]) < 34)) continue;
      last = s;
      item(p, () => {
        this.dot(s, 2.6, "#ffffff", shot.colour);
        g.font = "600 11px system-ui, sans-serif";
        g.textAlign = "center";
        g.strokeStyle = this.dark ? "#0a1420" : "#ffffff";
        g.lineWidth = 3;
        g.strokeText(t + " s", s[0], s[1] - 8);
        g.fillStyle = this.colour.ink;
        g.fillText(t + " s", s[0], s[1] - 8);
      });
    }
    for (const happened of shot.events) {
      const s = this.camera.project(happened.position);
      if (!s) continue;
      item(happened.position, () => {
        g.globalAlpha = happened.time <= time ? 1 : 0.5;
        this.dot(s, happened.kind === "goal" ? 6 : 4, EVENT_COLOURS[happened.kind], shot.colour);
        g.globalAlpha = 1;
        this.drawn.marks++;
      });
    }
  }

  dot(s, r, fill, stroke) {
    const { g } = this;
    g.beginPath();
    g.arc(s[0], s[1], r, 0, 2 * Math.PI);
    g.fillStyle = fill;
    g.fill();
    g.strokeStyle = stroke;
    g.lineWidth = 1.5;
    g.stroke();
  }

  disc(p, radius, colour) {
    const s = this.camera.project(p);
    if (!s) return;
    const { g } = this, r = Math.max(1, radius * s[2]);
    const light = g.createRadialGradient(s[0] - 0.3 * r, s[1] - 0.4 * r, 0.1 * r, s[0], s[1], r);
    light.addColorStop(0, "#ffffff");
    light.addColorStop(0.4, colour);
    light.addColorStop(1, this.colour["obstacle-edge"]);
    this.dot(s, r, light, this.colour["obstacle-edge"]);
    this.drawn.faces++;
  }

  drawTarget(p) {
    for (const r of [4, 8]) this.ring(p, "#ff5ad1", r);
  }

  ring(p, colour, r) {
    const s = this.camera.project(p);
    if (!s) return;
    this.g.beginPath();
    this.g.arc(s[0], s[1], r, 0, 2 * Math.PI);
    this.g.strokeStyle = colour;
    this.g.lineWidth = 2;
    this.g.stroke();
  }
}

// Returns a person at a time.
function movedTo(person, time) {
  if (person.velocity.every(x => x === 0)) return person;
  const way = mul(Math.min(time, person.until), person.velocity);
  return { ...person, feet: add(person.feet, way), limbs: person.limbs.map(l => ({ ...l, from: add(l.from, way), to: add(l.to, way) })) };
}

// A net between four corners. Its columns divide the side from the first to the second corner, its rows that from the first to the fourth.
class NetSheet {
  constructor([a, b, c, d]) {
    this.middle = mul(0.25, [a, b, c, d].reduce(add));
    this.columns = clamp(Math.ceil(len(sub(b, a)) / MESH), 2, 60);
    this.rows = clamp(Math.ceil(len(sub(d, a)) / MESH), 2, 40);
    this.nodes = [];
    for (let j = 0; j <= this.rows; j++) {
      for (let i = 0; i <= this.columns; i++) this.nodes.push(lerp(lerp(a, b, i / this.columns), lerp(d, c, i / this.columns), j / this.rows));
    }
  }

  // Paints the net with an optional bulge { depth, position, direction }.
  paint(g, camera, bulge, colour) {
    const base = bulge && sub(bulge.position, mul(bulge.depth, bulge.direction));
    const seen = this.nodes.map(p => {
      if (!bulge) return camera.project(p);
      const d = sub(p, base), far = (dot(d, d) - dot(d, bulge.direction) ** 2) / (BULGE_WIDTH * BULGE_WIDTH);
      return camera.project(far > 9 ? p : add(p, mul(bulge.depth * Math.exp(-far), bulge.direction)));
    });
    g.beginPath();
    const join = (from, step, count) => {
      let on = false;
      for (let k = 0, n = from; k <= count; k++, n += step) {
        const s = seen[n];
        if (s && on) g.lineTo(s[0], s[1]); else if (s) g.moveTo(s[0], s[1]);
        on = !!s;
      }
    };
    for (let j = 0; j <= this.rows; j++) join(j * (this.columns + 1), 1, this.columns);
    for (let i = 0; i <= this.columns; i++) join(i, this.columns + 1, this.rows);
    const near = camera.project(this.middle);
    g.strokeStyle = colour;
    g.lineWidth = clamp(near ? 0.016 * near[2] : 0.7, 0.55, 1.6);
    g.stroke();
    return this.rows + this.columns + 2;
  }
}
