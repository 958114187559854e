// Static objects: sky, stands, boards, grass and its lines. They are painted once per camera position, then copied.
const LIGHT = {
  skies: ["#5aa5df", "#a9d3f0", "#e6f3fb"], bank: "#4a5566", roof: "#37404d", board: "#16324f", board2: "#0f5c8c", boardText: "#f4f8fb", haze: "rgba(230,243,251,",
  grass: "#64a64a", grass2: "#549139", outside: "#477d32", line: "rgba(255,255,255,0.88)", dusk: "rgba(10,30,5,",
  faces: ["#d9ac86", "#a8754f", "#e6c3a1", "#7a5138"],
  crowd: ["#aeb8c4", "#9a4a50", "#4a6c9c", "#b59a5c", "#3a4350", "#7d8997", "#c9ced4", "#5e6b7a"],
};
const NIGHT = {
  skies: ["#03060d", "#0a1428", "#182a4a"], bank: "#161d2a", roof: "#0b1018", board: "#0c2138", board2: "#0b3c5d", boardText: "#cfe6f7", haze: "rgba(24,42,74,",
  grass: "#33743a", grass2: "#29612f", outside: "#1d4524", line: "rgba(235,245,235,0.8)", dusk: "rgba(0,4,12,",
  faces: ["#6a5546", "#4a382c", "#7b6452", "#34281f"],
  crowd: ["#3c4655", "#4a2a33", "#233a5c", "#4f4630", "#141a24", "#2d3643", "#525d6c", "#1f2733"],
};
const HALF_WIDTH = 34, LENGTH = 105, STRIPE = 5.5;

class Stadium {
  // The goals determine the position of the pitch. Without goals, there is only a meadow.
  constructor(goals) {
    this.goal = goals && goals.length > 0 ? goals[0] : null;
    if (!this.goal) return;
    const out = unit(this.goal.facing), right = cross([0, 1, 0], out);
    this.at = (across, along, height = 0) => add(this.goal.center, add(add(mul(across, right), mul(along, out)), [0, height, 0]));
  }

  paint(g, camera, dark) {
    const look = dark ? NIGHT : LIGHT;
    const horizon = this.horizon(camera);
    const sky = g.createLinearGradient(0, Math.min(0, horizon - camera.height), 0, Math.max(1, horizon));
    look.skies.forEach((c, i) => sky.addColorStop(i / (look.skies.length - 1), c));
    g.fillStyle = sky;
    g.fillRect(0, 0, camera.width, camera.height);
    if (this.goal) this.stands(g, camera, look, dark); else this.hills(g, camera, look, horizon);
  }

  horizon(camera) {
    const level = unit([camera.forward[0], 0, camera.forward[2]]);
    const c = [0, dot(level, camera.up), dot(level, camera.forward)];
    return c[2] > 1e-3 ? camera.screen(c)[1] : -camera.height;
  }

  hills(g, camera, look, horizon) {
    g.fillStyle = look.outside;
    g.beginPath();
    g.moveTo(0, horizon + 2);
    for (let x = 0; x <= camera.width; x += 8) {
      const a = x / camera.focus + camera.yaw * -1;
      g.lineTo(x, horizon - camera.focus * (0.02 + 0.012 * Math.sin(7 * a) + 0.008 * Math.sin(17 * a + 1)));
    }
    g.lineTo(camera.width, horizon + 2);
    g.fill();
  }

  // Level grass in stripes across the pitch, lighter towards the horizon.
  grass(g, camera, dark, height, drawn) {
    const look = dark ? NIGHT : LIGHT;
    const quad = (corners, colour) => {
      const screen = camera.clipped(corners, true);
      if (screen.length < 3) return;
      trace(g, screen);
      g.fillStyle = colour;
      g.fill();
      drawn.ground++;
    };
    const far = 900;
    const [x, z] = this.goal ? [this.goal.center[0], this.goal.center[2]] : [camera.target[0], camera.target[2]];
    quad([[x - far, height, z - far], [x - far, height, z + far], [x + far, height, z + far], [x + far, height, z - far]], look.outside);
    if (this.goal) {
      const side = HALF_WIDTH + 3.6;
      quad([this.at(-side, -3.6), this.at(-side, LENGTH + 3.6), this.at(side, LENGTH + 3.6), this.at(side, -3.6)], look.grass2);
      for (let b = 0; b < LENGTH; b += 2 * STRIPE) quad([this.at(-side, b), this.at(-side, b + STRIPE), this.at(side, b + STRIPE), this.at(side, b)], look.grass);
    } else {
      const middle = 2 * STRIPE * Math.round(z / (2 * STRIPE));
      quad([[x - far, height, middle - 120], [x - far, height, middle + 120], [x + far, height, middle + 120], [x + far, height, middle - 120]], look.grass2);
      for (let b = middle - 120; b < middle + 120; b += 2 * STRIPE) quad([[x - far, height, b], [x - far, height, b + STRIPE], [x + far, height, b + STRIPE], [x + far, height, b]], look.grass);
    }
    const horizon = clamp(this.horizon(camera), 0, camera.height);
    const shade = g.createLinearGradient(0, horizon, 0, camera.height);
    shade.addColorStop(0, look.haze + "0.3)");
    shade.addColorStop(0.3, look.haze + "0)");
    shade.addColorStop(0.7, look.dusk + "0)");
    shade.addColorStop(1, look.dusk + "0.22)");
    g.fillStyle = shade;
    g.fillRect(0, horizon, camera.width, camera.height - horizon);
    if (this.goal) this.boards(g, camera, look);
  }

