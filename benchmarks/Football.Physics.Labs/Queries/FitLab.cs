using FootballPhysics.Numerics;

namespace FootballPhysics.Labs.Queries;

/// <summary>football lab fit: compares how often fits of noisy tracks are within their uncertainty with the stated probability.</summary>
internal static class FitLab
{
    public static Lab Create() => new Lab(
        "fit",
        "Fits of noisy simulated tracks (25 points per second, 2 cm): how often the true value is within the reported uncertainty.",
        ["football lab fit --tracks 1 --seed 7"]).Plays(Lab.Number("--tracks", "Tracks of each kind.", 1, 1_000_000, 2), Run);

    private static void Run(LabRun run, int tracks)
    {
        LabTable table = run.Table("Fits of noisy tracks", "looked for", "tracks", "within the 95 % region, %", "least of a number within 1.96 σ, %", "not converged", "steps", "verdict");
        foreach (bool also in (bool[])[false, true])
        {
            var check = new FitCheck();
            for (int i = 0; i < tracks; i++)
            {
                run.Progress.Report(i, tracks, () => also ? "launch and scene" : "launch");
                check.Run(run.Random((also ? 1_000_003 : 0) + i), also);
            }

            double within = 100.0 * check.Counts["within"] / tracks;
            table.Add(
                also ? "launch, drag, lift, restitution, friction" : "launch", tracks, within, 100.0 * check.Names.Min(name => check.Counts[name]) / tracks, check.Counts["not converged"],
                (double)check.Counts["steps"] / tracks, Verdict.Of(within >= 90));
        }

        run.Notes.Add("Reached: the truth is within the region that is to hold 95 % of them in 90 % of the tracks.");
    }
}

/// <summary>Fits noisy tracks of random shots, seen 25 times a second to 2 cm, and counts the fits within their own uncertainty.</summary>
internal sealed class FitCheck
{
    private const double Interval = 0.04;
    private const double Noise = 0.02;

    /// <summary>The 95 % quantiles of the squared Mahalanobis distance, by degrees of freedom from 9 on.</summary>
    private static readonly double[] s_limits = [16.919, 18.307, 19.675, 21.026, 22.362];

    private readonly TrackFit _fit = new(Scene.Measured);

    /// <summary>
    /// The cases with all numbers together in the 95 % region, those that did not converge, the steps of all searches; and for each number the cases in
    /// which it is within 1.96 standard deviations.
    /// </summary>
    public LabCounts Counts { get; } = new();

    /// <summary>The names of the numbers.</summary>
    public IReadOnlyList<string> Names { get; private set; } = [];

    /// <summary>Draws a shot, samples its track and fits it.</summary>
    /// <param name="random">The random numbers.</param>
    /// <param name="also">True to fit drag, lift, restitution and friction too.</param>
    public void Run(SeededRandom random, bool also)
    {
        double[] factors = also ? [random.Normal(1, 0.1), random.Normal(1, 0.2), random.Normal(1, 0.05), random.Normal(1, 0.1)] : [];
        Scene scene = Scene.Measured;
        if (also)
        {
            Ground ground = scene.Ground;
            scene = scene with
            {
                Ground = ground with
                {
                    Material = ground.Material with
                    {
                        NormalRestitution = factors[2] * ground.Material.NormalRestitution,
                        ImpactFriction = factors[3] * ground.Material.ImpactFriction,
                        SlidingFriction = factors[3] * ground.Material.SlidingFriction,
                    },
                },
                Forces = scene.Forces with { CustomForces = [new ScaledAir(scene, factors[0], factors[1])] },
            };
        }

        var simulator = new Simulator(scene);
        var from = new Vector3d(0, 0.11, 0);
        Vector3d velocity = random.Velocity(14, 28, 8, 35);
        Vector3d spin = random.Uniform(0, 60) * random.Direction();
        BallState ball = simulator.Launch(from, velocity, spin);
        var log = new StepLog();
        var track = new TrackPoint[also ? 75 : 50];
        for (int i = 0; i < track.Length; i++)
        {
            var off = new Vector3d(random.Normal(0, Noise), random.Normal(0, Noise), random.Normal(0, Noise));
            track[i] = new TrackPoint(i * Interval, ball.Position + off, Noise);
            log.Clear();
            simulator.Run(ref ball, 0.01, Interval, StopAt.Time, log);
        }

        TrackFitResult found = _fit.Find(track, new TrackFitRequest { Drag = also, Lift = also, Restitution = also, Friction = also });
        double[] truth = [from.X, from.Y, from.Z, velocity.X, velocity.Y, velocity.Z, spin.X, spin.Y, spin.Z, .. factors];
        Judge(found, truth);
    }

    private void Judge(TrackFitResult found, double[] truth)
    {
        int n = truth.Length;
        double[] off = [.. truth.Select((value, i) => found.Value(i) - value)];
        double[] covariance = [.. Enumerable.Range(0, n * n).Select(i => found.Covariance(i / n, i % n))];
        for (int i = 0; i < n; i++)
        {
            Counts.AddIf(Math.Abs(off[i]) <= 1.96 * found.StandardError(i), found.Names[i]);
        }

        double[] solved = new double[n];
        double distance = Linear.Solve(covariance, off, solved, n) ? solved.Zip(off, (a, b) => a * b).Sum() : double.PositiveInfinity;
        Names = found.Names;
        Counts.Add("steps", found.Iterations);
        Counts.AddIf(!found.Converged, "not converged");
        Counts.AddIf(distance <= s_limits[n - 9], "within");
    }
}
