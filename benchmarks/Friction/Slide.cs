namespace FootballPhysics.Friction;

/// <summary>The largest differences between a slide of the library and the closed form.</summary>
internal readonly record struct Errors(double Slip, double Way, double End, double Roll)
{
    /// <summary>True if no difference of the slide exceeds a limit, and none of its end another one.</summary>
    public bool Within(double most, double mostAtEnd) => Slip <= most && Way <= most && End <= mostAtEnd && Roll <= mostAtEnd;
}

/// <summary>A ball that slides along a track without spin at first, until it rolls.</summary>
internal static class Slide
{
    private const double Speed = 9;

    /// <summary>Plays a slide, and compares it with the law at 80 % of its duration and at its end.</summary>
    /// <remarks>
    /// Each of n contacts bears g/(n cos φ) per mass. At the lever r cos φ, its friction turns the ball, so ds/dt = (1 + cos² φ/α) dv/dt.
    /// </remarks>
    public static Errors Compare(Track track, SlipLaw law, Integrator method, int rate)
    {
        BallProperties ball = track.Scene.Ball;
        double cos = Math.Cos(track.Lean);
        double slowing = track.Friction * track.Scene.Gravity / cos;
        double perSpeed = 1.0 + (cos * cos / ball.InertiaFactor);
        double lambda = perSpeed * slowing;
        double end = law.EndOf(Speed, lambda);
        double read = 0.8 * end;

        var simulator = new Simulator(track.Scene, new SolverSettings { Integrator = method });
        BallState state = simulator.Launch(track.Position, new Vector3d(0, 0, -Speed), default);
        var log = new StepLog();
        double dt = 1.0 / rate;
        for (; state.Time + dt < read; log.Clear())
        {
            simulator.Step(ref state, dt, log);
        }

        simulator.Step(ref state, read - state.Time, log);
        double slip = -state.Velocity.Z - (ball.Radius * cos * -state.Spin.X);
        double wantedSlip = law.After(Speed, lambda, read);
        double wantedWay = (Speed * read) - (((Speed * read) - law.Way(Speed, lambda, read)) / perSpeed);
        double way = -state.Position.Z;

        BallEvent roll = default;
        while (roll.Kind != BallEventKind.Roll && state.Time < end + 1)
        {
            log.Clear();
            simulator.Step(ref state, dt, log);
            foreach (BallEvent happened in log.Events)
            {
                roll = happened.Kind == BallEventKind.Roll ? happened : roll;
            }
        }

        double speed = Speed - (Speed / perSpeed);
        return new Errors(Math.Abs(slip - wantedSlip), Math.Abs(way - wantedWay), Math.Abs(roll.Time - end), Math.Abs(roll.Velocity.Length - speed));
    }
}
