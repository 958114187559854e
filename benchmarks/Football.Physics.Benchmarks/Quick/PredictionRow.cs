namespace FootballPhysics.Benchmarks;

/// <summary>A row of the table of predictors: requests, and the method that answers them.</summary>
internal sealed record PredictionRow(string Name, Func<ThesisAimer> Aimer, Func<AimRequest[]> Requests, AimMethod Method)
{
    /// <summary>Most plain RK2 steps an aim; none for rows that only inform.</summary>
    public double? Target { get; init; }

    /// <summary>Most simulations an aim, on average.</summary>
    public double? Simulations { get; init; }

    /// <summary>Largest true miss, m.</summary>
    public double? Miss { get; init; }

    /// <summary>Largest true miss at the point on the way, m.</summary>
    public double? ThroughMiss { get; init; }

    /// <summary>Whether every request must be out of reach.</summary>
    public bool OutOfReach { get; init; }

    /// <summary>What is asked; by default the kick by the method, without its miss measured.</summary>
    public Func<ThesisAimer, AimRequest, AimResult>? Question { get; init; }

    /// <summary>What the thesis measured.</summary>
    public string Thesis { get; init; } = "–";

    /// <summary>The answer with its miss measured.</summary>
    public AimResult Answer(ThesisAimer aimer, AimRequest request) => Question?.Invoke(aimer, request) ?? aimer.Find(request, Method);

    /// <summary>The requests, answered in order.</summary>
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
