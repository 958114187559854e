// Compiled, not run: the types of the package as a game uses them.
import { load, loadWorker, PhysicsError, type BallEvent, type RemoteBall, type SceneDescription } from "football-physics";

const description: SceneDescription = {
  profile: "measured",
  goals: [{ center: [0, 0, -22], facing: [0, 0, 1] }],
  obstacles: [{ name: "wall", shape: "box", center: [0, 0.9, -9], halfSize: [1, 0.9, 0.2], surface: { material: "boot", normalRestitution: 0.3 } }],
  bodies: [{ name: "leg", shape: "capsule", from: [0, -0.4, 0], to: [0, 0.4, 0], radius: 0.1, mass: 2 }],
};

export async function play(): Promise<string> {
  const physics = await load({ url: "/runtime/" }), scene = physics.scene(description), ball = scene.ball();
  ball.kick([3, 8, -22], { x: 0, y: 40, z: 0 });
  ball.kick({ speed: 25, elevation: 12 });
  const drag: number = ball.forces(1 / 60)?.drag[0] ?? 0;
  const path: Float64Array = ball.lookAhead(2, 60, { timeStep: 1 / 120, stopAt: "impact" });
  scene.ball().restart([0, 0.11, 0], { velocity: [0, 0, 1], orientation: [0, 0, 0, 1] });
  scene.body("leg").place([0, 0.5, -8], { velocity: [0, 0, 1], orientation: [0, 0, 0, 1] });
  ball.step(1 / 120);
  const goals: BallEvent[] = ball.events.filter(e => e.kind === "goal");
  const [x, y, z] = ball.position;
  const saved: Uint8Array = ball.save();
  ball.restore(saved);
  const aim = scene.aim({ from: [x, y, z], target: [0, 1, -22], speed: 25 });
  return aim.status === "hit" ? `${goals.length} ${path[1]} ${ball.hash()}` : physics.grounds.join();
}

export async function playInWorker(): Promise<number> {
  const physics = await loadWorker(), scene = await physics.scene(description), ball: RemoteBall = await scene.ball();
  await ball.kick({ speed: 25 });
  scene.bodies[0].place([0, 0, -5]);
  await ball.step(1 / 60);
  const path = await ball.lookAhead(1);
  return path.length + ball.time;
}

// @ts-expect-error: a vector has three numbers
export const flat: SceneDescription = { gravity: [0, 1] };

// @ts-expect-error: no such event
export const isOffside = (e: BallEvent): boolean => e.kind === "offside";

export const isRefusal = (error: unknown): boolean => error instanceof PhysicsError;
