// The positions of the camera, and the drawing of a frame.

// ---- cameras

function look() {
  document.querySelectorAll("[data-view]").forEach(b => b.setAttribute("aria-pressed", b.dataset.view === view));
  if (!stage.picture) return;
  const goal = stage.picture.goals[0].center, start = [0, radius, 0], way = unit([goal[0], 0, goal[2]]), right = [-way[2], 0, way[0]];
  const narrow = camera.width < 640, far = len([goal[0], 0, goal[2]]);
  // The panel hides a part of the picture, so look past it.
  const aside = narrow || $("fold").getAttribute("aria-expanded") === "false" ? 0 : 0.055 * far;
  const eye = (back, up, across = 0) => add(add(mul(-back, way), mul(across, right)), [0, up, 0]);
  const place = {
    // The ball is high enough above the bar that the user can pull it back.
    behind: () => [add(eye(narrow ? 9 : 6.8, narrow ? 3.1 : 2.5), mul(0.4 * aside, right)), add(add(lerp(start, goal, 0.62), mul(aside, right)), [0, narrow ? -0.6 : camera.height < 640 ? -1.3 : -0.35, 0])],
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
    const before = time;
    time = Math.min(time + rate * passed, Number.isFinite(known) ? known : Infinity, end + 1);
    flights.forEach(f => hear(f, before, time));
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
  showForces(flown[0]);
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

// Updates the score and the words to the events so far.
function story() {
  const end = Math.max(...flights.map(f => f.end)), over = flights.every(f => f.isOver);
  const verdicts = flights.map(f => f.verdict(time));
  if (flights.length <= 2) {
    if (verdicts[0]) say(verdicts[0], flights[0].events.some(e => e.kind === "goal" && e.time <= time));
  } else {
    const inside = flights.filter(f => f.events.some(e => e.kind === "goal" && e.time <= time)).length;
    if (inside > 0) say(`${inside} of ${flights.length}`, true);
  }
  // Count each goal once, as soon as it is visible. The second ball is only for comparison.
  const fresh = flights.filter(f => f.which === 0 && !f.scored && f.events.some(e => e.kind === "goal" && e.time <= time));
  fresh.forEach(f => { f.scored = true; });
  if (fresh.length > 0) score(0, fresh.length);
  if (over && time >= Math.min(end, storyEnd())) playing = false;
}

function score(moreKicks, moreGoals) {
  kicks += moreKicks;
  goals += moreGoals;
  $("kicks").textContent = kicks;
  $("goals").textContent = goals;
}

// A kick ends 1.8 s after its deciding event, not when the ball comes to rest.
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
