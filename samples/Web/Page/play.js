// What a visitor does: pull back and let go, click into the goal, slide, replay. Everything that is set stands in the address.
const $ = id => document.getElementById(id);
const DEGREES = 180 / Math.PI, FULL_PULL = 0.3, LEAST_SPEED = 6, MOST_SPEED = 38, MANY = 20;
const DEFAULTS = {
  speed: 25.5, elevation: 18.5, azimuth: -13, side: 62, top: 10, distance: 22, aside: 0, wall: 4, keeper: 2,
  ball: "Football", ground: "DryTurf", windAcross: 0, windAlong: 0, altitude: 0, profile: "measured", beside: "",
};
const START = "Pull back from the ball and let go, or click into the goal.";
const VIEWS = ["behind", "side", "above", "goal", "ball"];
const KICK = ["speed", "elevation", "azimuth", "top", "side"];
const SCENE = ["profile", "ball", "ground", "altitude", "windAcross", "windAlong", "distance", "aside", "wall", "keeper"];
const TEXT = {
  speed: v => `${v.toFixed(1)} m/s`, elevation: v => `${v.toFixed(1)}°`,
  azimuth: v => Math.abs(v) < 0.05 ? "straight" : `${Math.abs(v).toFixed(1)}° ${v > 0 ? "left" : "right"}`,
  side: v => v === 0 ? "none" : `${Math.abs(v * 9.549).toFixed(0)} rpm ${v > 0 ? "to the left" : "to the right"}`,
  top: v => v === 0 ? "none" : `${Math.abs(v * 9.549).toFixed(0)} rpm ${v > 0 ? "top" : "back"}`,
  distance: v => `${v} m`, aside: v => v === 0 ? "middle" : `${Math.abs(v)} m ${v > 0 ? "right" : "left"}`, wall: v => v === 0 ? "none" : `${v}`,
  windAcross: v => v === 0 ? "none" : `${Math.abs(v)} m/s to the ${v > 0 ? "right" : "left"}`,
  windAlong: v => v === 0 ? "none" : `${Math.abs(v)} m/s ${v > 0 ? "behind" : "against"}`, altitude: v => `${v} m`,
};

const stage = new Stage($("stage")), camera = stage.camera;
const set = { ...DEFAULTS };
let engine = null, radius = 0.11, besideRadius = 0.11, flights = [], time = 0, rate = 1, view = "behind", viewed = "behind", playing = false, counted = true;
let pull = null, aimed = null, dirty = true, last = 0, number = 0, kicks = 0, goals = 0, saidUntil = 0, moved = null;

// ---- what is set

// What the address does not name is as at first.
function readAddress() {
  const said = new URLSearchParams(location.hash.slice(1));
  Object.assign(set, DEFAULTS);
  for (const name of Object.keys(DEFAULTS)) {
    if (!said.has(name)) continue;
    const value = typeof DEFAULTS[name] === "number" ? Number(said.get(name)) : said.get(name);
    const field = $("panel").elements[name];
    if (typeof value === "number" ? Number.isFinite(value) && (!field.min || (value >= Number(field.min) && value <= Number(field.max))) : [...field.options].some(o => o.value === value)) set[name] = value;
  }
  if (said.has("theme")) document.documentElement.dataset.theme = said.get("theme");
  view = VIEWS.includes(said.get("view")) ? said.get("view") : "behind";
}

function address() {
  const said = new URLSearchParams();
  for (const name of Object.keys(DEFAULTS)) if (set[name] !== DEFAULTS[name]) said.set(name, typeof set[name] === "number" ? String(Math.round(set[name] * 1e6) / 1e6) : set[name]);
  return said.toString();
}

function fill() {
  for (const field of $("panel").elements) {
    if (!(field.name in set)) continue;
    field.value = set[field.name];
    const output = field.closest("label").querySelector("output");
    if (output) output.textContent = TEXT[field.name](set[field.name]);
  }
  drawStrike();
  history.replaceState(null, "", "#" + address());
  document.body.dataset.kick = JSON.stringify(KICK.map(name => set[name]));
}

