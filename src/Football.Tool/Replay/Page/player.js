// The controls of the page. An address such as page.html#picture=chip&time=1.2&view=side&theme=dark sets the initial state; the animation is then paused.
const $ = id => document.getElementById(id);
const data = JSON.parse($("data").textContent);
const begin = new URLSearchParams(location.hash.slice(1));
const stage = new Stage($("stage"));
const camera = stage.camera;
let shots = [], time = 0, end = 1, story = 1, ended = 0, playing = false, speed = 1, view = "behind", hover = null, last = 0;

const shown = () => shots.filter(s => s.visible);
const redraw = () => {
  stage.bulges = new Map();
  shown().forEach(shot => shot.netTrack.at(time, stage.bulges));
  stage.figures = keeper(time);
  stage.draw(shown(), time, hover);
};
// Returns the goalkeeper between two poses: rows of time, feet, shoulders and hands.
const POSE = 10;
function keeper(t) {
  const rows = stage.picture.keeper, last = rows.length / POSE - 1;
  if (last < 0) return [];
  let i = 0;
  while (i < last && rows[POSE * (i + 1)] <= t) i++;
  const [a, b] = [i, Math.min(i + 1, last)].map(j => rows.slice(POSE * j, POSE * (j + 1))), s = b[0] > a[0] ? clamp((t - a[0]) / (b[0] - a[0]), 0, 1) : 0;
  const [feet, shoulders, hands] = [1, 4, 7].map(j => lerp(a.slice(j, j + 3), b.slice(j, j + 3), s));
  return [{ limbs: limbsOf(feet, shoulders, hands, [0, 0, 1], "keeper"), feet }];
}
const numbers = at => {
  const spin = len(at.spin);
  return `${at.t.toFixed(2)} s, ${MOTIONS[at.motion]}\n${len(at.v).toFixed(1)} m/s, ${(3.6 * len(at.v)).toFixed(0)} km/h\n`
    + `height ${at.p[1].toFixed(2)} m\nspin ${spin.toFixed(1)} rad/s, ${(spin * 30 / Math.PI).toFixed(0)} rpm\n(${at.p.map(x => x.toFixed(2)).join(", ")}) m`;
};

function choose(id) {
  const picture = data.pictures.find(p => p.id === id) || data.pictures[0];
  stage.show(picture);
  $("about").textContent = picture.about;
  $("picture").value = picture.id;
  shots = picture.shots.map((shot, i) => ({ ...shot, events: shot.events, track: new Track(shot), netTrack: new NetTrack(shot.nets), colour: stage.series[i % stage.series.length], visible: true }));
  const list = $("shots");
  list.replaceChildren(...shots.map(shot => {
    const row = document.createElement("li");
    const label = document.createElement("label");
    const box = Object.assign(document.createElement("input"), { type: "checkbox", checked: true });
    const key = document.createElement("i");
    shot.key = key;
    key.classList.toggle("dashed", shot.compares);
    const name = Object.assign(document.createElement("span"), { textContent: shot.name });
    const kick = Object.assign(document.createElement("small"), { textContent: shot.kick });
    box.addEventListener("change", () => { shot.visible = box.checked; limits(); redraw(); });
    label.append(box, key, name, kick);
    row.append(label);
    return row;
  }));
  recolour();
  limits();
  go(0);
  look(view);
}

function recolour() {
  shots.forEach((shot, i) => {
    shot.colour = stage.series[i % stage.series.length];
    shot.key.style.background = shot.colour;
    shot.key.style.setProperty("--c", shot.colour);
  });
}

function limits() {
  end = Math.max(0.01, ...shown().map(s => s.track.end));
  story = Math.min(end, Math.max(0.01, ...shown().map(storyEnd)));
  $("time").max = end;
  $("events").replaceChildren(...shown().filter(s => !s.compares).flatMap(shot => shot.events.map(happened => {
    const mark = document.createElement("b");
    mark.style.left = 100 * happened.time / end + "%";
    mark.style.background = EVENT_COLOURS[happened.kind];
    return mark;
  })));
}

