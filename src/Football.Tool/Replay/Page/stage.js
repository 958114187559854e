// Draws a picture at a time. What was drawn is told in the canvas' data-drawn, for whoever checks it.
const LEAST_BALL = 7;
const COLOURS = ["#0072b2", "#e07b00", "#009e73", "#c8382b", "#9b5fa8", "#56b4e9", "#b58900", "#d55e9c"];
const COLOURS_IN_THE_DARK = ["#56b4e9", "#f2a33a", "#2ec795", "#ef6a5e", "#cf98dc", "#a5dcff", "#d9b44a", "#f08cc8"];
const EVENT_COLOURS = { impact: "#ffd23f", slide: "#e07b00", roll: "#4fd1a5", rest: "#e5484d", net: "#9ad0f5", goal: "#ff5ad1", leave: "#c9a5ff" };

class Stage {
  constructor(canvas) {
    this.canvas = canvas;
    this.g = canvas.getContext("2d");
    this.camera = new Camera();
  }

  resize() {
    const scale = window.devicePixelRatio || 1;
    const [w, h] = [this.canvas.clientWidth, this.canvas.clientHeight];
    this.canvas.width = Math.round(w * scale);
    this.canvas.height = Math.round(h * scale);
    this.g.setTransform(scale, 0, 0, scale, 0, 0);
    this.camera.size(w, h);
  }

  theme() {
    const style = getComputedStyle(document.documentElement);
    this.series = style.getPropertyValue("--dark").trim() === "1" ? COLOURS_IN_THE_DARK : COLOURS;
    this.colour = {};
    for (const name of ["ink", "sky", "grass", "grass2", "marking", "frame", "net", "obstacle", "obstacle-edge", "shadow"]) {
      this.colour[name] = style.getPropertyValue("--" + name).trim();
    }
  }

  show(picture) {
    this.picture = picture;
    this.shapes = picture.shapes.map(s => ({ ...s, lines: s.lines.map(points), faces: s.faces.map(points) }));
    this.targets = points(picture.targets);
  }

  groundAt(x, z) {
    const g = this.picture.ground;
    if (!g) return 0;
    const u = clamp((x - g.x) / g.cell, 0, g.columns - 1.001), w = clamp((z - g.z) / g.cell, 0, g.rows - 1.001);
    const [i, j] = [Math.floor(u), Math.floor(w)], h = (a, b) => g.heights[b * g.columns + a];
    const [s, r] = [u - i, w - j];
    return (1 - r) * ((1 - s) * h(i, j) + s * h(i + 1, j)) + r * ((1 - s) * h(i, j + 1) + s * h(i + 1, j + 1));
  }

  // Draws all shots that are shown, at a time; hover is a place on a path under the pointer.
  draw(shots, time, hover) {
    const { g, camera } = this;
    this.drawn = { time: Math.round(time * 1e4) / 1e4, shots: shots.length, pieces: 0, balls: 0, marks: 0, faces: 0, lines: 0, ground: 0 };
    g.fillStyle = this.colour.sky;
    g.fillRect(0, 0, camera.width, camera.height);
    this.drawGround();
    this.shapes.filter(s => s.kind === "marking").forEach(s => s.lines.forEach(line => this.line(line, this.colour.marking, 0.06)));
    const balls = shots.map(shot => ({ shot, at: shot.track.at(time) }));
    shots.forEach(shot => this.drawPathShadow(shot));
    balls.forEach(ball => this.drawShadow(ball));

    // From far to near.
    const items = [];
    const item = (p, paint) => { const z = camera.see(p)[2]; if (z > NEAR) items.push({ z, paint }); };
    this.shapes.filter(s => s.kind !== "marking" && s.kind !== "guide").forEach(s => this.addShape(s, time, item));
    shots.forEach(shot => this.addPath(shot, time, item));
    balls.forEach(ball => item(ball.at.p, () => this.drawBallOf(ball)));
    items.sort((a, b) => b.z - a.z).forEach(i => i.paint());
    this.shapes.filter(s => s.kind === "guide").forEach(s => s.lines.forEach(line => this.line(line, this.series[1], 0, 2)));
    this.targets.forEach(p => this.drawTarget(p));
    shots.forEach(shot => this.drawMarks(shot, time));
    if (hover) this.ring(hover.p, this.colour.ink, 6);
    this.canvas.dataset.drawn = JSON.stringify(this.drawn);
  }

