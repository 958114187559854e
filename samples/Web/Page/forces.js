// The forces on the ball as arrows, and an overlay with its numbers.
const FORCE_COLOURS = { weight: "#b9c2cc", buoyancy: "#7fd6e8", drag: "#ff6b5e", magnus: "#3aa0ff", knuckle: "#c58bff", nets: "#7bd88f", load: "#ffd24a", friction: "#ff9a4d" };
// The length of an arrow: pixels per N, and at most so many. Below the least force, in N, there is no arrow.
const ARROW = 18, LONGEST_ARROW = 170, LEAST_FORCE = 0.02;
let showsForces = false;

function toggleForces() {
  showsForces = !showsForces;
  $("forces").setAttribute("aria-pressed", String(showsForces));
  dirty = true;
}

// Draws the arrows of a ball at the present time, and writes its numbers.
function showForces(flown) {
  const shown = showsForces && flown && flown.forces.length > 0;
  $("forces-shown").hidden = !shown;
  if (!shown) return;
  const at = flown.track.at(time), forces = flown.forcesAt(time);
  const acting = forces ? FORCES.map(name => ({ name, force: forces[name], size: len(forces[name]) })).filter(f => f.size > LEAST_FORCE) : [];
  acting.forEach(({ name, force }) => drawArrow(at.p, force, FORCE_COLOURS[name]));
  const last = flown.events.findLast(e => e.time <= time), motion = MOTIONS[at.motion] ?? "is pinned";
  const reynolds = len(sub(at.v, air.wind)) * 2 * flown.radius / air.viscosity;
  const line = (...parts) => { const p = document.createElement("p"); p.append(...parts); return p; };
  $("forces-shown").replaceChildren(
    line(`${len(at.v).toFixed(1)} m/s · ${len(at.spin).toFixed(0)} rad/s`), line(`Re ${(reynolds / 1e5).toFixed(2)}e5 · it ${motion}`),
    ...acting.map(({ name, size }) => {
      const mark = document.createElement("i");
      mark.style.background = FORCE_COLOURS[name];
      return line(mark, `${name} ${size.toFixed(2)} N`);
    }),
    ...(forces ? [] : [line("the step begins with impulses")]),
    ...(last ? [line(`${last.kind} ${last.surface} at ${last.time.toFixed(2)} s`)] : []));
  document.body.dataset.arrows = JSON.stringify({ time, forces: acting.map(f => f.name) });
}

function drawArrow(from, force, colour) {
  const a = camera.project(from), size = len(force), length = Math.min(LONGEST_ARROW, ARROW * size);
  const b = a && camera.project(add(from, mul(length / (a[2] * size), force)));
  if (!b) return;
  const { g } = stage, [x, y] = [b[0] - a[0], b[1] - a[1]], seen = Math.hypot(x, y);
  // An arrow that points at the camera is a dot.
  const head = Math.min(9, seen);
  const [u, v] = seen > 0 ? [x / seen, y / seen] : [0, 0];
  g.lineCap = "round";
  g.lineWidth = 3;
  g.strokeStyle = g.fillStyle = colour;
  g.beginPath();
  g.moveTo(a[0], a[1]);
  g.lineTo(b[0], b[1]);
  g.stroke();
  g.beginPath();
  g.moveTo(b[0] + head * u, b[1] + head * v);
  g.lineTo(b[0] - 0.6 * head * v, b[1] + 0.6 * head * u);
  g.lineTo(b[0] + 0.6 * head * v, b[1] - 0.6 * head * u);
  g.fill();
}
