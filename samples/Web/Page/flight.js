// A moving ball. The worker simulates it ahead of the display, and passes it to the page in rows of numbers, which begin with their kind.
const ROW = { key: 0, event: 1, keeper: 2, bulge: 3, sound: 4, squash: 5, forces: 6 };
// The forces of a row, in this order; the page has the same list.
const FORCES = ["weight", "buoyancy", "drag", "magnus", "knuckle", "nets", "load", "friction"];
// The samples per second of a sound; the page has the same number.
const SOUND_RATE = 24000;
// The loudness below which the page is silent, and the flattening below which the ball is round.
const QUIET = 0.02, ROUND = 0.999;

class Flight {
  // changes: times from which on the ball moves in the scene of another setting.
  constructor(given) {
    const { setting, keeper, kick, changes } = given;
    Object.assign(this, { given, keeper, changes: [...changes], rows: [] });
    this.enter(setting);
    this.ball.kick(kick.velocity, kick.spin);
    this.key(this.ball, this.ball.velocity, this.ball.orientation);
    this.writeKeeper();
    this.writeForces();
  }

  enter(setting) {
    this.scene = setting.scene(this.keeper ? KEEPER_BODIES : []);
    this.ball = this.scene.ball();
    this.moving = this.ball.bulges().map(() => false);
  }

  // Continues the ball in the scene of another setting.
  changeTo(setting) {
    const { scene, ball } = this;
    this.enter(setting);
    this.ball.restore(ball.save());
    ball.free();
    scene.free();
  }

  free() {
    this.ball.free();
    this.scene.free();
  }

  get isOver() { return this.ball.motion === "rest" || this.ball.time >= LONGEST; }

  // Simulates some more seconds, and returns the new rows.
  advance(seconds) {
    const until = this.ball.time + seconds;
    while (this.ball.time < until && !this.isOver) {
      while (this.changes.length > 0 && this.changes[0].time <= this.ball.time) this.changeTo(this.changes.shift().setting);
      const { ball } = this;
      if (this.keeper) this.keeper.moveTo(ball.time, this.scene.bodies);
      ball.step(TIME_STEP);
      ball.events.forEach((e, i) => {
        // Add the events within the step, with the ball's orientation at their time.
        this.key(e, e.velocityBefore, e.time < ball.time ? turned(this.last.orientation, this.last.spin, e.time - this.last.time) : ball.orientation);
        this.rows.push(ROW.event, KINDS.indexOf(e.kind), e.collider, e.time, ...e.position, size(e.velocityBefore), size(e.velocity));
        if (e.kind === "impact") this.writeSound(e, i);
      });
      this.key(ball, ball.velocity, ball.orientation);
      this.writeKeeper();
      this.writeNets();
      this.writeSquash();
      this.writeForces();
    }
    return Float64Array.from(this.rows.splice(0));
  }

  key({ time, position, velocity, spin }, before, orientation) {
    this.last = { time, spin, orientation };
    this.rows.push(ROW.key, time, ...position, ...before, ...velocity, ...spin, ...orientation, MOTIONS.indexOf(this.ball.motion));
  }

  writeSound(e, index) {
    const { loudness, brightness, brush, samples } = this.ball.impactSound(index, SOUND_RATE);
    if (loudness >= QUIET) this.rows.push(ROW.sound, e.time, loudness, brightness, brush, ...samples);
    this.rows.push(ROW.squash, e.time, 1, 1, ...e.normal);
  }

  writeSquash() {
    const { along, across, axis } = this.ball.squash(), flat = along < ROUND;
    if (flat || this.flat) this.rows.push(ROW.squash, this.ball.time, along, across, ...axis);
    this.flat = flat;
  }

  // Writes the forces with which the next step begins; zeros if it begins with impulses.
  writeForces() {
    if (!this.given.showsForces) return;
    const forces = this.ball.forces(TIME_STEP);
    this.rows.push(ROW.forces, this.ball.time, forces ? 1 : 0, ...FORCES.flatMap(name => forces ? forces[name] : [0, 0, 0]));
  }

  writeKeeper() {
    if (!this.keeper) return;
    const { feet, shoulders, gloves } = this.keeper.at(this.ball.time);
    this.rows.push(ROW.keeper, this.ball.time, ...feet, ...shoulders, ...gloves);
  }

  writeNets() {
    this.ball.bulges().forEach(({ depth, position, direction }, net) => {
      const moves = depth > 0.005;
      if (moves || this.moving[net]) this.rows.push(ROW.bulge, this.ball.time, net, depth, ...position, ...direction);
      this.moving[net] = moves;
    });
  }
}

// Rotates an orientation [x, y, z, w] by a spin during a time.
function turned(q, spin, time) {
  const angle = size(spin) * time;
  if (!(angle > 0)) return q;
  const s = Math.sin(angle / 2) * time / angle, [x, y, z, w] = [s * spin[0], s * spin[1], s * spin[2], Math.cos(angle / 2)];
  return [
    w * q[0] + x * q[3] + (y * q[2] - z * q[1]), w * q[1] + y * q[3] + (z * q[0] - x * q[2]),
    w * q[2] + z * q[3] + (x * q[1] - y * q[0]), w * q[3] - (x * q[0] + y * q[1] + z * q[2]),
  ];
}
