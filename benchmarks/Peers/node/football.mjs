// node football.mjs SHOTS PACKAGE: this library as WebAssembly, from the folder of its npm package.
import { readFileSync, readdirSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { gravity, post, restitution, run } from "./harness.mjs";

const folder = resolve(process.argv[3]);
const { load } = await import(pathToFileURL(`${folder}/index.js`));
const physics = await load();

// The same scenes as in dotnet/FootballWorld.cs.
function create({ post: withPost, rolling, vacuum }) {
  const description = { ground: { surface: "publishedTurf", normalRestitution: restitution } };
  if (rolling) Object.assign(description.ground, { rollingFriction: 1 / gravity, rollingFrictionBySpeed: 0 });
  if (vacuum) description.forces = { buoyancy: false, drag: "none", magnus: "none", spinDecay: "none" };
  if (withPost) description.obstacles = [{ name: "post", shape: "capsule", from: [0, 0, post.z], to: [0, post.height, post.z], radius: post.radius }];
  const scene = physics.scene(description);
  const balls = [];
  return {
    add(position, velocity, spin) {
      const ball = scene.ball();
      ball.launch(position, velocity, spin);
      balls.push(ball);
    },
    step(h) {
      for (const ball of balls) ball.step(h);
    },
    get(i) {
      const { position, orientation, velocity, spin } = balls[i];
      return [...position, ...orientation, ...velocity, ...spin];
    },
    set(i, s) {
      balls[i].launch(s.slice(0, 3), s.slice(7, 10), s.slice(10));
    },
    save: () => balls[0].save(),
    restore: (saved) => balls[0].restore(saved),
    bytes: (saved) => saved.length,
    free() {
      for (const ball of balls) ball.free();
      scene.free();
    },
  };
}

run({
  name: "Football.Physics, npm",
  version: JSON.parse(readFileSync(`${folder}/package.json`)).version,
  build: "WebAssembly, node",
  saved: "ball",
  files: ["index.js", ...readdirSync(`${folder}/runtime`).map((name) => `runtime/${name}`)].map((name) => `${folder}/${name}`),
  canCcd: true,
  alwaysCcd: true,
  canRoll: true,
  create,
}, process.argv[2]);
