// Football.Physics as WebAssembly. The library writes the numbers of a ball into its memory, and getters read them there. So a frame makes one call into the library.
const EVENT_NUMBERS = 22, PLACEMENT_NUMBERS = 15;
const ASSEMBLY = "Football.Physics.Web.dll";

// The events, in the order of their numbers in C#.
const FORCES = ["weight", "buoyancy", "drag", "magnus", "knuckle", "nets", "load", "friction", "sum", "acceleration"];
const EVENTS = ["impact", "slide", "roll", "rest", "net", "goal", "contactEnd", "pinned", "enterZone", "exitZone"];
const MOTIONS = ["airborne", "sliding", "rolling", "rest", "pinned"];

/** An input was rejected. The message names the field, the value and the allowed range. */
export class PhysicsError extends Error {
  constructor(message) {
    super(message);
    this.name = "PhysicsError";
  }
}

let loading = null;

/** Loads the library in this thread, once. */
export function load(options = {}) {
  loading ??= start(options).catch(error => { loading = null; throw error; });
  return loading;
}

/** Loads the library in its own worker. */
export async function loadWorker(options = {}) {
  const url = options.worker ?? new URL("./worker.js", import.meta.url);
  const { worker: _, ...rest } = options, { RemotePhysics } = await import("./remote.js");
  return RemotePhysics.start(new Worker(url, { type: "module" }), rest, PhysicsError);
}

async function start({ url, files }) {
  // Without this flag, the runtime treats a worker as one of its own threads.
  if (typeof WorkerGlobalScope !== "undefined") globalThis.dotnetSidecar = true;
  // The traces of the interpreter's compiler sum four numbers at once in another order, which changes the bits of the results.
  const settings = { runtimeOptions: ["--no-jiterpreter-traces-enabled"] };
  const runtime = files ? await fromMemory(files, settings) : await fromAddress(url ?? new URL("./runtime/", import.meta.url).href, settings);
  return new Physics(runtime, (await runtime.getAssemblyExports(ASSEMBLY)).FootballPhysics.Web.Engine);
}

async function fromAddress(url, settings) {
  const { dotnet } = await import(/* webpackIgnore: true */ /* @vite-ignore */ url + "dotnet.js");
  return dotnet.withConfig(settings).create();
}

// Loads the library in a page of one file. Its scripts have blob addresses, and no address can be relative to a blob.
async function fromMemory(files, settings) {
  const script = name => URL.createObjectURL(new Blob([files[name]], { type: "text/javascript" })), Whole = URL;
  globalThis.URL = class extends Whole {
    constructor(address, base) { super(address, base && String(base).startsWith("blob:") ? "https://page.invalid/" : base); }
  };
  try {
    const { dotnet } = await import(/* webpackIgnore: true */ /* @vite-ignore */ script("dotnet.js"));
    return await dotnet.withConfig(settings).withResourceLoader((type, name) =>
      name.endsWith(".js") ? script(name) : Promise.resolve(new Response(files[name], { headers: { "Content-Type": "application/wasm" } }))).create();
  } finally {
    globalThis.URL = Whole;
  }
}

function run(call, ...args) {
  try {
    return call(...args);
  } catch (error) {
    throw new PhysicsError(error.message);
  }
}

function refuse(name, value, allowed) {
  const text = typeof value === "string" ? JSON.stringify(value) : typeof value === "object" && value ? JSON.stringify(value) : String(value);
  throw new PhysicsError(`${name} is ${text}; allowed: ${allowed}.`);
}

function number(name, value) {
  return typeof value === "number" ? value : refuse(name, value, "a number");
}

/** Returns [x, y, z] of an array or of an object with x, y and z. */
function vector(name, value) {
  const v = value && typeof value.x === "number" ? [value.x, value.y, value.z] : value;
  return v && v.length === 3 && typeof v[0] === "number" && typeof v[1] === "number" && typeof v[2] === "number" ? v : refuse(name, value, "[x, y, z]");
}

function quaternion(name, value) {
  const q = value && typeof value.w === "number" ? [value.x, value.y, value.z, value.w] : value;
  return q && q.length === 4 && Array.prototype.every.call(q, part => typeof part === "number") ? q : refuse(name, value, "[x, y, z, w]");
}

class Physics {
  constructor(runtime, engine) {
    this.runtime = runtime;
    this.engine = engine;
    this.scenes = new FinalizationRegistry(id => engine.FreeScene(id));
    this.freed = new FinalizationRegistry(id => engine.FreeBall(id));
  }

  // Create a new view each time, because the memory may have grown.
  get heap() { return this.runtime.localHeapViewF64(); }

