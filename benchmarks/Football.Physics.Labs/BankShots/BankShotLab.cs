using System.Diagnostics;

namespace FootballPhysics.Labs.BankShots;

/// <summary>football lab bankshots: aims at points that a random kick reached after bounces, off a wall, off a post.</summary>
internal static class BankShotLab
{
    /// <summary>The kinds of bank shots: the obstacle, the range of azimuths in degrees, and the contacts on the path.</summary>
    private static readonly (string Name, double Least, double Most, string[] After)[] Kinds =
    [
        ("one bounce", -15, 15, ["ground"]), ("two bounces", -15, 15, ["ground", "ground"]), ("off the wall", 20, 70, ["wall"]), ("bounce, wall", 20, 70, ["ground", "wall"]),
        ("off the left post", -18, -13, ["left post"]), ("crossbar, bounce", -15, 15, ["crossbar", "ground"]),
    ];

    private static readonly Scene Scene = Scene.Measured with
    {
        Obstacles = [new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d(-9, 0, 0), new Vector3d(1, 0, 0)), Surface = SurfaceMaterial.PublishedGoalFrame }],
        Goals = [new Goal { Center = new Vector3d(0, 0, -14), Facing = new Vector3d(0, 0, 1), Surface = SurfaceMaterial.GoalFrame }],
    };

    public static Lab Create() => new Lab(
        "bankshots",
        "Aims after bounces and off walls, crossbar and post. Each request comes from a random kick, so that a solution exists.",
        ["football lab bankshots --requests 1 --seed 7"]).Plays(Lab.Number("--requests", "Requests of each kind.", 1, 100_000, 2), Run);

    private static void Run(LabRun run, int requests)
    {
        LabTable table = run.Table("Aims after what is met before, to 1 mm", "after", "requests", "hit", "hit, %", "simulations", "median", "95 %", "worst", "µs", "median µs", "95 % µs", "worst µs", "verdict");
        var aimer = new BankShotAimer(Scene);
        var simulator = new Simulator(Scene);
        int all = 0;
        int hit = 0;
        foreach ((string name, double least, double most, string[] after) in Kinds)
        {
            var set = new BankShotSet(simulator, after) { Azimuth = (least, most), Elevation = (2, 35), Speed = (14, 26) };
            SeededRandom random = run.Random(name.Length);
            int hits = 0;
            double[] simulations = new double[requests];
            double[] times = new double[requests];
            for (int i = 0; i < requests; i++)
            {
                run.Progress.Report(i, requests, () => name);
                AimRequest request = set.Draw(random) with { MaximumElevationDegrees = 45 };
                long start = Stopwatch.GetTimestamp();
                AimResult found = aimer.Find(request, after);
                times[i] = Stopwatch.GetElapsedTime(start).TotalMicroseconds;
                hits += found.Status == AimStatus.Hit ? 1 : 0;
                simulations[i] = found.Simulations;
            }

            all += requests;
            hit += hits;
            var counts = new Spread(simulations);
            var spans = new Spread(times);
            table.Add(
                name, requests, hits, 100.0 * hits / requests, counts.Mean, counts.Median, counts.P95, counts.Worst, spans.Mean, spans.Median, spans.P95, spans.Worst, Verdict.Of(hits >= 0.98 * requests));
        }

        run.Notes.Add(FormattableString.Invariant($"{hit} of {all} hit: {100.0 * hit / all:0.0} %. Reached: 98 % of a kind."));
    }
}
