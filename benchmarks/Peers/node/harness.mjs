// Plays the shots against one engine and prints one line of JSON. native/harness.hpp and dotnet/Harness.cs do the same, experiment by experiment.
import { readFileSync } from "node:fs";
import { brotliCompressSync } from "node:zlib";

export const ball = { mass: 0.43, radius: 0.11, inertia: (2 / 3) * 0.43 * 0.11 * 0.11 };
export const gravity = 9.81;
export const restitution = 0.6;
export const friction = 0.5;
export const post = { z: -20, radius: 0.06, height: 2.5 };
// The lever arm of the rolling resistance, m, at which a rolling ball loses 1 m/s every second: 5 m/s lead 12.5 m far.
export const rollingArm = (ball.radius * (1 + 2 / 3)) / gravity;
const frame = 1 / 60;
const none = [0, 0, 0];

function read(path) {
  const shots = { drop: [], post: [], kick: [] };
  for (const line of readFileSync(path, "utf8").trim().split("\n")) {
    const [kind, ...numbers] = line.split(" ");
    shots[kind].push(numbers.map(Number));
  }

  return shots;
}

// An engine has: name, version, build, saved, canCcd, alwaysCcd, canRoll, many, and create(options). That returns a world with
// add(position, velocity, spin), step(h), get(i) -> 13 numbers (position, orientation, velocity, spin), set(i, 13 numbers), save(), restore(saved), bytes(saved), free().
export function run(engine, path) {
  const shots = read(path);
  // From the start of node's own code to the first step: the modules are read and compiled, and the engine is initialised.
  firstStep(engine, shots);
  const loadMs = performance.now() - performance.nodeTiming.bootstrapComplete;
  const result = { name: engine.name, version: engine.version, build: engine.build, saved: engine.saved, loadMs };
  // The files that a page loads, each compressed with brotli as by a web server.
  result.kib = engine.files.reduce((sum, file) => sum + brotliCompressSync(readFileSync(file)).length, 0) / 1024;
  result.cost1 = costOfOne(engine, shots);
  result.cost10k = engine.many === false ? null : costOfMany(engine, shots);
  Object.assign(result, bounce(engine, shots));
  result.post60 = engine.alwaysCcd ? null : posts(engine, shots, false, 60);
  result.post240 = engine.alwaysCcd ? null : posts(engine, shots, false, 240);
  result.postCcd = engine.canCcd ? posts(engine, shots, true, 60) : null;
  result.roll = engine.canRoll ? roll(engine) : null;
  Object.assign(result, predict(engine, shots));
  Object.assign(result, restore(engine, shots));
  result.same = same(engine, shots);
  console.log(JSON.stringify(result));
}

function firstStep(engine, shots) {
  const world = engine.create({ ground: true, step: frame });
  world.add(...kicked(shots.kick[0]));
  world.step(frame);
  world.free();
}

const kicked = (kick) => [[0, 1, 0], kick.slice(0, 3), kick.slice(3, 6)];

function costOfOne(engine, shots) {
  const world = engine.create({ ground: true, step: frame });
  world.add(...kicked(shots.kick[0]));
  const start = world.get(0);
  let least = Infinity;
  for (let round = 0; round < 400; round++) {
    world.set(0, start);
    const from = process.hrtime.bigint();
    for (let i = 0; i < 60; i++) world.step(frame);
    least = Math.min(least, Number(process.hrtime.bigint() - from) / 60);
  }

  world.free();
  return least;
}

// Balls do not collide with each other: every engine has the same contacts.
function costOfMany(engine, shots) {
  const count = 10000;
  let least = Infinity;
  const world = engine.create({ ground: true, step: frame, count });
  const starts = [];
  for (let i = 0; i < count; i++) {
    const [, velocity, spin] = kicked(shots.kick[i]);
    world.add([3 * (i % 100), 1, 3 * Math.floor(i / 100)], velocity, spin);
  }

  for (let i = 0; i < count; i++) starts.push(world.get(i));
  world.ready?.();
  for (let round = 0; round < 10; round++) {
    for (let i = 0; i < count; i++) world.set(i, starts[i]);
    const from = process.hrtime.bigint();
    for (let i = 0; i < 60; i++) world.step(frame);
    least = Math.min(least, Number(process.hrtime.bigint() - from) / 60 / count);
  }

  world.free();
  return least;
}

