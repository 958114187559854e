// Runs the library in its own worker; remote.js calls it.
import { load } from "./index.js";

const objects = new Map();
let physics = null, last = 0;

function add(object) {
  objects.set(++last, object);
  return last;
}

const stateOf = ball => ({ time: ball.time, position: ball.position, velocity: ball.velocity, spin: ball.spin, orientation: ball.orientation, motion: ball.motion, events: ball.events });

async function answer({ target, method, args, bodies }) {
  if (method === "load") {
    physics = await load(args[0]);
    const { version, balls, grounds, materials } = physics;
    return { value: { version, balls, grounds, materials } };
  }
  const object = target === 0 ? physics : objects.get(target);
  for (const [index, placement] of bodies ?? []) {
    const body = object.scene.bodies[index];
    if (placement) body.place(...placement); else body.withdraw();
  }
  const value = object[method](...args);
  if (method === "free") {
    objects.delete(target);
    return {};
  }
  if (method === "scene") {
    const { radius, kinematicViscosity, names, hash, shapes, goals } = value;
    return { value: { id: add(value), radius, kinematicViscosity, names, hash, shapes, goals, bodies: value.bodies.map(body => body.name) } };
  }
  if (method === "ball") return { value: { id: add(value), ...stateOf(value) } };
  return object.scene ? { value, state: stateOf(object) } : { value };
}

onmessage = async ({ data }) => {
  try {
    postMessage({ id: data.id, ...await answer(data) });
  } catch (error) {
    postMessage({ id: data.id, error: String(error.message ?? error) });
  }
};
