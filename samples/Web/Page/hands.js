// The user's input: pulls back and releases the ball, drags the small ball, moves sliders, presses keys.

// ---- pulling back

function ballOnScreen() { return camera.project([0, radius, 0]); }

function drawPull() {
  const s = ballOnScreen(), { g } = stage;
  if (!s) return;
  if (pull) {
    const [x, y] = pull.now;
    g.lineCap = "round";
    g.strokeStyle = "rgba(255,255,255,0.9)";
    g.lineWidth = 3;
    g.beginPath();
    g.moveTo(s[0], s[1]);
    g.lineTo(s[0] + x, s[1] + y);
    g.stroke();
    const share = (set.speed - LEAST_SPEED) / (MOST_SPEED - LEAST_SPEED);
    g.beginPath();
    g.arc(s[0] + x, s[1] + y, 9, 0, 2 * Math.PI);
    g.fillStyle = `hsl(${120 - 120 * clamp(share, 0, 1)}, 90%, 50%)`;
    g.fill();
    g.stroke();
    // Write next to the handle, on the side away from the line.
    const text = `${(3.6 * set.speed).toFixed(0)} km/h`, left = x < 0;
    g.font = "700 16px system-ui, sans-serif";
    g.textAlign = left ? "right" : "left";
    g.strokeStyle = "rgba(0,0,0,0.55)";
    g.lineWidth = 4;
    const at = [clamp(s[0] + x + (left ? -18 : 18), left ? 84 : 8, camera.width - (left ? 8 : 84)), s[1] + y + 5];
    g.strokeText(text, ...at);
    g.fillStyle = "#fff";
    g.fillText(text, ...at);
  } else {
    const r = Math.max(16, 2.1 * radius * s[2]);
    g.beginPath();
    g.arc(s[0], s[1], r + 3 * Math.sin(performance.now() / 300), 0, 2 * Math.PI);
    g.strokeStyle = "rgba(255,255,255,0.75)";
    g.lineWidth = 2;
    g.setLineDash([5, 5]);
    g.stroke();
    g.setLineDash([]);
  }
}

// Sets the kick from a pull. A pull straight back kicks straight ahead, as the camera looks. A pull to the side turns the kick, at a full pull by the width of the goal.
function pulled(x, y) {
  // Let a full pull end above the panels at the bottom of the page.
  const room = floor() - ballOnScreen()[1] - 14;
  const full = Math.max(60, Math.min(FULL_PULL * Math.min(camera.height, camera.width * 1.5), room)), length = Math.hypot(x, y);
  pull.now = length > full ? [x * full / length, y * full / length] : [x, y];
  const share = clamp(length / full, 0, 1), goal = stage.picture.goals[0].center;
  set.speed = Math.round(10 * (LEAST_SPEED + share * (MOST_SPEED - LEAST_SPEED))) / 10;
  const straight = Math.atan2(-goal[0], -goal[2]) * DEGREES;
  set.azimuth = clamp(Math.round(10 * (straight + 26 * clamp(x / full, -1, 1))) / 10, -40, 40);
  fill();
  lookAhead();
}

// Returns the upper edge of the panels at the bottom of the page.
function floor() {
  const folded = $("fold").getAttribute("aria-expanded") === "false";
  return Math.min(...[$("bar"), ...(camera.width <= 720 && folded ? [$("panel")] : [])].map(e => e.getBoundingClientRect().top));
}

// Returns the point of the goal's plane under a pixel; null if it is not near the goal.
function inGoal(x, y) {
  if (!stage.picture) return null;
  const goal = stage.picture.goals[0].center, p = camera.onPlane(x, y, goal[2]);
  return p && Math.abs(p[0] - goal[0]) < 5.5 && p[1] > 0 && p[1] < 4 ? [p[0], Math.max(p[1], radius)] : null;
}