// The greatest height between the first bounce and the second. A frame of more than 1/60 s becomes equal steps of at most 1/60 s: manuals ask for it.
function apex(engine, from, frameTime) {
  const parts = Math.max(1, Math.ceil(frameTime * 60 - 0.01));
  const h = frameTime / parts;
  const world = engine.create({ ground: true, vacuum: true, step: h });
  world.add([0, from, 0], none, none);
  let [top, rises] = [0, false];
  for (let i = 0; i * h < 3; i++) {
    world.step(h);
    const s = world.get(0);
    if (s[8] > 0) rises = true;
    if (rises) top = Math.max(top, s[1]);
    if (rises && s[8] < 0) break;
  }

  world.free();
  return top;
}

function bounce(engine, shots) {
  const tops = [0.005, 0.01, frame, 0.04].map((h) => apex(engine, 2, h));
  const drops = shots.drop.map(([from]) => Math.sqrt((apex(engine, from, frame) - ball.radius) / (from - ball.radius)));
  return { tops, reboundLow: Math.min(...drops), reboundHigh: Math.max(...drops) };
}

// A hit turns the ball by more than 2 degrees, or back.
function posts(engine, shots, ccd, rate) {
  let hits = 0;
  for (const [x, z] of shots.post) {
    const world = engine.create({ post: true, ccd, step: 1 / rate });
    world.add([x, 1, z], [0, 3, -40], none);
    for (let i = 0; i < 0.75 * rate; i++) world.step(1 / rate);
    const s = world.get(0);
    if (-s[9] < Math.cos(Math.PI / 90) * Math.hypot(s[7], s[9])) hits++;
    world.free();
  }

  return hits;
}

function roll(engine) {
  const world = engine.create({ ground: true, rolling: true, vacuum: true, step: frame });
  world.add([0, ball.radius, 0], [0, 0, -5], [-5 / ball.radius, 0, 0]);
  for (let i = 0; i < 1800; i++) world.step(frame);
  const distance = -world.get(0)[2];
  world.free();
  return distance;
}

// A second world starts from the state that the first saved 40 steps after the kick, and runs 3 s ahead. How far is it from the first?
function predict(engine, shots) {
  let [least, off] = [Infinity, 0];
  const second = engine.create({ ground: true, step: frame });
  second.add([0, 1, 0], none, none);
  for (const kick of shots.kick.slice(0, 20)) {
    const world = engine.create({ ground: true, step: frame });
    world.add(...kicked(kick));
    for (let i = 0; i < 40; i++) world.step(frame);
    const state = world.save();
    let path;
    for (let round = 0; round < 5; round++) {
      const from = process.hrtime.bigint();
      second.restore(state);
      path = [];
      for (let i = 0; i < 180; i++) {
        second.step(frame);
        path.push(second.get(0));
      }

      least = Math.min(least, Number(process.hrtime.bigint() - from) / 1000);
    }

    for (const s of path) {
      world.step(frame);
      const t = world.get(0);
      off = Math.max(off, Math.hypot(s[0] - t[0], s[1] - t[1], s[2] - t[2]));
    }

    world.release?.(state);
    world.free();
  }

  second.free();
  return { predictUs: least, predictOff: off };
}

function path(world, steps) {
  const states = [];
  for (let i = 0; i < steps; i++) {
    world.step(frame);
    states.push(world.get(0));
  }

  return states;
}

const equal = (a, b) => a.every((s, i) => s.every((x, k) => Object.is(x, b[i][k])));

// Saves 40 steps after the kick, plays 120 steps, goes back and plays them again.
function restore(engine, shots) {
  let [least, bytes, again] = [Infinity, 0, 0];
  for (const kick of shots.kick.slice(0, 20)) {
    const world = engine.create({ ground: true, step: frame });
    world.add(...kicked(kick));
    path(world, 40);
    for (let round = 0; round < 5; round++) {
      const from = process.hrtime.bigint();
      for (let i = 0; i < 50; i++) {
        const saved = world.save();
        world.restore(saved);
        world.release?.(saved);
      }

      least = Math.min(least, Number(process.hrtime.bigint() - from) / 50);
    }

    const saved = world.save();
    bytes = world.bytes(saved);
    const first = path(world, 120);
    world.restore(saved);
    if (equal(first, path(world, 120))) again++;
    world.release?.(saved);
    world.free();
  }

  return { bytes, saveNs: least, again };
}

function same(engine, shots) {
  let count = 0;
  for (const kick of shots.kick.slice(0, 20)) {
    const paths = [0, 1].map(() => {
      const world = engine.create({ ground: true, post: true, step: frame });
      world.add(...kicked(kick));
      const states = path(world, 180);
      world.free();
      return states;
    });
    if (equal(paths[0], paths[1])) count++;
  }

  return count;
}
