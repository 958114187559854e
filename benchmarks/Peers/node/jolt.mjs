// node jolt.mjs SHOTS
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import initJolt from "jolt-physics/wasm-compat";
import { ball, friction, gravity, post, restitution, run } from "./harness.mjs";

const Jolt = await initJolt();
const [fixedLayer, ballLayer] = [0, 1];

// As in the examples of JoltPhysics.js: one broad-phase layer for fixed objects and one for moving objects.
function settingsOf(count) {
  const settings = new Jolt.JoltSettings();
  settings.mMaxWorkerThreads = 0;
  if (count) settings.mMaxBodies = settings.mMaxBodyPairs = settings.mMaxContactConstraints = 2 * count;
  const pairs = new Jolt.ObjectLayerPairFilterTable(2);
  pairs.EnableCollision(fixedLayer, ballLayer);
  const layers = new Jolt.BroadPhaseLayerInterfaceTable(2, 2);
  const [still, moving] = [new Jolt.BroadPhaseLayer(0), new Jolt.BroadPhaseLayer(1)];
  layers.MapObjectToBroadPhaseLayer(fixedLayer, still);
  layers.MapObjectToBroadPhaseLayer(ballLayer, moving);
  Jolt.destroy(still);
  Jolt.destroy(moving);
  settings.mObjectLayerPairFilter = pairs;
  settings.mBroadPhaseLayerInterface = layers;
  settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 2, pairs, 2);
  return settings;
}

function create({ ground, post: withPost, ccd, count }) {
  const settings = settingsOf(count);
  const jolt = new Jolt.JoltInterface(settings);
  Jolt.destroy(settings);
  const system = jolt.GetPhysicsSystem();
  const bodiesOf = system.GetBodyInterface();
  const vector = (x, y, z) => new Jolt.Vec3(x, y, z);
  const place = (x, y, z) => new Jolt.RVec3(x, y, z);
  const using = (...objects) => { for (const o of objects.slice(1)) Jolt.destroy(o); return objects[0]; };
  const g = vector(0, -gravity, 0);
  using(system.SetGravity(g), g);
  const identity = new Jolt.Quat(0, 0, 0, 1);

  function fix(shape, x, y, z) {
    const at = place(x, y, z);
    const creation = new Jolt.BodyCreationSettings(shape, at, identity, Jolt.EMotionType_Static, fixedLayer);
    creation.mRestitution = restitution;
    creation.mFriction = friction;
    const body = bodiesOf.CreateBody(creation);
    bodiesOf.AddBody(body.GetID(), Jolt.EActivation_DontActivate);
    using(0, at, creation);
  }

  if (ground) {
    const up = vector(0, 1, 0);
    const plane = new Jolt.Plane(up, 0);
    fix(new Jolt.PlaneShape(plane, null, 1000), 0, 0, 0);
    using(0, up, plane);
  }

  if (withPost) fix(new Jolt.CapsuleShape(post.height / 2, post.radius), 0, post.height / 2, post.z);
  const sphere = new Jolt.SphereShape(ball.radius);
  sphere.AddRef();
  const bodies = [];
  return {
    add(position, velocity, spin) {
      const [at, v, w] = [place(...position), vector(...velocity), vector(...spin)];
      const creation = new Jolt.BodyCreationSettings(sphere, at, identity, Jolt.EMotionType_Dynamic, ballLayer);
      creation.mRestitution = restitution;
      creation.mFriction = friction;
      creation.mLinearDamping = creation.mAngularDamping = 0;
      // A solid sphere of the shape is replaced by a thin shell: the moment of inertia times 5/3.
      creation.mOverrideMassProperties = Jolt.EOverrideMassProperties_CalculateInertia;
      creation.mMassPropertiesOverride.mMass = ball.mass;
      creation.mInertiaMultiplier = 5 / 3;
      // The default of 47 rad/s would slow the fastest kicks.
      creation.mMaxAngularVelocity = 100;
      creation.mMotionQuality = ccd ? Jolt.EMotionQuality_LinearCast : Jolt.EMotionQuality_Discrete;
      creation.mLinearVelocity = v;
      creation.mAngularVelocity = w;
      const body = bodiesOf.CreateBody(creation);
      bodiesOf.AddBody(body.GetID(), Jolt.EActivation_Activate);
      bodies.push(body);
      using(0, at, v, w, creation);
    },
    ready: () => system.OptimizeBroadPhase(),
    // The documentation: one collision step per 1/60 s. No step here is longer.
    step: (h) => jolt.Step(h, 1),
    get(i) {
      const [p, q, v, w] = [bodies[i].GetPosition(), bodies[i].GetRotation(), bodies[i].GetLinearVelocity(), bodies[i].GetAngularVelocity()];
      return [p.GetX(), p.GetY(), p.GetZ(), q.GetX(), q.GetY(), q.GetZ(), q.GetW(), v.GetX(), v.GetY(), v.GetZ(), w.GetX(), w.GetY(), w.GetZ()];
    },
    set(i, s) {
      const [at, q, v, w] = [place(s[0], s[1], s[2]), new Jolt.Quat(s[3], s[4], s[5], s[6]), vector(s[7], s[8], s[9]), vector(s[10], s[11], s[12])];
      const id = bodies[i].GetID();
      bodiesOf.SetPositionAndRotation(id, at, q, Jolt.EActivation_Activate);
      bodiesOf.SetLinearAndAngularVelocity(id, v, w);
      using(0, at, q, v, w);
    },
    save() {
      const recorder = new Jolt.StateRecorderImpl();
      system.SaveState(recorder);
      return recorder;
    },
    restore(recorder) {
      recorder.Rewind();
      system.RestoreState(recorder);
    },
    release: (recorder) => Jolt.destroy(recorder),
    bytes() {
      let size = 0;
      const counter = new Jolt.StateRecorderJS();
      counter.WriteBytes = (data, count) => { size += count; };
      counter.ReadBytes = () => {};
      counter.IsEOF = () => false;
      counter.IsFailed = () => false;
      system.SaveState(counter);
      Jolt.destroy(counter);
      return size;
    },
    free() {
      sphere.Release();
      Jolt.destroy(identity);
      Jolt.destroy(jolt);
    },
  };
}

run({
  name: "Jolt",
  version: `(jolt-physics ${JSON.parse(readFileSync(new URL("./node_modules/jolt-physics/package.json", import.meta.url))).version})`,
  build: "WebAssembly, node",
  saved: "world",
  files: [fileURLToPath(import.meta.resolve("jolt-physics/wasm-compat"))],
  canCcd: true,
  canRoll: false,
  create,
}, process.argv[2]);