const canvas = $("stage");
let pressed = null;
canvas.addEventListener("pointerdown", e => {
  document.body.classList.remove("keys");
  canvas.focus();
  if (e.isPrimary === false) return;
  touch = e.pointerType === "touch";
  canvas.setPointerCapture(e.pointerId);
  // Use the camera that the user sees: ready() may move it.
  const goal = inGoal(e.clientX, e.clientY);
  if (flights.length > 0 && !playing) { ready(); }
  const s = flights.length === 0 && ballOnScreen();
  pressed = { x: e.clientX, y: e.clientY, id: e.pointerId, goal, pull: s && Math.hypot(s[0] - e.clientX, s[1] - e.clientY) < Math.max(44, 3 * radius * s[2]) };
});
canvas.addEventListener("pointermove", e => {
  if (!pressed || e.pointerId !== pressed.id) return;
  const [x, y] = [e.clientX - pressed.x, e.clientY - pressed.y];
  if (pressed.pull) {
    if (!pull && Math.hypot(x, y) < 8) return;
    pull = pull || { now: [0, 0] };
    stage.targets = [];
    hint(touch ? "Let go to kick." : "Let go to kick; the wheel or ↑ ↓ change the height.");
    pulled(x, y);
  } else {
    camera.yaw -= 0.005 * (e.clientX - (pressed.px ?? pressed.x));
    camera.pitch = clamp(camera.pitch + 0.004 * (e.clientY - (pressed.py ?? pressed.y)), 0.01, 1.5);
    [pressed.px, pressed.py] = [e.clientX, e.clientY];
    if (Math.hypot(x, y) > 6) pressed.dragged = true;
    if (pressed.dragged) { camera.update(); dirty = true; }
  }
});
canvas.addEventListener("pointerup", e => {
  if (!pressed || e.pointerId !== pressed.id) return;
  const was = pressed;
  pressed = null;
  if (pull) {
    const strong = Math.hypot(...pull.now) > 14;
    pull = null;
    if (strong) kickOne(); else lookAhead();
  } else if (was.pull) {
    kickOne();
  } else if (!was.dragged && was.goal) {
    aimAt(was.goal);
  }
  dirty = true;
});
canvas.addEventListener("pointercancel", () => { pressed = pull = null; dirty = true; });
canvas.addEventListener("wheel", e => { e.preventDefault(); change("elevation", e.deltaY < 0 ? 0.5 : -0.5); }, { passive: false });

// ---- the small ball: the point that the foot hits

function drawStrike() {
  const c = $("strike").firstElementChild, g = c.getContext("2d");
  g.setTransform(2, 0, 0, 2, 0, 0);
  g.clearRect(0, 0, 92, 92);
  drawBall(g, { right: [1, 0, 0], up: [0, 1, 0], forward: [0, 0, -1] }, [0.18, 0.12, 0.03, 0.975], 46, 46, 42, "");
  const [x, y] = [46 + 36 * set.side / 90, 46 - 36 * set.top / 70];
  g.strokeStyle = "rgba(227,34,50,0.5)";
  g.lineWidth = 1;
  g.beginPath();
  g.moveTo(46, 8); g.lineTo(46, 84); g.moveTo(8, 46); g.lineTo(84, 46);
  g.stroke();
  g.beginPath();
  g.arc(x, y, 7, 0, 2 * Math.PI);
  g.fillStyle = "#e32232";
  g.fill();
  g.strokeStyle = "#fff";
  g.lineWidth = 2;
  g.stroke();
}

// A hit on the right side makes the ball bend to the left; a hit below the centre gives it backspin.
const strike = e => {
  const box = $("strike").getBoundingClientRect(), x = (e.clientX - box.left - 46) / 36, y = (46 - (e.clientY - box.top)) / 36;
  const d = Math.max(1, Math.hypot(x, y));
  set.side = Math.round(90 * x / d);
  set.top = Math.round(70 * y / d);
  changed();
};
$("strike").addEventListener("pointerdown", e => { $("strike").setPointerCapture(e.pointerId); strike(e); });
$("strike").addEventListener("pointermove", e => { if (e.buttons) strike(e); });

// ---- fields, buttons, keys

function changed(name) {
  stage.targets = [];
  if (flights.length > 0) { ready(); return; }
  fill();
  if (engine) lookAhead();
  dirty = true;
}

function change(name, by) {
  const field = $("panel").elements[name];
  set[name] = clamp(Math.round(10 * (set[name] + by)) / 10, Number(field.min), Number(field.max));
  changed();
}

