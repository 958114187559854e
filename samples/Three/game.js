// The game without its picture: a free kick over players who jump. The page, the golden hash and the C# test play the same game.
export const TIME_STEP = 1 / 120;

const WALL_DISTANCE = 9.15, STANDING = 0.9;

/** Places the players, who jump when the ball is kicked: 0.45 m high, 0.6 s long. Returns their positions. */
export function placeWall(bodies, time) {
  const jumps = time < 0.6, velocity = [0, jumps ? 3 - 10 * time : 0, 0];
  return bodies.map((body, i) => {
    const position = [0.3 + 0.55 * i, STANDING + (jumps ? time * (3 - 5 * time) : 0), -WALL_DISTANCE];
    body.place(position, { velocity });
    return position;
  });
}

export class Game {
  constructor(physics, { scene, kicks }) {
    this.physics = physics;
    this.given = scene;
    this.dials = {};
    this.last = "";
    this.before = 0; // the time before the clock of the ball began again
    this.scene = physics.scene(scene);
    this.ball = this.scene.ball();
    this.kicks = kicks;
    this.reset();
  }

  // Puts the ball on its spot, and the players on their feet.
  reset() {
    this.before = 0;
    this.ball.place([0, this.scene.radius, 0]);
    this.moveWall(0.6);
  }

  kick(kick) {
    this.reset();
    this.ball.kick(kick);
  }

  // Returns the path of a kick without kicking, past players who stand still: rows t, x, y, z.
  path(kick) {
    this.kick(kick);
    const path = this.ball.lookAhead(1.25, 65, { timeStep: TIME_STEP });
    this.reset();
    return path;
  }

  // Returns the numbers of an overlay: speed, spin, Reynolds number, motion and the last event.
  numbers() {
    const { velocity, spin, motion } = this.ball, speed = Math.hypot(...velocity);
    const reynolds = speed * 2 * this.scene.radius / this.scene.kinematicViscosity;
    return `${speed.toFixed(1)} m/s, ${Math.hypot(...spin).toFixed(0)} rad/s, Re ${(reynolds / 1e5).toFixed(2)}e5, ${motion}, ${this.last}`;
  }

  // Makes pitch and ball wetter, and continues the ball in the new scene. Returns the wetness.
  wetter() {
    this.dials = { ...this.dials, wetness: (((this.dials.wetness ?? 0) + 0.25) % 1.25) };
    const scene = this.physics.scene({ ...this.given, dials: this.dials }), ball = scene.ball();
    const { position, velocity, spin, orientation, time } = this.ball;
    ball.restart(position, { velocity, spin, orientation });
    this.ball.free();
    this.scene.free();
    Object.assign(this, { scene, ball, before: this.before + time });
    this.moveWall(this.before);
    return this.dials.wetness;
  }

  moveWall(time) { this.wall = placeWall(this.scene.bodies, time); }

  // Steps the players and the ball. Returns the events.
  step() {
    this.moveWall(this.before + this.ball.time);
    this.ball.step(TIME_STEP);
    const events = this.ball.events;
    if (events.length > 0) this.last = `${events.at(-1).kind} ${events.at(-1).name ?? ""}`.trim();
    return events;
  }
}
