namespace FootballPhysics.Labs;

/// <summary>Runs the library's own solver on random requests, and checks its verdicts against the dense scan.</summary>
internal static class AimVerdicts
{
    /// <summary>The number of elevations that a scan tries.</summary>
    public const int Elevations = 181;

    /// <summary>The number of answers shown that are wrong or not the closest.</summary>
    private const int Shown = 5;

    private static readonly string[] s_before = ["requests", "hit", "out of reach", "not converged", "without an answer", "worst hit, mm"];
    private static readonly string[] s_after = ["scanned", "can be hit", "can be closer"];

    /// <summary>True if the scan hits no request that the solver missed, and every request has an answer.</summary>
    public static bool Answers(LabCounts counts) => counts["can be hit"] == 0 && counts["without an answer"] == 0;

    /// <summary>True if the scan contradicts no verdict, and every request has one.</summary>
    public static bool Hold(LabCounts counts) => Answers(counts) && counts["can be closer"] == 0 && counts["not converged"] == 0;

    /// <summary>Solves requests on all processors, and adds a table.</summary>
    /// <param name="run">The run that receives the table, and some answers that are wrong or not the closest.</param>
    /// <param name="title">The title of the table.</param>
    /// <param name="scene">Returns the scene of an index.</param>
    /// <param name="count">The number of requests.</param>
    /// <param name="scanEvery">The scan checks one in this many of the requests that were not hit.</param>
    public static LabCounts Of(LabRun run, string title, Func<int, Scene> scene, int count, int scanEvery)
    {
        int perScene = (count + AimAnything.Scenes - 1) / AimAnything.Scenes;
        LabCounts counts = LabCounts.Of(count, perScene, (counts, index, requests) => Solve(counts, scene(index), unchecked((int)run.Seed), index, requests, scanEvery));
        long hits = counts["hit"];
        long others = counts["requests"] - hits;
        run.Table(title, [.. s_before, "simulations: hit", "simulations: others", .. s_after]).Add(
            [
                .. counts.Cells(s_before), hits > 0 ? (double)counts["simulations: hit"] / hits : null, others > 0 ? (double)counts["simulations: others"] / others : null,
                .. counts.Cells(s_after),
            ]);
        run.Notes.AddRange(counts.Examples.Take(Shown));
        return counts;
    }

    private static void Solve(LabCounts counts, Scene scene, int seed, int index, int count, int scanEvery)
    {
        var aimer = new Aimer(scene);
        var scan = new AimScan(scene);
        int missed = 0;
        foreach (AimRequest request in AimAnything.Requests(seed, index, count))
        {
            AimResult result = aimer.Find(request);
            double? best = !result.HitsTarget && missed++ % scanEvery == 0 ? scan.Best(request, Elevations) : null;
            Add(counts, index, request, in result, best);
        }
    }

    private static void Add(LabCounts counts, int scene, AimRequest request, in AimResult result, double? best)
    {
        counts.Add("requests");
        double elevation = Math.Atan2(result.Velocity.Y, result.Velocity.Horizontal.Length) * 180 / Math.PI;
        bool answer = Math.Abs(result.Velocity.Length - request.Speed) <= 1e-9 * request.Speed && result.Spin.IsFinite && double.IsFinite(result.Miss)
            && elevation >= request.MinimumElevationDegrees - 1e-7 && elevation <= request.MaximumElevationDegrees + 1e-7;
        counts.AddIf(!answer, "without an answer");
        bool hit = result.Status == AimStatus.Hit;
        counts.Add(hit ? "hit" : result.Status == AimStatus.OutOfReach ? "out of reach" : "not converged");
        counts.Add(hit ? "simulations: hit" : "simulations: others", result.Simulations);
        counts.Most("worst hit, mm", hit ? 1e3 * result.Miss : 0);
        if (best is { } miss)
        {
            bool notClosest = result.Miss > (1.01 * miss) + 0.01;
            counts.Add("scanned");
            counts.AddIf(notClosest, "can be closer");
            counts.AddIf(miss < request.Tolerance, "can be hit");
            counts.Require(
                !notClosest && miss >= request.Tolerance,
                "contradicted",
                $"scene {scene}: {result.Status} with a miss of {result.Miss:0.0000} m, the scan has {miss:0.000000} m; {request}");
        }
    }
}

/// <summary>Random requests of every kind: speeds, spins, winds, laws, distances, heights, elevation bounds.</summary>
internal static class AimAnything
{
    /// <summary>The number of scenes that the requests are spread over.</summary>
    public const int Scenes = 100;

    private static readonly ForceSet[] Laws = [ForceSet.Published, ForceSet.Regularized, ForceSet.Constant, ForceSet.Published with { Magnus = ForceLaw.Constant }, ForceSet.None];

    /// <summary>Returns one of the scenes.</summary>
    public static Scene Scene(int seed, int index)
    {
        var random = new Random((seed * 1000) + index);
        double angle = random.Between(0, 2 * Math.PI);
        double wind = index % 2 == 0 ? 0 : random.Between(0, 12);
        return FootballPhysics.Scene.Published with { Forces = Laws[index % Laws.Length], Air = new Air { Wind = wind * new Vector3d(Math.Cos(angle), 0, Math.Sin(angle)) } };
    }

    /// <summary>Returns requests for a scene.</summary>
    public static AimRequest[] Requests(int seed, int index, int count)
    {
        var random = new Random((seed * 1000) + 500_000 + index);
        var requests = new AimRequest[count];
        for (int i = 0; i < count; i++)
        {
            double distance = random.Between(1, 70);
            double angle = random.Between(0, 2 * Math.PI);
            bool spins = random.Next(4) > 0;
            (double low, double high) = random.Next(5) switch
            {
                0 => (0, 90),
                1 => (-90, 90),
                2 => (random.Between(0, 30), random.Between(30, 80)),
                _ => (0.0, 45.0),
            };
            requests[i] = new AimRequest
            {
                From = new Vector3d(0, random.Next(3) > 0 ? 0.11 : random.Between(0.11, 2.5), 0),
                Target = new Vector3d(distance * Math.Cos(angle), random.Next(3) > 0 ? random.Between(0.11, 2.5) : random.Between(0.11, 12), distance * Math.Sin(angle)),
                Speed = random.Between(5, 40),
                TopSpin = spins ? random.Between(-60, 60) : 0,
                SideSpin = spins ? random.Between(-60, 60) : 0,
                MinimumElevationDegrees = low,
                MaximumElevationDegrees = high,
                Tolerance = 1e-3,
            };
        }

        return requests;
    }
}
