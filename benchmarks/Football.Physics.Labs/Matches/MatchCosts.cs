using System.Diagnostics;

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
            static double Middle(IEnumerable<double> values) => values.Order().ElementAt(Rounds / 2);
            double ratio = Middle(single.Zip(together, (a, b) => b / a));
            table.Add(name, Middle(single), Middle(together), ratio, met / 2, double.IsNaN(most) ? null : Verdict.Of(!(ratio > most)));
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

/// <summary>Measures the cost of a jump within a recording: a complete match, and a shorter one among players, to random ticks.</summary>
internal static class JumpCost
{
    private const int Jumps = 400;
    private const double Most = 1.0; // ms

    /// <summary>Adds the table. The run fails for another state, not for a time: the machine may be busy.</summary>
    public static void Play(LabRun run)
    {
        LabTable table = run.Table("Jumps within a recording at 60 Hz, to ticks by lot", "recording", "minutes", "MB", "steps at most", "median ms", "p95 ms", "worst ms", "other states", "verdict");
        Add("a ball on a pitch with goals", players: false, minutes: 90);
        Add("a ball among 22 players in curves", players: true, minutes: 3);

        void Add(string name, bool players, int minutes)
        {
            FixedStepRunner New()
            {
                var squad = new Squad(run.Random(3));
                Scene scene = Pitch.Standard.On();
                return new FixedStepRunner(new Simulator(players ? scene with { Bodies = squad.NewBodies() } : scene), 1 / 60.0) { MoveBodies = players ? squad.Mover() : null };
            }

            FixedStepRunner match = New();
            Recording segment = match.Record();
            SeededRandom random = run.Random(5);
            int ticks = minutes * 3600;
            while (match.Tick < ticks)
            {
                if (match.Tick % 200 == 0)
                {
                    Vector3d home = -0.2 * match.State.Position.Horizontal;
                    match.QueueKick(home + new Vector3d(random.Uniform(-12, 12), random.Uniform(0, 8), random.Uniform(-12, 12)), 20 * random.Direction());
                }

                match.Step();
            }

            byte[] bytes = segment.ToBytes();
            segment = Recording.FromBytes(bytes);
            FixedStepRunner replay = segment.Replay(New().Simulator);
            var times = new double[Jumps];
            int most = 0;
            int other = 0;
            for (int i = -20; i < Jumps; i++)
            {
                // The first jumps compile the code.
                long tick = random.Below(ticks + 1);
                long start = Stopwatch.GetTimestamp();
                int steps = segment.Seek(replay, tick);
                double time = Stopwatch.GetElapsedTime(start).TotalMilliseconds;
                most = Math.Max(most, steps);
                other += segment.HashAt(tick) == Snapshot.Hash(replay.State) ? 0 : 1;
                times[Math.Max(i, 0)] = time;
            }

            Array.Sort(times);
            table.Add(name, minutes, bytes.Length / 1e6, most, times[Jumps / 2], times[(int)(0.95 * Jumps)], times[^1], other, Verdict.Of(other == 0 && times[(int)(0.95 * Jumps)] <= Most));
            run.Failed |= other > 0;
        }
    }
}
