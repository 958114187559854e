// The game without its picture: a free kick over players who jump. Page, golden hash and C# play the same.
export const TIME_STEP = 1 / 120;

const WALL_DISTANCE = 9.15, STANDING = 0.9;

/** The players jump when the ball is kicked: 0.45 m high, 0.6 s long. Returns where they are. */
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
    this.scene = physics.scene(scene);
    this.ball = this.scene.ball();
    this.kicks = kicks;
    this.reset();
  }

  // The ball on its spot, the players on their feet.
  reset() {
    this.ball.place([0, this.scene.radius, 0]);
    this.moveWall(0.6);
  }

  kick(kick) {
    this.reset();
    this.ball.kick(kick);
  }

  // The path of a kick that is not kicked, past players who stand: rows t, x, y, z.
  path(kick) {
    this.kick(kick);
    const path = this.ball.lookAhead(1.25, 65, { timeStep: TIME_STEP });
    this.reset();
    return path;
  }

  moveWall(time) { this.wall = placeWall(this.scene.bodies, time); }

  // One step: the wall, the ball. Returns the events.
  step() {
    this.moveWall(this.ball.time);
    this.ball.step(TIME_STEP);
    return this.ball.events;
  }
}
