// Plays the cases of cases.json with the npm package, and prints every bit as hexadecimal words; Web.Tests prints the same lines in C#.
//   node tests/Npm/bits.mjs PACKAGE
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const { load } = await import(pathToFileURL(process.argv[2] + "/index.js"));
const physics = await load();
const view = new DataView(new ArrayBuffer(8));
const bits = number => { view.setFloat64(0, number); return view.getBigUint64(0).toString(16).padStart(16, "0"); };
const words = numbers => Array.from(numbers, bits).join(" ");

for (const { name, kick, ticks, scene: description } of JSON.parse(readFileSync(new URL("./cases.json", import.meta.url), "utf8"))) {
  const scene = physics.scene(description), ball = scene.ball();
  ball.kick(kick.velocity, kick.spin);
  const path = ball.lookAhead(2, 21, { timeStep: 1 / 64 });
  for (let i = 0; i < 21; i++) console.log(`${name} path ${words(path.subarray(4 * i, 4 * i + 4))}`);
  for (let tick = 0; tick < ticks; tick++) {
    // Players who move: one walks across and jumps, one turns.
    if (scene.bodies.length > 0) {
      const t = tick / 64;
      scene.body("wall").place([0.25 + 0.5 * t, 0.95 + t * (1 - t), -9], { velocity: [0.5, 1 - 2 * t, 0] });
      scene.body("leg").place([0, 0.3, -7], { orientation: [0, 0.6, 0, 0.8], spin: [0, 3, 0] });
    }
    ball.step(1 / 64);
    for (const e of ball.events) console.log(`${name} ${e.kind} ${e.name} ${words([e.time, ...e.position, ...e.velocityBefore, ...e.velocity, ...e.spinBefore, ...e.spin, ...e.normal])}`);
    ball.events.forEach((e, i) => {
      if (e.kind !== "impact") return;
      const out = ball.impact(i), { loudness, brightness, brush, samples } = ball.impactSound(i, 8000);
      console.log(`${name} outputs ${words([out.normalImpulse, out.tangentialImpulse, out.slipBefore, out.slipAfter, out.contactTime, out.compression, out.peakForce, out.energyLost])} ${out.grips}`);
      console.log(`${name} sound ${samples.length} ${words([loudness, brightness, brush, samples[40], samples[400]])}`);
    });
    const { along, across, axis } = ball.squash();
    if (along < 1) console.log(`${name} squash ${words([along, across, ...axis])}`);
    if (tick % 10 === 0) console.log(`${name} ${ball.motion} ${words([ball.time, ...ball.position, ...ball.velocity, ...ball.spin, ...ball.orientation])} ${ball.hash()}`);
    if (tick % 10 === 5) {
      const f = ball.forces(1 / 64);
      console.log(`${name} forces ${f ? words([...f.weight, ...f.drag, ...f.magnus, ...f.load, ...f.friction, ...f.sum, ...f.acceleration]) : "none"} ${f ? f.contacts.map(c => c.name).join(",") : ""}`);
    }
  }
  // Saved, moved and restored: the same bits again.
  const saved = ball.save(), hash = ball.hash();
  ball.kick({ speed: 20, elevation: 15, azimuth: -10, topSpin: 5, sideSpin: 30 });
  ball.step(1 / 64);
  console.log(`${name} kicked again ${ball.hash()}`);
  ball.restart([1, 2, 3], { velocity: [-4, 3, 1], spin: [0, 6, 0], orientation: [0, 2, 0, 2] });
  ball.step(1 / 64);
  console.log(`${name} restarted ${ball.hash()}`);
  ball.restore(saved);
  console.log(`${name} restored ${ball.hash() === hash}`);
}
const aimed = physics.scene().aim({ from: [0, 0.11, 0], target: [20, 1.5, 3], speed: 25, spin: { top: 20, side: 10 } });
console.log(`aim ${aimed.status} ${words([...aimed.velocity, ...aimed.spin, aimed.miss, aimed.time])}`);
