// The settings, which the address contains, and the start of the page.
const $ = id => document.getElementById(id);
const DEGREES = 180 / Math.PI, FULL_PULL = 0.3, LEAST_SPEED = 6, MOST_SPEED = 38, MANY = 20;
const DEFAULTS = {
  speed: 31, elevation: 17, azimuth: 0.5, side: 40, top: 25, distance: 22, aside: 0, wall: 4, keeper: 2,
  ball: "modern", ground: "matchTurf", windAcross: 0, windAlong: 0, altitude: 0, profile: "measured", beside: "",
  wetness: 0, mud: 0, wear: 0, pressure: 0.8,
};
// The hint names only controls of the device: fingers have neither a wheel nor keys.
let touch = matchMedia("(pointer: coarse)").matches;
const start = () => `Pull back from the ball and let go, or ${touch ? "tap" : "click in"} the goal.`;
const VIEWS = ["behind", "side", "above", "goal", "ball"];
const KICK = ["speed", "elevation", "azimuth", "top", "side"];
const SCENE = ["profile", "ball", "ground", "altitude", "windAcross", "windAlong", "distance", "aside", "wall", "keeper", "wetness", "mud", "wear", "pressure"];
// The dials act on a ball that already moves; all other conditions put it back on its spot.
const DIALS = ["wetness", "mud", "wear", "pressure"];
const TEXT = {
  speed: v => `${v.toFixed(1)} m/s`, elevation: v => `${v.toFixed(1)}°`,
  azimuth: v => Math.abs(v) < 0.05 ? "straight" : `${Math.abs(v).toFixed(1)}° ${v > 0 ? "left" : "right"}`,
  side: v => v === 0 ? "none" : `${Math.abs(v * 9.549).toFixed(0)} rpm ${v > 0 ? "to the left" : "to the right"}`,
  top: v => v === 0 ? "none" : `${Math.abs(v * 9.549).toFixed(0)} rpm ${v > 0 ? "top" : "back"}`,
  distance: v => `${v} m`, aside: v => v === 0 ? "middle" : `${Math.abs(v)} m ${v > 0 ? "right" : "left"}`, wall: v => v === 0 ? "none" : `${v}`,
  windAcross: v => v === 0 ? "none" : `${Math.abs(v)} m/s to the ${v > 0 ? "right" : "left"}`,
  windAlong: v => v === 0 ? "none" : `${Math.abs(v)} m/s ${v > 0 ? "behind" : "against"}`, altitude: v => `${v} m`,
  ...Object.fromEntries(["wetness", "mud", "wear"].map(name => [name, v => v === 0 ? "none" : v.toFixed(2)])), pressure: v => `${v.toFixed(2)} bar`,
};

const stage = new Stage($("stage")), camera = stage.camera;
const set = { ...DEFAULTS };
let engine = null, air = null, radius = 0.11, besideRadius = 0.11, flights = [], time = 0, rate = 1, view = "behind", viewed = "behind", playing = false;
let pull = null, dirty = true, last = 0, number = 0, run = 0, kicks = 0, goals = 0, moved = null;

// ---- what is set

// Reads the settings from the address. Settings that it does not contain get their defaults.
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

// Sets the scene of the library, and the second one for comparison. Returns the objects of the first.
async function compile() {
  const shown = engine.call("set", SCENE.map(name => set[name]));
  if (set.beside) {
    const [profile, ball] = set.beside.split(":");
    besideRadius = await engine.call("beside", [profile || set.profile, ball || set.ball]);
  }
  return shown;
}

async function scene() {
  const shown = await compile();
  radius = shown.radius;
  air = { viscosity: shown.kinematicViscosity, wind: shown.wind };
  stage.show({ shapes: [...shown.shapes, ...wholePitch(shown.goals[0])], goals: shown.goals, targets: [], ground: { x: -200, z: -200, cell: 400, columns: 2, rows: 2, heights: [0, 0, 0, 0] } });
  ready();
  await lookAhead();
  document.body.dataset.scene = String(1 + Number(document.body.dataset.scene || 0));
}

// Returns the lines beyond the penalty area, which the drawing of a goal does not include.
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

// ---- start

if (matchMedia("(max-width: 720px), (max-height: 560px)").matches) $("fold").setAttribute("aria-expanded", "false");
const begun = performance.now();
Engine.start().then(async started => {
  engine = started;
  const { balls, grounds } = await engine.call("names", []);
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
  hint(start());
  requestAnimationFrame(frame);
}).catch(error => {
  document.body.dataset.failed = error.message;
  hint("The library could not be started: " + error.message);
});
