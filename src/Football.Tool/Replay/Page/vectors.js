// Vectors are [x, y, z], rotations [x, y, z, w].
const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const mul = (s, a) => [s * a[0], s * a[1], s * a[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const len = a => Math.hypot(a[0], a[1], a[2]);
const unit = a => { const l = len(a); return l > 0 ? mul(1 / l, a) : [0, 1, 0]; };
const lerp = (a, b, s) => a.map((x, i) => x + s * (b[i] - x));
const clamp = (x, low, high) => Math.max(low, Math.min(high, x));

const rotate = (q, v) => {
  const u = [q[0], q[1], q[2]];
  const t = mul(2, cross(u, v));
  return add(add(v, mul(q[3], t)), cross(u, t));
};

const slerp = (a, b, s) => {
  let c = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const sign = c < 0 ? -1 : 1;
  c = Math.min(1, Math.abs(c));
  const angle = Math.acos(c);
  const [u, v] = angle < 1e-4 ? [1 - s, s] : [Math.sin((1 - s) * angle) / Math.sin(angle), Math.sin(s * angle) / Math.sin(angle)];
  return a.map((x, i) => u * x + sign * v * b[i]);
};

// Returns the points of a flat list of numbers, three per point.
const points = flat => {
  const all = [];
  for (let i = 0; i < flat.length; i += 3) all.push([flat[i], flat[i + 1], flat[i + 2]]);
  return all;
};
