using System.Diagnostics;

namespace FootballPhysics.Labs.Following;

/// <summary>Times of a filter at 100 Hz, in flight steps of the same run.</summary>
internal static class FollowTimes
{
    private const int Rounds = 3;

    /// <summary>Returns the mean and the worst time of a point, the time of a flight step, in s, the simulated steps of a point, the greatest work of a point, in flight steps, and the allocated bytes.</summary>
    /// <remarks>Each point has the least of some equal rounds, because other processes disturb the clock.</remarks>
    public static (double Mean, double Worst, double Step, double Steps, double Work, long Bytes) Measure(LabRun run, IEnumerable<double> noises)
    {
        double sum = 0;
        double worst = 0;
        double work = 0;
        long points = 0;
        long steps = 0;
        long bytes = 0;
        int index = 0;
        foreach (double noise in noises)
        {
            FollowTrack track = FollowTrack.Simulate(run.Random(900_000 + index++), 100, noise);
            var least = new double[track.Rows.Count];
            Array.Fill(least, double.PositiveInfinity);
            long fewest = long.MaxValue;
            for (int round = 0; round <= Rounds; round++)
            {
                var filter = new BallFilter(track.Scene, new BallFilterSettings { Noise = noise });
                long before = GC.GetAllocatedBytesForCurrentThread();
                for (int i = 0; i < least.Length; i++)
                {
                    FollowRow row = track.Rows[i];
                    long start = Stopwatch.GetTimestamp();
                    filter.Update(row.Time, row.Measured);
                    least[i] = Math.Min(least[i], Stopwatch.GetElapsedTime(start).TotalSeconds);
                    work = Math.Max(work, filter.Work);
                }

                fewest = Math.Min(fewest, GC.GetAllocatedBytesForCurrentThread() - before);
                steps += round == Rounds ? filter.Steps : 0;
            }

            // The runtime itself allocates in some rounds, while it compiles.
            bytes = Math.Max(bytes, fewest);
            sum += least.Sum();
            worst = Math.Max(worst, least.Max());
            points += least.Length;
        }

        return (sum / points, worst, FlightStep(), (double)steps / points, work, bytes);
    }

    private static double FlightStep()
    {
        var simulator = new Simulator(FollowTrack.TruthScene, new SolverSettings { Integrator = Integrator.Rk4 });
        var log = new StepLog();
        double best = double.PositiveInfinity;
        for (int round = 0; round < 20; round++)
        {
            BallState ball = simulator.Launch(new Vector3d(0, 500, 0), new Vector3d(20, 10, 0), new Vector3d(0, 30, 10));
            long start = Stopwatch.GetTimestamp();
            for (int i = 0; i < 500; i++)
            {
                log.Clear();
                simulator.Step(ref ball, 0.01, log);
            }

            best = Math.Min(best, Stopwatch.GetElapsedTime(start).TotalSeconds / 500);
        }

        return best;
    }
}