$("panel").addEventListener("input", e => {
  const { name, value } = e.target;
  if (!(name in set)) return;
  set[name] = typeof DEFAULTS[name] === "number" ? Number(value) : value;
  if (KICK.includes(name)) changed();
  else if (engine) { if (DIALS.includes(name) && playing && flights.length <= 2) turn(); else scene(); }
});
$("spots").addEventListener("click", e => {
  if (!e.target.dataset.spot) return;
  const [distance, aside, wall, speed, elevation, azimuth, side, top] = e.target.dataset.spot.split(",").map(Number);
  Object.assign(set, { distance, aside, wall, speed, elevation, azimuth, side, top });
  scene();
});
$("fold").addEventListener("click", () => {
  $("fold").setAttribute("aria-expanded", $("fold").getAttribute("aria-expanded") === "false");
  look();
});
$("kick").addEventListener("click", kickOne);
$("many").addEventListener("click", kickMany);
$("replay").addEventListener("click", replay);
$("forces").addEventListener("click", toggleForces);
document.querySelectorAll("[data-view]").forEach(b => b.addEventListener("click", () => { view = viewed = b.dataset.view; look(); }));

async function copied(text, words) {
  document.body.dataset.copied = text;
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    // A page that is opened from disk may lack the permission; use the old method.
    const area = Object.assign(document.createElement("textarea"), { value: text });
    document.body.append(area);
    area.select();
    document.execCommand("copy");
    area.remove();
  }
  hint(words);
}
const copyCode = async () => copied(await engine.call("code", kickOf()), "Copied: a C# program that plays this kick to the last digit.");
const copyLink = () => copied(location.href.split("#")[0] + "#" + address(), "Copied: a link to this kick.");
$("copy").addEventListener("click", copyCode);
$("link").addEventListener("click", copyLink);
$("help").addEventListener("click", () => $("how").showModal());
function toggleTheme() {
  document.documentElement.dataset.theme = stage.dark ? "light" : "dark";
  retheme();
}
$("theme").addEventListener("click", toggleTheme);
$("sound").addEventListener("click", mute);
function retheme() { stage.theme(); dirty = true; }
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", retheme);

// Use another worker, so that the page stays playable.
$("bits").addEventListener("click", async () => {
  const begun = performance.now(), said = words => { $("bitsSaid").textContent = words; $("bitsSaid").scrollIntoView({ block: "nearest" }); };
  const report = () => said(`Playing the golden kicks and games … ${((performance.now() - begun) / 1000).toFixed(0)} s. You can play on.`);
  $("bits").disabled = true;
  report();
  const clock = setInterval(report, 1000);
  let other = null;
  try {
    other = await Engine.start();
    const lines = await other.call("golden", [Number($("bits").dataset.every ?? 1)]), total = lines[lines.length - 1].split(" ").pop();
    document.body.dataset.golden = lines.join("\n");
    const answer = `${lines.length} results in ${((performance.now() - begun) / 1000).toFixed(0)} s. Their hash is ${total}. Compare it with the last line of tests/Golden/golden.txt.`;
    said(answer);
    hint("Golden kicks: " + answer);
  } catch (error) {
    said("The golden kicks failed: " + error.message);
  } finally {
    clearInterval(clock);
    if (other) other.worker.terminate();
    $("bits").disabled = false;
  }
});

const KEYS = {
  " ": kickOne, Enter: kickOne, b: kickMany, r: replay, c: copyCode, l: copyLink, t: toggleTheme, m: mute, f: toggleForces, "?": () => $("how").showModal(),
  ArrowLeft: () => change("azimuth", 0.5), ArrowRight: () => change("azimuth", -0.5), ArrowUp: () => change("elevation", 0.5), ArrowDown: () => change("elevation", -0.5),
  "+": () => change("speed", 0.5), "=": () => change("speed", 0.5), "-": () => change("speed", -0.5),
  a: () => change("side", 3), d: () => change("side", -3), w: () => change("top", 3), s: () => change("top", -3), Escape: ready, n: ready,
};
document.addEventListener("keydown", e => {
  if (e.key === "Tab") document.body.classList.add("keys");
  if (e.ctrlKey || e.altKey || e.metaKey || $("how").open || !engine) return;
  const field = e.target.tagName === "SELECT" || e.target.type === "range" || e.target.tagName === "BUTTON";
  if (field && (e.key === " " || e.key === "Enter" || e.key.startsWith("Arrow"))) return;
  if (VIEWS[Number(e.key) - 1]) { view = viewed = VIEWS[Number(e.key) - 1]; look(); }
  else if (KEYS[e.key]) KEYS[e.key]();
  else return;
  e.preventDefault();
});
window.addEventListener("resize", () => { stage.resize(); look(); });
window.addEventListener("hashchange", () => { readAddress(); if (engine) scene(); });

// For tests of the page: the settings, the predicted path, and the balls in flight.
globalThis.playground = { set, stage, get flights() { return flights; }, get way() { return stage.way; }, get time() { return time; }, get playing() { return playing; } };