async function scene() {
  const told = JSON.parse(await engine.call("Set", SCENE.map(name => set[name])));
  radius = told.radius;
  if (set.beside) {
    const [profile, ball] = set.beside.split(":");
    besideRadius = await engine.call("Beside", [profile || set.profile, ball || set.ball]);
  }
  stage.show({ shapes: [...told.shapes, ...wholePitch(told.goals[0])], goals: told.goals, targets: [], ground: { x: -200, z: -200, cell: 400, columns: 2, rows: 2, heights: [0, 0, 0, 0] } });
  ready();
  await lookAhead();
  document.body.dataset.scene = String(1 + Number(document.body.dataset.scene || 0));
}

// The lines beyond the penalty area, which the drawing of a goal does not have.
function wholePitch(goal) {
  const pitch = new Stadium([goal]), line = (...places) => places.flat();
  const circle = Array.from({ length: 49 }, (_, i) => pitch.at(9.15 * Math.cos(i * Math.PI / 24), LENGTH / 2 + 9.15 * Math.sin(i * Math.PI / 24), 0.005));
  const at = (across, along) => pitch.at(across, along, 0.005);
  const lines = [
    line(at(-HALF_WIDTH, 0), at(-HALF_WIDTH, LENGTH)), line(at(HALF_WIDTH, 0), at(HALF_WIDTH, LENGTH)), line(at(-HALF_WIDTH, LENGTH), at(HALF_WIDTH, LENGTH)),
    line(at(-HALF_WIDTH, 0), at(HALF_WIDTH, 0)), line(at(-HALF_WIDTH, LENGTH / 2), at(HALF_WIDTH, LENGTH / 2)), circle.flat(),
  ];
  return [{ name: "pitch", kind: "marking", radius: 0, velocity: [0, 0, 0], lines, faces: [] }];
}

// ---- the way ahead

const kickOf = () => KICK.map(name => set[name]);

async function lookAhead() {
  const rows = await engine.call("Ahead", [0, ...kickOf(), 2.6], "ahead");
  const beside = set.beside ? await engine.call("Ahead", [1, ...kickOf(), 2.6], "beside") : null;
  if (!rows) return;
  const dots = (flat, colour) => {
    const all = [];
    for (let i = 4; i < flat.length; i += 8) all.push({ t: flat[i], p: Array.from(flat.slice(i + 1, i + 4)), colour });
    return all;
  };
  stage.way = rows;
  stage.ahead = flights.length > 0 ? [] : [...dots(rows), ...(beside ? dots(beside, "#ff9a4d") : [])];
  document.body.dataset.ahead = String(rows.length / 4);
  dirty = true;
}

// The ball lies on its spot again.
function ready() {
  flights = [];
  time = 0;
  rate = 1;
  playing = false;
  stage.bulges = new Map();
  say("");
  if (engine) hint(START);
  if (viewed !== view) viewed = view;
  look();
  fill();
  if (engine) lookAhead();
  dirty = true;
}

// ---- kicking

async function kick(kickings) {
  if (!engine) return;
  await engine.call("Forget", []);
  stage.ahead = [];
  aimed = null;
  stage.targets = [];
  flights = kickings.map(({ which, kick, colour }) => Object.assign(new Flown(++number, colour, which === 1 ? besideRadius : radius), { which, kick }));
  time = 0;
  rate = 1;
  playing = true;
  counted = false;
  viewed = view;
  look();
  say("");
  hint("");
  for (const flown of flights) await engine.call("Kick", [flown.number, flown.which, ...flown.kick]);
  const mine = flights;
  const things = new Map();
  const name = thing => things.get(thing) || "";
  while (mine === flights && mine.some(f => !f.isOver)) {
    for (const flown of mine.filter(f => !f.isOver)) {
      const rows = await engine.call("Advance", [flown.number, mine.length > 1 ? 0.2 : 0.3]);
      for (let i = 0; i < rows.length; i += ROWS[rows[i]]) {
        if (rows[i] === 1 && !things.has(rows[i + 2])) things.set(rows[i + 2], await engine.call("NameOf", [flown.number, rows[i + 2]]));
      }
      if (mine !== flights) return;
      flown.take(rows, name);
      // Of many only what is shown is played.
      flown.isOver = (mine.length > 2 && flown.end > decided(flown) + 0.1) || await engine.call("IsOver", [flown.number]);
      document.body.dataset.flown = JSON.stringify(mine.map(f => ({ end: f.end, over: f.isOver, events: f.events.length })));
    }
  }
  if (mine.length === 1 && set.keeper > 0) {
    const answer = await engine.call("Answer", [mine[0].number]);
    if (mine === flights && !$("hint").textContent) hint(answer);
  }
}

