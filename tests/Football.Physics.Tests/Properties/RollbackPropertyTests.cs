using CsCheck;

namespace FootballPhysics.Tests.Properties;

/// <summary>Any sequence of calls of a runner: a tick that is simulated again has identical bits, whatever is called in between.</summary>
public sealed class RollbackPropertyTests
{
    private const int Plays = 100;
    private const double Step = 1 / 60.0;
    private const int Ring = 24;

    private static readonly Simulator[] s_simulators =
    [
        new(Pitch.Standard.On()),
        new(Pitch.Cage.On(Scene.Default with { Air = new Air { Wind = new Vector3d(3, 0, -7) }, Forces = ForceSet.Measured with { KnuckleSeed = 3 } })),
        new(Scene.Published, new SolverSettings { Integrator = Integrator.Rk2 }),
    ];

    /// <summary>A call: its kind, a small number whose meaning depends on the kind, and a kick.</summary>
    private static readonly Gen<Call> s_call = Gen.Select(Gen.Int[0, 7], Gen.Int[0, 12], Drawn.Vector(25), Drawn.Vector(60), (kind, number, velocity, spin) => new Call(kind, number, velocity, spin));

    private static readonly Gen<Call[]> s_calls = s_call.Array[1, 40];

    [Fact]
    public void A_restored_state_steps_to_identical_bits() =>
        Gen.Select(Gen.Int[0, s_simulators.Length - 1], Gen.Int[0, 3], s_calls).Sample(
            (scene, quantized, calls) =>
            {
                Simulator simulator = s_simulators[scene];
                var runner = new FixedStepRunner(simulator, Step) { QuantizationInterval = quantized };
                var saved = new List<(long Tick, byte[] Bytes)> { (0, Bytes(runner.State)) };
                var known = new Dictionary<long, byte[]>();
                var path = new Trajectory(64);
                foreach (Call call in calls)
                {
                    switch (call.Kind)
                    {
                        case 0:
                            // A kick changes the future.
                            runner.QueueKick(call.Velocity, call.Spin);
                            saved.RemoveAll(state => state.Tick > runner.Tick);
                            foreach (long tick in known.Keys.Where(tick => tick > runner.Tick).ToArray())
                            {
                                known.Remove(tick);
                            }

                            break;
                        case 1:
                            saved.Add((runner.Tick, Bytes(runner.State)));
                            break;
                        case 2:
                            (long back, byte[] bytes) = saved[call.Number % saved.Count];
                            BallState state = Snapshot.Read(bytes);
                            runner.Restore(back, in state);
                            break;
                        case 3:
                            // Reads change nothing.
                            simulator.LookAhead(runner.State, new LookAheadRequest { Duration = 0.1 * (1 + call.Number) }, path);
                            runner.PoseAt(call.Number / 12.0);
                            break;
                        default:
                            for (int i = 0; i <= call.Number; i++)
                            {
                                runner.Step();
                                byte[] now = Bytes(runner.State);
                                Assert.True(known.TryAdd(runner.Tick, now) || known[runner.Tick].AsSpan().SequenceEqual(now), $"tick {runner.Tick} differs");
                            }

                            break;
                    }
                }
            },
            iter: Plays);

    /// <summary>Two balls, and an obstacle that gives way: kicks and states that arrive late end where the same match ends that knew them from the start.</summary>
    [Fact]
    public void Late_kicks_in_any_order_end_in_the_bits_of_a_match_without_delay() =>
        s_calls.Sample(
            calls =>
            {
                FixedStepRunner runner = Match();
                var rollback = new Rollback(runner, Ring);
                FixedStepRunner straight = Match();
                foreach (Call call in calls)
                {
                    switch (call.Kind)
                    {
                        case 0 or 1:
                            long tick = Math.Max(Math.Max(0, rollback.OldestTick), runner.Tick - (2 * call.Number));
                            var kick = new KickInput(tick, call.Velocity, call.Spin, call.Number % 3, call.Kind);
                            rollback.ApplyKick(in kick);
                            straight.Kicks.Add(in kick);
                            break;
                        case 2:
                            Assert.Null(rollback.SyncTest(1 + call.Number));
                            break;
                        default:
                            for (int i = 0; i <= call.Number; i++)
                            {
                                runner.Step();
                            }

                            break;
                    }
                }

                while (straight.Tick < runner.Tick)
                {
                    straight.Step();
                }

                for (int ball = 0; ball < runner.Balls; ball++)
                {
                    Assert.Equal(Bytes(straight.StateOf(ball)), Bytes(runner.StateOf(ball)));
                }
            },
            iter: Plays);

