namespace FootballPhysics.Labs.Following;

/// <summary>football lab follow: the live filter on simulated, shared and real tracks, next to its targets.</summary>
internal static class FollowLab
{
    private static readonly double[] Rates = [10, 25, 50, 100];
    private static readonly double[] Noises = [0.005, 0.02, 0.05, 0.1];
    private static readonly double[] Limits = [1.7, 1.3, 1.15, 1.2];
    private const double MostOfBound = 1.1;
    private static readonly string[] Names = ["velocity, 3 points", "velocity, 5 points", "velocity, 10 points", "1 s ahead, 10 points"];

    public static Lab Create()
    {
        var lab = new Lab("follow", "Follows simulated balls live: errors next to those of an oracle, kicks, deviations and time.", ["football lab follow --tracks 500"]);
        var tracks = lab.Whole("--tracks", "Number of simulated tracks.", 0, 1_000_000, 500);
        var flat = lab.Whole("--without-heights", "Number of simulated tracks whose points have no height.", 0, 1_000_000, 100);
        var jobs = lab.Jobs("Threads.");
        var files = lab.Add(new System.CommandLine.Option<string[]>("--track") { HelpName = "FILE", Description = "Track with its truth beside it (.json); can be repeated.", DefaultValueFactory = _ => [] });
        var real = lab.Add(new System.CommandLine.Option<string[]>("--real") { HelpName = "FILE", Description = "Track of a real match; can be repeated.", DefaultValueFactory = _ => [] });
        var noise = lab.Add(new System.CommandLine.Option<double>("--noise") { HelpName = "M", Description = "Standard deviation of the points of real tracks, m.", DefaultValueFactory = _ => 0.03 });
        var hostile = lab.Whole("--hostile", "Number of hostile calls.", 0, 100_000_000, 100_000);
        return lab.Plays(run =>
        {
            if (run.Get(real)! is { Length: > 0 } matches)
            {
                LabTable table = run.Table("Real tracks: root mean square of the predicted position in flights, m", "track", "ahead, s", "flights", "points", "filter", "constant velocity", "parabola");
                foreach (string file in matches)
                {
                    FollowReal.Add(file, run.Get(noise), table, run);
                }
            }

            if (run.Int(hostile) > 0)
            {
                LabCounts counts = FollowHostile.Run(run, run.Int(hostile));
                counts.AddTo(run.Table("Hostile calls", "calls", "number", "verdict"), ("calls", false), ("rejected", false), ("without a message", true), ("changed by a rejected call", true), ("not finite", true), ("other exceptions", true));
                run.Notes.AddRange(counts.Examples.Take(10));
            }

            if (run.Get(files)! is { Length: > 0 } shared)
            {
                FollowTrack[] read = [.. shared.Select(FollowTrack.Read)];
                FollowScore[] scores = run.Parallel(read.Length, run.Int(jobs), "tracks", i => FollowPlay.Run(read[i], Settings(read[i].Noise)));
                Report(run, $"{read.Length} shared tracks", Sum(scores), []);
            }

            CompareTruth(run);
            ReportTimes(run);
            int count = run.Int(tracks);
            if (count > 0)
            {
                FollowScore[] all = run.Parallel(count, run.Int(jobs), "tracks", i => Play(run, (int)i));
                FollowScore[] cells = [.. Enumerable.Range(0, 16).Select(cell => Sum(all.Where((_, i) => i % 16 == cell)))];
                Report(run, $"{count} simulated tracks", Sum(all), cells);
            }

            int without = run.Int(flat);
            if (without > 0)
            {
                Cover(run, $"{without} simulated tracks without heights", Sum(run.Parallel(without, run.Int(jobs), "tracks", i => Play(run, (int)i, withHeights: false))));
            }
        });
    }

    /// <summary>Compares the lab's integrator with the library: the distances after 1, 3 and 5 s.</summary>
    private static void CompareTruth(LabRun run)
    {
        LabTable table = run.Table("The lab's integrator next to the library, mm", "launch", "1 s", "3 s", "5 s", "spin after 3 s, rad/s");
        (string Name, Vector3d Velocity, Vector3d Spin)[] launches =
        [
            ("roll", new Vector3d(4, 0, 1), new Vector3d(1 / TruthBall.Radius, 0, -4 / TruthBall.Radius)),
            ("roll, turning", new Vector3d(4, 0, 1), new Vector3d(1 / TruthBall.Radius, 30, -4 / TruthBall.Radius)),
            ("fast slide, backspin", new Vector3d(20.6, 0, -6.4), new Vector3d(-1.8, 3, 50.4)), ("slide", new Vector3d(15, 0, 1), new Vector3d(10, 20, 30)), ("flight", new Vector3d(20, 12, 3), new Vector3d(30, 20, -20)),
            ("low flight", new Vector3d(20, 2, 3), new Vector3d(30, 20, -20)),
        ];
        foreach ((string name, Vector3d velocity, Vector3d spin) in launches)
        {
            var truth = new TruthBall();
            truth.Launch(0, TruthBall.Radius * Vector3d.Up, velocity, spin);
            var simulator = new Simulator(FollowTrack.TruthScene, new SolverSettings { Integrator = Integrator.Rk4 });
            BallState ball = simulator.Launch(TruthBall.Radius * Vector3d.Up, velocity, spin);
            var log = new StepLog();
            var off = new double[3];
            double turned = 0;
            for (int i = 0; i < 3; i++)
            {
                double time = 1 + (2 * i);
                simulator.Run(ref ball, 0.01, time - ball.Time, StopAt.Time, log);
                truth.Run(time);
                off[i] = 1000 * (truth.Position - ball.Position).Length;
                turned = i == 1 ? (truth.Spin - ball.Spin).Length : turned;
            }

            table.Add(name, off[0], off[1], off[2], turned);
        }
    }