  // Returns the stands; those seen from behind are omitted.
  sides(camera) {
    const inside = p => dot(sub(camera.eye, p[0]), p[1]) > 0;
    const [w, l] = [HALF_WIDTH + 4, LENGTH + 4];
    const inward = (across, along) => sub(this.at(across, along), this.at(0, 0));
    return [
      { from: [-w, -4], to: [w, -4], step: [0, -1], into: inward(0, 1) },
      { from: [-w, l], to: [-w, -4], step: [-1, 0], into: inward(1, 0) },
      { from: [w, -4], to: [w, l], step: [1, 0], into: inward(-1, 0) },
      { from: [w, l], to: [-w, l], step: [0, 1], into: inward(0, -1) },
    ].filter(s => inside([this.at(...s.from), s.into])).sort((a, b) => this.distance(camera, b) - this.distance(camera, a));
  }

  distance(camera, side) {
    return len(sub(camera.eye, lerp(this.at(...side.from), this.at(...side.to), 0.5)));
  }

  stands(g, camera, look, dark) {
    for (const side of this.sides(camera)) {
      const place = (share, out, height) => this.at(
        side.from[0] + share * (side.to[0] - side.from[0]) + out * side.step[0], side.from[1] + share * (side.to[1] - side.from[1]) + out * side.step[1], height);
      const quad = (a, b, c, d, colour) => { const s = camera.clipped([a, b, c, d], true); if (s.length > 2) { trace(g, s); g.fillStyle = colour; g.fill(); } };
      const rows = 26, depth = i => 2 + 0.85 * i, height = i => 1.15 + 0.52 * i;
      quad(place(-0.06, depth(0), 0), place(1.06, depth(0), 0), place(1.06, depth(rows), height(rows)), place(-0.06, depth(rows), height(rows)), look.bank);
      for (let i = rows - 1; i >= 0; i--) this.row(g, camera, look, i, (share, up) => place(share, depth(i), height(i) + up));
      this.shade(g, camera, place(0.5, depth(0), height(0)), place(0.5, depth(rows), height(rows)), [place(-0.06, depth(0), 0), place(1.06, depth(0), 0), place(1.06, depth(rows), height(rows)), place(-0.06, depth(rows), height(rows))]);
      quad(place(-0.06, depth(rows), height(rows)), place(1.06, depth(rows), height(rows)), place(1.06, depth(rows), height(rows) + 4), place(-0.06, depth(rows), height(rows) + 4), look.roof);
      quad(place(-0.06, depth(rows), height(rows) + 4), place(1.06, depth(rows), height(rows) + 4), place(1.06, depth(rows - 12), height(rows) + 5.6), place(-0.06, depth(rows - 12), height(rows) + 5.6), look.roof);
      if (dark) this.lamps(g, camera, share => place(share, depth(rows - 12), height(rows) + 5.6));
    }
  }

  // The deeper a row is under the roof, the darker it is.
  shade(g, camera, front, back, corners) {
    const [a, b, screen] = [camera.project(front), camera.project(back), camera.clipped(corners, true)];
    if (!a || !b || screen.length < 3) return;
    const dusk = g.createLinearGradient(0, a[1], 0, b[1]);
    dusk.addColorStop(0, "rgba(8,14,26,0.05)");
    dusk.addColorStop(0.55, "rgba(8,14,26,0.25)");
    dusk.addColorStop(1, "rgba(8,14,26,0.7)");
    trace(g, screen);
    g.fillStyle = dusk;
    g.fill();
  }

