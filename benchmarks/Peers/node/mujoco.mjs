// node mujoco.mjs SHOTS
import { readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import load from "@mujoco/mujoco";
import { ball, friction, gravity, post, restitution, rollingArm, run } from "./harness.mjs";

const mujoco = await load();
const main = fileURLToPath(import.meta.resolve("@mujoco/mujoco"));
const whole = mujoco.mjtState.mjSTATE_INTEGRATION.value;
// MuJoCo has no coefficient of restitution. A contact is a damped spring that cannot pull, and with the damping ratio z it returns this fraction of the speed.
function returned(z) {
  const root = Math.sqrt(1 - z * z);
  return Math.exp((-z / root) * (Math.PI - Math.atan2(2 * z * root, 1 - 2 * z * z)));
}

let [damping, tooMuch] = [0, 0.9];
while (tooMuch - damping > 1e-9) {
  const middle = (damping + tooMuch) / 2;
  if (returned(middle) > restitution) damping = middle;
  else tooMuch = middle;
}

function create({ ground, post: withPost, rolling, step }) {
  // The default time step is 2 ms: a frame becomes equal steps of at most 2 ms. With a time constant of 30 ms instead of 20, a contact lasts nine steps and returns its speed more evenly.
  const parts = Math.ceil(step / 0.002 - 1e-9);
  const contact = `solref="0.03 ${damping}" solimp="0.99 0.99 0.001" condim="${rolling ? 6 : 3}" friction="${friction} 0.005 ${rolling ? rollingArm : 0.0001}"`;
  const balls = [];
  let model, data, buffer;

  function compile() {
    const body = ({ position }) => `<body pos="${position.join(" ")}"><freejoint/><inertial pos="0 0 0" mass="${ball.mass}"
      diaginertia="${ball.inertia} ${ball.inertia} ${ball.inertia}"/><geom type="sphere" size="${ball.radius}" contype="1" conaffinity="2" ${contact}/></body>`;
    const fixed = [];
    if (ground) fixed.push(`<geom type="plane" size="0 0 1" zaxis="0 1 0" contype="2" conaffinity="1" ${contact}/>`);
    if (withPost) fixed.push(`<geom type="capsule" fromto="0 0 ${post.z} 0 ${post.height} ${post.z}" size="${post.radius}" contype="2" conaffinity="1" ${contact}/>`);
    const xml = `<mujoco><option timestep="${step / parts}" gravity="0 ${-gravity} 0" cone="elliptic"/><worldbody>${fixed.join("")}${balls.map(body).join("")}</worldbody></mujoco>`;
    model = mujoco.MjModel.from_xml_string(xml);
    data = new mujoco.MjData(model);
    balls.forEach(({ velocity, spin }, i) => {
      // The spin is in the ball's own axes, which are the world's at the start.
      data.qvel.set([...velocity, ...spin], 6 * i);
    });
  }

  const ready = () => { if (!model) compile(); };
  return {
    add: (position, velocity, spin) => { balls.push({ position, velocity, spin }); },
    step() {
      ready();
      for (let i = 0; i < parts; i++) mujoco.mj_step(model, data);
    },
    get(i) {
      ready();
      const [q, v] = [data.qpos.subarray(7 * i, 7 * i + 7), data.qvel.subarray(6 * i, 6 * i + 6)];
      return [...q, ...v];
    },
    set(i, s) {
      ready();
      data.qpos.set(s.slice(0, 7), 7 * i);
      data.qvel.set(s.slice(7), 6 * i);
    },
    save() {
      ready();
      buffer ??= new mujoco.DoubleBuffer(mujoco.mj_stateSize(model, whole));
      mujoco.mj_getState(model, data, buffer, whole);
      return Array.from(buffer.GetView());
    },
    restore(saved) {
      ready();
      mujoco.mj_setState(model, data, saved, whole);
    },
    bytes: (saved) => 8 * saved.length,
    free() {
      buffer?.delete();
      data?.delete();
      model?.delete();
    },
  };
}

run({
  name: "MuJoCo",
  version: mujoco.mj_versionString(),
  build: "WebAssembly, node",
  saved: "world",
  files: [main, ...readdirSync(dirname(main)).filter((file) => file.endsWith(".wasm")).map((file) => join(dirname(main), file))],
  canCcd: false,
  canRoll: true,
  // The time to compile a model grows with the square of the bodies: 10,000 take minutes.
  many: false,
  create,
}, process.argv[2]);
