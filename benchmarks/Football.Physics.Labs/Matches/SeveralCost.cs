using System.Diagnostics;

namespace Football.Physics.Labs.Matches;

/// <summary>What fifty balls over a pitch cost together, by what they cost one after the other.</summary>
internal static class SeveralCost
{
    private const int Balls = 50;
    private const int Steps = 120;
    private const int Rounds = 41;
    private const double Step = 1 / 60.0;

    public static (LabTable Table, bool Holds) Table(long seed)
    {
        var table = new LabTable("Fifty balls over a pitch", "balls", "single, ns a step", "together, ns a ball and step", "ratio", "impacts of balls", "verdict");
        bool holds = true;
        foreach ((string name, double flying, bool judged) in new[] { ("half in the air", 0.5, true), ("all in the air", 1.0, false), ("all on the ground", 0.0, false) })
        {
            var simulator = new Simulator();
            var group = new BallGroup(simulator, Balls);
            var single = new double[Rounds];
            var together = new double[Rounds];
            long met = 0;
            for (int round = 0; round < Rounds; round++)
            {
                BallState[] alone = Start(simulator, seed, round, flying);
                BallState[] among = [.. alone];
                var log = new StepLog();
                long start = Stopwatch.GetTimestamp();
                for (int k = 0; k < Steps; k++)
                {
                    log.Clear();
                    for (int i = 0; i < Balls; i++)
                    {
                        simulator.Step(ref alone[i], Step, log);
                    }
                }

                single[round] = Stopwatch.GetElapsedTime(start).TotalNanoseconds / (Balls * Steps);
                start = Stopwatch.GetTimestamp();
                for (int k = 0; k < Steps; k++)
                {
                    log.Clear();
                    group.Step(among, Step, log);
                    foreach (ref readonly BallEvent happened in log.Events.Span)
                    {
                        met += happened.OtherBall >= 0 ? 1 : 0;
                    }
                }

                together[round] = Stopwatch.GetElapsedTime(start).TotalNanoseconds / (Balls * Steps);
            }

            // The median of the ratios: both are measured in turns, so that a busy machine slows both.
            double[] ratios = [.. single.Zip(together, (a, b) => b / a).Order()];
            double ratio = ratios[Rounds / 2];
            bool reached = ratio <= 1.2;
            holds &= reached || !judged;
            table.Add(name, single.Order().ElementAt(Rounds / 2), together.Order().ElementAt(Rounds / 2), ratio, met / 2, judged ? Verdict.Of(reached) : null);
        }

        return (table, holds);
    }

    private static BallState[] Start(Simulator simulator, long seed, int round, double flying)
    {
        var random = new LabRandom(LabRandom.Mix(seed, round));
        return
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
}
