// The pattern of a ball: twelve pentagons around the corners of an icosahedron, and the seams between them.
const GOLDEN = (1 + Math.sqrt(5)) / 2;
const CORNERS = [];
for (const a of [-1, 1]) for (const b of [-GOLDEN, GOLDEN]) CORNERS.push([0, a, b], [a, b, 0], [b, 0, a]);
const CORNER_UNITS = CORNERS.map(unit);
const PENTAGONS = [];
const SEAMS = [];
CORNERS.forEach((c, i) => {
  const near = CORNERS.map((n, j) => j).filter(j => Math.abs(len(sub(CORNERS[j], c)) - 2) < 1e-6);
  const axis = CORNER_UNITS[i];
  const u = unit(sub(CORNERS[near[0]], mul(dot(CORNERS[near[0]], axis), axis))), v = cross(axis, u);
  near.sort((j, k) => Math.atan2(dot(CORNERS[j], v), dot(CORNERS[j], u)) - Math.atan2(dot(CORNERS[k], v), dot(CORNERS[k], u)));
  PENTAGONS.push(near.map(j => unit(add(mul(2, c), CORNERS[j]))));
  near.filter(j => j > i).forEach(j => SEAMS.push([unit(add(mul(2, c), CORNERS[j])), unit(add(c, mul(2, CORNERS[j])))]));
});

// Draws a ball of a radius in pixels, turned as it is, seen by a camera.
function drawBall(g, camera, q, x, y, r, colour) {
  const seen = d => {
    const w = rotate(q, d);
    return [dot(w, camera.right), dot(w, camera.up), -dot(w, camera.forward)];
  };
  const place = c => {
    // What is behind is drawn at the rim.
    const flat = Math.hypot(c[0], c[1]) || 1;
    const s = c[2] < 0 ? 1 / flat : 1;
    return [x + r * s * c[0], y - r * s * c[1]];
  };
  const light = g.createRadialGradient(x - 0.35 * r, y - 0.4 * r, 0.1 * r, x, y, r);
  light.addColorStop(0, "#ffffff");
  light.addColorStop(0.7, "#e3e7eb");
  light.addColorStop(1, "#aab3bc");
  g.beginPath();
  g.arc(x, y, r, 0, 2 * Math.PI);
  g.fillStyle = light;
  g.fill();
  g.save();
  g.clip();
  g.fillStyle = "#22282e";
  PENTAGONS.forEach((pentagon, i) => {
    if (seen(CORNER_UNITS[i])[2] < -0.35) return;
    g.beginPath();
    pentagon.forEach((d, k) => { const p = place(seen(d)); if (k) g.lineTo(p[0], p[1]); else g.moveTo(p[0], p[1]); });
    g.fill();
  });
  if (r > 9) {
    g.strokeStyle = "#8b959f";
    g.lineWidth = Math.max(0.6, r / 40);
    for (const [a, b] of SEAMS) {
      const [ca, cb] = [seen(a), seen(b)];
      if (ca[2] < 0 && cb[2] < 0) continue;
      const [pa, pb] = [place(ca), place(cb)];
      g.beginPath();
      g.moveTo(pa[0], pa[1]);
      g.lineTo(pb[0], pb[1]);
      g.stroke();
    }
  }
  g.restore();
  g.beginPath();
  g.arc(x, y, r, 0, 2 * Math.PI);
  g.strokeStyle = colour;
  g.lineWidth = Math.max(1.4, r / 16);
  g.stroke();
}
