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
    this.scene = physics.scene(scene);
    this.ball = this.scene.ball();
    this.kicks = kicks;
    this.reset();
  }

  // Puts the ball on its spot, and the players on their feet.
  reset() {
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

  moveWall(time) { this.wall = placeWall(this.scene.bodies, time); }

  // Steps the players and the ball. Returns the events.
  step() {
    this.moveWall(this.ball.time);
    this.ball.step(TIME_STEP);
    return this.ball.events;
  }
}