// Returns the end of the interesting part: a moment after the goal or the last hit of an object; otherwise after the ball begins to roll.
function storyEnd(shot) {
  const last = kind => shot.events.filter(kind).reduce((t, e) => Math.max(t, e.time), -1);
  const goal = shot.events.find(e => e.kind === "goal"), hit = last(e => e.kind === "impact" && e.surface && e.surface !== "ground"), rolls = last(e => e.kind === "roll");
  return goal ? goal.time + 1.6 : hit >= 0 ? hit + 2 : rolls >= 0 ? rolls + 2 : shot.track.end;
}

function go(t) {
  time = clamp(t, 0, end);
  $("time").value = time;
  $("clock").textContent = `${time.toFixed(2)} of ${end.toFixed(1)} s`;
  if (view === "ball") follow();
  redraw();
}

function follow() {
  const shot = shown()[0];
  if (!shot) return;
  camera.target = shot.track.at(time).p;
  camera.update();
}

function look(name) {
  view = name;
  document.querySelectorAll("[data-view]").forEach(b => b.setAttribute("aria-pressed", b.dataset.view === name));
  // Use the mean direction of the paths.
  const ways = (shown().length ? shown() : shots).map(({ track }) => {
    const start = track.keys[0], way = sub(track.at(Math.min(track.end, 1.5)).p, start.p);
    const along = Math.hypot(way[0], way[2]) > 0.5 ? way : start.v;
    return Math.hypot(along[0], along[2]) > 0 ? unit([along[0], 0, along[2]]) : [0, 0, -1];
  });
  const along = ways.reduce(add), yaw = Math.atan2(-along[0], -along[2]);
  const narrow = camera.width < 640;
  const margin = { left: camera.width > 900 ? $("shots").parentElement.offsetWidth + 24 : 24, right: 24, top: narrow ? 0.3 * camera.height : 40, bottom: narrow ? 150 : 110 };
  camera.yaw = { behind: yaw, side: yaw - Math.PI / 2, above: yaw, front: yaw + Math.PI, ball: yaw - 0.6 }[name];
  camera.pitch = { behind: 0.2, side: 0.1, above: 1.5, front: 0.18, ball: 0.12 }[name];
  camera.update();
  if (name === "ball") {
    camera.distance = 3;
    follow();
  } else if (name === "behind" && (shown()[0] || shots[0])) {
    behind(unit([along[0], 0, along[2]]), margin);
  } else {
    camera.fit(focus(), margin);
  }
  redraw();
}

// Moves the camera behind the ball, as close as possible with the complete picture between the panels. The ball is in the foreground, and nothing covers it.
function behind(way, margin) {
  const start = (shown()[0] || shots[0]).track.keys[0].p, places = [start, ...focus()];
  const low = [0, 1, 2].map(i => Math.min(...places.map(p => p[i]))), high = [0, 1, 2].map(i => Math.max(...places.map(p => p[i])));
  const far = Math.max(2, dot(sub(lerp(low, high, 0.5), start), way));
  const inside = p => {
    const s = camera.project(p);
    return s && s[0] > margin.left && s[0] < camera.width - margin.right && s[1] > margin.top && s[1] < camera.height - margin.bottom;
  };
  for (let back = 4; back < 400; back *= 1.07) {
    // Aim the camera so that the points are in the centre of the free area.
    const eye = add(sub(start, mul(back, way)), [0, 0.9 + 0.27 * back, 0]);
    let target = add(add(start, mul(far, way)), [0, 0.3 * (high[1] - low[1]), 0]);
    for (let round = 0; round < 4; round++) {
      camera.lookFrom(eye, target);
      const seen = places.map(p => camera.project(p)).filter(s => s);
      const middle = i => 0.5 * (Math.min(...seen.map(s => s[i])) + Math.max(...seen.map(s => s[i])));
      const s = camera.distance / camera.focus;
      target = add(target, add(mul(s * (middle(0) - 0.5 * (margin.left + camera.width - margin.right)), camera.right), mul(-s * (middle(1) - 0.5 * (margin.top + camera.height - margin.bottom)), camera.up)));
    }
    camera.lookFrom(eye, target);
    if (places.every(inside)) return;
  }
}

