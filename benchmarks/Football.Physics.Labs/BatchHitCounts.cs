namespace FootballPhysics.Labs;

/// <summary>Counts the hits of batch aims that miss when they are simulated: low drives with backspin, which the ground blocks, and any kick.</summary>
internal static class BatchHitCounts
{
    public static readonly string[] Columns = ["requests", "hits", "false hits", "worst, mm"];

    private const int PerScene = 400;

    /// <summary>Aims kicks, on all processors.</summary>
    /// <param name="seed">Seed of the requests.</param>
    /// <param name="count">The number of requests.</param>
    /// <param name="wind">Largest wind, m/s.</param>
    /// <param name="drives">True for low drives with backspin.</param>
    public static LabCounts Of(int seed, int count, double wind, bool drives) =>
        LabCounts.Of(count, PerScene, (counts, index, requests) => Run(counts, seed, index, requests, wind, drives));

    private static void Run(LabCounts counts, int seed, int index, int count, double wind, bool drives)
    {
        var random = new Random((seed * 100_043) + index);
        Scene scene = KnownKick.Scene(random, index % KnownKick.Balls.Length, wind);
        double contact = scene.Ball.Radius;
        var aims = new BatchAims(count) { MaximumElevationDegrees = 60, Tolerance = 1e-3 };
        for (int i = 0; i < count; i++)
        {
            double distance = random.Between(5, 30);
            double angle = random.Between(0, 2 * Math.PI);
            double height = contact + (drives ? random.Between(0, 0.5) : random.Between(0, 3));
            var from = new Vector3d(0, contact + (drives || random.Next(2) == 0 ? 0 : random.Between(0, 2)), 0);
            double top = drives ? random.Between(-60, -20) : random.Between(-60, 60);
            aims.Set(i, from, new Vector3d(distance * Math.Cos(angle), height, distance * Math.Sin(angle)), random.Between(15, 35), top, random.Between(-30, 30));
        }

        var kicks = new BatchKicks(count);
        new BatchAimer(scene).Find(aims, kicks, count);
        var truth = new TrueMiss(scene);
        for (int i = 0; i < count; i++)
        {
            bool hit = kicks.Status[i] == AimStatus.Hit;
            double miss = hit ? truth.Of(new AimRequest { From = aims.From[i], Target = aims.Target[i] }, kicks.Velocity[i], kicks.Spin[i]) : 0;
            counts.Add("requests");
            counts.AddIf(hit, "hits");
            counts.AddIf(miss > TrueMiss.Rounding * aims.Tolerance, "false hits");
            counts.Most("worst, mm", 1e3 * miss);
        }
    }
}
