namespace FootballPhysics.Tests.Symmetry;

/// <summary>A simulator holds nothing that a step changes: threads that share one need no lock, each with a ball and a log of its own.</summary>
public sealed class ThreadTests
{
    private const int Threads = 8;
    private const int Balls = 48;

    public static TheoryData<string> Scenes() => [.. s_scenes.Keys];

    private static readonly Dictionary<string, Scene> s_scenes = new()
    {
        ["default"] = new Scene(),
        ["default in wind and gusts"] = new Scene { Air = new Air { Wind = new Vector3d(6, 1, -4), WindField = new WindByHeight(3, 2, 1, gusts: new Gusts { Seed = 3 }) } },
        ["default among things"] = Pitch.Standard.On(),
        ["published"] = Scene.Published,
        ["wind"] = Scene.Published with { Air = new Air { Wind = new Vector3d(6, 1, -4) } },
        ["regularised"] = Scene.Published with { Forces = ForceSet.Regularized },
        ["constant"] = Scene.Published with { Forces = ForceSet.Constant },
        ["constant decay"] = Scene.Published with { Forces = ForceSet.Published with { SpinDecay = ForceLaw.Constant, SpinDecayCoefficient = 1e-3 } },
        ["vacuum"] = Scene.Vacuum,
        ["strong air"] = Scene.Published with { Ball = new BallProperties { Mass = 1e-3 } },
        ["own force"] = Scene.Published with { Forces = ForceSet.Published with { CustomForces = [IForce.From(ball => new Vector3d(0.1 * ball.Velocity.Y, 0, 0.2))] } },
    };

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Eight_threads_on_one_simulator_have_the_bits_of_one(string name)
    {
        foreach (Integrator integrator in Enum.GetValues<Integrator>())
        {
            var simulator = new Simulator(s_scenes[name], new SolverSettings { Integrator = integrator });
            ulong[] alone = [.. Enumerable.Range(0, Balls).Select(ball => Life(simulator, ball))];
            var together = new ulong[Threads][];
            using var start = new Barrier(Threads);
            Thread[] threads = [.. Enumerable.Range(0, Threads).Select(thread => new Thread(() =>
            {
                start.SignalAndWait();

                // Each another ball at a time, so that they disturb one another if they can.
                together[thread] = new ulong[Balls];
                for (int i = 0; i < Balls; i++)
                {
                    int ball = (i + (thread * 5)) % Balls;
                    together[thread][ball] = Life(simulator, ball);
                }
            }))];
            Array.ForEach(threads, thread => thread.Start());
            Array.ForEach(threads, thread => thread.Join());
            Assert.All(together, hashes => Assert.Equal(alone, hashes));
        }
    }

    /// <summary>Every state, event and count of a ball's life, and of a look-ahead from its middle, in one number.</summary>
    private static ulong Life(Simulator simulator, int ball)
    {
        var log = new StepLog(1);
        var path = new Trajectory();
        BallState state = simulator.Launch(
            new Vector3d(0, 0.11 + (ball % 3), 0), new Vector3d(1 + (ball * 0.6), 1 + (ball % 7), -3), new Vector3d(ball % 5, 9 * (ball % 11), -ball));
        ulong hash = 0;
        for (int i = 0; i < 120; i++)
        {
            log.Clear();
            simulator.Step(ref state, i % 2 == 0 ? 0.02 : 0.007, log);
            hash = (hash * 31) ^ Snapshot.Hash(in state) ^ (ulong)log.Steps ^ ((ulong)log.Evaluations << 20);
            foreach (ref readonly BallEvent item in log.Events)
            {
                hash = (hash * 31) ^ (ulong)item.Kind ^ (ulong)BitConverter.DoubleToInt64Bits(item.Time + item.Velocity.X);
            }

            if (i == 20)
            {
                simulator.LookAhead(in state, new LookAheadRequest { Duration = 2 }, path);
                hash = (hash * 31) ^ Snapshot.Hash(path.Final);
            }
        }

        return hash;
    }
}
