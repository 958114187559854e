namespace FootballPhysics.Labs;

/// <summary>Random requests answered by the library's own solver, its verdicts held against the dense scan.</summary>
internal sealed class AimVerdicts
{
    /// <summary>Elevations that a scan tries.</summary>
    public const int Elevations = 181;

    private readonly Lock _lock = new();
    private readonly List<string> _examples = [];

    public int Requests { get; private set; }

    public int Hits { get; private set; }

    public int OutOfReach { get; private set; }

    public int NotConverged { get; private set; }

    /// <summary>Answers that are no kick of the speed asked for within the bounds.</summary>
    public int WithoutAnswer { get; private set; }

    /// <summary>Requests that were scanned: all that were not hit, or a sample of them. A hit proves itself by its measured miss.</summary>
    public int Scanned { get; private set; }

    /// <summary>Scanned requests that the scan hits.</summary>
    public int Wrong { get; private set; }

    /// <summary>Scanned requests whose kick is further off than the scan's best, by more than 1 cm and 1 %.</summary>
    public int NotClosest { get; private set; }

    public long HitSimulations { get; private set; }

    public long OtherSimulations { get; private set; }

    public double WorstHit { get; private set; }

    /// <summary>The first few that are wrong, or not the closest.</summary>
    public IEnumerable<string> Examples => _examples.Order(StringComparer.Ordinal).Take(5);

    /// <summary>Whether the scan contradicts no verdict, and every request has one.</summary>
    public bool Hold => Wrong == 0 && NotClosest == 0 && WithoutAnswer == 0 && NotConverged == 0;

    /// <summary>Answers all requests, on all processors.</summary>
    /// <param name="seed">Seed of the requests.</param>
    /// <param name="count">How many.</param>
    /// <param name="scanEvery">Scans every so manieth of those that were not hit.</param>
    /// <param name="report">Told how many are done.</param>
    public static AimVerdicts Of(int seed, int count, int scanEvery, Action<int> report) =>
        Of(index => AimAnything.Scene(seed, index), seed, count, scanEvery, report);

    /// <summary>The same in other scenes.</summary>
    /// <param name="scene">The scene of an index.</param>
    /// <param name="seed">Seed of the requests.</param>
    /// <param name="count">How many.</param>
    /// <param name="scanEvery">Scans every so manieth of those that were not hit.</param>
    /// <param name="report">Told how many are done.</param>
    public static AimVerdicts Of(Func<int, Scene> scene, int seed, int count, int scanEvery, Action<int> report)
    {
        var verdicts = new AimVerdicts();
        int perScene = (count + AimAnything.Scenes - 1) / AimAnything.Scenes;
        Parallel.For(
            0, AimAnything.Scenes, index => verdicts.Run(scene(index), seed, index, Math.Min(perScene, count - (index * perScene)), scanEvery, report));
        return verdicts;
    }

    /// <summary>All of it in a row.</summary>
    /// <param name="name">What was asked for.</param>
    public LabTable Table(string name = "Random requests (5 to 40 m/s, spins, winds, laws, 1 to 70 m, heights, elevation bounds; 1 mm), direct, held against a dense scan")
    {
        var table = new LabTable(
            name,
            "requests", "hit", "out of reach", "not converged", "without an answer", "worst hit, mm", "simulations: hit", "simulations: others", "scanned", "can be hit", "can be closer");
        int others = Requests - Hits;
        table.Add(
            Requests, Hits, OutOfReach, NotConverged, WithoutAnswer, 1e3 * WorstHit, Hits > 0 ? (double)HitSimulations / Hits : null,
            others > 0 ? (double)OtherSimulations / others : null, Scanned, Wrong, NotClosest);
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
            lock (_lock)
            {
                Add(index, request, in result, best);
                report(Requests);
            }
        }
    }

    private void Add(int scene, AimRequest request, in AimResult result, double? best)
    {
        Requests++;
        double elevation = Math.Atan2(result.Velocity.Y, result.Velocity.Horizontal.Length) * 180 / Math.PI;
        bool answer = Math.Abs(result.Velocity.Length - request.Speed) <= 1e-9 * request.Speed && result.Spin.IsFinite && double.IsFinite(result.Miss)
            && elevation >= request.MinimumElevationDegrees - 1e-7 && elevation <= request.MaximumElevationDegrees + 1e-7;
        WithoutAnswer += answer ? 0 : 1;
        switch (result.Status)
        {
            case AimStatus.Hit:
                Hits++;
                HitSimulations += result.Simulations;
                WorstHit = Math.Max(WorstHit, result.Miss);
                break;
            case AimStatus.OutOfReach:
                OutOfReach++;
                OtherSimulations += result.Simulations;
                break;
            default:
                NotConverged++;
                OtherSimulations += result.Simulations;
                break;
        }

        if (best is { } miss)
        {
            Scanned++;
            bool notClosest = result.Miss > (1.01 * miss) + 0.01;
            NotClosest += notClosest ? 1 : 0;
            Wrong += miss < request.Tolerance ? 1 : 0;
            if (notClosest || miss < request.Tolerance)
            {
                _examples.Add(FormattableString.Invariant($"scene {scene}: {result.Status} with a miss of {result.Miss:0.0000} m, the scan has {miss:0.000000} m; {request}"));
            }
        }
    }
}
