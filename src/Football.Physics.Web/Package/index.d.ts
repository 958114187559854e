/** [x, y, z]: right-handed axes, y up, forward −z; SI units. */
export type Vector = [number, number, number];

/** [x, y, z, w], body to world. */
export type Quaternion = [number, number, number, number];

/** A vector that you pass: an array, or an object such as a `THREE.Vector3`. */
export type VectorLike = ArrayLike<number> | { readonly x: number; readonly y: number; readonly z: number };

/** An orientation that you pass: an array, or an object such as a `THREE.Quaternion`. */
export type QuaternionLike = ArrayLike<number> | { readonly x: number; readonly y: number; readonly z: number; readonly w: number };

export type EventKind = "impact" | "slide" | "roll" | "rest" | "net" | "goal" | "contactEnd" | "pinned" | "enterZone" | "exitZone";

export type Motion = "airborne" | "sliding" | "rolling" | "rest" | "pinned";

/** An event within a step, with its exact time and position. */
export interface BallEvent {
  kind: EventKind;
  /** The object that was hit or passed, such as "ground", "left post" or "goal"; "" if there is none. */
  name: string;
  /** The index of the object in `Scene.names`; −1 if there is none. */
  collider: number;
  /** Time since the ball was placed, in s. */
  time: number;
  position: Vector;
  velocityBefore: Vector;
  velocity: Vector;
  spinBefore: Vector;
  spin: Vector;
  /** Unit normal of the contact, from the object to the ball. */
  normal: Vector;
  /** Energy that a bumper added, in J. */
  addedEnergy: number;
}

/** The outputs of an impact, for sound, haptics and looks. The simulation does not depend on them. */
export interface Impact {
  /** The impulse along the normal, in N s. */
  normalImpulse: number;
  /** The impulse of friction, in N s. */
  tangentialImpulse: number;
  /** The speed of the contact point along the surface before and after, in m/s. */
  slipBefore: number;
  slipAfter: number;
  /** True if friction held the contact. */
  grips: boolean;
  /** The duration of a real impact, in s. */
  contactTime: number;
  /** The largest compression of the ball, in m. */
  compression: number;
  /** The largest normal force, in N. */
  peakForce: number;
  /** The kinetic energy lost, in J, relative to the surface. */
  energyLost: number;
}

/** The forces on a ball with which its next step begins, in N, in world coordinates: for arrows and overlays. */
export interface Forces {
  weight: Vector;
  buoyancy: Vector;
  drag: Vector;
  magnus: Vector;
  /** The knuckle force of the seams; it acts only in flight. */
  knuckle: Vector;
  /** The sum of the forces of all nets. */
  nets: Vector;
  /** The sum of the loads of all contacts, along their normals. */
  load: Vector;
  /** The sum of the friction of all contacts, with rolling resistance. */
  friction: Vector;
  /** The sum of all forces. */
  sum: Vector;
  /** The acceleration, in m/s². */
  acceleration: Vector;
  /** The contacts; empty in flight. */
  contacts: ContactForce[];
}

/** The forces of one contact on a ball, in N. */
export interface ContactForce {
  /** The name of the object. */
  name: string;
  /** The contact point, in m. */
  point: Vector;
  /** The normal of the surface, towards the ball. */
  normal: Vector;
  load: Vector;
  friction: Vector;
}

/** A kick at a speed (m/s) and two angles (degrees), with spins in rad/s. */
export interface KickAngles {
  speed: number;
  /** The angle above the horizontal, in degrees; default 0. */
  elevation?: number;
  /** The angle from −z, to the left, in degrees; default 0. */
  azimuth?: number;
  topSpin?: number;
  /** Positive bends to the left. */
  sideSpin?: number;
}

export type Material = { material?: string } & Record<string, number | null | string | undefined>;

export type Shape =
  | { shape: "sphere"; center: Vector; radius: number }
  | { shape: "capsule"; from: Vector; to: Vector; radius: number }
  | { shape: "box"; center: Vector; halfSize: Vector; rotation?: Quaternion }
  | { shape: "plane"; point: Vector; normal: Vector };

export interface Goal {
  /** The centre of the goal line. */
  center: Vector;
  /** The direction towards the pitch. */
  facing: Vector;
  width?: number;
  height?: number;
  postRadius?: number;
  depth?: [number, number];
  net?: boolean;
  surface?: Material;
}

/** A scene, with the members of a scenario of the `football` command; `{}` is the default pitch. */
export interface SceneDescription {
  profile?: "measured" | "published";
  ball?: { type?: string; mass?: number; radius?: number } & Record<string, unknown>;
  air?: Record<string, unknown>;
  gravity?: number | Vector;
  forces?: Record<string, unknown>;
  ground?: { surface?: string } & Record<string, unknown>;
  dials?: { pressure?: number; wetness?: number; wear?: number; mud?: number };
  goals?: Goal[];
  obstacles?: (Shape & { name?: string; surface?: Material; velocity?: Vector; spin?: Vector; pivot?: Vector; mass?: number | null; layer?: number })[];
  nets?: { name?: string; center: Vector; normal: Vector; along: Vector; halfSize: [number, number] }[];
  zones?: (Shape & { name?: string; of?: "ball" | "centre"; layer?: number })[];
  /** Objects that your game moves, such as players. Their shapes are in the frame of the body. */
  bodies?: (Shape & { name?: string; surface?: Material; mass?: number | null; layer?: number })[];
  solver?: { integrator?: "euler" | "semiImplicitEuler" | "rk2" | "rk4" } & Record<string, unknown>;
}