function kickOne() {
  const all = [{ which: 0, kick: kickOf(), colour: set.beside ? "#3aa0ff" : "#fff36b" }];
  if (set.beside) all.push({ which: 1, kick: kickOf(), colour: "#ff9a4d" });
  return kick(all);
}

// As a player's kicks spread: 3 % of the speed, a degree or two, some spin.
function kickMany() {
  const normal = () => Math.sqrt(-2 * Math.log(1 - Math.random())) * Math.cos(2 * Math.PI * Math.random());
  const colours = stage.series;
  return kick(Array.from({ length: MANY }, (_, i) => ({
    which: 0, colour: colours[i % colours.length],
    kick: i === 0 ? kickOf() : [set.speed * (1 + 0.03 * normal()), clamp(set.elevation + 1.3 * normal(), 0, 80), set.azimuth + 1.6 * normal(), set.top + 5 * normal(), set.side + 6 * normal()],
  })));
}

function replay() {
  if (flights.length === 0 || flights.some(f => !f.track)) return;
  time = 0;
  rate = 0.25;
  playing = true;
  counted = true;
  say("");
  if (view === "behind") viewed = viewed === "replay" ? "goal" : "replay";
  look();
  dirty = true;
}

// The kick that goes through a point of the goal's plane.
async function aimAt(p) {
  if (!engine || flights.length > 0) ready();
  hint("Looking for the kick …");
  const z = stage.picture.goals[0].center[2];
  const said = (await engine.call("Aim", [p[0], p[1], z, set.speed, set.top, set.side], "aim"));
  if (!said) return;
  const [status, speed, elevation, azimuth, top, side, miss, at, blocked] = said.split("|");
  aimed = [p[0], p[1], z];
  stage.targets = [aimed];
  document.body.dataset.aim = said;
  if (status === "Hit" || status === "TargetOnly") {
    Object.assign(set, { speed: Number(speed), elevation: Number(elevation), azimuth: Number(azimuth), top: Number(top), side: Number(side) });
    hint(`Found: ${(3.6 * set.speed).toFixed(0)} km/h, ${set.elevation.toFixed(1)}° up, ${Math.abs(set.side * 9.549).toFixed(0)} rpm, there in ${Number(at).toFixed(2)} s. Press Kick.`);
  } else {
    hint(status === "Blocked" ? `No kick at ${(3.6 * set.speed).toFixed(0)} km/h gets there: the ${blocked} is in the way. Try another speed.`
      : status === "OutOfReach" ? `Out of reach at ${(3.6 * set.speed).toFixed(0)} km/h: the closest kick misses by ${Number(miss).toFixed(1)} m. Kick harder.`
      : "No kick was found for that point.");
  }
  fill();
  lookAhead();
}

// ---- cameras

function look() {
  document.querySelectorAll("[data-view]").forEach(b => b.setAttribute("aria-pressed", b.dataset.view === view));
  if (!stage.picture) return;
  const goal = stage.picture.goals[0].center, start = [0, radius, 0], way = unit([goal[0], 0, goal[2]]), right = [-way[2], 0, way[0]];
  const narrow = camera.width < 640, far = len([goal[0], 0, goal[2]]);
  // The panel hides a part of the picture: look past it.
  const aside = narrow || $("fold").getAttribute("aria-expanded") === "false" ? 0 : 0.055 * far;
  const eye = (back, up, across = 0) => add(add(mul(-back, way), mul(across, right)), [0, up, 0]);
  const place = {
    behind: () => [add(eye(narrow ? 9 : 6.6, narrow ? 3 : 2.25), mul(0.4 * aside, right)), add(add(lerp(start, goal, 0.62), mul(aside, right)), [0, narrow ? 0.1 : 0.75, 0])],
    replay: () => [add(mul(0.5 * far, way), add(mul(narrow ? -21 : -15, right), [0, 1.9, 0])), add(mul((narrow ? 0.7 : 0.63) * far, way), [0, 1.4, 0])],
    side: () => [add(mul(0.5 * far, way), add(mul((narrow ? 1.6 : 0.82) * far + 6, right), [0, 5, 0])), add(mul(0.52 * far, way), [0, 1.5, 0])],
    above: () => [add(mul(0.5 * far - 0.5, way), [0, (narrow ? 1.35 : 1.3) * far + 8, 0]), add(mul(0.5 * far, way), mul(narrow ? 0 : 2.5, right))],
    goal: () => [add(goal, add(mul(narrow ? 10 : 6.4, way), [0, 2.9, 0])), add(lerp(goal, start, 0.35), [0, 0.9, 0])],
    ball: () => [eye(3.2, 1.1, 0.9), add(start, [0, 0.3, 0])],
  }[viewed];
  if (viewed !== "ball" || !playing) camera.lookFrom(...place());
  moved = null;
  dirty = true;
}

