namespace FootballPhysics.Labs;

/// <summary>Solves the same requests in scenes of both profiles, and counts the kicks found, the flights and the errors.</summary>
internal static class ProfileAims
{
    private const double Tolerance = 1e-3;

    private static readonly Vector3d s_wind = new(4, 0, -6);

    /// <summary>The scenes; the published profile first.</summary>
    public static IReadOnlyList<(string Name, Scene Scene)> Scenes { get; } =
    [
        ("published", Scene.Published),
        ("published, wind of 7 m/s", Scene.Published with { Air = new Air { Wind = s_wind } }),
        ("measured", Scene.Measured),
        ("measured, wind of 7 m/s", Scene.Measured with { Air = new Air { Wind = s_wind } }),
        ("measured, Jabulani at 2240 m", Scene.Measured with { Ball = BallProperties.Jabulani, Air = Weather.AtAltitude(2240).ToAir() }),
        ("measured, wind by height of 8 m/s", Scene.Measured with { Air = new Air { WindField = new WindByHeight(8, 1, -2) } }),
        ("measured, gusts of 8 m/s", Scene.Measured with { Air = new Air { WindField = new WindByHeight(8, 1, -2, gusts: new Gusts { Seed = 7 }) } }),
    ];

    /// <summary>Aims kicks of 20 to 30 m/s with spin at points in the goal, to a millimetre.</summary>
    public static (int Hits, double Simulations, int Most, double Worst) Of(Scene scene, int seed, int count)
    {
        var aimer = new Aimer(scene);
        int hits = 0;
        long simulations = 0;
        int most = 0;
        double worst = 0;
        foreach (AimRequest request in AimSets.Studio(seed, count))
        {
            AimResult result = aimer.Find(request with { Tolerance = Tolerance });
            simulations += result.Simulations;
            most = Math.Max(most, result.Simulations);
            if (result.Status == AimStatus.Hit)
            {
                hits++;
                worst = Math.Max(worst, result.Miss);
            }
        }

        return (hits, (double)simulations / count, most, worst);
    }

    public static void Run(LabRun run, int count)
    {
        LabTable table = run.Table("Kicks of 20 to 30 m/s from 14 to 20 m, to 1 mm, direct", "scene", "requests", "hits", "flights a request", "at most", "worst true miss, mm");
        foreach ((string name, Scene scene) in Scenes)
        {
            run.Progress.Report(() => name);
            (int hits, double simulations, int most, double worst) = Of(scene, unchecked((int)run.Seed), count);
            table.Add(name, count, hits, simulations, most, 1e3 * worst);
            run.Failed |= hits < count || worst > Tolerance;
        }
    }
}
