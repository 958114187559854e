using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Reference;

/// <summary>A reference case played by the library.</summary>
internal sealed class ReferenceRun
{
    private ReferenceRun(ReferenceCase wanted, Integrator integrator, double timeStep)
    {
        Case = wanted;
        var simulator = new Simulator(wanted.Scene, new SolverSettings { Integrator = integrator });
        BallState state = simulator.Launch(wanted.Position, wanted.Velocity, wanted.Spin, wanted.Orientation);
        var apex = new ApexObserver(state.Position.Y);
        var log = new StepLog { Observer = apex };
        bool halted = simulator.Run(ref state, timeStep, wanted.Duration, wanted.StopAt, log);
        Apex = apex.Apex;
        Events = log.Events.Span.ToArray();
        Time = state.Time;
        Position = state.Position;
        Velocity = state.Velocity;
        Spin = state.Spin;
        Orientation = state.Orientation;
        if (halted)
        {
            // An impact reports the impulse's own velocity, a rest that at which it was declared.
            BallEvent last = Array.FindLast(Events, item => item.Kind == (wanted.StopAt == StopAt.Impact ? BallEventKind.Impact : BallEventKind.Rest));
            Velocity = last.Velocity;
            Spin = last.Spin;
        }
    }

    public ReferenceCase Case { get; }

    public BallEvent[] Events { get; }

    public double Apex { get; }

    public double Time { get; }

    public Vector3d Position { get; }

    public Vector3d Velocity { get; }

    public Vector3d Spin { get; }

    public Quaterniond Orientation { get; }

    public bool EventsMatch => Events.Select(item => item.Kind).SequenceEqual(Case.Expected.Events.Select(item => item.Kind));

    /// <summary>Every case once, with one method and step.</summary>
    public static IReadOnlyList<ReferenceRun> PlayAll(Integrator integrator, double timeStep) =>
        [.. ReferenceCase.All.Select(item => new ReferenceRun(item, integrator, timeStep))];

    public override string ToString() => Case.Name;
}
