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

// Draws a ball with the given radius in pixels and orientation. A coloured rim distinguishes the balls.
function drawBall(g, camera, q, x, y, r, colour) {
  const seen = d => {
    const w = rotate(q, d);
    return [dot(w, camera.right), dot(w, camera.up), -dot(w, camera.forward)];
  };
  const place = c => {
    // Points on the far side are drawn at the rim.
    const flat = Math.hypot(c[0], c[1]) || 1;
    const s = c[2] < 0 ? 1 / flat : 1;
    return [x + r * s * c[0], y - r * s * c[1]];
  };
  if (colour) {
    g.beginPath();
    g.arc(x, y, r + Math.max(1.2, r / 9), 0, 2 * Math.PI);
    g.fillStyle = colour;
    g.fill();
  }
  g.beginPath();
  g.arc(x, y, r, 0, 2 * Math.PI);
  g.fillStyle = "#fbfcfd";
  g.fill();
  g.save();
  g.clip();
  g.fillStyle = "#1b2027";
  PENTAGONS.forEach((pentagon, i) => {
    if (seen(CORNER_UNITS[i])[2] < -0.35) return;
    g.beginPath();
    pentagon.forEach((d, k) => { const p = place(seen(d)); if (k) g.lineTo(p[0], p[1]); else g.moveTo(p[0], p[1]); });
    g.fill();
  });
  if (r > 9) {
    g.strokeStyle = "#7d8791";
    g.lineWidth = Math.max(0.6, r / 40);
    g.beginPath();
    for (const [a, b] of SEAMS) {
      const [ca, cb] = [seen(a), seen(b)];
      if (ca[2] < 0 && cb[2] < 0) continue;
      const [pa, pb] = [place(ca), place(cb)];
      g.moveTo(pa[0], pa[1]);
      g.lineTo(pb[0], pb[1]);
    }
    g.stroke();
  }
  const light = g.createRadialGradient(x - 0.38 * r, y - 0.45 * r, 0.05 * r, x, y, 1.05 * r);
  light.addColorStop(0, "rgba(255,255,255,0.55)");
  light.addColorStop(0.35, "rgba(255,255,255,0)");
  light.addColorStop(0.72, "rgba(20,30,45,0.12)");
  light.addColorStop(1, "rgba(15,20,35,0.5)");
  g.fillStyle = light;
  g.fillRect(x - r, y - r, 2 * r, 2 * r);
  g.restore();
}

// Squashes what is drawn next around a point of the picture. The outline of an ellipsoid is an ellipse along the axis as it is seen.
function squash(g, camera, { along, across, axis }, x, y) {
  const right = dot(axis, camera.right), up = dot(axis, camera.up), seen = right * right + up * up, turn = Math.atan2(-up, right);
  g.translate(x, y);
  g.rotate(turn);
  g.scale(Math.sqrt(along * along * seen + across * across * (1 - seen)), across);
  g.rotate(-turn);
  g.translate(-x, -y);
}
