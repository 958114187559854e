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

    /// <summary>True if the scan contradicts no verdict. In wind, a target that is only missed is not called out of reach: no bound holds there.</summary>
    public static bool Hold(LabCounts counts) => Answers(counts) && counts["can be closer"] == 0;

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

/// <summary>
/// The dense scan that verdicts are checked against. It tries elevations between the bounds and corrects the azimuth of each by the direction in which
/// the kick went. It judges a kick by the simulated closest approach before the first impact. It then searches every valley down to its minimum. In a
/// wind the closest kick need not point towards the point where it comes closest, so the scan also searches both angles from the best kick.
/// </summary>
internal sealed class AimScan(Scene scene)
{
    private const double Coarse = 0.05;
    private const double Fine = 0.005;
    private const double Degree = Math.PI / 180;

    private readonly Simulator _simulator = new(scene);
    private readonly Trajectory _path = new(16384);
    private readonly LookAheadRequest _look = new() { TimeStep = Coarse, Duration = 30, StopAt = StopAt.Impact };
    private readonly LookAheadRequest _lookFine = new() { TimeStep = Fine, Duration = 30, StopAt = StopAt.Impact };

    private readonly bool _windy = scene.Air.Wind != Vector3d.Zero;
    private double _bestMiss;
    private double _bestElevation;
    private double _bestAzimuth;

    /// <summary>Returns the smallest miss of any kick that the scan tries, m.</summary>
    /// <param name="request">The request.</param>
    /// <param name="elevations">The number of elevations between the bounds.</param>
    public double Best(AimRequest request, int elevations)
    {
        double low = request.MinimumElevationDegrees * Degree;
        double high = request.MaximumElevationDegrees * Degree;
        int count = high > low ? elevations : 1;
        _bestMiss = double.PositiveInfinity;
        var misses = new double[count];
        var azimuths = new double[count];
        Vector3d straight = request.Target - request.From;
        double azimuth = Math.Atan2(straight.Z, straight.X);
        double At(int i) => count == 1 ? low : low + ((high - low) * i / (count - 1));
        for (int i = 0; i < count; i++)
        {
            misses[i] = Miss(request, At(i), ref azimuth, i == 0 ? 12 : 4, _look);
            azimuths[i] = azimuth;
        }

        double best = double.PositiveInfinity;
        for (int i = 0; i < count; i++)
        {
            bool valley = (i == 0 || misses[i] <= misses[i - 1]) && (i == count - 1 || misses[i] <= misses[i + 1]);
            if (valley)
            {
                best = Math.Min(best, Bottom(request, At(Math.Max(0, i - 1)), At(Math.Min(count - 1, i + 1)), azimuths[i]));
            }
        }

        return _windy && best > request.Tolerance ? Math.Min(best, BothAngles(request, low, high)) : best;
    }

    /// <summary>Descends in both angles, from the best kick so far.</summary>
    private double BothAngles(AimRequest request, double low, double high)
    {
        for (double step = 0.02; step > 1e-4; step *= 0.5)
        {
            bool closer = true;
            while (closer)
            {
                double before = _bestMiss;
                (double elevation, double azimuth) = (_bestElevation, _bestAzimuth);
                foreach ((double up, double turn) in new[] { (step, 0.0), (-step, 0.0), (0.0, step), (0.0, -step) })
                {
                    double turned = azimuth + turn;
                    Miss(request, Math.Clamp(elevation + up, low, high), ref turned, 1, _look);
                }

                closer = _bestMiss < before;
            }
        }

        return _bestMiss;
    }

    /// <summary>Finds the minimum of a valley by golden-section search.</summary>
    private double Bottom(AimRequest request, double a, double b, double azimuth)
    {
        const double Golden = 0.38196601125010515;
        double ends = Math.Min(Miss(request, a, ref azimuth, 6, _look), Miss(request, b, ref azimuth, 6, _look));
        double x = a + (Golden * (b - a));
        double y = b - (Golden * (b - a));
        double fx = Miss(request, x, ref azimuth, 6, _look);
        double fy = Miss(request, y, ref azimuth, 6, _look);
        while (b - a > 1e-6)
        {
            if (fx <= fy)
            {
                (b, y, fy) = (y, x, fx);
                x = a + (Golden * (b - a));
                fx = Miss(request, x, ref azimuth, 3, _look);
            }
            else
            {
                (a, x, fx) = (x, y, fy);
                y = b - (Golden * (b - a));
                fy = Miss(request, y, ref azimuth, 3, _look);
            }
        }

        return Math.Min(ends, Miss(request, 0.5 * (a + b), ref azimuth, 6, _lookFine));
    }

    private double Miss(AimRequest request, double elevation, ref double azimuth, int corrections, LookAheadRequest look)
    {
        double best = double.PositiveInfinity;
        for (int i = 0; i < corrections; i++)
        {
            (double up, double flat) = Math.SinCos(elevation);
            (double z, double x) = Math.SinCos(azimuth);
            var velocity = new Vector3d(request.Speed * flat * x, request.Speed * up, request.Speed * flat * z);
            Vector3d spin = new((request.TopSpin * z), request.SideSpin, -(request.TopSpin * x));
            BallState ball = _simulator.Launch(request.From, velocity, spin);
            _simulator.LookAhead(in ball, look, _path);
            PathPoint closest = _path.ClosestApproach(request.Target);
            best = Math.Min(best, closest.Distance);
            if (closest.Distance < _bestMiss)
            {
                (_bestMiss, _bestElevation, _bestAzimuth) = (closest.Distance, elevation, azimuth);
            }

            Vector3d went = closest.Position - ball.Position;
            Vector3d wanted = request.Target - ball.Position;
            double turn = Math.Atan2((went.X * wanted.Z) - (went.Z * wanted.X), (went.X * wanted.X) + (went.Z * wanted.Z));
            if (!(Math.Abs(turn) > 1e-7))
            {
                break;
            }

            azimuth += turn;
        }

        return best;
    }
}