  drawGround() {
    const ground = this.picture.ground, { g, camera } = this;
    if (!ground) return;
    if (Math.max(...ground.heights) - Math.min(...ground.heights) < 1e-9) {
      this.drawLevel(ground);
      return;
    }
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
      this.trace(screen);
      g.fillStyle = Math.floor((cell.j * ground.cell + 1e-9) / Math.max(5, ground.cell)) % 2 ? this.colour.grass : this.colour.grass2;
      g.fill();
      g.strokeStyle = g.fillStyle;
      g.lineWidth = 0.8;
      g.stroke();
      // Light from the left and above.
      const n = unit(cross(sub(cell.corners[3], cell.corners[0]), sub(cell.corners[1], cell.corners[0])));
      const shade = dot(n, unit([-0.8, 1, 0.3])) - unit([-0.8, 1, 0.3])[1];
      g.fillStyle = shade > 0 ? `rgba(255,255,255,${clamp(0.9 * shade, 0, 0.5)})` : `rgba(0,0,0,${clamp(-1.2 * shade, 0, 0.6)})`;
      g.fill();
      this.drawn.ground++;
    }
  }

  // Level ground has no end; its stripes are five metres wide.
  drawLevel(ground) {
    const y = ground.heights[0], x = ground.x, middle = 10 * Math.round((ground.z + 0.5 * ground.rows * ground.cell) / 10);
    const strip = (from, to, colour) => {
      const screen = this.camera.clipped([[x - 900, y, from], [x + 900, y, from], [x + 900, y, to], [x - 900, y, to]], true);
      if (screen.length < 3) return;
      this.trace(screen);
      this.g.fillStyle = colour;
      this.g.fill();
      this.drawn.ground++;
    };
    strip(middle - 900, middle + 900, this.colour.grass2);
    for (let z = middle - 200; z < middle + 200; z += 10) strip(z, z + 5, this.colour.grass);
  }

  trace(screen) {
    this.g.beginPath();
    screen.forEach((s, i) => { if (i) this.g.lineTo(s[0], s[1]); else this.g.moveTo(s[0], s[1]); });
    this.g.closePath();
  }

  // A line through places, as wide as it is in metres but always to be seen.
  line(places, colour, width, least = 1, dash = []) {
    const screen = this.camera.clipped(places, false), { g } = this;
    if (screen.length < 2) return;
    g.beginPath();
    screen.forEach((s, i) => { if (i) g.lineTo(s[0], s[1]); else g.moveTo(s[0], s[1]); });
    g.strokeStyle = colour;
    g.lineWidth = Math.max(least, width * screen[0][2]);
    g.lineCap = "round";
    g.lineJoin = "round";
    g.setLineDash(dash);
    g.stroke();
    g.setLineDash([]);
    this.drawn.lines++;
  }

  addShape(shape, time, item) {
    const moved = p => add(p, mul(time, shape.velocity));
    const colour = this.colour[shape.kind];
    for (const line of shape.lines.map(l => l.map(moved))) {
      if (line.length === 1) {
        item(line[0], () => this.disc(line[0], shape.radius, colour));
        continue;
      }
      const parts = Math.ceil(len(sub(line[1], line[0])) / (shape.kind === "net" ? 2 : 0.8));
      for (let i = 0; i < parts; i++) {
        const piece = [lerp(line[0], line[1], i / parts), lerp(line[0], line[1], (i + 1) / parts)];
        item(lerp(piece[0], piece[1], 0.5), () => this.line(piece, colour, 2 * shape.radius, shape.kind === "net" ? 0.7 : 1.5));
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
        this.trace(screen);
        this.g.globalAlpha = shape.faces.length > 1 ? 0.9 : 0.6;
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

  addPath(shot, time, item) {
    const path = shot.track.path;
    for (let i = 0; i + 1 < path.length; i++) {
      const [a, b] = [path[i], path[i + 1]];
      const past = a.t <= time;
      item(lerp(a.p, b.p, 0.5), () => {
        const [s, e] = [this.camera.project(a.p), this.camera.project(b.p)];
        if (!s || !e) return;
        const { g } = this;
        g.globalAlpha = past ? 0.95 : 0.4;
        g.beginPath();
        g.moveTo(s[0], s[1]);
        g.lineTo(e[0], e[1]);
        g.strokeStyle = shot.colour;
        g.lineWidth = shot.compares ? 1.6 : 2.6;
        g.lineCap = "round";
        if (!shot.compares || Math.floor(a.t / 0.08) % 2 === 0) g.stroke();
        g.globalAlpha = 1;
        this.drawn.pieces++;
      });
    }
  }

  drawPathShadow(shot) {
    const places = shot.track.path.map(k => [k.p[0], this.groundAt(k.p[0], k.p[2]) + 0.01, k.p[2]]);
    if (this.picture.ground) this.line(places, this.colour.shadow, 0, 1.2);
  }

  drawShadow({ shot, at }) {
    if (!this.picture.ground) return;
    const r = Math.max(shot.radius, LEAST_BALL / Math.max(1e-9, this.camera.pixelsAt(at.p)));
    const rim = Array.from({ length: 18 }, (_, i) => {
      const [x, z] = [at.p[0] + r * Math.cos(i * Math.PI / 9), at.p[2] + r * Math.sin(i * Math.PI / 9)];
      return [x, this.groundAt(x, z) + 0.01, z];
    });
    const screen = this.camera.clipped(rim, true);
    if (screen.length < 3) return;
    this.trace(screen);
    this.g.fillStyle = this.colour.shadow;
    this.g.fill();
  }

  drawBallOf({ shot, at }) {
    const s = this.camera.project(at.p);
    if (!s) return;
    const r = Math.max(LEAST_BALL, shot.radius * s[2]);
    drawBall(this.g, this.camera, at.q, s[0], s[1], r, shot.colour);
    this.drawn.balls++;
  }

  // Whole seconds along a path, and what happened on it.
  drawMarks(shot, time) {
    const { g } = this;
    g.font = "600 11px system-ui, sans-serif";
    g.textAlign = "center";
    let last = null;
    for (let t = 1; t < shot.track.end && !shot.compares; t++) {
      const s = this.camera.project(shot.track.at(t).p);
      if (!s || (last && Math.hypot(s[0] - last[0], s[1] - last[1]) < 34)) continue;
      last = s;
      this.dot(s, 2.4, shot.colour, this.colour.sky);
      g.strokeStyle = this.colour.sky;
      g.lineWidth = 3;
      g.strokeText(t + " s", s[0], s[1] - 8);
      g.fillStyle = this.colour.ink;
      g.fillText(t + " s", s[0], s[1] - 8);
    }
    for (const happened of shot.events) {
      const s = this.camera.project(happened.position);
      if (!s) continue;
      g.globalAlpha = happened.time <= time ? 1 : 0.5;
      this.dot(s, happened.kind === "goal" ? 6 : 4, EVENT_COLOURS[happened.kind], shot.colour);
      g.globalAlpha = 1;
      this.drawn.marks++;
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
    const s = this.camera.project(p), { g } = this;
    if (!s) return;
    g.strokeStyle = "#ff5ad1";
    g.lineWidth = 2;
    for (const r of [4, 8]) { g.beginPath(); g.arc(s[0], s[1], r, 0, 2 * Math.PI); g.stroke(); }
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