  // Paints a row of spectators: dashes as wide as a seat, in several colours and with different offsets.
  row(g, camera, look, i, at) {
    const parts = 10;
    for (let k = 0; k < parts; k++) {
      const line = camera.clipped([at(k / parts, 0.45), at((k + 1) / parts, 0.45)], false);
      if (line.length < 2) continue;
      const scale = Math.max(line[0][2], line[1][2]);
      if (line.every(p => p[0] < -50) || line.every(p => p[0] > camera.width + 50) || line.every(p => p[1] < -50)) continue;
      // Paint the shoulders, then the heads above them.
      for (let c = 0; c < 5; c++) {
        const tone = (i * 7 + k * 3 + c * 5) % look.crowd.length, seat = 0.5 * scale, phase = (c * 2.3 + (i * 53 + k * 29) % 17) * seat;
        const gaps = [(1.6 + (i * 31 + k * 17 + c * 13) % 7 * 0.6) * seat, (2.6 + (i * 5 + c * 11 + k) % 5 * 0.8) * seat];
        const dash = (part, shift, lift, width, colour) => {
          g.beginPath();
          g.moveTo(line[0][0], line[0][1] - lift * scale);
          g.lineTo(line[1][0], line[1][1] - lift * scale);
          g.setLineDash([part * seat, gaps[0] + (1 - part) * seat, part * seat, gaps[1] + (1 - part) * seat]);
          g.lineDashOffset = phase - shift * seat;
          g.strokeStyle = colour;
          g.lineWidth = Math.max(0.6, width * scale);
          g.stroke();
        };
        dash(0.86, 0, 0, 0.46, look.crowd[tone]);
        if (scale > 6) dash(0.4, 0.23, 0.34, 0.24, look.faces[(i + c) % look.faces.length]);
      }
    }
    g.setLineDash([]);
  }

  lamps(g, camera, at) {
    for (let i = 1; i < 8; i++) {
      const s = camera.project(at(i / 8));
      if (!s) continue;
      const r = Math.min(90, 6 * s[2]);
      const glow = g.createRadialGradient(s[0], s[1], 0, s[0], s[1], r);
      glow.addColorStop(0, "rgba(255,252,235,0.95)");
      glow.addColorStop(0.12, "rgba(255,250,225,0.55)");
      glow.addColorStop(1, "rgba(180,210,255,0)");
      g.fillStyle = glow;
      g.fillRect(s[0] - r, s[1] - r, 2 * r, 2 * r);
    }
  }

  // Paints boards around the pitch. Their texts are drawn in perspective, panel by panel.
  boards(g, camera, look) {
    const words = ["FOOTBALL.PHYSICS", "SAME BITS EVERYWHERE", "KICK IT", "0 DEPENDENCIES"];
    for (const side of this.sides(camera)) {
      const length = Math.hypot(side.to[0] - side.from[0], side.to[1] - side.from[1]), panels = Math.round(length / 7.6);
      for (let i = 0; i < panels; i++) {
        const place = (share, height) => this.at(side.from[0] + share * (side.to[0] - side.from[0]), side.from[1] + share * (side.to[1] - side.from[1]), height);
        const [a, b] = [i / panels, (i + 1) / panels];
        const screen = camera.clipped([place(a, 0), place(b, 0), place(b, 0.95), place(a, 0.95)], true);
        if (screen.length < 3) continue;
        trace(g, screen);
        g.fillStyle = i % 2 ? look.board2 : look.board;
        g.fill();
        const [p, q, r] = [camera.project(place(a, 0.95)), camera.project(place(b, 0.95)), camera.project(place(a, 0))];
        if (!p || !q || !r || Math.abs(q[0] - p[0]) < 24) continue;
        g.save();
        g.clip();
        const flip = q[0] < p[0], [l, m, n] = flip ? [q, p, camera.project(place(b, 0))] : [p, q, r];
        g.transform((m[0] - l[0]) / 100, (m[1] - l[1]) / 100, (n[0] - l[0]) / 12.5, (n[1] - l[1]) / 12.5, l[0], l[1]);
        g.font = "800 7.6px system-ui, sans-serif";
        g.textAlign = "center";
        g.textBaseline = "middle";
        g.fillStyle = look.boardText;
        g.fillText(words[i % words.length], 50, 6.6, 92);
        g.restore();
      }
    }
  }
}

function trace(g, screen) {
  g.beginPath();
  screen.forEach((s, i) => { if (i) g.lineTo(s[0], s[1]); else g.moveTo(s[0], s[1]); });
  g.closePath();
}