function followBall() {
  const flown = flights[0];
  if (!flown || !flown.track) return;
  const at = flown.track.at(time), v = len([at.v[0], 0, at.v[2]]) > 1 ? unit([at.v[0], 0, at.v[2]]) : unit(sub(stage.picture.goals[0].center, at.p));
  moved = moved ? unit(lerp(moved, v, 0.08)) : v;
  const eye = add(at.p, add(mul(-3.4, moved), [0.5, 0.85, 0]));
  camera.lookFrom([eye[0], Math.max(0.5, eye[1]), eye[2]], add(at.p, mul(1.2, moved)));
}

// ---- frames

function frame(now) {
  requestAnimationFrame(frame);
  const passed = Math.min(0.1, (now - last) / 1000);
  last = now;
  if (playing && flights.length > 0) {
    const known = Math.min(...flights.map(f => f.isOver ? Infinity : f.end));
    const end = Math.max(...flights.map(f => f.end));
    time = Math.min(time + rate * passed, Number.isFinite(known) ? known : Infinity, end + 1);
    story();
    dirty = true;
  }
  if (!dirty || !stage.picture) return;
  dirty = false;
  paint();
  tally(now);
}

let shown = [];
function tally(now) {
  shown = shown.filter(t => now - t < 1000);
  shown.push(now);
  if (playing) document.body.dataset.frames = String(Math.max(Number(document.body.dataset.frames || 0), shown.length));
}

function paint() {
  const flown = flights.filter(f => f.track);
  if (viewed === "ball" && playing) followBall();
  stage.bulges = new Map();
  flown.forEach(f => f.nets.at(time, stage.bulges));
  stage.figures = keepers(flown);
  if (flown.length > 0) {
    stage.draw(flown, time, null);
  } else {
    const lying = r => ({ radius: r, colour: "", events: [], plain: true, track: { path: [], end: 0, at: () => ({ p: [0, r, 0], q: [0.2, 0.1, 0, 0.97] }) } });
    stage.draw([lying(radius)], 0, null);
    drawPull();
  }
  numbers(flown);
}

function keepers(flown) {
  if (set.keeper === 0) return [];
  const goal = stage.picture.goals[0].center, f = flown[0] && flown[0].keeperAt(time);
  const feet = f ? f.feet : add(goal, [0, 0.1, 0.5]);
  const shoulders = f ? f.shoulders : add(feet, [0, 1.4, 0]);
  const hands = f ? f.hands : add(goal, [0, 1.2, 0.75]);
  return [{ limbs: limbsOf(feet, shoulders, hands, [0, 0, 1], "keeper"), feet: [feet[0], Math.max(0, feet[1] - 0.1), feet[2]] }];
}

function numbers(flown) {
  const at = flown.length > 0 ? flown[0].track.at(time) : null;
  const speed = at ? len(at.v) : set.speed, spin = at ? len(at.spin) : Math.hypot(set.side, set.top);
  $("numbers").textContent = `${(3.6 * speed).toFixed(0)} km/h · ${(9.549 * spin).toFixed(0)} rpm` + (at ? ` · ${Math.max(0, at.p[1] - radius).toFixed(1)} m high · ${time.toFixed(2)} s${rate < 1 ? " · slow" : ""}` : "");
}

// What has happened by now: the score, the words.
function story() {
  const end = Math.max(...flights.map(f => f.end)), over = flights.every(f => f.isOver);
  const verdicts = flights.map(f => f.verdict(time));
  if (flights.length <= 2) {
    if (verdicts[0]) say(verdicts[0], flights[0].events.some(e => e.kind === "goal" && e.time <= time));
  } else {
    const inside = flights.filter(f => f.events.some(e => e.kind === "goal" && e.time <= time)).length;
    if (inside > 0) say(`${inside} of ${flights.length}`, true);
  }
  if (!counted && over && time >= Math.min(end, storyEnd())) {
    counted = true;
    kicks += flights.length > 2 ? flights.length : 1;
    goals += (flights.length > 2 ? flights : flights.slice(0, 1)).filter(f => f.first("goal")).length;
    $("goals").textContent = goals;
    $("kicks").textContent = kicks;
  }
  if (over && time >= Math.min(end, storyEnd())) playing = false;
}

