using System.CommandLine;
using System.Diagnostics;
using System.Text;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Sweep.Formats;
using FootballPhysics.Tool.Sweep.Output;
using FootballPhysics.Tool.Sweep;

namespace FootballPhysics.Labs;

/// <summary>football lab sweep: the rate at which data sets are made, compared with the batch that simulates their balls.</summary>
internal static class SweepLab
{
    /// <summary>The number of runs; each rate is the best of them.</summary>
    private const int Runs = 3;

    /// <summary>The number of rows after which all code is compiled.</summary>
    private const int WarmUp = 50_000;

    /// <summary>The number of balls of a batch: they fit the caches, as in a sweep.</summary>
    private const int Balls = 4096;

    public static Lab Create()
    {
        var lab = new Lab(
            "sweep",
            "Rows per second that a sweep writes, compared with the flights per second of its batch.",
            ["football lab sweep --count 2000 --jobs 1"]);
        Option<long> count = lab.Whole("--count", "Rows per run.", 1, 1_000_000_000, 300_000);
        Option<long> jobs = lab.Jobs("Maximum number of threads; default: one per processor.");
        Option<string?> folder = lab.Add(new Option<string?>("--folder") { HelpName = "DIR", Description = "Folder for the rows, which are deleted afterwards; default: the folder for temporary files." });
        return lab.Plays(run => Run(run, run.Get(count), run.Int(jobs), run.Get(folder) ?? Path.GetTempPath()));
    }

    private static void Run(LabRun run, long count, int jobs, string folder)
    {
        SweepPlan plan = SweepInput.Read(InputCase.Read(new InputLine(Encoding.UTF8.GetBytes("{}"), false), []).Scenario!, Math.Abs(run.Seed));
        LabTable table = run.Table($"Rows a second of the default sweep, {count} rows, the best of {Runs} runs", "threads", "what", "rows/s", "of the batch", "of one thread", "processor time, µs a row", "batch's share of it", "bytes a row");
        Dictionary<string, double> alone = [];
        foreach (int threads in (int[])[1, .. jobs > 1 ? [jobs] : (int[])[]])
        {
            run.Progress.Report(() => $"the batch, {threads} threads");
            (double Rate, double Microseconds) batch = Best(() => Fly(plan, count, threads));
            Add("batch", batch, null);
            foreach (string format in RowFormat.Names.Reverse())
            {
                run.Progress.Report(() => $"{format}, {threads} threads");
                long bytes = 0;
                Write(plan, format, threads, WarmUp, folder, ref bytes);
                Add(format, Best(() => Write(plan, format, threads, count, folder, ref bytes)), bytes / (double)count);
            }

            void Add(string what, (double Rate, double Microseconds) measured, double? bytes)
            {
                alone.TryAdd(what, measured.Rate);
                table.Add(
                    threads, what, Math.Round(measured.Rate), measured.Rate / batch.Rate, measured.Rate / alone[what], measured.Microseconds, batch.Microseconds / measured.Microseconds, bytes);
            }
        }
    }

    /// <summary>Returns the greatest rate, and the least processor time, which other programs on the machine affect less.</summary>
    private static (double Rate, double Microseconds) Best(Func<(double Rate, double Microseconds)> run)
    {
        var runs = Enumerable.Range(0, Runs).Select(_ => run()).ToArray();
        return (runs.Max(one => one.Rate), runs.Min(one => one.Microseconds));
    }

    /// <summary>Measures the rows per second, and the processor time per row, µs.</summary>
    private static (double Rate, double Microseconds) Measure(double rows, Action work)
    {
        TimeSpan before = Environment.CpuUsage.TotalTime;
        var clock = Stopwatch.StartNew();
        work();
        return (rows / clock.Elapsed.TotalSeconds, (Environment.CpuUsage.TotalTime - before).TotalMicroseconds / rows);
    }

    /// <summary>Measures the batch alone: it draws and writes nothing meanwhile.</summary>
    private static (double Rate, double Microseconds) Fly(SweepPlan plan, long count, int threads)
    {
        var batches = Enumerable.Range(0, threads).Select(_ => (Batch: new BallBatch(plan.Scene.Scene, plan.Scene.BatchSettings), Launches: Launches(plan), Flights: new BatchFlights(Balls))).ToArray();
        long runs = Math.Max(1, count / Balls / threads);
        void Fly(int thread, long times)
        {
            for (long i = 0; i < times; i++)
            {
                batches[thread].Batch.Fly(batches[thread].Launches, batches[thread].Flights, Balls, plan.Scene.Duration);
            }
        }

        Parallel.For(0, threads, thread => Fly(thread, 1 + (WarmUp / Balls)));
        return Measure((double)runs * Balls * threads, () => Parallel.For(0, threads, thread => Fly(thread, runs)));
    }

    private static BatchLaunches Launches(SweepPlan plan)
    {
        var rows = new FootballPhysics.Tool.Sweep.Rows.RowDraws(plan, Balls);
        rows.Draw(0, Balls);
        var launches = new BatchLaunches(Balls);
        for (int i = 0; i < Balls; i++)
        {
            double Kick(int number) => rows.Number(plan.Scene, DirectField.Kick + number, i);
            new FootballPhysics.Scenarios.KickNumbers(Kick(0), Kick(1), Kick(2), Kick(3), Kick(4)).Vectors(out Vector3d velocity, out Vector3d spin);
            launches.Set(i, rows.Vector(plan.Scene, DirectField.Position, i), velocity, spin);
        }

        return launches;
    }

    private static (double Rate, double Microseconds) Write(SweepPlan plan, string format, int threads, long count, string folder, ref long bytes)
    {
        string path = Path.Combine(folder, $"football-lab-sweep-{Environment.ProcessId}");
        try
        {
            var run = new SweepRun(plan, format, threads);
            var identity = new Identity("football lab", format, plan.Seed, count, plan.Text);
            (double, double) measured = Measure(count, () =>
            {
                using FolderSink sink = FolderSink.Open(path, identity, new Shard(1, 1, count), run.Format, Schema.Text(run.Columns, run.Format), run.NoRows, TimeProvider.System);
                run.RunAsync(new Shard(1, 1, count), sink, _ => { }).GetAwaiter().GetResult();
            });
            bytes = run.Format.Files.Sum(file => new FileInfo(Path.Combine(path, file)).Length);
            return measured;
        }
        finally
        {
            if (Directory.Exists(path))
            {
                Directory.Delete(path, recursive: true);
            }
        }
    }
}
