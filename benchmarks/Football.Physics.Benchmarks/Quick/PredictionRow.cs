namespace FootballPhysics.Benchmarks;

/// <summary>A row of the table of predictors: requests, and the method that solves them.</summary>
internal sealed record PredictionRow(string Name, Func<ThesisAimer> Aimer, Func<AimRequest[]> Requests, AimMethod Method) : Row(Name)
{
    public override IEnumerable<(string Name, Func<Workload> Make)> Subjects => Only(Subject);

    /// <summary>The largest number of plain RK2 steps per aim; null if the row has no target.</summary>
    public double? Target { get; init; }

    /// <summary>The largest mean number of simulations per aim.</summary>
    public double? Simulations { get; init; }

    /// <summary>The largest true miss, m.</summary>
    public double? Miss { get; init; }

    /// <summary>The largest true miss at the waypoint, m.</summary>
    public double? ThroughMiss { get; init; }

    /// <summary>True if every request must be out of reach.</summary>
    public bool OutOfReach { get; init; }

    /// <summary>The query; by default the kick by the method, without measuring its miss.</summary>
    public Func<ThesisAimer, AimRequest, AimResult>? Question { get; init; }

    /// <summary>The thesis' result.</summary>
    public string Thesis { get; init; } = "–";

    /// <summary>Returns the result with its measured miss.</summary>
    public AimResult Answer(ThesisAimer aimer, AimRequest request) => Question?.Invoke(aimer, request) ?? aimer.Find(request, Method);

    /// <summary>Solves the requests in order.</summary>
    public Workload Subject()
    {
        ThesisAimer aimer = Aimer();
        AimRequest[] requests = Requests();
        Func<ThesisAimer, AimRequest, AimResult> ask = Question ?? ((one, request) => one.Find(request, Method, measure: false));
        return new Workload(() => Answer(aimer, requests, ask), requests.Length);
    }

    private static double Answer(ThesisAimer aimer, AimRequest[] requests, Func<ThesisAimer, AimRequest, AimResult> ask)
    {
        double sum = 0;
        foreach (AimRequest request in requests)
        {
            sum += ask(aimer, request).Time;
        }

        return sum;
    }
}