// A story ends a second and a half after what decides it, not when the ball has stopped rolling.
const storyEnd = () => Math.max(...flights.map(decided));

function decided(flown) {
  const e = flown.first("goal") || flown.events.find(x => x.kind === "impact" && /post|bar|keeper|gloves|wall|head/.test(x.surface));
  return e ? e.time + 1.8 : 3.6;
}

function say(words, goal) {
  const v = $("verdict");
  if (words) v.textContent = words;
  v.classList.toggle("said", !!words);
  v.classList.toggle("goal", !!goal);
  document.body.dataset.verdict = words;
}

function hint(words) { $("hint").textContent = words; }

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
    g.font = "700 15px system-ui, sans-serif";
    g.textAlign = "center";
    g.strokeStyle = "rgba(0,0,0,0.55)";
    g.lineWidth = 4;
    const text = `${(3.6 * set.speed).toFixed(0)} km/h`, up = y > 0 && s[1] + y + 30 > camera.height - 60 ? -18 : 28;
    g.strokeText(text, s[0] + x, s[1] + y + up);
    g.fillStyle = "#fff";
    g.fillText(text, s[0] + x, s[1] + y + up);
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

// Straight back is straight ahead, as the camera looks; aside turns, by as much as the goal is wide at a full pull.
function pulled(x, y) {
  // A full pull ends where the window does.
  const room = camera.height - ballOnScreen()[1] - 14;
  const full = Math.max(90, Math.min(FULL_PULL * Math.min(camera.height, camera.width * 1.5), room)), length = Math.hypot(x, y);
  pull.now = length > full ? [x * full / length, y * full / length] : [x, y];
  const share = clamp(length / full, 0, 1), goal = stage.picture.goals[0].center;
  set.speed = Math.round(10 * (LEAST_SPEED + share * (MOST_SPEED - LEAST_SPEED))) / 10;
  const straight = Math.atan2(-goal[0], -goal[2]) * DEGREES;
  set.azimuth = clamp(Math.round(10 * (straight + 26 * clamp(x / full, -1, 1))) / 10, -40, 40);
  fill();
  lookAhead();
}

const canvas = $("stage");
let pressed = null;
canvas.addEventListener("pointerdown", e => {
  canvas.focus();
  if (e.isPrimary === false) return;
  canvas.setPointerCapture(e.pointerId);
  if (flights.length > 0 && !playing) { ready(); }
  const s = flights.length === 0 && ballOnScreen();
  pressed = { x: e.clientX, y: e.clientY, id: e.pointerId, pull: s && Math.hypot(s[0] - e.clientX, s[1] - e.clientY) < Math.max(44, 3 * radius * s[2]) };
});
canvas.addEventListener("pointermove", e => {
  if (!pressed || e.pointerId !== pressed.id) return;
  const [x, y] = [e.clientX - pressed.x, e.clientY - pressed.y];
  if (pressed.pull) {
    if (!pull && Math.hypot(x, y) < 8) return;
    pull = pull || { now: [0, 0] };
    stage.targets = [];
    hint("Let go to kick; the wheel or ↑ ↓ change the height.");
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
  } else if (!was.dragged && stage.picture) {
    const p = camera.onPlane(e.clientX, e.clientY, stage.picture.goals[0].center[2]), goal = stage.picture.goals[0].center;
    if (p && Math.abs(p[0] - goal[0]) < 5.5 && p[1] > 0 && p[1] < 4) aimAt([p[0], Math.max(p[1], radius)]);
  }
  dirty = true;
});
canvas.addEventListener("pointercancel", () => { pressed = pull = null; dirty = true; });
canvas.addEventListener("wheel", e => { e.preventDefault(); change("elevation", e.deltaY < 0 ? 0.5 : -0.5); }, { passive: false });

// ---- the little ball: where the foot meets it

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

