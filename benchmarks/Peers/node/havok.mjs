// node havok.mjs SHOTS
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import HavokPhysics from "@babylonjs/havok";
import { ball, friction, gravity, post, restitution, run } from "./harness.mjs";

const folder = new URL("./node_modules/@babylonjs/havok/", import.meta.url);
const hk = await HavokPhysics({ wasmBinary: readFileSync(new URL("lib/esm/HavokPhysics.wasm", folder)) });
const upright = [0, 0, 0, 1];
const material = [friction, friction, restitution, hk.MaterialCombine.MINIMUM, hk.MaterialCombine.MAXIMUM];

// Every call returns a result code first.
const ok = ([code, ...values]) => {
  if (code !== hk.Result.RESULT_OK) throw new Error(`Havok returned ${code}`);
  return values[0];
};

function create({ ground, post: withPost, step }) {
  const world = ok(hk.HP_World_Create());
  hk.HP_World_SetGravity(world, [0, -gravity, 0]);
  hk.HP_World_SetIdealStepTime(world, step);
  const shapes = [];
  const made = [];
  function shapeOf(shape, member, collidesWith) {
    hk.HP_Shape_SetMaterial(shape, material);
    hk.HP_Shape_SetFilterInfo(shape, [member, collidesWith]);
    shapes.push(shape);
    return shape;
  }

  function body(shape, type, position) {
    const id = ok(hk.HP_Body_Create());
    hk.HP_Body_SetShape(id, shape);
    hk.HP_Body_SetMotionType(id, type);
    hk.HP_Body_SetQTransform(id, [position, upright]);
    made.push(id);
    return id;
  }

  const fix = (shape) => hk.HP_World_AddBody(world, body(shapeOf(shape, 2, 1), hk.MotionType.STATIC, [0, 0, 0]), false);
  if (ground) fix(ok(hk.HP_Shape_CreateBox([0, -1, 0], upright, [2000, 2, 2000])));
  if (withPost) fix(ok(hk.HP_Shape_CreateCapsule([0, 0, post.z], [0, post.height, post.z], post.radius)));
  const sphere = shapeOf(ok(hk.HP_Shape_CreateSphere([0, 0, 0], ball.radius)), 1, 2);
  const unit = ball.inertia / ball.mass;
  const bodies = [];
  return {
    add(position, velocity, spin) {
      const id = body(sphere, hk.MotionType.DYNAMIC, position);
      hk.HP_Body_SetMassProperties(id, [[0, 0, 0], ball.mass, [unit, unit, unit], upright]);
      hk.HP_Body_SetLinearDamping(id, 0);
      hk.HP_Body_SetAngularDamping(id, 0);
      hk.HP_World_AddBody(world, id, false);
      hk.HP_Body_SetLinearVelocity(id, velocity);
      hk.HP_Body_SetAngularVelocity(id, spin);
      bodies.push(id);
    },
    step: (h) => hk.HP_World_Step(world, h),
    get(i) {
      const [p, q] = ok(hk.HP_Body_GetQTransform(bodies[i]));
      return [...p, ...q, ...ok(hk.HP_Body_GetLinearVelocity(bodies[i])), ...ok(hk.HP_Body_GetAngularVelocity(bodies[i]))];
    },
    set(i, s) {
      hk.HP_Body_SetQTransform(bodies[i], [s.slice(0, 3), s.slice(3, 7)]);
      hk.HP_Body_SetLinearVelocity(bodies[i], s.slice(7, 10));
      hk.HP_Body_SetAngularVelocity(bodies[i], s.slice(10, 13));
    },
    save() { return this.get(0); },
    restore(saved) { this.set(0, saved); },
    bytes: (saved) => 4 * saved.length,
    free() {
      for (const id of made) {
        hk.HP_World_RemoveBody(world, id);
        hk.HP_Body_Release(id);
      }

      for (const shape of shapes) hk.HP_Shape_Release(shape);
      hk.HP_World_Release(world);
    },
  };
}

run({
  name: "Havok",
  version: `(@babylonjs/havok ${JSON.parse(readFileSync(new URL("package.json", folder))).version})`,
  build: "WebAssembly, node",
  saved: "by hand",
  files: [fileURLToPath(import.meta.resolve("@babylonjs/havok")), new URL("lib/esm/HavokPhysics.wasm", folder)],
  // The module has no switch: every body is swept.
  alwaysCcd: true,
  canCcd: true,
  canRoll: false,
  create,
}, process.argv[2]);
