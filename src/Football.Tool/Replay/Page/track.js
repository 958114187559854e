// The path of a ball: keys with time, position, velocity before and after, spin, orientation and motion.
const WIDTH = 18;
const MOTIONS = ["flies", "slides", "rolls", "rests"];

class Track {
  // Creates a track from rows of numbers, or from keys.
  constructor({ keys }) {
    this.keys = typeof keys[0] === "number" ? Track.unrolled(keys) : keys;
    this.end = this.keys[this.keys.length - 1].t;
    this.path = this.sampled();
  }

  static unrolled(k) {
    const keys = [];
    for (let i = 0; i < k.length; i += WIDTH) {
      keys.push({
        t: k[i], p: k.slice(i + 1, i + 4), before: k.slice(i + 4, i + 7), v: k.slice(i + 7, i + 10),
        spin: k.slice(i + 10, i + 13), q: k.slice(i + 13, i + 17), motion: k[i + 17],
      });
    }
    return keys;
  }

  index(t) {
    let low = 0, high = this.keys.length - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.keys[middle].t <= t) low = middle; else high = middle;
    }
    return low;
  }

  // Returns the ball at a time: the cubic through positions and velocities, and the shorter rotation between orientations.
  at(t) {
    const i = this.index(t), a = this.keys[i], b = this.keys[Math.min(i + 1, this.keys.length - 1)];
    const h = b.t - a.t;
    if (!(h > 0) || t >= this.end) return { t: Math.min(t, this.end), p: b.p, v: b.v, spin: b.spin, q: b.q, motion: b.motion };
    const s = clamp((t - a.t) / h, 0, 1), r = 1 - s;
    const p = [0, 1, 2].map(j =>
      r * r * (1 + 2 * s) * a.p[j] + s * s * (1 + 2 * r) * b.p[j] + h * s * r * (r * a.v[j] - s * b.before[j]));
    return { t, p, v: lerp(a.v, b.before, s), spin: lerp(a.spin, b.spin, s), q: slerp(a.q, b.q, s), motion: a.motion };
  }

  // Returns points for drawing: at short time intervals, and at every key where the velocity jumps.
  sampled() {
    const path = [];
    for (let i = 0; i + 1 < this.keys.length; i++) {
      const a = this.keys[i], b = this.keys[i + 1];
      const jumps = a.before.some((x, j) => x !== a.v[j]);
      if (!jumps && path.length > 0 && a.t - path[path.length - 1].t < 0.035) continue;
      const parts = Math.max(1, Math.ceil((b.t - a.t) / 0.04));
      for (let j = 0; j < parts; j++) path.push(this.at(a.t + (j / parts) * (b.t - a.t)));
    }
    path.push(this.at(this.end));
    return path;
  }
}

// The movements of nets: for each net its bulges in order of time, from rows of time, net, depth, position and direction.
const NET_ROW = 9;

class NetTrack {
  constructor(rows) {
    this.nets = new Map();
    this.take(rows);
  }

  take(rows) {
    for (let i = 0; i < rows.length; i += NET_ROW) {
      const bulge = { t: rows[i], depth: rows[i + 2], position: rows.slice(i + 3, i + 6), direction: rows.slice(i + 6, i + 9) };
      if (this.nets.has(rows[i + 1])) this.nets.get(rows[i + 1]).push(bulge); else this.nets.set(rows[i + 1], [bulge]);
    }
  }

  // Writes the bulges at a time to a map by net, if they are deeper than those in the map.
  at(t, into) {
    for (const [net, all] of this.nets) {
      const next = all.findIndex(b => b.t > t);
      if (next === 0) continue;
      const a = all[next < 0 ? all.length - 1 : next - 1], b = next < 0 ? a : all[next], s = b.t > a.t ? (t - a.t) / (b.t - a.t) : 0;
      const depth = a.depth + s * (b.depth - a.depth);
      if (depth > 0.004 && depth > (into.get(net)?.depth ?? 0)) into.set(net, b.depth > 0.004 ? { depth, position: lerp(a.position, b.position, s), direction: b.direction } : { ...a, depth });
    }
  }
}