    private static FollowScore Play(LabRun run, int index, bool withHeights = true)
    {
        int cell = index % 16;
        FollowTrack track = FollowTrack.Simulate(run.Random(index), Rates[cell % 4], Noises[cell / 4]);
        return FollowPlay.Run(track, Settings(track.Noise), withHeights);
    }

    private static BallFilterSettings Settings(double noise) => new() { Noise = noise };

    private static void ReportTimes(LabRun run)
    {
        FollowTimes times = FollowTimes.Measure(run, [.. Noises, .. Noises]);
        LabTable table = run.Table("Time per point at 100 Hz, in RK4 flight steps", "measure", "value", "target", "verdict");
        table.Judge(times.Mean <= 600, "mean", times.Mean, "≤ 600");
        table.Judge(times.Worst.Time <= 6000, "worst", times.Worst.Time, "≤ 6000");
        table.Judge(times.Bytes == 0, "bytes allocated", times.Bytes, "0");
        table.Add("median", times.Share(0.5), null, null);
        table.Add("99.9 %", times.Share(0.999), null, null);
        table.Add("work that the filter counts for the worst point", times.Worst.Work, null, null);
        table.Add("work that the filter counts for a point, worst", times.Work, null, null);
        table.Add("simulated steps of a point, mean", times.Steps, null, null);
        table.Add("flight step, ns", 1e9 * times.Step, null, null);
    }

    private static FollowScore Sum(IEnumerable<FollowScore> scores)
    {
        var sum = new FollowScore();
        foreach (FollowScore score in scores)
        {
            sum.Add(score);
        }

        return sum;
    }

    private static void Report(LabRun run, string name, FollowScore all, FollowScore[] cells)
    {
        LabTable table = run.Table(name, "measure", "whole", "median cell", "worst cell", "oracle", "oracle / bound", "of", "target", "verdict");
        for (int i = 0; i < 4; i++)
        {
            int at = i;
            double[] ratios = [.. cells.Where(cell => cell.Counts[at] >= 5).Select(cell => cell.Ratio(at)).Order()];
            table.Judge(all.Ratio(i) <= Limits[i], Names[i], all.Ratio(i), Median(ratios), Worst(ratios), all.OracleError(i), all.BoundRatio(i), all.Counts[i], $"≤ {Limits[i]}");
        }

        for (int i = 0; i < all.AirBound.Length; i++)
        {
            table.Judge(all.AirBoundRatio(i) <= MostOfBound, $"oracle / bound, {Names[i]}, kicks into the air", all.AirBoundRatio(i), null, null, null, null, all.AirCounts[i], $"≤ {MostOfBound}");
        }

        double missed = 100.0 * all.Missed / Math.Max(1, all.Kicks);
        table.Judge(missed <= 1, "kicks not found within 5 points, %", missed, null, null, null, null, all.Kicks, "≤ 1");
        double falses = all.False / all.Seconds * 600;
        double[] cellFalses = [.. cells.Select(cell => cell.False / cell.Seconds * 600).Order()];
        table.Judge(falses <= 2, "false kicks in 10 minutes", falses, Median(cellFalses), Worst(cellFalses), null, null, all.Seconds, "≤ 2");
        for (int i = 0; i < 4; i++)
        {
            int at = i;
            double[] ones = [.. cells.Where(cell => cell.Covered[at] > 0).Select(cell => cell.Share1(at)).OrderBy(share => Math.Abs(share - 65.5))];
            double[] threes = [.. cells.Where(cell => cell.Covered[at] > 0).Select(cell => cell.Share3(at)).OrderDescending()];
            table.Judge(all.Share1(i) is >= 55 and <= 76, $"{FollowScore.Quantities[i]} within one deviation, %", all.Share1(i), Median(ones), Worst(ones), null, null, all.Covered[i], "55–76");
            table.Judge(all.Share3(i) >= 97, $"{FollowScore.Quantities[i]} within three deviations, %", all.Share3(i), Median(threes), Worst(threes), null, null, all.Covered[i], "≥ 97");
        }

        run.Notes.AddRange(all.Falses);
    }

    /// <summary>Reports the coverage of points without height: a height that they do not show must have a large deviation.</summary>
    private static void Cover(LabRun run, string name, FollowScore all)
    {
        LabTable table = run.Table(name, "measure", "value", "of", "target", "verdict");
        for (int i = 0; i < 4; i++)
        {
            table.Add($"{FollowScore.Quantities[i]} within one deviation, %", all.Share1(i), all.Covered[i], null, null);
            table.Judge(all.Share3(i) >= 97, $"{FollowScore.Quantities[i]} within three deviations, %", all.Share3(i), all.Covered[i], "≥ 97");
        }

        table.Add("kicks not found within 5 points, %", 100.0 * all.Missed / Math.Max(1, all.Kicks), all.Kicks, null, null);
        table.Add("false kicks in 10 minutes", all.False / all.Seconds * 600, all.Seconds, null, null);
    }

    private static double Median(double[] sorted) => sorted.Length == 0 ? double.NaN : sorted[sorted.Length / 2];

    private static double Worst(double[] sorted) => sorted.Length == 0 ? double.NaN : sorted[^1];
}
