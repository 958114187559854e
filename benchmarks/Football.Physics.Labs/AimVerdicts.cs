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