/** An object of a scene, to draw. Lines and faces are lists of coordinates x, y, z, x, y, z … */
export interface SceneShape {
  name: string;
  kind: "frame" | "net" | "obstacle" | "marking" | "people";
  /** The radius of the lines, in m; 0 for thin lines. */
  radius: number;
  velocity: Vector;
  lines: number[][];
  /** Convex polygons; the corners of a net. */
  faces: number[][];
}

export interface AimRequest {
  from: Vector;
  target: Vector;
  /** The speed of the kick, in m/s. */
  speed: number;
  /** A waypoint of the path. */
  through?: Vector;
  targetVelocity?: Vector;
  kickTime?: number;
  arc?: "low" | "high";
  spin?: { top?: number; side?: number; free?: boolean };
  maxSpin?: { top?: number; side?: number };
  elevation?: { min?: number; max?: number };
  tolerance?: number;
  throughTolerance?: number;
  maxIterations?: number;
}

export interface AimResult {
  status: "hit" | "outOfReach" | "notConverged" | "degenerate" | "waypointMissed" | "blocked";
  velocity: Vector;
  spin: Vector;
  speed: number;
  elevation: number;
  azimuth: number;
  topSpin: number;
  sideSpin: number;
  /** The distance by which the kick misses the target, in m. */
  miss: number | null;
  time: number | null;
  /** The object that a blocked kick hits. */
  blockedBy: string | null;
  /** The bound that excludes every kick, the undefined quantity, or the nearest miss, as a sentence; null for a hit. */
  reason: string | null;
}

export interface KeeperPlayer {
  position: Vector;
  velocity?: Vector;
  reaction?: number;
  acceleration?: number;
  speed?: number;
  reach?: number;
  minimumHeight?: number;
  maximumHeight?: number;
}

export interface KeeperAnswer {
  crosses: boolean;
  isOnTarget: boolean;
  saves: boolean;
  /** The time at which the ball crosses the goal line, in s, and the position there. */
  time: number | null;
  position: Vector;
  lateralOffset: number | null;
  reachLeft: number | null;
  reachRight: number | null;
  reachHeight: number | null;
  latestReaction: number | null;
}

export interface Placement {
  velocity?: VectorLike;
  spin?: VectorLike;
  orientation?: QuaternionLike;
  /** The ball's time for which the placement holds, in s; default: the start of the next step. */
  time?: number;
}

export interface LookAheadOptions {
  /** The step of the prediction, in s; default 0.01. With the step of your game, the path is bit-identical to the later simulation. */
  timeStep?: number;
  /** The event that ends the prediction; default "rest". */
  stopAt?: "rest" | "impact" | "time";
}

export interface LoadOptions {
  /** The address of the folder `runtime`, with a trailing slash; default: next to this module. */
  url?: string;
  /** The contents of the folder `runtime` by file name, for a page in one file. */
  files?: Record<string, ArrayBuffer>;
}

/** An input was rejected. The message names the field, the value and the allowed range. */
export class PhysicsError extends Error {}

/** Loads the library in this thread, once. */
export function load(options?: LoadOptions): Promise<Physics>;

/** Loads the library in its own worker. Each method then returns a promise. */
export function loadWorker(options?: LoadOptions & { worker?: string | URL }): Promise<RemotePhysics>;

interface Presets {
  readonly version: string;
  /** The balls by their names for `ball.type`. */
  readonly balls: Readonly<Record<string, { mass: number; radius: number; inertiaFactor: number; bounce: number }>>;
  /** Names for `ground.surface`. */
  readonly grounds: readonly string[];
  /** Names for `surface.material`. */
  readonly materials: readonly string[];
}

export interface Physics extends Presets {
  /** Validates and compiles a scene: an object, or JSON text. */
  scene(description?: SceneDescription | string): Scene;
  /** Creates a ball with its own scene. */
  ball(description?: SceneDescription | string): Ball;
  /** Computes the velocity and the spin of a kick at a speed and two angles. */
  kickVectors(kick: KickAngles): { velocity: Float64Array; spin: Float64Array };
  /** Returns the hashes of a few hundred simulations. They are identical on every machine and in every language. With `every` above 1, only every so many. */
  goldenHashes(every?: number): string[];
}

interface SceneAbout {
  /** The radius of the ball, in m. */
  readonly radius: number;
  /** The kinematic viscosity of the air, in m²/s, for the Reynolds number. */
  readonly kinematicViscosity: number;
  /** The names of all objects, by index. */
  readonly names: readonly string[];
  /** The hash of the scene. Scenes with equal hashes give identical results. */
  readonly hash: string;
  /** The objects, to draw. */
  readonly shapes: readonly SceneShape[];
  readonly goals: readonly { center: Vector; facing: Vector }[];
}