  get about() { return this.read ??= JSON.parse(this.engine.Names()); }

  get version() { return this.about.version; }

  get balls() { return this.about.balls; }

  get grounds() { return this.about.grounds; }

  get materials() { return this.about.materials; }

  scene(description = {}) { return new Scene(this, description); }

  ball(description = {}) { return this.scene(description).ball(); }

  kickVectors({ speed, elevation = 0, azimuth = 0, topSpin = 0, sideSpin = 0 }) {
    const v = run(this.engine.KickVector, number("speed", speed), number("elevation", elevation), number("azimuth", azimuth), number("topSpin", topSpin), number("sideSpin", sideSpin));
    return { velocity: v.slice(0, 3), spin: v.slice(3, 6) };
  }

  goldenHashes(every = 1) {
    return Number.isInteger(every) && every > 0 ? this.engine.Golden(every).split("\n") : refuse("every", every, "a whole number from 1");
  }

  eventsAt(address, count, scene) {
    // Read the names first: a call can move the memory.
    const { names } = scene, heap = this.heap, events = [];
    for (let i = 0, at = address >>> 3; i < count; i++, at += EVENT_NUMBERS) {
      const three = from => Array.from(heap.subarray(at + from, at + from + 3)), collider = heap[at + 1];
      events.push({
        kind: EVENTS[heap[at]], name: names[collider] ?? "", collider, time: heap[at + 2], position: three(3),
        velocityBefore: three(6), velocity: three(9), spinBefore: three(12), spin: three(15), normal: three(18), addedEnergy: heap[at + 21],
      });
    }
    return events;
  }
}

class Scene {
  constructor(physics, description) {
    this.physics = physics;
    this.id = run(physics.engine.CreateScene, typeof description === "string" ? description : JSON.stringify(description) ?? "undefined");
    const memory = run(physics.engine.BodyMemory, this.id) >>> 3, names = run(physics.engine.BodyNames, this.id);
    this.bodies = names.map((name, i) => new Body(this, name, i, memory + PLACEMENT_NUMBERS * i));
    physics.scenes.register(this, this.id, this);
  }

  // Parse the description on first use only: parsing takes longer than the first ball.
  get about() { return this.read ??= JSON.parse(run(this.physics.engine.DescribeScene, this.id)); }

  get names() { return this.called ??= run(this.physics.engine.SceneNames, this.id); }

  get radius() { return this.about.radius; }

  get kinematicViscosity() { return this.about.kinematicViscosity; }

  get hash() { return this.about.hash; }

  get shapes() { return this.about.shapes; }

  get goals() { return this.about.goals; }

  ball() { return new Ball(this); }

  body(name) { return this.bodies.find(body => body.name === name) ?? refuse("body", name, this.bodies.map(body => body.name).join(" | ") || "none: the scene has no bodies"); }

  aim(request) { return JSON.parse(run(this.physics.engine.Aim, this.id, JSON.stringify(request) ?? "undefined")); }

  free() {
    this.physics.scenes.unregister(this);
    this.physics.engine.FreeScene(this.id);
    this.id = -1;
  }
}

class Body {
  constructor(scene, name, index, memory) {
    Object.assign(this, { scene, name, index, memory });
  }

  place(position, { velocity = [0, 0, 0], spin = [0, 0, 0], orientation, time = NaN } = {}) {
    const p = vector("position", position), v = vector("velocity", velocity), s = vector("spin", spin), q = orientation === undefined ? null : quaternion("orientation", orientation);
    const heap = this.memoryOfScene(), at = this.memory;
    heap[at + 1] = number("time", time);
    heap.set(p, at + 2);
    heap.set(v, at + 5);
    heap.set(s, at + 8);
    if (q) heap.set(q, at + 11);
    // An orientation stays until the next step, even if a later placement has none.
    heap[at] = q || heap[at] === 2 ? 2 : 1;
  }

  withdraw() { this.memoryOfScene()[this.memory] = 3; }

  // Throw if the scene is freed: its memory may belong to another object now.
  memoryOfScene() {
    if (this.scene.id < 0) throw new PhysicsError("The scene was freed. Create a new one.");
    return this.scene.physics.heap;
  }

  state() {
    const n = run(this.scene.physics.engine.Body, this.scene.id, this.index);
    return { position: n.slice(0, 3), velocity: n.slice(3, 6), spin: n.slice(6, 9), orientation: n.slice(9, 13) };
  }
}

class Ball {
  constructor(scene) {
    const { physics } = scene;
    this.scene = scene;
    this.physics = physics;
    this.engine = physics.engine;
    this.id = run(physics.engine.CreateBall, scene.id);
    this.memory = run(physics.engine.BallMemory, this.id) >>> 3;
    physics.freed.register(this, this.id, this);
  }

