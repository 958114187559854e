// The predicted path, kicks of one ball and of many, replays, and the kick to a point that the user clicks.

// ---- the predicted path

const kickOf = () => KICK.map(name => set[name]);

async function lookAhead() {
  const rows = await engine.call("ahead", [0, ...kickOf(), 2.6], "ahead");
  const beside = set.beside ? await engine.call("ahead", [1, ...kickOf(), 2.6], "beside") : null;
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

// Puts the ball back on its spot.
function ready() {
  run++;
  flights = [];
  time = 0;
  rate = 1;
  playing = false;
  stage.bulges = new Map();
  say("");
  if (engine) hint(start());
  if (viewed !== view) viewed = view;
  look();
  fill();
  if (engine) lookAhead();
  dirty = true;
}

// ---- kicking

// Kicks balls. A newer kick or ready() ends this one. The worker answers in order, so no call may follow the newer kick's "forget".
async function kick(kickings) {
  if (!engine) return;
  const mine = ++run, over = () => mine !== run;
  score(kickings.length > 2 ? kickings.length : 1, 0);
  await engine.call("forget", []);
  if (over()) return;
  stage.ahead = [];
  stage.targets = [];
  flights = kickings.map(({ which, kick, colour }) => Object.assign(new Flown(++number, colour, which === 1 ? besideRadius : radius), { which, kick }));
  time = 0;
  rate = 1;
  playing = true;
  viewed = view;
  look();
  say("");
  hint(kickings.some(k => k.which === 1) ? `Blue: as set. Orange: ${$("panel").elements.beside.selectedOptions[0].text}.` : "");
  for (const flown of flights) {
    await engine.call("kick", [flown.number, flown.which, flights.length <= 2, ...flown.kick]);
    if (over()) return;
  }
  await simulate(flights, over);
}

// Continues the balls under the new dials from the present time on.
async function turn() {
  const mine = ++run, over = () => mine !== run, now = time;
  const balls = flights.map(f => Object.assign(new Flown(f.number, f.colour, f.radius), { which: f.which, kick: f.kick, scored: f.scored }));
  fill();
  await compile();
  if (over()) return;
  for (const flown of balls) {
    await engine.call("change", [flown.number, flown.which, now]);
    if (over()) return;
  }
  document.body.dataset.turned = String(now);
  await simulate(balls, over);
}

// Simulates balls to their end, ahead of the display, which shows them as soon as they have reached its time.
async function simulate(balls, over) {
  const things = new Map();
  const name = thing => things.get(thing) || "";
  while (balls.some(f => !f.isOver)) {
    for (const flown of balls.filter(f => !f.isOver)) {
      const rows = await engine.call("advance", [flown.number, balls.length > 1 ? 0.2 : 0.3]);
      if (over()) return;
      for (let i = 0; i < rows.length; i += ROWS[rows[i]]) {
        if (rows[i] === 1 && !things.has(rows[i + 2])) things.set(rows[i + 2], await engine.call("nameOf", [flown.number, rows[i + 2]]));
        if (over()) return;
      }
      flown.take(rows, name);
      // Of many balls, simulate only the part that is shown.
      flown.isOver = (balls.length > 2 && flown.end > decided(flown) + 0.1) || await engine.call("isOver", [flown.number]);
      if (over()) return;
      if (balls !== flights && balls.every(f => f.isOver || f.end > time)) flights = balls;
      document.body.dataset.flown = JSON.stringify(balls.map(f => ({ end: f.end, over: f.isOver, events: f.events.length })));
    }
  }
  if (balls.length === 1 && set.keeper > 0) {
    const answer = await engine.call("answer", [balls[0].number]);
    if (!over() && !$("hint").textContent) hint(answer);
  }
}

function kickOne() {
  const all = [{ which: 0, kick: kickOf(), colour: set.beside ? "#3aa0ff" : "#fff36b" }];
  if (set.beside) all.push({ which: 1, kick: kickOf(), colour: "#ff9a4d" });
  return kick(all);
}

// Kicks many balls with the spread of a player: 3 % of the speed, a degree or two, some spin.
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
  say("");
  if (view === "behind") viewed = viewed === "replay" ? "goal" : "replay";
  look();
  dirty = true;
}

// Finds the kick through a point of the goal's plane.
async function aimAt(p) {
  if (!engine) return;
  ready();
  hint("Looking for the kick …");
  const z = stage.picture.goals[0].center[2];
  const said = (await engine.call("aim", [p[0], p[1], z, set.speed, set.top, set.side], "aim"));
  if (!said || flights.length > 0) return;
  const [status, speed, elevation, azimuth, top, side, miss, at, blocked] = said.split("|");
  stage.targets = [[p[0], p[1], z]];
  document.body.dataset.aim = said;
  if (status === "Hit" || status === "WaypointMissed") {
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
