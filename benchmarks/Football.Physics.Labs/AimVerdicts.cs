namespace FootballPhysics.Labs;

/// <summary>Runs the library's own solver on random requests, and checks its verdicts against the dense scan.</summary>
internal sealed class AimVerdicts
{
    /// <summary>The number of elevations that a scan tries.</summary>
    public const int Elevations = 181;

    private readonly LabCounts _counts = new();

    /// <summary>The first few answers that are wrong or not the closest.</summary>
    public IEnumerable<string> Examples => _counts.Examples.Take(5);

    /// <summary>True if the scan hits no request that the solver missed, and every request has an answer.</summary>
    public bool Answers => _counts["can be hit"] == 0 && _counts["without an answer"] == 0;

    /// <summary>True if the scan contradicts no verdict, and every request has one.</summary>
    public bool Hold => Answers && _counts["can be closer"] == 0 && _counts["not converged"] == 0;

    /// <summary>Solves all requests, on all processors.</summary>
    /// <param name="seed">Seed of the requests.</param>
    /// <param name="count">The number of requests.</param>
    /// <param name="scanEvery">The scan checks one in this many of the requests that were not hit.</param>
    /// <param name="report">Receives the number of requests done.</param>
    public static AimVerdicts Of(int seed, int count, int scanEvery, Action<int> report) =>
        Of(index => AimAnything.Scene(seed, index), seed, count, scanEvery, report);

    /// <summary>Solves requests in other scenes.</summary>
    /// <param name="scene">Returns the scene of an index.</param>
    /// <param name="seed">Seed of the requests.</param>
    /// <param name="count">The number of requests.</param>
    /// <param name="scanEvery">The scan checks one in this many of the requests that were not hit.</param>
    /// <param name="report">Receives the number of requests done.</param>
    public static AimVerdicts Of(Func<int, Scene> scene, int seed, int count, int scanEvery, Action<int> report)
    {
        var verdicts = new AimVerdicts();
        int perScene = (count + AimAnything.Scenes - 1) / AimAnything.Scenes;
        Parallel.For(
            0, AimAnything.Scenes, index => verdicts.Run(scene(index), seed, index, Math.Min(perScene, count - (index * perScene)), scanEvery, report));
        return verdicts;
    }

    /// <summary>Returns all counts as one row.</summary>
    /// <param name="name">The name of the requests.</param>
    public LabTable Table(string name = "Random requests (5 to 40 m/s, spins, winds, laws, 1 to 70 m, heights, elevation bounds; 1 mm), direct, held against a dense scan")
    {
        var table = new LabTable(
            name,
            "requests", "hit", "out of reach", "not converged", "without an answer", "worst hit, mm", "simulations: hit", "simulations: others", "scanned", "can be hit", "can be closer");
        long hits = _counts["hit"];
        long others = _counts["requests"] - hits;
        table.Add(
        [
            .. _counts.Cells("requests", "hit", "out of reach", "not converged", "without an answer", "worst hit, mm"),
            hits > 0 ? (double)_counts["simulations: hit"] / hits : null, others > 0 ? (double)_counts["simulations: others"] / others : null,
            .. _counts.Cells("scanned", "can be hit", "can be closer"),
        ]);
        return table;
    }

    private void Run(Scene scene, int seed, int index, int count, int scanEvery, Action<int> report)
    {
        if (count <= 0)
        {
            return;
        }

        var aimer = new Aimer(scene);
        var scan = new AimScan(scene);
        int missed = 0;
        foreach (AimRequest request in AimAnything.Requests(seed, index, count))
        {
            AimResult result = aimer.Find(request);
            double? best = !result.HitsTarget && missed++ % scanEvery == 0 ? scan.Best(request, Elevations) : null;
            Add(index, request, in result, best);
            report((int)_counts["requests"]);
        }
    }

    private void Add(int scene, AimRequest request, in AimResult result, double? best)
    {
        _counts.Add("requests");
        double elevation = Math.Atan2(result.Velocity.Y, result.Velocity.Horizontal.Length) * 180 / Math.PI;
        bool answer = Math.Abs(result.Velocity.Length - request.Speed) <= 1e-9 * request.Speed && result.Spin.IsFinite && double.IsFinite(result.Miss)
            && elevation >= request.MinimumElevationDegrees - 1e-7 && elevation <= request.MaximumElevationDegrees + 1e-7;
        _counts.AddIf(!answer, "without an answer");
        bool hit = result.Status == AimStatus.Hit;
        _counts.Add(hit ? "hit" : result.Status == AimStatus.OutOfReach ? "out of reach" : "not converged");
        _counts.Add(hit ? "simulations: hit" : "simulations: others", result.Simulations);
        _counts.Most("worst hit, mm", hit ? 1e3 * result.Miss : 0);
        if (best is { } miss)
        {
            bool notClosest = result.Miss > (1.01 * miss) + 0.01;
            _counts.Add("scanned");
            _counts.AddIf(notClosest, "can be closer");
            _counts.AddIf(miss < request.Tolerance, "can be hit");
            _counts.Require(
                !notClosest && miss >= request.Tolerance,
                "contradicted",
                $"scene {scene}: {result.Status} with a miss of {result.Miss:0.0000} m, the scan has {miss:0.000000} m; {request}");
        }
    }
}
