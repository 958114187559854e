// The functions that the page calls, for scenes, predicted paths, kicks and aims. They use the npm package.
const KINDS = ["impact", "slide", "roll", "rest", "net", "goal", "contactEnd", "pinned", "enterZone", "exitZone"];
const MOTIONS = ["airborne", "sliding", "rolling", "rest", "pinned"];

class Playground {
  constructor(physics, keeperSource) {
    Object.assign(this, { physics, keeperSource, settings: [], balls: [], flights: new Map() });
  }

  names() { return { balls: Object.keys(this.physics.balls), grounds: this.physics.materials.slice(0, this.physics.materials.indexOf("goalFrame")) }; }

  // Sets the scene, and returns its objects for the drawing.
  set(profile, ball, ground, altitude, windAcross, windAlong, distance, aside, wall, keeper, wetness, mud, wear, pressure) {
    this.put(0, new Setting(this.physics, { profile, ball, ground, altitude, windAcross, windAlong, distance, aside, wall, keeper, wetness, mud, wear, pressure }));
    const { radius, kinematicViscosity, shapes, goals } = this.balls[0].scene;
    return { radius, kinematicViscosity, shapes, goals, wind: this.settings[0].wind };
  }

  // Sets a second scene for comparison: the first one with other laws and another ball. Returns the ball's radius.
  beside(profile, ball) {
    this.put(1, new Setting(this.physics, { ...this.settings[0], profile, ball }));
    return this.settings[1].start[1];
  }

  put(which, setting) {
    this.settings[which] = setting;
    this.balls[which] = setting.scene([]).ball();
  }

  // Returns the path of a kick without the goalkeeper, in steps of the page: times and positions.
  ahead(which, speed, elevation, azimuth, topSpin, sideSpin, seconds) {
    const kick = this.physics.kickVectors({ speed, elevation, azimuth, topSpin, sideSpin });
    const rows = this.look(which, kick, seconds, 1 + Math.round(seconds / (2 * TIME_STEP)));
    let end = 4;
    while (end < rows.length && rows[end] > rows[end - 4]) end += 4;
    return rows.slice(0, end);
  }

  look(which, { velocity, spin }, seconds, samples) {
    const ball = this.balls[which];
    ball.launch(this.settings[which].start, velocity, spin);
    return ball.lookAhead(seconds, samples, { timeStep: TIME_STEP });
  }

  // Kicks a ball, with a number that the page chooses. The page draws the forces on some balls only.
  kick(number, which, showsForces, speed, elevation, azimuth, topSpin, sideSpin) {
    const kick = this.physics.kickVectors({ speed, elevation, azimuth, topSpin, sideSpin }), setting = this.settings[which];
    let keeper = null;
    if (setting.keeper > 0) {
      this.look(which, kick, 3, 2);
      keeper = new Keeper(setting.goal, setting.reaction, setting.gloveSpeed);
      keeper.watch(this.balls[which]);
    }
    this.flights.set(number, new Flight({ setting, keeper, kick, showsForces, changes: [] }));
  }

  // Continues a kicked ball in the present scene from a time on. The ball is simulated again up to that time, because it is ahead of the display.
  change(number, which, time) {
    const old = this.flights.get(number), changes = old.given.changes.filter(change => change.time < time);
    this.flights.set(number, new Flight({ ...old.given, changes: [...changes, { time, setting: this.settings[which] }] }));
    old.free();
  }

  advance(number, seconds) { return this.flights.get(number).advance(seconds); }

  isOver(number) { return this.flights.get(number).isOver; }

  nameOf(number, collider) { return this.flights.get(number).scene.names[collider] ?? ""; }

  // Returns the chance of the goalkeeper in a sentence; empty if there is none.
  answer(number) {
    const { keeper } = this.flights.get(number), answer = keeper?.answer;
    if (!answer?.crosses) return "";
    if (!answer.isOnTarget) return "Off target.";
    return answer.saves ? `The keeper can get there if he dives by ${answer.latestReaction.toFixed(2)} s.`
      : `Out of the keeper's reach: he covers ${answer.reachRight.toFixed(1)} m, it is ${Math.abs(answer.lateralOffset).toFixed(1)} m aside.`;
  }

  forget() {
    for (const flight of this.flights.values()) flight.free();
    this.flights.clear();
  }

  // Finds the kick that reaches a point at a speed, over or round the wall. Returns status, speed, elevation, azimuth, topspin, sidespin, miss, time and the blocking object.
  aim(x, y, z, speed, top, side) {
    const setting = this.settings[0], found = this.balls[0].scene.aim({
      from: setting.start, target: [x, y, z], speed, spin: { top, side, free: setting.wall > 0 }, maxSpin: { top: 70, side: 90 }, elevation: { max: 60 }, tolerance: 0.02,
    });
    return [
      found.status[0].toUpperCase() + found.status.slice(1), found.speed, found.elevation, found.azimuth, found.topSpin, found.sideSpin, found.miss, found.time, found.blockedBy ?? "",
    ].join("|");
  }

  // Returns the C# program that reproduces a kick.
  code(speed, elevation, azimuth, topSpin, sideSpin) {
    const { velocity, spin } = this.physics.kickVectors({ speed, elevation, azimuth, topSpin, sideSpin });
    return this.settings[0].code(velocity, spin, this.keeperSource);
  }

  // Returns the golden kicks, line by line. Every runtime must produce the same lines.
  golden(every) { return this.physics.goldenHashes(every); }
}
