using System.Diagnostics;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Matches;

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
