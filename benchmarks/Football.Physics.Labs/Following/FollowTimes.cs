using System.Diagnostics;

namespace FootballPhysics.Labs.Following;

/// <summary>Times of a filter at 100 Hz, in flight steps of the same run.</summary>
internal sealed class FollowTimes
{
    /// <summary>The number of times that each track is played.</summary>
    private const int Rounds = 5;

    /// <summary>The number of bursts that measure a flight step.</summary>
    private const int Bursts = 15;

    private readonly List<(double Time, double Work)> _points = [];

    /// <summary>The simulated steps of a point.</summary>
    public double Steps { get; private set; }

    /// <summary>The allocated bytes.</summary>
    public long Bytes { get; private set; }

    /// <summary>The time of a flight step, s.</summary>
    public double Step { get; private set; }

    public double Mean => _points.Average(point => point.Time);

    /// <summary>The greatest work that the filter counts for a point.</summary>
    public double Work => _points.Max(point => point.Work);

    /// <summary>The point that takes longest.</summary>
    public (double Time, double Work) Worst => _points.MaxBy(point => point.Time);

    /// <summary>Returns the time that a share of the points does not exceed.</summary>
    public double Share(double share) => _points.Select(point => point.Time).Order().ElementAt((int)(share * (_points.Count - 1)));

    /// <summary>Measures tracks with a noise each.</summary>
    /// <remarks>
    /// Equal rounds have equal bits, so each point has the least of its rounds, from the same state. The clock of the machine changes: flight steps just before and just
    /// after each round are its unit.
    /// </remarks>
    public static FollowTimes Measure(LabRun run, IEnumerable<double> noises)
    {
        var times = new FollowTimes();
        FlightStep();
        double before = FlightStep();
        var units = new List<double>();
        long steps = 0;
        int index = 0;
        foreach (double noise in noises)
        {
            FollowTrack track = FollowTrack.Simulate(run.Random(900_000 + index++), 100, noise);
            var least = new double[track.Rows.Count];
            var taken = new double[track.Rows.Count];
            var work = new double[track.Rows.Count];
            Array.Fill(least, double.PositiveInfinity);
            long fewest = long.MaxValue;
            for (int round = 0; round < Rounds; round++)
            {
                var filter = new BallFilter(track.Scene, new BallFilterSettings { Noise = noise });
                long allocated = GC.GetAllocatedBytesForCurrentThread();
                for (int i = 0; i < least.Length; i++)
                {
                    FollowRow row = track.Rows[i];
                    long start = Stopwatch.GetTimestamp();
                    filter.Update(row.Time, row.Measured);
                    taken[i] = Stopwatch.GetElapsedTime(start).TotalSeconds;
                    work[i] = filter.Work;
                }

                fewest = Math.Min(fewest, GC.GetAllocatedBytesForCurrentThread() - allocated);
                steps += round == 0 ? filter.Steps : 0;
                double after = FlightStep();
                units.Add(Math.Min(before, after));
                before = after;
                for (int i = 0; i < least.Length; i++)
                {
                    least[i] = Math.Min(least[i], taken[i] / units[^1]);
                }
            }

            // The runtime itself allocates in some rounds, while it compiles.
            times.Bytes = Math.Max(times.Bytes, fewest);
            times._points.AddRange(least.Zip(work));
        }

        times.Step = units.Min();
        times.Steps = (double)steps / times._points.Count;
        return times;
    }

    private static double FlightStep()
    {
        var simulator = new Simulator(FollowTrack.TruthScene, new SolverSettings { Integrator = Integrator.Rk4 });
        var log = new StepLog();
        var bursts = new double[Bursts];
        for (int round = 0; round < Bursts; round++)
        {
            BallState ball = simulator.Launch(new Vector3d(0, 500, 0), new Vector3d(20, 10, 0), new Vector3d(0, 30, 10));
            long start = Stopwatch.GetTimestamp();
            for (int i = 0; i < 500; i++)
            {
                log.Clear();
                simulator.Step(ref ball, 0.01, log);
            }

            bursts[round] = Stopwatch.GetElapsedTime(start).TotalSeconds / 500;
        }

        // Some bursts are disturbed, too.
        return bursts.Order().ElementAt(Bursts / 5);
    }
}
