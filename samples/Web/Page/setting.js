// The settings of a user, from which the scene and a C# program for it are built.
const TIME_STEP = 0.01, LONGEST = 9, WALL_DISTANCE = 9.15, SHOULDER = 0.5, USUAL_PRESSURE = 0.8;
const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (s, a) => [s * a[0], s * a[1], s * a[2]];
const size = a => Math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
const normal = a => { const l = size(a); return [a[0] / l, a[1] / l, a[2] / l]; };
const between = (a, b, s) => plus(a, times(s, minus(b, a)));
const within = (x, low, high) => Math.max(low, Math.min(high, x));

class Setting {
  constructor(physics, { profile, ball, ground, altitude, windAcross, windAlong, distance, aside, wall, keeper, wetness, mud, wear, pressure }) {
    Object.assign(this, { physics, profile, ball, ground, altitude, windAcross, windAlong, distance, aside, wall, keeper, wetness, mud, wear, pressure });
  }

  // The default ground depends on the profile.
  get groundName() { return this.profile === "published" && this.ground === "matchTurf" ? "publishedTurf" : this.ground; }

  get goal() { return { center: [-this.aside, 0, -this.distance], facing: [0, 0, 1] }; }

  get wind() { return [this.windAcross, 0, -this.windAlong]; }

  // The dials that are not at their defaults.
  get dials() {
    const { wetness, mud, wear, pressure } = this;
    return Object.fromEntries(Object.entries({ wetness, mud, wear, pressure }).filter(([name, value]) => value !== (name === "pressure" ? USUAL_PRESSURE : 0)));
  }

  // The position of the ball before the kick.
  get start() { return [0, this.ballNumbers.radius, 0]; }

  get ballNumbers() { return this.physics.balls[this.ball]; }

  get reaction() { return [0, 0.38, 0.28, 0.2][this.keeper]; }

  get gloveSpeed() { return [0, 3.6, 4.6, 5.6][this.keeper]; }

  // The positions of the players in the wall, between the ball and the near half of the goal.
  get players() {
    const towards = normal([-this.aside + (this.aside < 0 ? -1.3 : 1.3), 0, -this.distance]), along = [-towards[2], 0, towards[0]];
    const distance = Math.min(WALL_DISTANCE, 0.6 * this.distance);
    return Array.from({ length: this.wall }, (_, i) => plus(times(distance, towards), times((i - 0.5 * (this.wall - 1)) * SHOULDER, along)));
  }

  // The published laws accept only numbers for a ball, not a type.
  scene(bodies) {
    const wall = at => [
      { name: "wall", shape: "capsule", from: plus(at, [0, 0.2, 0]), to: plus(at, [0, 1.35, 0]), radius: 0.2, surface: { material: "boot" } },
      { name: "wall", shape: "sphere", center: plus(at, [0, 1.7, 0]), radius: 0.12, surface: { material: "head" } },
    ];
    const weather = this.altitude === 0 ? {} : { weather: { altitude: this.altitude } };
    return this.physics.scene({
      profile: this.profile,
      ball: this.profile === "published" ? this.ballNumbers : { type: this.ball },
      ground: { surface: this.groundName },
      air: { ...weather, wind: this.wind },
      dials: this.dials,
      goals: [this.goal],
      obstacles: this.players.flatMap(wall),
      bodies,
    });
  }

  // Returns a program that plays a kick in this scene and prints the events.
  code(velocity, spin, keeperSource) {
    const dials = Object.entries(this.dials).map(([name, value]) => `${name[0].toUpperCase()}${name.slice(1)} = ${value}`).join(", ");
    const of = v => `new Vector3d(${Array.from(v, x => x + 0).join(", ")})`, { goal, keeper } = this;
    const profile = this.profile === "published" ? "Published" : "Measured";
    return "using FootballPhysics;\nusing FootballPhysics.Prediction;\nusing FootballPhysics.Shapes;\n\n"
      + `var goal = new Goal { Center = ${of(goal.center)}, Facing = new Vector3d(0, 0, 1) };\n`
      + (keeper > 0 ? `var keeper = new Keeper(goal, reaction: ${this.reaction}, speed: ${this.gloveSpeed});\n` : "")
      + (this.wall > 0 ? `Vector3d[] wall = [${this.players.map(of).join(", ")}];\n` : "")
      + `var scene = Scene.${profile} with\n{\n    Ball = BallProperties.Presets["${this.ball}"],\n    Ground = Ground.Presets["${this.groundName}"],\n`
      + `    Air = ${this.altitude === 0 ? "new Air()" : `Weather.AtAltitude(${this.altitude}).ToAir()`} with { Wind = ${of(this.wind)} },\n    Goals = [goal],\n`
      + (this.wall > 0 ? "    Obstacles =\n    [\n        .. wall.SelectMany(at => new[]\n        {\n"
        + "            new Obstacle { Name = \"wall\", Shape = new CapsuleShape(at + new Vector3d(0, 0.2, 0), at + new Vector3d(0, 1.35, 0), 0.2), Surface = SurfaceMaterial.Boot },\n"
        + "            new Obstacle { Name = \"wall\", Shape = new SphereShape(at + new Vector3d(0, 1.7, 0), 0.12), Surface = SurfaceMaterial.Head },\n        }),\n    ],\n" : "")
      + "};\n"
      + (dials ? `scene = new Dials { ${dials} }.Apply(scene);\n` : "")
      + "\n"
      + (keeper > 0 ? "var path = new Trajectory();\nvar empty = new Simulator(scene);\n"
        + `empty.LookAhead(empty.Launch(${of(this.start)}, ${of(velocity)}, ${of(spin)}), new LookAheadRequest { Duration = 3, TimeStep = ${TIME_STEP} }, path);\n`
        + "keeper.Watch(path);\n\n" : "")
      + `var ball = new Ball(${keeper > 0 ? "scene with { Bodies = keeper.Bodies }" : "scene"});\n`
      + `ball.Kick(velocity: ${of(velocity)}, spin: ${of(spin)});\n`
      + `while (ball.Time < ${LONGEST} && ball.Motion != MotionState.Rest)\n{\n${keeper > 0 ? "    keeper.MoveTo(ball.Time);\n" : ""}    ball.Step(${TIME_STEP});\n`
      + "    foreach (BallEvent happened in ball.Events)\n        Console.WriteLine(FormattableString.Invariant($\"{happened.Time:F6} {happened.Kind} {ball.Simulator.NameOf(happened.ColliderIndex)} {happened.Position.X:F6} {happened.Position.Y:F6} {happened.Position.Z:F6}\"));\n}\n"
      + (keeper > 0 ? "\n" + keeperSource : "");
  }
}
