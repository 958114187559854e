using FootballPhysics.Aiming;
using FootballPhysics.Prediction;

namespace FootballPhysics.Passes.Plays;

/// <summary>One ball on open ground and on pitches: kicks of all kinds, each ball preset, each surface, each setting of the solver.</summary>
internal static class OneBall
{
    public static void Play()
    {
        var draw = new Draw(1);
        Scene[] scenes =
        [
            Scene.Default, Scene.HighAltitude, Scene.Windy(new Vector3d(4, 0, -2)), Pitch.Standard.On(), Pitch.Stadium.On(), Pitch.Futsal.On(), Pitch.Cage.On(),
            .. BallProperties.Presets.Values.Select(ball => new Scene { Ball = ball }),
            .. Ground.Presets.Values.Select(ground => new Scene { Ground = ground }),
            .. Dialled().Select(dials => dials.Apply(Scene.Default)),
        ];
        foreach (Scene scene in scenes)
        {
            Kicks(draw, new Simulator(scene), 5, 1.0 / 60);
        }

        foreach (Integrator integrator in Enum.GetValues<Integrator>())
        {
            var settings = new SolverSettings { Integrator = integrator };
            Kicks(draw, new Simulator(null, settings), 4, 0.005);
            Kicks(draw, new Simulator(Pitch.Cage.On(), settings), 4, 0.005);
            Kicks(draw, new Simulator(null, settings with { CollisionTiming = CollisionTiming.Bisection, RollingTransition = RollingTransition.Heuristic }), 4, 0.005);
        }

        foreach (Accuracy accuracy in Enum.GetValues<Accuracy>())
        {
            SolverSettings settings = SolverSettings.For(accuracy, out double timeStep);
            Kicks(draw, new Simulator(null, settings), 4, timeStep);
        }

        // Long and short steps, and steps of any length.
        foreach (double step in new[] { 1e-6, 1e-3, 0.1, 0.5, 2 })
        {
            Kicks(draw, new Simulator(Pitch.Stadium.On()), 4, step);
        }

        Handled(draw);
    }

    /// <summary>Launches and kicks a ball, each time until it rests or for 20 s.</summary>
    public static void Kicks(Draw draw, Simulator simulator, int count, double step)
    {
        var log = new StepLog();
        for (int i = 0; i < count; i++)
        {
            (Vector3d velocity, Vector3d spin) = draw.Kick();
            BallState ball = simulator.Launch(new Vector3d(draw.Between(-20, 20), draw.Any(0, 0.11, 1.5), draw.Between(-45, 45)), velocity, spin);
            simulator.Run(ref ball, step, Math.Min(20, 2000 * step), draw.Any(StopAt.Rest, StopAt.Rest, StopAt.Impact, StopAt.Time), log, draw.Chance(0.2) ? _ => { }
            : null);
            (velocity, spin) = draw.Kick();
            simulator.Kick(ref ball, velocity, spin);
            simulator.Run(ref ball, step, Math.Min(20, 2000 * step), StopAt.Rest, log);
            log.Clear();
        }
    }

    private static IEnumerable<Dials> Dialled() =>
        [new Dials { Wetness = 0.4 }, new Dials { Mud = 0.5, Wear = 0.3 }, new Dials { Pressure = 0.7 }, new Dials { Wetness = 1, Pressure = 1.05, Wear = 0.9 }];

    // The game's own class for a ball: placed, kicked by angles, described, and watched ahead.
    private static void Handled(Draw draw)
    {
        var ball = new Ball(Pitch.Standard.On());
        var words = new List<string?>();
        for (int i = 0; i < 30; i++)
        {
            ball.Place(new Vector3d(draw.Between(-30, 30), draw.Between(0, 2), draw.Between(-40, 40)));
            switch (i % 3)
            {
                case 0:
                    ball.Kick(draw.Between(5, 30), draw.Between(0, 40), draw.Between(-180, 180), draw.Between(-30, 30), draw.Between(-60, 60));
                    break;
                case 1:
                    ball.Kick(draw.Between(5, 30), draw.Heading(), draw.Between(-30, 30), draw.Between(-60, 60));
                    break;
                default:
                    ball.Launch(ball.State.Position, draw.Vector(20), draw.Vector(60));
                    break;
            }

            for (int step = 0; step < 200; step++)
            {
                ball.Step(1.0 / 60);
                foreach (ref readonly BallEvent happened in ball.Events)
                {
                    words.Add(ball.NameOf(in happened));
                    words.Add(happened.ToString());
                    _ = ball.Simulator.ImpactOf(in happened).EnergyLost + happened.TickAt(1.0 / 60) + happened.ApproachSpeed + happened.SpeedLost;
                }
            }

            BallState state = ball.State;
            words.Add(state.ToString() + ball.Motion + ball.Position + ball.Velocity + ball.Spin + ball.Orientation);
        }

        var path = new Trajectory();
        ball.LookAhead(new LookAheadRequest { Duration = 2 }, path);
        ball.Place(new Vector3d(0, 0.11, 30));
        ball.Kick(new Aimer(ball.Simulator).Find(new AimRequest { From = ball.Position, Target = new Vector3d(2, 1, 52), Speed = 25 }));
        for (int i = 0; i < 1200; i++)
        {
            ball.Step(1.0 / 60);
        }

        // The ball rests: it stays at rest in the new scene if that has the same ground there.
        ball.Simulator = new Simulator(Pitch.Futsal.On());
        ball.State = ball.Simulator.Launch(new Vector3d(0, 1, 0), default, default);
        ball.Step(0.01);
        ball.Simulator.WarmUp();
    }
}
