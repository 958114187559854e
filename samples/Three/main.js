// A free kick with three.js. The arrow keys aim, and the space bar kicks. F shows the forces, W makes pitch and ball wetter while the ball flies.
import { load, loadWorker } from "football-physics";
import { Game, placeWall, TIME_STEP } from "./game.js";
import { Picture } from "./picture.js";

const text = document.getElementById("text"), shot = new URLSearchParams(location.search).has("shot");
const begun = performance.now();
const physics = await load();
physics.ball().step(TIME_STEP);
const firstBall = performance.now() - begun;

const file = await (await fetch("scene.json")).json(), game = new Game(physics, file);
const picture = new Picture(game, innerWidth, innerHeight);
document.body.append(picture.renderer.domElement);
const aim = { ...game.kicks[1] };
let showsForces = false, isMoving = false, last = 0, behind = 0, said = "";

function describe() {
  text.textContent = `${aim.speed.toFixed(1)} m/s, ${aim.elevation.toFixed(1)}° up, ${aim.azimuth.toFixed(1)}° to the left, spin ${aim.sideSpin} rad/s\n${said}${showsForces ? `\n${game.numbers()}` : ""}`;
}

function ready() {
  isMoving = false;
  picture.path(game.path(aim));
  describe();
}

// Plays all kicks of scene.json, with events and hashes as in golden.txt, and takes one picture in between.
async function show() {
  const lines = [];
  let png = "";
  for (const kick of game.kicks) {
    picture.path(game.path(kick));
    game.kick(kick);
    for (let tick = 0; tick < 360; tick++) {
      for (const e of game.step()) if (e.kind !== "impact" || e.name !== "ground") lines.push(`${e.kind} ${e.name}`);
      if (kick === game.kicks[1] && tick === 52) {
        picture.draw();
        png = picture.renderer.domElement.toDataURL("image/png");
      }
    }
    lines.push(`hash ${game.ball.hash()}`);
  }
  await fetch("result", { method: "POST", body: JSON.stringify({ lines, png, firstBall, inWorker: await playInWorker() }) });
}

// Repeats the last kick with the library in a worker: one message per step. Returns the hash.
async function playInWorker() {
  const worker = await loadWorker(), scene = await worker.scene(file.scene), ball = await scene.ball();
  await ball.place([0, scene.radius, 0]);
  await ball.kick(file.kicks.at(-1));
  for (let tick = 0; tick < 360; tick++) {
    placeWall(scene.bodies, ball.time);
    await ball.step(TIME_STEP);
  }
  const hash = await ball.hash();
  worker.terminate();
  return hash;
}

function frame(now) {
  requestAnimationFrame(frame);
  behind = Math.min(behind + (now - last) / 1000, 0.1);
  last = now;
  for (; isMoving && behind >= TIME_STEP; behind -= TIME_STEP) {
    for (const e of game.step()) {
      if (e.kind === "goal") said = "Goal!";
      if (e.kind === "impact" && e.name !== "ground") said = `Off the ${e.name}.`;
    }
    if (game.ball.time > 4 || game.ball.motion === "rest") {
      game.reset();
      ready();
    }
  }
  if (isMoving) describe();
  picture.forces(showsForces ? game.ball.forces(TIME_STEP) : null);
  picture.draw();
}

addEventListener("keydown", ({ key }) => {
  if (key === " ") {
    game.kick(aim);
    said = "";
    behind = 0;
    isMoving = true;
    return;
  }
  if (key === "f") {
    showsForces = !showsForces;
    describe();
    return;
  }
  if (key === "w") {
    said = `Wetness ${game.wetter().toFixed(2)}.`;
    describe();
    return;
  }
  const change = { ArrowLeft: ["azimuth", 0.5], ArrowRight: ["azimuth", -0.5], ArrowUp: ["elevation", 0.5], ArrowDown: ["elevation", -0.5] }[key];
  if (!change || isMoving) return;
  aim[change[0]] += change[1];
  ready();
});

if (shot) {
  await show();
} else {
  ready();
  requestAnimationFrame(frame);
}
