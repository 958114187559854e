namespace FootballPhysics.Benchmarks;

/// <summary>A row of "A heap".</summary>
/// <param name="Name">The balls, their walls, and the method.</param>
/// <param name="Integrator">The method.</param>
/// <param name="Make">Makes the balls at the start.</param>
/// <param name="Contact">The time after which most balls touch others, s.</param>
internal sealed record HeapRow(string Name, Integrator Integrator, Func<Integrator, Heap> Make, double Contact) : Row(Name)
{
    /// <summary>The number of steps of all balls together per call.</summary>
    private const int Steps = 360;

    public override Integrator? FlightUnit => Integrator;

    public override IEnumerable<(string Name, Func<Workload> Make)> Subjects => [("moving", () => From(Contact)), ("at rest", () => From(HeapTable.Duration))];

    /// <summary>Repeats the steps that follow a time.</summary>
    private Workload From(double time)
    {
        Heap heap = Make(Integrator);
        var log = new StepLog();
        heap.Group.Run(heap.States, Heap.Frame, time, StopAt.Rest, log);
        var states = new BallState[heap.States.Length];
        int frames = Steps / states.Length;
        return new Workload(
            () =>
            {
                Array.Copy(heap.States, states, states.Length);
                for (int i = 0; i < frames; i++)
                {
                    log.Clear();
                    heap.Group.Step(states, Heap.Frame, log);
                }

                return states[0].Position.X;
            },
            frames * states.Length);
    }
}