    /// <summary>A set of kicks and restarts, of which some arrive twice: any order of arrival ends in the same bits.</summary>
    [Fact]
    public void Any_order_of_arrival_of_kicks_and_restarts_ends_in_the_same_bits() =>
        Gen.Select(s_call.Array[1, 16], Gen.Int[0, 1_000_000]).Sample(
            (calls, seed) =>
            {
                // One input for each tick, player and ball, as a log has them; few ticks, so that many share one.
                const int Ticks = Ring - 2;
                var kicks = new Dictionary<(long, int, int), KickInput>();
                var places = new Dictionary<(long, int, int), PlaceInput>();
                for (int i = 0; i < calls.Length; i++)
                {
                    Call call = calls[i];
                    (long Tick, int Player, int Ball) key = (call.Number % 7 * 3, i % 3, call.Kind % 2);
                    if (call.Kind < 4)
                    {
                        kicks[key] = new KickInput(key.Tick, call.Velocity, call.Spin, key.Player, key.Ball);
                    }
                    else
                    {
                        places[key] = new PlaceInput(key.Tick, key.Player, key.Ball, 0.2 * call.Velocity, 0.1 * call.Spin, call.Spin, new Quaterniond(0, call.Number, 0, 1));
                    }
                }

                FixedStepRunner straight = Match();
                foreach (KickInput kick in kicks.Values)
                {
                    straight.Kicks.Add(in kick);
                }

                foreach (PlaceInput place in places.Values)
                {
                    straight.Kicks.Add(in place);
                }

                while (straight.Tick < Ticks)
                {
                    straight.Step();
                }

                for (int order = 0; order < 3; order++)
                {
                    var random = new Random(seed + order);
                    FixedStepRunner runner = Match();
                    var rollback = new Rollback(runner, Ring);
                    List<Action> arrivals =
                    [
                        .. kicks.Values.Select(kick => (Action)(() => rollback.ApplyKick(in kick))),
                        .. places.Values.Select(place => (Action)(() => rollback.ApplyPlace(in place))),
                        .. Enumerable.Repeat<Action>(runner.Step, Ticks),
                    ];
                    arrivals.AddRange(arrivals[..(kicks.Count + places.Count)].Where(_ => random.Next(3) == 0));
                    Action[] shuffled = [.. arrivals];
                    random.Shuffle(shuffled);
                    foreach (Action arrive in shuffled)
                    {
                        arrive();
                    }

                    for (int ball = 0; ball < runner.Balls; ball++)
                    {
                        Assert.Equal(Bytes(straight.StateOf(ball)), Bytes(runner.StateOf(ball)));
                    }

                    Assert.Equal(straight.Kicks.ToBytes(), runner.Kicks.ToBytes());
                    Assert.Null(rollback.SyncTest(Ticks));
                }
            },
            iter: Plays);

    private static FixedStepRunner Match()
    {
        Scene scene = Scene.Default with
        {
            Obstacles =
            [
                new Obstacle { Name = "skittle", Shape = new CapsuleShape(new Vector3d(0, 0.1, -1), new Vector3d(0, 0.9, -1), 0.1), Mass = 2, Surface = SurfaceMaterial.Wood },
                new Obstacle { Name = "board", Shape = new PlaneShape(new Vector3d(0, 0, -4), new Vector3d(0, 0, 1)), Surface = SurfaceMaterial.Board },
            ],
        };
        var runner = new FixedStepRunner(new BallGroup(new Simulator(scene), 2), Step);
        runner.Place(new Vector3d(0.5, 0.11, 0), 1);
        return runner;
    }

    private static byte[] Bytes(BallState state)
    {
        var bytes = new byte[Snapshot.Size];
        Snapshot.Write(in state, bytes);
        return bytes;
    }

    private sealed record Call(int Kind, int Number, Vector3d Velocity, Vector3d Spin);
}