// Returns the points that must be visible: the paths without their long final parts, and goals and obstacles near them.
function focus() {
  const paths = (shown().length ? shown() : shots).filter(s => !s.compares || shots.length === 1);
  const all = paths.flatMap(s => {
    const goal = s.events.find(e => e.kind === "goal" || e.kind === "net");
    const touch = s.events.find(e => e.kind === "impact");
    const until = goal ? goal.time + 0.5 : touch ? Math.max(1.6 * touch.time, touch.time + 0.5) : s.track.end;
    return s.track.path.filter(k => k.t <= until).map(k => k.p);
  });
  const low = [0, 1, 2].map(i => Math.min(...all.map(p => p[i]))), high = [0, 1, 2].map(i => Math.max(...all.map(p => p[i])));
  const near = p => [0, 2].every(i => p[i] > low[i] - 8 && p[i] < high[i] + 8);
  const frames = stage.shapes.filter(s => s.kind === "frame" || s.kind === "obstacle").flatMap(s => [...s.lines, ...s.faces]).filter(l => l.every(near));
  const places = [...all, ...frames.flat()];
  // If the ball hardly moves, limit the zoom.
  const middle = lerp(low, high, 0.5);
  return len(sub(high, low)) > 3 ? places : [...places, add(middle, [1.5, 0, 1.5]), add(middle, [-1.5, 0.5, -1.5])];
}

function play(on) {
  playing = on;
  $("play").textContent = on ? "❚❚" : "▶";
  $("play").setAttribute("aria-label", on ? "Pause" : "Play");
  if (!on) return;
  if (time >= story) go(0);
  ended = 0;
  last = performance.now();
  requestAnimationFrame(frame);
}

function frame(now) {
  if (!playing) return;
  const passed = Math.min(0.1, Math.max(0, now - last) / 1000);
  last = now;
  // At the end, wait for a moment, and start again.
  if (time < story) go(time + speed * passed);
  else if ((ended += passed) > 0.9) { ended = 0; go(0); }
  requestAnimationFrame(frame);
}

function faster(by) {
  const list = $("speed");
  list.selectedIndex = clamp(list.selectedIndex + by, 0, list.options.length - 1);
  speed = Number(list.value);
}

function theme(name) {
  document.documentElement.dataset.theme = name;
  stage.theme();
  recolour();
  redraw();
}

function nearest(x, y) {
  let best = null;
  for (const shot of shown()) {
    for (const at of shot.track.path) {
      const s = camera.project(at.p);
      const d = s ? Math.hypot(s[0] - x, s[1] - y) : Infinity;
      if (d < 16 && (!best || d < best.d)) best = { d, shot, at, p: at.p };
    }
  }
  return best;
}

function point(x, y) {
  hover = nearest(x, y);
  const tip = $("tip");
  tip.hidden = !hover;
  if (hover) {
    const happened = hover.shot.events.filter(e => Math.abs(e.time - hover.at.t) < 0.025)
      .map(e => `\n${e.kind}${e.surface ? ", " + e.surface : ""}: ${e.before.toFixed(1)} → ${e.after.toFixed(1)} m/s`).join("");
    tip.textContent = hover.shot.name + "\n" + numbers(hover.at) + happened;
    tip.style.left = clamp(x + 14, 4, camera.width - tip.offsetWidth - 4) + "px";
    tip.style.top = clamp(y - tip.offsetHeight - 10, 4, camera.height - tip.offsetHeight - 4) + "px";
  }
  redraw();
}

function turn(yaw, pitch) {
  camera.yaw -= yaw;
  camera.pitch = clamp(camera.pitch + pitch, -0.4, 1.55);
  camera.update();
  redraw();
}

function move(x, y) {
  const s = camera.distance / camera.focus;
  camera.target = add(camera.target, add(mul(-s * x, camera.right), mul(s * y, camera.up)));
  camera.update();
  redraw();
}

function zoom(by) {
  camera.distance = clamp(camera.distance * by, 0.4, 2000);
  camera.update();
  redraw();
}

