using System.CommandLine;
using System.Diagnostics;
using Football.Physics.Headless.Commands;
using Football.Physics.Yardsticks;

namespace Football.Physics.Headless.Lab.BankShots;

/// <summary>football lab bankshots: kicks to where a random kick came after bounces, off a wall, off a post.</summary>
internal static class BankShotLab
{
    private const double Tolerance = 1e-3;

    /// <summary>What is to be met, in a scene that has it.</summary>
    private static readonly (string Name, string[] After)[] Kinds =
    [
        ("one bounce", ["ground"]), ("two bounces", ["ground", "ground"]), ("off the wall", ["wall"]), ("bounce, wall", ["ground", "wall"]), ("off the left post", ["left post"]),
        ("crossbar, bounce", ["crossbar", "ground"]),
    ];

    private static readonly Scene Scene = Scene.Measured with
    {
        Obstacles = [new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d(-9, 0, 0), new Vector3d(1, 0, 0)), Surface = Surface.GoalFrame }],
        Goals = [new Goal { Center = new Vector3d(0, 0, -14), Facing = new Vector3d(0, 0, 1), Surface = Surface.MeasuredFrame }],
    };

    public static Command Create(Terminal terminal)
    {
        Option<long> requests = Arguments.Whole("--requests", "Requests of each kind.", 1, 100_000, 2);
        return LabOptions.Create(
            "bankshots",
            "Aims after bounces and off walls, bar and post: requests made by flying a random kick, so that there is an answer.",
            ["football lab bankshots --requests 1 --seed 7"],
            terminal,
            (parsed, seed, progress) => Run(seed, (int)parsed.GetValue(requests), progress),
            requests);
    }

    private static LabReport Run(long seed, int requests, Progress progress)
    {
        var table = new LabTable("Aims after what is met before, to 1 mm", "after", "requests", "hit", "hit, %", "simulations", "median", "95 %", "worst", "µs", "median µs", "95 % µs", "worst µs", "verdict");
        var report = new LabReport { Name = "bankshots", Seed = seed, Tables = { table } };
        var aimer = new BankShotAimer(Scene);
        var simulator = new Simulator(Scene);
        int all = 0;
        int hit = 0;
        foreach ((string name, string[] after) in Kinds)
        {
            var random = new SeededRandom(SeededRandom.Mix(seed, name.Length));
            int hits = 0;
            double[] simulations = new double[requests];
            double[] times = new double[requests];
            for (int i = 0; i < requests; i++)
            {
                progress.Report(i, requests, () => name);
                AimRequest request = Draw(simulator, after, random);
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

        report.Notes.Add(FormattableString.Invariant($"{hit} of {all} hit: {100.0 * hit / all:0.0} %. Reached: 98 % of a kind."));
        return report;
    }

    /// <summary>A request for where a random kick came after it had met these things.</summary>
    private static AimRequest Draw(Simulator simulator, string[] after, SeededRandom random)
    {
        var from = new Vector3d(0, 0.11, 0);
        while (true)
        {
            double speed = random.Uniform(14, 26);
            double elevation = random.Uniform(2, 35);
            (double top, double side) = (random.Uniform(-20, 20), random.Uniform(-20, 20));
            double azimuth = after.Contains("wall") ? random.Uniform(20, 70) : after.Contains("left post") ? random.Uniform(-18, -13) : random.Uniform(-15, 15);
            double angle = azimuth * Math.PI / 180;
            double up = elevation * Math.PI / 180;
            var d = new Vector3d(-Math.Sin(angle), 0, -Math.Cos(angle));
            BallState state = simulator.Launch(from, speed * ((Math.Cos(up) * d) + new Vector3d(0, Math.Sin(up), 0)), KickSpin.Vector(d, top, side));
            var path = new Trajectory(1024);
            simulator.LookAhead(in state, new LookAheadRequest { Duration = 5, TimeStep = 0.01, StopAt = StopAt.Time }, path);
            BallEvent[] impacts = [.. path.Events.Span.ToArray().Where(e => e.Kind == BallEventKind.Impact)];
            if (impacts.Length < after.Length || !impacts.Take(after.Length).Select(e => simulator.NameOf(e.Thing)).SequenceEqual(after))
            {
                continue;
            }

            double begin = impacts[after.Length - 1].Time;
            double end = impacts.Length > after.Length ? impacts[after.Length].Time : path.EndTime;
            double share = random.Uniform(0.2, 0.9);
            Vector3d target = path.PositionAt(begin + (share * Math.Min(end - begin, 2)));
            return new AimRequest { From = from, Target = target, Speed = speed, TopSpin = top, SideSpin = side, MaximumElevationDegrees = 45, Tolerance = Tolerance };
        }
    }
}
