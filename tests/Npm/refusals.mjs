// Bad input: each call must throw the library's one message, and leave the ball as it was.
import assert from "node:assert/strict";
import { load, PhysicsError } from "football-physics";

const physics = await load();
const scene = physics.scene({ bodies: [{ name: "leg", shape: "sphere", center: [0, 0, 0], radius: 0.1 }] }), ball = scene.ball();
ball.kick([3, 8, -22]);
ball.step(0.1);
const hash = ball.hash();
const freed = physics.scene({ bodies: [{ shape: "sphere", center: [0, 0, 0], radius: 0.1 }] });
freed.free();
const gone = physics.ball();
gone.free();
const cases = [
  [() => ball.kick([1e4, 0, 0]), "launch.velocity is (10000, 0, 0); allowed: finite components, size at most 1000 m/s."],
  [() => ball.kick([1, 0]), "velocity is [1,0]; allowed: [x, y, z]."],
  [() => ball.kick({ speed: -1 }), /^speed is -1; allowed: 0 … 1000\.$/],
  [() => ball.restart([0, 1, 0], { spin: [2e4, 0, 0] }), "place.spin is (20000, 0, 0); allowed: finite components, size at most 10000 rad/s."],
  [() => ball.restart([0, 1, 0], { orientation: [0, 0, 1] }), "orientation is [0,0,1]; allowed: [x, y, z, w]."],
  [() => ball.step(-1), "dt is -1; allowed: 0 … 1000000000000."],
  [() => ball.step("0.1"), "dt is \"0.1\"; allowed: a number."],
  [() => ball.step(NaN), /^dt is NaN; allowed: 0 … /],
  [() => ball.lookAhead(1, 1), "samples is 1; allowed: 2 … 1000000."],
  [() => ball.lookAhead(1, 10, { stopAt: "goal" }), "stopAt is goal; allowed: rest, impact, time."],
  [() => ball.lookAhead(-1), /^lookAhead\.duration is -1; allowed: /],
  [() => ball.restore(new Uint8Array(228)), /damaged|checksum/i],
  [() => ball.keeper({ position: [0, 0, 0] }), /^goal is 0; allowed: /],
  [() => physics.scene("{"), /^the input is cut off after byte 1; allowed: strict JSON/],
  [() => physics.scene(null), /^the scenario is null; allowed: an object /],
  [() => physics.scene({ ball: { mass: 1000 } }), "ball.mass is 1000; allowed: 0.001 … 100."],
  [() => physics.scene({ ground: { slidingFriction: "x" } }), "ground.slidingFriction is \"x\"; allowed: 0 … 10."],
  [() => physics.scene({ bals: 1 }), /^bals is unknown .* did you mean ball\?$/],
  [() => physics.scene({ bodies: [{ shape: "sphere", center: [0, 0, 0], radius: -1 }] }), /^bodies\[0\].*radius is -1; allowed: /],
  [() => scene.aim({}), "from is missing; allowed: [x, y, z], 3 finite numbers."],
  [() => scene.aim({ from: [0, 0, 0], target: [0, 1, -20], through: [0, 2, -10], targetVelocity: [1, 0, 0], speed: 20 }), /targetVelocity cannot be combined with/],
  [() => scene.body("arm"), "body is \"arm\"; allowed: leg."],
  [() => scene.bodies[0].place([0, 0]), "position is [0,0]; allowed: [x, y, z]."],
  [() => { scene.bodies[0].place([1e9, 0, 0]); ball.step(0.1); }, /^bodies\[0\] \(leg\): position is .*; allowed: /],
  [() => freed.ball(), "The scene was freed. Create a new one."],
  [() => physics.goldenHashes(0), "every is 0; allowed: a whole number from 1."],
  [() => freed.bodies[0].place([0, 0, 0]), "The scene was freed. Create a new one."],
  [() => gone.step(0.1), "The ball was freed. Create a new one."],
];
for (const [call, message] of cases) {
  assert.throws(call, error => {
    assert(error instanceof PhysicsError, `${call}: ${error}`);
    if (typeof message === "string") assert.equal(error.message, message); else assert.match(error.message, message);
    return true;
  }, String(call));
  assert.equal(ball.hash(), hash, String(call));
}
const open = physics.scene();
for (const [target, status, reason] of [
  [[0, 1, -20], "hit", /^null$/],
  [[0, 1, -200], "outOfReach", /^Flights at close elevations all pass below the target or fall short of it/],
  [[0, 0, 0], "degenerate", /^The direction of the kick is undefined/],
]) {
  const found = open.aim({ from: [0, 0, 0], target, speed: 25 });
  assert.equal(found.status, status);
  assert.match(`${found.reason}`, reason);
}
console.log(`${cases.length} calls with bad input throw the one message and change nothing`);