// Struck on its right side a ball turns to the left; struck below its middle it gets backspin.
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
  if (KICK.includes(name)) changed(); else if (engine) scene();
});
$("spots").addEventListener("click", e => {
  if (!e.target.dataset.spot) return;
  const [distance, aside, wall] = e.target.dataset.spot.split(",").map(Number);
  const straight = Math.atan2(aside, distance) * DEGREES;
  Object.assign(set, { distance, aside, wall, azimuth: Math.round(10 * clamp(straight, -40, 40)) / 10, side: wall > 0 ? set.side : 0, elevation: wall > 0 ? 18 : 9 });
  scene();
});
$("fold").addEventListener("click", () => {
  $("fold").setAttribute("aria-expanded", $("fold").getAttribute("aria-expanded") === "false");
  look();
});
$("kick").addEventListener("click", kickOne);
$("many").addEventListener("click", kickMany);
$("replay").addEventListener("click", replay);
document.querySelectorAll("[data-view]").forEach(b => b.addEventListener("click", () => { view = viewed = b.dataset.view; look(); }));

async function copied(text, words) {
  document.body.dataset.copied = text;
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    // A page from disk may not be allowed to; an old way is.
    const area = Object.assign(document.createElement("textarea"), { value: text });
    document.body.append(area);
    area.select();
    document.execCommand("copy");
    area.remove();
  }
  hint(words);
}
const copyCode = async () => copied(await engine.call("Code", kickOf()), "Copied: a C# program that plays this kick to the last digit.");
const copyLink = () => copied(location.href.split("#")[0] + "#" + address(), "Copied: a link to this kick.");
$("copy").addEventListener("click", copyCode);
$("link").addEventListener("click", copyLink);
$("help").addEventListener("click", () => $("how").showModal());
function toggleTheme() {
  document.documentElement.dataset.theme = stage.dark ? "light" : "dark";
  retheme();
}
$("theme").addEventListener("click", toggleTheme);
function retheme() { stage.theme(); dirty = true; }
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", retheme);

$("bits").addEventListener("click", async () => {
  $("bitsSaid").textContent = "Playing the golden kicks …";
  const lines = (await engine.call("Golden", [])).split("\n");
  document.body.dataset.golden = lines.join("\n");
  $("bitsSaid").textContent = `${lines.length} kicks and games; ${lines[lines.length - 1]}: as tests/Golden says for every machine.`;
});

const KEYS = {
  " ": kickOne, Enter: kickOne, b: kickMany, r: replay, c: copyCode, l: copyLink, t: toggleTheme, "?": () => $("how").showModal(),
  ArrowLeft: () => change("azimuth", 0.5), ArrowRight: () => change("azimuth", -0.5), ArrowUp: () => change("elevation", 0.5), ArrowDown: () => change("elevation", -0.5),
  "+": () => change("speed", 0.5), "=": () => change("speed", 0.5), "-": () => change("speed", -0.5),
  a: () => change("side", 3), d: () => change("side", -3), w: () => change("top", 3), s: () => change("top", -3), Escape: ready, n: ready,
};
document.addEventListener("keydown", e => {
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

// For whoever checks the page: what is set, the way ahead, and what flies.
globalThis.playground = { set, stage, get flights() { return flights; }, get way() { return stage.way; }, get time() { return time; } };

// ---- beginning

if (matchMedia("(max-width: 720px), (max-height: 560px)").matches) $("fold").setAttribute("aria-expanded", "false");
const begun = performance.now();
Engine.start().then(async started => {
  engine = started;
  const [balls, grounds] = (await engine.call("Names", [])).split("|").map(names => names.split(" "));
  const words = name => name.replace(/([a-z])([A-Z0-9])/g, "$1 $2").toLowerCase().replace(/^(jabulani|brazuca|teamgeist|tango|telstar|al rihla|trionda)/, w => w[0].toUpperCase() + w.slice(1));
  $("panel").elements.ball.replaceChildren(...balls.map(name => new Option(words(name), name)));
  $("panel").elements.ground.replaceChildren(...grounds.map(name => new Option(words(name), name)));
  readAddress();
  viewed = view;
  stage.theme();
  stage.resize();
  await scene();
  document.body.dataset.ready = String(Math.round(performance.now() - begun));
  for (const id of ["kick", "many", "replay"]) $(id).disabled = false;
  hint(START);
  requestAnimationFrame(frame);
}).catch(error => {
  document.body.dataset.failed = error.message;
  hint("The library could not be started: " + error.message);
});
