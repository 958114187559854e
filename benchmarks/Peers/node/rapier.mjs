// node rapier.mjs SHOTS PACKAGE
import { fileURLToPath } from "node:url";
import { ball, friction, gravity, post, restitution, run } from "./harness.mjs";

const name = process.argv[3] ?? "@dimforge/rapier3d-compat";
const { default: RAPIER } = await import(name);
await RAPIER.init();
const deterministic = name.includes("deterministic");

// Balls are in group 1 and collide with group 2 only.
const balls = (1 << 16) | 2;
const fixed = (2 << 16) | 1;

function create({ ground, post: withPost, ccd, step }) {
  let world = new RAPIER.World({ x: 0, y: -gravity, z: 0 });
  world.timestep = step;
  // Rapier sweeps fast bodies against fixed colliders by default: 0 substeps turn that off, for the rows without CCD.
  if (ccd === false) world.maxCcdSubsteps = 0;
  const surface = (desc) => world.createCollider(desc.setRestitution(restitution).setFriction(friction).setCollisionGroups(fixed));
  if (ground) surface(RAPIER.ColliderDesc.cuboid(1000, 1, 1000).setTranslation(0, -1, 0));
  if (withPost) surface(RAPIER.ColliderDesc.capsule(post.height / 2, post.radius).setTranslation(0, post.height / 2, post.z));
  const handles = [];
  let bodies = [];
  const vector = ([x, y, z]) => ({ x, y, z });
  return {
    add(position, velocity, spin) {
      const body = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(...position).setLinvel(...velocity).setAngvel(vector(spin)).setCcdEnabled(!!ccd));
      const i = ball.inertia;
      world.createCollider(
        RAPIER.ColliderDesc.ball(ball.radius)
          .setMassProperties(ball.mass, { x: 0, y: 0, z: 0 }, { x: i, y: i, z: i }, { x: 0, y: 0, z: 0, w: 1 })
          .setRestitution(restitution)
          .setFriction(friction)
          .setCollisionGroups(balls),
        body);
      handles.push(body.handle);
      bodies.push(body);
    },
    step: () => world.step(),
    get(i) {
      const [p, q, v, w] = [bodies[i].translation(), bodies[i].rotation(), bodies[i].linvel(), bodies[i].angvel()];
      return [p.x, p.y, p.z, q.x, q.y, q.z, q.w, v.x, v.y, v.z, w.x, w.y, w.z];
    },
    set(i, s) {
      bodies[i].setTranslation(vector(s), true);
      bodies[i].setRotation({ x: s[3], y: s[4], z: s[5], w: s[6] }, true);
      bodies[i].setLinvel(vector(s.slice(7)), true);
      bodies[i].setAngvel(vector(s.slice(10)), true);
    },
    save: () => world.takeSnapshot(),
    restore(saved) {
      world.free();
      world = RAPIER.World.restoreSnapshot(saved);
      bodies = handles.map((handle) => world.getRigidBody(handle));
    },
    bytes: (saved) => saved.length,
    free: () => world.free(),
  };
}

run({
  name: deterministic ? "Rapier, deterministic" : "Rapier",
  version: RAPIER.version(),
  build: "WebAssembly, node",
  saved: "world",
  files: [fileURLToPath(import.meta.resolve(name))],
  canCcd: true,
  canRoll: false,
  create,
}, process.argv[2]);
