namespace FootballPhysics.Tests.Support;

/// <summary>Short ways to play a shot.</summary>
internal static class Flight
{
    public const double Radius = 0.11;

    public static Integrator[] Integrators { get; } = Enum.GetValues<Integrator>();

    /// <summary>One theory row an integrator.</summary>
    public static TheoryData<Integrator> EveryIntegrator() => [.. Integrators];

    public static SolverSettings With(Integrator integrator) => new() { Integrator = integrator };

    /// <summary>Plays until the first impact and gives it.</summary>
    public static BallEvent ToImpact(Scene scene, Integrator integrator, double timeStep, Vector3d position, Vector3d velocity, Vector3d spin)
    {
        BallState state = Play(scene, With(integrator), timeStep, 60, StopAt.Impact, position, velocity, spin, out StepLog log);
        Assert.True(log.Events.Count > 0, $"no impact before {state.Time} s");
        return log.Events[0];
    }

    /// <summary>Plays and gives the final state.</summary>
    public static BallState Play(
        Scene scene, SolverSettings settings, double timeStep, double duration, StopAt stopAt, Vector3d position, Vector3d velocity, Vector3d spin, out StepLog log)
    {
        var simulator = new Simulator(scene, settings);
        BallState state = simulator.Launch(position, velocity, spin);
        var limit = new PieceLimit(2_000_000);
        log = new StepLog { Observer = limit };
        simulator.Run(ref state, timeStep, duration, stopAt, log);
        Assert.False(limit.Reached, $"a run of {duration} s does not end");
        return state;
    }

    /// <summary>The event of a kind, which must have happened.</summary>
    public static BallEvent First(StepLog log, BallEventKind kind)
    {
        foreach (ref readonly BallEvent item in log.Events)
        {
            if (item.Kind == kind)
            {
                return item;
            }
        }

        throw new InvalidOperationException($"no {kind} among {log.Events.Count} events");
    }

    public static string Kinds(StepLog log) => string.Join(' ', log.Events.Span.ToArray().Select(item => item.Kind));
}