export interface Scene extends SceneAbout {
  readonly bodies: readonly Body[];
  body(name: string): Body;
  /** Creates a ball at rest on the ground at the origin. */
  ball(): Ball;
  /** Finds the kick that reaches a target. */
  aim(request: AimRequest): AimResult;
  /** Frees the scene; otherwise the garbage collector does. */
  free(): void;
}

export interface Body {
  readonly name: string;
  /** Places the body for the next step or look-ahead, which throws if a number is out of range. */
  place(position: VectorLike, motion?: Placement): void;
  /** Takes the body out of play until you place it again. */
  withdraw(): void;
  state(): { position: Float64Array; velocity: Float64Array; spin: Float64Array; orientation: Float64Array };
}

interface BallState {
  /** Time since `place` or `launch`, in s; `restart` does not reset it. */
  readonly time: number;
  readonly position: Vector;
  readonly velocity: Vector;
  /** Angular velocity in the world frame, in rad/s. */
  readonly spin: Vector;
  readonly orientation: Quaternion;
  readonly motion: Motion;
  /** The events of the last step, in order of time. */
  readonly events: BallEvent[];
}

export interface Ball extends BallState {
  readonly scene: Scene;
  /** Places the ball without motion and resets its clock. */
  place(position: VectorLike): void;
  /** Places the ball with a velocity and a spin, and resets its clock. */
  launch(position: VectorLike, velocity: VectorLike, spin?: VectorLike): void;
  /** Places the ball with any motion, for a kick-off, a throw-in or a corner. The clock continues, as with `PlaceInput` in C#. */
  restart(position: VectorLike, motion?: Omit<Placement, "time">): void;
  kick(velocity: VectorLike, spin?: VectorLike): void;
  kick(kick: KickAngles): void;
  /** Advances the ball by a time, in s. */
  step(dt: number): void;
  /** Returns the outputs of an impact: the index is that in `events` of the last step. All are 0 if the event is not an impact. */
  impact(index: number): Impact;
  /**
   * Returns the sound of an impact of the last step, and a generated wave of 0.25 s for an `AudioBuffer` with one channel. The rate is the number of samples
   * per second, 8000 … 192 000; default 48 000. Loudness follows from the peak force, brightness (the frequency, in Hz) from the duration, brush from the slip.
   */
  impactSound(index: number, rate?: number): { loudness: number; brightness: number; brush: number; samples: Float32Array };
  /** Returns the squash of the drawn ball: scales along and across an axis. The ball itself stays round. Call it after each step. */
  squash(): { along: number; across: number; axis: Vector };
  /** Returns the forces with which the next step begins; null if it begins with an impact, or solves its contacts by impulses. `dt` is the length of that step, in s; default 1/60. */
  forces(dt?: number): Forces | null;
  /** Predicts the path as rows t, x, y, z, evenly spaced from now. If the prediction ends early, the last row repeats. */
  lookAhead(seconds: number, samples?: number, options?: LookAheadOptions): Float64Array;
  /** Returns the end of the last prediction, in s. */
  lookAheadEnd(): number;
  /** Returns the events of the last prediction. */
  lookAheadEvents(): BallEvent[];
  /** Computes whether a goalkeeper saves the ball on the last predicted path. */
  keeper(player: KeeperPlayer, goal?: number): KeeperAnswer;
  /** Returns the bulges of the nets, for drawing. Call it after each step. */
  bulges(): { depth: number; position: Float64Array; direction: Float64Array }[];
  /** Returns the hash of the state: 16 hexadecimal digits, as `Snapshot.Hash` in C# and `fp_hash` in C. */
  hash(): string;
  /** Returns the state as bytes, as `Snapshot.Write` does in C#. */
  save(): Uint8Array;
  restore(bytes: Uint8Array): void;
  /** Frees the ball; otherwise the garbage collector does. */
  free(): void;
}

type Remote<T> = { [K in keyof T]: T[K] extends (...args: infer A) => infer R ? (...args: A) => Promise<R> : T[K] };

export interface RemotePhysics extends Presets {
  scene(description?: SceneDescription | string): Promise<RemoteScene>;
  ball(description?: SceneDescription | string): Promise<RemoteBall>;
  goldenHashes(every?: number): Promise<string[]>;
  terminate(): void;
}

export interface RemoteScene extends SceneAbout {
  readonly bodies: readonly Omit<Body, "state">[];
  body(name: string): Omit<Body, "state"> | undefined;
  ball(): Promise<RemoteBall>;
  aim(request: AimRequest): Promise<AimResult>;
  free(): Promise<void>;
}

/** A ball in a worker. Its numbers are those after the last completed call. */
export interface RemoteBall extends BallState, Omit<Remote<Omit<Ball, keyof BallState | "scene" | "kick">>, never> {
  readonly scene: RemoteScene;
  kick(velocity: VectorLike, spin?: VectorLike): Promise<void>;
  kick(kick: KickAngles): Promise<void>;
}
