// People: limbs with two radii, placed relative to feet, shoulders and hands. figures.json defines the limbs.
const FIGURES = JSON.parse(document.getElementById("figures").textContent);

// Returns the limbs of a person. facing is a horizontal direction, kit a name in figures.json, and who a number that selects colours.
function limbsOf(feet, shoulders, hands, facing, kit, who = 0) {
  const colours = FIGURES.kits[kit], up = unit(sub(shoulders, feet)), right = unit(cross(up, facing)), front = cross(right, up);
  const at = c => [0, 1, 2].map(i => c[0] * feet[i] + c[1] * shoulders[i] + c[2] * hands[i] + c[3] * right[i] + c[4] * front[i] + c[5] * up[i]);
  const picked = part => { const c = colours[part] || colours.skin; return Array.isArray(c) ? c[who % c.length] : c; };
  return FIGURES.limbs.map(limb => ({ from: at(limb.from), to: at(limb.to), r: limb.r, colour: picked(limb.part) }));
}

// Paints limbs from far to near. Each is the hull of two discs, lit from the upper left.
function paintFigure(g, camera, limbs, dim) {
  const seen = limbs.map(limb => ({ limb, a: camera.project(limb.from), b: camera.project(limb.to), z: camera.see(limb.from)[2] + camera.see(limb.to)[2] }))
    .filter(s => s.a && s.b).sort((a, b) => b.z - a.z);
  for (const { limb, a, b } of seen) {
    const [ra, rb] = [limb.r[0] * a[2], limb.r[1] * b[2]];
    hull(g, a, ra, b, rb);
    g.fillStyle = limb.colour;
    g.fill();
    if (Math.max(ra, rb) < 1.6) continue;
    g.fillStyle = "rgba(0,0,0,0.2)";
    g.fill();
    hull(g, [a[0] - 0.16 * ra, a[1] - 0.14 * ra], 0.84 * ra, [b[0] - 0.16 * rb, b[1] - 0.14 * rb], 0.84 * rb);
    g.fillStyle = limb.colour;
    g.fill();
    hull(g, [a[0] - 0.34 * ra, a[1] - 0.3 * ra], 0.42 * ra, [b[0] - 0.34 * rb, b[1] - 0.3 * rb], 0.42 * rb);
    g.fillStyle = "rgba(255,255,255,0.16)";
    g.fill();
  }
  if (!dim) return;
  for (const { limb, a, b } of seen) {
    hull(g, a, limb.r[0] * a[2], b, limb.r[1] * b[2]);
    g.fillStyle = dim;
    g.fill();
  }
}

// Traces the outline around two discs.
function hull(g, a, ra, b, rb) {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]], d = Math.hypot(dx, dy);
  g.beginPath();
  if (d <= Math.abs(ra - rb) + 1e-6) {
    const [c, r] = ra > rb ? [a, ra] : [b, rb];
    g.arc(c[0], c[1], r, 0, 2 * Math.PI);
    return;
  }
  const along = Math.atan2(dy, dx), half = Math.acos(clamp((ra - rb) / d, -1, 1));
  g.arc(a[0], a[1], ra, along + half, along - half);
  g.arc(b[0], b[1], rb, along - half, along + half);
  g.closePath();
}
