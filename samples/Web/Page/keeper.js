// A goalkeeper of two bodies (trunk and gloves). He dives once, towards the point at which the library predicts the ball on the goal line. Keeper.cs is the same in C#.
const KEEPER_LENGTH = 2.2, SHOULDERS = 1.4, MOMENT = 1e-4;
const KEEPER_BODIES = [
  { name: "keeper", shape: "capsule", from: [0, -0.6, 0], to: [0, 0.6, 0], radius: 0.2, surface: { material: "boot" } },
  { name: "gloves", shape: "sphere", center: [0, 0, 0], radius: 0.17, surface: { material: "glove" } },
];

class Keeper {
  constructor(goal, reaction, speed) {
    this.feet = plus(goal.center, [0, 0, 0.5]);
    this.ready = plus(this.feet, [0, 1.2, 0.25]);
    this.player = { position: this.feet, reaction, acceleration: 14, speed, reach: 0.6, maximumHeight: 2.6 };
    this.from = this.until = Infinity;
  }

  // Watches the predicted path of a ball, and plans his dive.
  watch(ball) {
    const answer = this.answer = ball.keeper(this.player), aside = answer.position[0] - this.feet[0];
    if (!answer.crosses || Math.abs(aside) > 0.5 * 7.32 + 1 || answer.position[1] > 2.44 + 0.8) return; // no dive: the shot is wide or high
    this.from = ball.time + this.player.reaction;
    this.until = Math.max(answer.time, this.from + 0.25);
    // Dive to the crossing if he gets there in time, otherwise as far as he can reach.
    const covers = Math.max(Math.abs(answer.reachLeft), Math.abs(answer.reachRight)) - this.player.reach;
    const share = answer.saves ? 1 : within(covers / Math.max(Math.abs(aside), 1e-9), 0.2, 0.9);
    this.reached = between(this.ready, [answer.position[0], Math.max(0.15, answer.position[1]), this.feet[2] - 0.1], share);
    this.landing = [this.reached[0], Math.min(this.reached[1], 0.25), this.reached[2]];
  }

  // Moves his bodies to their pose at a time. Call it before the step that begins at that time.
  moveTo(time, [trunk, gloves]) {
    const now = this.at(time), then = this.at(time + MOMENT);
    const up = normal(minus(now.shoulders, now.feet)), next = normal(minus(then.shoulders, then.feet)), change = minus(next, up);
    const middle = plus(now.feet, times(0.75, up)), moved = minus(plus(then.feet, times(0.75, next)), middle);
    const half = Math.sqrt(Math.max(1e-9, 0.5 * (1 + up[1]))), per = v => [v[0] / MOMENT, v[1] / MOMENT, v[2] / MOMENT];
    const turning = [up[1] * change[2] - up[2] * change[1], up[2] * change[0] - up[0] * change[2], up[0] * change[1] - up[1] * change[0]];
    trunk.place(middle, { orientation: [0.5 * up[2] / half, 0, -0.5 * up[0] / half, half], velocity: per(moved), spin: per(turning), time });
    gloves.place(now.gloves, { velocity: per(minus(then.gloves, now.gloves)), time });
  }

  // Returns the positions of feet, shoulders and gloves at a time.
  at(time) {
    const dived = within((time - this.from) / (this.until - this.from), 0, 1), fallen = within((time - this.until - 0.1) / 0.4, 0, 1);
    const gloves = this.from === Infinity || dived <= 0 ? this.ready
      : between(between(this.ready, this.reached, dived * (2 - dived)), this.landing, fallen * fallen);
    // He leans towards his gloves. If leaning is not enough, his feet move aside.
    const aside = gloves[0] - this.feet[0], lean = within(aside / KEEPER_LENGTH, -0.97, 0.97), height = Math.sqrt(1 - lean * lean);
    const lifted = Math.max(0, gloves[1] - KEEPER_LENGTH * height - 0.2), feet = [this.feet[0] + aside - KEEPER_LENGTH * lean, Math.max(0.1, lifted), this.feet[2]];
    return { feet, shoulders: plus(feet, times(SHOULDERS, [lean, height, 0])), gloves };
  }
}
