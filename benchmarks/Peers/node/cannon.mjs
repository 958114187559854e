// node cannon.mjs SHOTS
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import * as CANNON from "cannon-es";
import { ball, friction, gravity, post, restitution, run } from "./harness.mjs";

// The broad phase leaves its sweep at the first pair out of reach, but looks at the filter first: with balls that ignore each other it never leaves.
class Sweep extends CANNON.SAPBroadphase {
  needBroadphaseCollision() { return true; }
  intersectionTest(a, b, first, second) {
    if (super.needBroadphaseCollision(a, b)) super.intersectionTest(a, b, first, second);
  }
}

function create({ ground, post: withPost, step, count }) {
  const world = new CANNON.World({ gravity: new CANNON.Vec3(0, -gravity, 0) });
  // The documentation recommends the sweep-and-prune broad phase for many bodies.
  if (count) {
    world.broadphase = new Sweep(world);
    // The default matrices are arrays over all pairs and exceed the heap with 10,000 bodies.
    world.collisionMatrix = new CANNON.ObjectCollisionMatrix();
    world.collisionMatrixPrevious = new CANNON.ObjectCollisionMatrix();
  }

  const material = new CANNON.Material();
  // Relaxation 3, the default, applies 12/13 of the restitution and adds speed for the depth. 10 is the greatest value in cannon-es's own examples.
  world.addContactMaterial(new CANNON.ContactMaterial(material, material, { friction, restitution, contactEquationRelaxation: 10 }));
  const fixed = (shape) => new CANNON.Body({ mass: 0, shape, material, collisionFilterGroup: 2, collisionFilterMask: 1 });
  if (ground) {
    const plane = fixed(new CANNON.Plane());
    plane.quaternion.setFromEuler(-Math.PI / 2, 0, 0);
    world.addBody(plane);
  }

  if (withPost) {
    const cylinder = fixed(new CANNON.Cylinder(post.radius, post.radius, post.height, 16));
    cylinder.position.set(0, post.height / 2, post.z);
    world.addBody(cylinder);
  }

  const bodies = [];
  return {
    add(position, velocity, spin) {
      const body = new CANNON.Body({
        mass: ball.mass,
        shape: new CANNON.Sphere(ball.radius),
        material,
        linearDamping: 0,
        angularDamping: 0,
        position: new CANNON.Vec3(...position),
        velocity: new CANNON.Vec3(...velocity),
        angularVelocity: new CANNON.Vec3(...spin),
        collisionFilterGroup: 1,
        collisionFilterMask: 2,
      });
      body.inertia.set(ball.inertia, ball.inertia, ball.inertia);
      body.invInertia.set(1 / ball.inertia, 1 / ball.inertia, 1 / ball.inertia);
      body.updateInertiaWorld(true);
      world.addBody(body);
      bodies.push(body);
    },
    step: (h) => world.step(h),
    get(i) {
      const { position: p, quaternion: q, velocity: v, angularVelocity: w } = bodies[i];
      return [p.x, p.y, p.z, q.x, q.y, q.z, q.w, v.x, v.y, v.z, w.x, w.y, w.z];
    },
    set(i, s) {
      bodies[i].position.set(s[0], s[1], s[2]);
      bodies[i].quaternion.set(s[3], s[4], s[5], s[6]);
      bodies[i].velocity.set(s[7], s[8], s[9]);
      bodies[i].angularVelocity.set(s[10], s[11], s[12]);
      bodies[i].aabbNeedsUpdate = true;
    },
    save() { return this.get(0); },
    restore(saved) { this.set(0, saved); },
    bytes: (saved) => 8 * saved.length,
    free() {},
  };
}

run({
  name: "cannon-es",
  version: JSON.parse(readFileSync(new URL("./node_modules/cannon-es/package.json", import.meta.url))).version,
  build: "JavaScript, node",
  saved: "by hand",
  files: [fileURLToPath(import.meta.resolve("cannon-es"))],
  canCcd: false,
  canRoll: false,
  create,
}, process.argv[2]);