  get time() { return this.physics.heap[this.memory]; }

  get position() { return this.numbers(1, 3); }

  get velocity() { return this.numbers(4, 3); }

  get spin() { return this.numbers(7, 3); }

  get orientation() { return this.numbers(10, 4); }

  get motion() { return MOTIONS[this.physics.heap[this.memory + 14]]; }

  get events() {
    const heap = this.physics.heap;
    return this.physics.eventsAt(heap[this.memory + 16], heap[this.memory + 15], this.scene);
  }

  impact(index) {
    const [normalImpulse, tangentialImpulse, slipBefore, slipAfter, grips, contactTime, compression, peakForce, energyLost] = run(this.engine.Impact, this.id, number("index", index));
    return { normalImpulse, tangentialImpulse, slipBefore, slipAfter, grips: grips === 1, contactTime, compression, peakForce, energyLost };
  }

  impactSound(index, rate = 48000) {
    const n = run(this.engine.ImpactSound, this.id, number("index", index), number("rate", rate));
    return { loudness: n[0], brightness: n[1], brush: n[2], samples: Float32Array.from(n.slice(3)) };
  }

  squash() {
    const [along, across, ...axis] = run(this.engine.Squash, this.id);
    return { along, across, axis };
  }

  forces(dt = 1 / 60) {
    const numbers = run(this.engine.Forces, this.id, number("dt", dt));
    if (numbers.length === 0) return null;
    const at = i => Array.from(numbers.slice(i, i + 3)), forces = { contacts: [] };
    FORCES.forEach((name, i) => { forces[name] = at(3 * i); });
    for (let i = 3 * FORCES.length; i < numbers.length; i += 13) {
      forces.contacts.push({ name: this.scene.names[numbers[i]] ?? "", point: at(i + 1), normal: at(i + 4), load: at(i + 7), friction: at(i + 10) });
    }
    return forces;
  }

  numbers(from, count) { return Array.from(this.physics.heap.subarray(this.memory + from, this.memory + from + count)); }

  place(position) { run(this.engine.Place, this.id, ...vector("position", position)); }

  launch(position, velocity, spin = [0, 0, 0]) { run(this.engine.Launch, this.id, ...vector("position", position), ...vector("velocity", velocity), ...vector("spin", spin)); }

  restart(position, { velocity = [0, 0, 0], spin = [0, 0, 0], orientation = [0, 0, 0, 1] } = {}) {
    run(this.engine.Restart, this.id, [...vector("position", position), ...vector("velocity", velocity), ...vector("spin", spin), ...quaternion("orientation", orientation)]);
  }

  kick(velocity, spin = [0, 0, 0]) {
    const kick = velocity && velocity.speed !== undefined ? this.physics.kickVectors(velocity) : { velocity, spin };
    run(this.engine.Kick, this.id, ...vector("velocity", kick.velocity), ...vector("spin", kick.spin));
  }

  step(dt) { run(this.engine.Step, this.id, number("dt", dt)); }

  lookAhead(seconds, samples = 60, { timeStep = 0.01, stopAt = "rest" } = {}) {
    const address = run(this.engine.LookAhead, this.id, number("seconds", seconds), number("samples", samples), number("timeStep", timeStep), String(stopAt)) >>> 3;
    return this.physics.heap.slice(address, address + 4 * samples);
  }

  lookAheadEnd() { return run(this.engine.LookAheadEnd, this.id); }

  lookAheadEvents() {
    const [count, address] = run(this.engine.LookAheadEvents, this.id);
    return this.physics.eventsAt(address, count, this.scene);
  }

  keeper(player, goal = 0) { return JSON.parse(run(this.engine.Keeper, this.id, JSON.stringify(player) ?? "undefined", number("goal", goal))); }

  bulges() {
    const n = run(this.engine.Bulges, this.id), bulges = [];
    for (let i = 0; i < n.length; i += 7) bulges.push({ depth: n[i], position: n.slice(i + 1, i + 4), direction: n.slice(i + 4, i + 7) });
    return bulges;
  }

  hash() { return run(this.engine.Hash, this.id); }

  save() { return run(this.engine.Save, this.id).slice(); }

  restore(bytes) { run(this.engine.Restore, this.id, bytes instanceof Uint8Array ? bytes : refuse("bytes", bytes, "a Uint8Array of save()")); }

  free() {
    this.physics.freed.unregister(this);
    this.physics.engine.FreeBall(this.id);
    // Prevent reads from the memory of a freed ball.
    this.id = this.memory = -1;
  }
}
