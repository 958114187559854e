namespace FootballPhysics.Yardsticks;

/// <summary>The errors of the general engine's method for a football.</summary>
/// <param name="Rebounds">The measured restitution of drops, at several steps.</param>
/// <param name="Curl">Sideways deflection after 1 s of a 25 m/s shot with 40 rad/s of sidespin, m.</param>
/// <param name="TrueCurl">The same deflection by the library, m.</param>
/// <param name="Roll">The distance after 60 s of a ball that starts to roll at 5 m/s, without damping, m.</param>
/// <param name="TrueRoll">The distance at which it comes to rest by the library, m.</param>
/// <param name="VacuumLandings">The distance between the landing of a 20 m/s, 30° shot in vacuum and the parabola's end, at several steps.</param>
public sealed record RigidBodyEngineReport(
    IReadOnlyList<RigidBodyRebound> Rebounds,
    double Curl,
    double TrueCurl,
    double Roll,
    double TrueRoll,
    IReadOnlyList<RigidBodyLanding> VacuumLandings)
{
    private static readonly double[] Frames = [1.0 / 25, 1.0 / 30, 1.0 / 60, 1.0 / 120, 1.0 / 240];

    private static readonly double Radius = BallProperties.Tunnel.Radius;

    /// <summary>Runs all measurements.</summary>
    public static RigidBodyEngineReport Measure()
    {
        Vector3d velocity = new(0, 5, -25);
        Vector3d spin = new(0, 40, 0);
        return new RigidBodyEngineReport(
            [.. Frames.Select(Rebound)],
            EngineCurl(velocity, spin),
            TrueCurlOf(velocity, spin),
            EngineRoll(5),
            TrueRollOf(5),
            [.. Frames.Select(Landing)]);
    }

    /// <summary>Drops from 0.5 to 1.5 m, restitution 0.6: √(height after / height before) should be 0.6 each time.</summary>
    private static RigidBodyRebound Rebound(double h)
    {
        var engine = new RigidBodyEngine { LinearDamping = 0, AngularDamping = 0 };
        double least = double.PositiveInfinity;
        double greatest = 0;
        for (int i = 0; i <= 200; i++)
        {
            double drop = 0.5 + (0.005 * i);
            var s = new PlainState { Position = new PlainVector(0, Radius + drop, 0) };
            double top = 0;
            bool bounced = false;
            for (int k = 0; k * h < 3; k++)
            {
                engine.Step(ref s, h);
                if (bounced && s.Velocity.Y <= 0)
                {
                    break;
                }

                bounced |= s.Velocity.Y > 0;
                top = bounced ? Math.Max(top, s.Position.Y - Radius) : 0;
            }

            double restitution = Math.Sqrt(top / drop);
            least = Math.Min(least, restitution);
            greatest = Math.Max(greatest, restitution);
        }

        return new RigidBodyRebound(h, engine.Restitution, least, greatest);
    }

    private static double EngineCurl(Vector3d velocity, Vector3d spin)
    {
        var engine = new RigidBodyEngine();
        var s = PlainState.Of(new Shot(new Vector3d(0, ShotSets.HighUp, 0), velocity, spin));
        for (int i = 0; i < RigidBodyEngine.FrameRate; i++)
        {
            engine.Step(ref s, 1.0 / RigidBodyEngine.FrameRate);
        }

        return s.Position.X;
    }

    private static double TrueCurlOf(Vector3d velocity, Vector3d spin)
    {
        var simulator = new Simulator(Scene.Published);
        BallState s = simulator.Launch(new Vector3d(0, ShotSets.HighUp, 0), velocity, spin);
        simulator.Run(ref s, ShotSets.TimeStep, 1.0, StopAt.Time, new StepLog());
        return s.Position.X;
    }

    private static double EngineRoll(double speed)
    {
        var engine = new RigidBodyEngine { LinearDamping = 0, AngularDamping = 0 };
        var s = new PlainState { Position = new PlainVector(0, Radius, 0), Velocity = new PlainVector(speed, 0, 0), Spin = new PlainVector(0, 0, -speed / Radius) };
        for (int i = 0; i < 60 * RigidBodyEngine.FrameRate; i++)
        {
            engine.Step(ref s, 1.0 / RigidBodyEngine.FrameRate);
        }

        return s.Position.X;
    }

    private static double TrueRollOf(double speed)
    {
        var simulator = new Simulator(Scene.Published);
        BallState s = simulator.Launch(new Vector3d(0, Radius, 0), new Vector3d(speed, 0, 0), new Vector3d(0, 0, -speed / Radius));
        simulator.Run(ref s, ShotSets.TimeStep, 60, StopAt.Rest, new StepLog());
        return s.Position.X;
    }

    private static RigidBodyLanding Landing(double h)
    {
        var engine = new RigidBodyEngine { LinearDamping = 0, AngularDamping = 0, Friction = 0 };
        double up = 10;
        double along = 20 * Math.Sqrt(0.75);
        var s = new PlainState { Position = new PlainVector(0, Radius, 0), Velocity = new PlainVector(along, up, 0) };
        do
        {
            engine.Step(ref s, h);
        }
        while (s.Position.Y > Radius);

        return new RigidBodyLanding(h, s.Position.X - (along * 2.0 * up / engine.Gravity));
    }
}

/// <summary>The measured restitution of drops at one step, s, and the worst cases.</summary>
public sealed record RigidBodyRebound(double TimeStep, double Restitution, double Least, double Greatest);

/// <summary>The distance between the landing of a shot in vacuum and the parabola's end, at one step, s.</summary>
public sealed record RigidBodyLanding(double TimeStep, double Error);
