using System.Diagnostics;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Matches;

/// <summary>Compares the cost of fifty balls in groups over a pitch with their cost one by one.</summary>
internal static class SeveralCost
{
    private const int Balls = 50;
    private const int Steps = 120;
    private const int Rounds = 41;
    private const double Step = 1 / 60.0;

    /// <summary>The warm-up time, s, after which the code is fully compiled.</summary>
    private const double WarmUp = 1.5;

    /// <summary>The largest allowed ratios of a step in a group to a step alone, for fifty balls and for one.</summary>
    private const double Together = 1.2;
    private const double Alone = 1.1;

    /// <summary>Adds the table. A time is no reason to fail: the machine may be busy.</summary>
    public static void Play(LabRun run)
    {
        LabTable table = run.Table("Fifty balls over a pitch, and one", "balls", "single, ns a step", "together, ns a ball and step", "ratio", "impacts of balls", "verdict");
        foreach ((string name, int balls, double flying, double most) in new[]
        {
            ("50, half in the air", Balls, 0.5, Together),
            ("50, all in the air", Balls, 1.0, double.NaN),
            ("50, all on the ground", Balls, 0.0, double.NaN),
            ("one, in a group of its own", 1, 1.0, Alone),
        })
        {
            var simulator = new Simulator();
            var group = new BallGroup(simulator, balls);
            var single = new double[Rounds];
            var together = new double[Rounds];
            int met = 0;
            for (long start = Stopwatch.GetTimestamp(); Stopwatch.GetElapsedTime(start).TotalSeconds < WarmUp;)
            {
                Play(simulator, group, Start(simulator, run.Random(-1), flying), out _, out _);
            }

            for (int round = 0; round < Rounds; round++)
            {
                met += Play(simulator, group, Start(simulator, run.Random(round), flying), out single[round], out together[round]);
            }

            // Use the median of the ratios: both are measured in turns, so that a busy machine slows both.
            double[] ratios = [.. single.Zip(together, (a, b) => b / a).Order()];
            double ratio = ratios[Rounds / 2];
            bool reached = !(ratio > most);
            table.Add(name, single.Order().ElementAt(Rounds / 2), together.Order().ElementAt(Rounds / 2), ratio, met / 2, double.IsNaN(most) ? null : Verdict.Of(reached));
        }
    }

    /// <summary>Simulates two seconds of balls, first one by one and then in groups, and measures the time per ball and step, ns.</summary>
    /// <returns>The number of impacts between balls, each counted for both balls.</returns>
    private static int Play(Simulator simulator, BallGroup group, BallState[] alone, out double single, out double together)
    {
        int met = 0;
        BallState[][] among = [.. alone.Chunk(group.Count)];
        var log = new StepLog();
        long start = Stopwatch.GetTimestamp();
        for (int k = 0; k < Steps; k++)
        {
            log.Clear();
            for (int i = 0; i < alone.Length; i++)
            {
                simulator.Step(ref alone[i], Step, log);
            }
        }

        single = Stopwatch.GetElapsedTime(start).TotalNanoseconds / (Balls * Steps);
        start = Stopwatch.GetTimestamp();
        for (int k = 0; k < Steps; k++)
        {
            log.Clear();
            foreach (BallState[] some in among)
            {
                group.Step(some, Step, log);
            }

            foreach (ref readonly BallEvent happened in log.Events.Span)
            {
                met += happened.OtherBall >= 0 ? 1 : 0;
            }
        }

        together = Stopwatch.GetElapsedTime(start).TotalNanoseconds / (Balls * Steps);
        return met;
    }

    private static BallState[] Start(Simulator simulator, SeededRandom random, double flying) =>
    [
        .. Enumerable.Range(0, Balls).Select(_ =>
        {
            bool flies = random.Chance(flying);
            return simulator.Launch(
                new Vector3d(random.Uniform(-52, 52), flies ? random.Uniform(1, 3) : 0.11, random.Uniform(-34, 34)),
                new Vector3d(random.Uniform(-12, 12), flies ? random.Uniform(2, 14) : 0, random.Uniform(-12, 12)),
                new Vector3d(random.Uniform(-30, 30), random.Uniform(-30, 30), 0));
        }),
    ];
}