const fingers = new Map();
let dragged = 0;
$("stage").addEventListener("pointerdown", e => {
  fingers.set(e.pointerId, [e.clientX, e.clientY]);
  e.target.setPointerCapture(e.pointerId);
  dragged = 0;
});
$("stage").addEventListener("pointermove", e => {
  const from = fingers.get(e.pointerId);
  if (!from) { point(e.clientX, e.clientY); return; }
  const [x, y] = [e.clientX - from[0], e.clientY - from[1]];
  dragged += Math.abs(x) + Math.abs(y);
  if (fingers.size === 2) {
    const other = [...fingers].find(([id]) => id !== e.pointerId)[1];
    zoom(Math.hypot(from[0] - other[0], from[1] - other[1]) / Math.max(1, Math.hypot(e.clientX - other[0], e.clientY - other[1])));
    move(0.5 * x, 0.5 * y);
  } else if (e.shiftKey || e.buttons === 2 || e.buttons === 4) {
    move(x, y);
  } else {
    turn(0.006 * x, 0.006 * y);
  }
  fingers.set(e.pointerId, [e.clientX, e.clientY]);
});
for (const kind of ["pointerup", "pointercancel"]) {
  $("stage").addEventListener(kind, e => {
    fingers.delete(e.pointerId);
    if (kind === "pointerup" && dragged < 6) {
      point(e.clientX, e.clientY);
      if (hover) { play(false); go(hover.at.t); }
    }
  });
}
$("stage").addEventListener("pointerleave", () => { hover = null; $("tip").hidden = true; redraw(); });
$("stage").addEventListener("contextmenu", e => e.preventDefault());
$("stage").addEventListener("wheel", e => { e.preventDefault(); zoom(Math.exp(0.0012 * e.deltaY)); }, { passive: false });

$("time").addEventListener("input", () => { play(false); go(Number($("time").value)); });
$("play").addEventListener("click", () => play(!playing));
$("speed").addEventListener("change", () => { speed = Number($("speed").value); });
$("views").addEventListener("click", e => { if (e.target.dataset.view) look(e.target.dataset.view); });
$("theme").addEventListener("click", () => toggleTheme());
$("help").addEventListener("click", () => { $("keys").hidden = !$("keys").hidden; });
$("picture").addEventListener("change", () => { choose($("picture").value); play(true); });

function toggleTheme() {
  const now = document.documentElement.dataset.theme || (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
  theme(now === "dark" ? "light" : "dark");
}

function nextEvent() {
  const later = shown().flatMap(s => s.events).map(e => e.time).filter(t => t > time + 1e-4).sort((a, b) => a - b);
  play(false);
  go(later.length ? later[0] : end);
}

const VIEWS = ["behind", "side", "above", "front", "ball"];
const KEYS = {
  " ": () => play(!playing), Home: () => go(0), End: () => go(end), ArrowUp: () => faster(1), ArrowDown: () => faster(-1),
  "+": () => zoom(0.85), "=": () => zoom(0.85), "-": () => zoom(1.18), n: nextEvent, t: toggleTheme,
  "?": () => { $("keys").hidden = !$("keys").hidden; }, Escape: () => { $("keys").hidden = true; },
  a: () => turn(-0.06, 0), d: () => turn(0.06, 0), w: () => turn(0, 0.05), s: () => turn(0, -0.05),
  A: () => move(30, 0), D: () => move(-30, 0), W: () => move(0, 30), S: () => move(0, -30),
};
document.addEventListener("keydown", e => {
  if (e.ctrlKey || e.altKey || e.metaKey || e.target.tagName === "SELECT") return;
  const onButton = e.target.tagName === "BUTTON" || e.target.type === "checkbox";
  if (e.key === " " && onButton) return;
  const step = e.shiftKey ? 0.5 : 0.02;
  if (e.key === "ArrowLeft" || e.key === "ArrowRight") { play(false); go(time + (e.key === "ArrowLeft" ? -step : step)); }
  else if (VIEWS[Number(e.key) - 1]) look(VIEWS[Number(e.key) - 1]);
  else if (KEYS[e.key]) KEYS[e.key]();
  else return;
  e.preventDefault();
});

$("picture").hidden = data.pictures.length < 2;
$("picture").replaceChildren(...data.pictures.map(p => new Option(p.name, p.id)));
if (begin.has("theme")) document.documentElement.dataset.theme = begin.get("theme");
if (VIEWS.includes(begin.get("view"))) view = begin.get("view");
stage.theme();
stage.resize();
choose(begin.get("picture"));
window.addEventListener("resize", () => { stage.resize(); look(view); });
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { stage.theme(); recolour(); redraw(); });
if (begin.has("time")) go(Number(begin.get("time")));
else if (!matchMedia("(prefers-reduced-motion: reduce)").matches) play(true);
