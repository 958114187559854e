namespace FootballPhysics.Tests.Several;

/// <summary>Several balls stepped together.</summary>
public sealed class BallGroupTests
{
    private const double Step = 1 / 60.0;

    [Fact]
    public void One_ball_of_a_group_and_balls_far_apart_go_as_they_go_alone()
    {
        var simulator = new Simulator(Pitch.Standard.On(Scene.Default));
        BallState[] together = [.. Enumerable.Range(0, 6).Select(i => Shot(simulator, i))];
        BallState[] alone = [.. together];
        BallState[] single = [together[0]];
        var group = new BallGroup(simulator, 6);
        var one = new BallGroup(simulator, 1);
        var log = new StepLog();
        var own = new StepLog();
        for (int k = 0; k < 300; k++)
        {
            group.Step(together, Step, log);
            one.Step(single, Step, own);
            for (int i = 0; i < alone.Length; i++)
            {
                simulator.Step(ref alone[i], Step, own);
                Assert.True(Snapshot.Same(in alone[i], in together[i]));
            }

            Assert.True(Snapshot.Same(in alone[0], in single[0]));
        }

        for (int i = 1; i < log.Events.Count; i++)
        {
            Assert.True(log.Events[i].Time >= log.Events[i - 1].Time || log.Events[i].Time > log.Events[0].Time);
        }
    }

    /// <summary>A heavy ball throws a light one farther than either would have got alone: who lies there is met, whatever its number.</summary>
    [Fact]
    public void A_ball_that_was_struck_meets_one_that_nobody_would_have_reached()
    {
        BallProperties heavy = new() { Mass = 4 };
        BallProperties light = new() { Mass = 0.1 };
        var group = new BallGroup(new Scene(), [.. Enumerable.Repeat(new BallProperties(), 7), heavy, light, new BallProperties()]);
        BallState[] balls = [.. Enumerable.Range(0, 10).Select(i => group.SimulatorOf(i).Launch(new Vector3d(20 + (3 * i), 5, 0), Vector3d.Zero, Vector3d.Zero))];
        balls[7] = group.SimulatorOf(7).Launch(new Vector3d(0, 5, 0), new Vector3d(0, 0, -20), Vector3d.Zero);
        balls[8] = group.SimulatorOf(8).Launch(new Vector3d(0, 5, -1), Vector3d.Zero, Vector3d.Zero);
        balls[9] = group.SimulatorOf(9).Launch(new Vector3d(0, 5, -2.9), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        group.Step(balls, 0.1, log);
        Assert.Contains(log.Events.Span.ToArray(), hit => hit.Ball == 8 && hit.OtherBall == 9);
        Assert.True(balls[9].Velocity.Z < -2, $"the last ball goes at {balls[9].Velocity}");
        Assert.True((balls[8].Position - balls[9].Position).Length >= 0.22 - 1e-9);
    }

    [Theory]
    [InlineData(-0.01, 1, "timeStep")]
    [InlineData(0, 1, "timeStep")]
    [InlineData(double.NaN, 1, "timeStep")]
    [InlineData(1e-14, 1, "timeStep")]
    [InlineData(0.01, -1, "duration")]
    [InlineData(0.01, double.PositiveInfinity, "duration")]
    public void A_run_out_of_range_is_refused_by_name_before_anything_moves(double timeStep, double duration, string name)
    {
        var simulator = new Simulator();
        BallState[] balls = [Shot(simulator, 0), Shot(simulator, 1)];
        BallState[] before = [.. balls];
        ArgumentOutOfRangeException error = Assert.Throws<ArgumentOutOfRangeException>(() => new BallGroup(simulator, 2).Run(balls, timeStep, duration, StopAt.Rest, new StepLog()));
        Assert.Contains(name, error.Message, StringComparison.Ordinal);
        Assert.True(Snapshot.Same(in before[0], in balls[0]) && Snapshot.Same(in before[1], in balls[1]));
    }

    [Theory]
    [InlineData(1e-6, 2e-5)]
    [InlineData(0.01, 0.2)]
    public void A_run_takes_every_step_of_its_duration(double timeStep, double duration)
    {
        var simulator = new Simulator();
        BallState[] balls = [Shot(simulator, 0), Shot(simulator, 1)];
        int steps = 0;
        Assert.False(new BallGroup(simulator, 2).Run(balls, timeStep, duration, StopAt.Rest, new StepLog(), () => steps++));
        Assert.Equal(20, steps);
        Assert.Equal(duration, balls[1].Time, 1e-12);
    }

    /// <summary>The forces on a ball of a pile are those of the scene, of gravity and of the game.</summary>
    [Fact]
    public void The_free_rates_of_a_ball_in_a_pile_are_those_of_its_scene()
    {
        var torque = new Vector3d(1e-3, -2e-3, 3e-3);
        var force = new Vector3d(0.2, 0.1, -0.3);
        var scene = new Scene { Forces = ForceSet.Measured with { CustomForces = [new Steady(force, torque)] } };
        Scene bare = scene with { Forces = ForceSet.Measured };
        BallState ball = new Simulator(bare).Launch(new Vector3d(0, 3, 0), new Vector3d(3, 1, 2), new Vector3d(9, -4, 6));
        MotionRates with = new Simulator(scene).Pile.Free(in ball, 1e-3, looksAhead: false, out _);
        MotionRates without = new Simulator(bare).Pile.Free(in ball, 1e-3, looksAhead: false, out _);
        Assert.InRange((with.Acceleration - without.Acceleration - (force / scene.Ball.Mass)).Length, 0, 1e-12);
        Assert.InRange((with.SpinAcceleration - without.SpinAcceleration - (torque / scene.Ball.MomentOfInertia)).Length, 0, 1e-10);
        Assert.True(Vector3d.Dot(without.SpinAcceleration, ball.Spin) < 0);
        Assert.Equal(-9.81, new Simulator(bare).Pile.FreeAtRest(in ball, 1e-3).Acceleration.Y, 0.2);
    }

    [Fact]
    public void A_ball_that_hits_a_resting_one_gives_it_its_motion_and_no_energy_comes_from_it()
    {
        var simulator = new Simulator();
        var group = new BallGroup(simulator, 2);
        BallState[] balls =
        [
            simulator.Launch(new Vector3d(0, simulator.ContactHeight, 0), new Vector3d(8, 0, 0), new Vector3d(0, 0, -8 / 0.11)),
            Ball.AtRest(simulator, new Vector3d(3, 0, 0)),
        ];
        var log = new StepLog();
        double energy = Energy(balls);
        while (balls[0].Time < 6)
        {
            group.Step(balls, 0.01, log);
            double now = Energy(balls);
            Assert.InRange(now, 0, energy + 1e-9);
            energy = now;
        }

        BallEvent[] hits = [.. log.Events.Span.ToArray().Where(item => item.OtherBall >= 0)];
        Assert.True(hits.Length >= 2);
        Assert.Equal((0, 1), (hits[0].Ball, hits[0].OtherBall));
        Assert.Equal((1, 0), (hits[1].Ball, hits[1].OtherBall));
        Assert.Equal(hits[0].Time, hits[1].Time);
        Assert.Equal(-1, hits[0].ColliderIndex);
        Vector3d sum = simulator.ImpactOf(in hits[0]).Impulse + simulator.ImpactOf(in hits[1]).Impulse;
        Assert.InRange(sum.Length, 0, 1e-14);
        Assert.True(balls[1].Position.X > 5, "the resting ball has gone on");
        Assert.Equal(MotionState.Rest, balls[0].Motion);
        Assert.Equal(MotionState.Rest, balls[1].Motion);
        Assert.True((balls[0].Position - balls[1].Position).Length >= 0.22 - 1e-9);
    }

    /// <summary>Balls that run into a heap from all sides, on the ground and from above.</summary>
    [Fact]
    public void A_heap_comes_to_rest_without_energy_and_without_overlap()
    {
        var simulator = new Simulator();
        const int Count = 12;
        var group = new BallGroup(simulator, Count);
        BallState[] balls = new BallState[Count];
        for (int i = 0; i < Count; i++)
        {
            double angle = 2 * Math.PI * i / Count;
            var outward = new Vector3d(Math.Cos(angle), 0, Math.Sin(angle));
            balls[i] = simulator.Launch((2.0 + (0.3 * (i % 3))) * outward + new Vector3d(0, 0.11 + (0.4 * (i % 2)), 0), -5.0 * outward, default);
        }

        var log = new StepLog(mostEvents: 100_000);
        double energy = Energy(balls);
        double deepest = 0;
        for (int k = 0; k < 900; k++)
        {
            group.Step(balls, Step, log);
            double now = Energy(balls);
            Assert.InRange(now, 0, energy + 1e-6);
            energy = now;
            for (int i = 0; i < Count; i++)
            {
                for (int j = 0; j < i; j++)
                {
                    deepest = Math.Max(deepest, 0.22 - (balls[i].Position - balls[j].Position).Length);
                }
            }
        }

        Assert.InRange(deepest, 0, 2e-5);
        Assert.All(balls, ball => Assert.Equal(MotionState.Rest, ball.Motion));
        Assert.Equal(0, log.StalledSteps);
    }

    public static TheoryData<string> Crowds => ["heap", "among things", "two sizes"];

    /// <summary>Where no two impacts are at one time the numbers of the balls decide nothing: in any order each of them goes the same way, to the last bit.</summary>
    [Theory]
    [MemberData(nameof(Crowds))]
    public void A_permutation_of_the_balls_gives_the_same_motion(string crowd)
    {
        for (int seed = 0; seed < 4; seed++)
        {
            BallState[] expected = Played(crowd, seed, order: null, out int meetings, out _);
            Assert.True(meetings > 1, $"{crowd} {seed}: {meetings} meetings");
            for (int k = 0; k < 3; k++)
            {
                int[] order = [.. Enumerable.Range(0, expected.Length)];
                var random = new Random((17 * seed) + k);
                for (int i = order.Length - 1; i > 0; i--)
                {
                    int j = random.Next(i + 1);
                    (order[i], order[j]) = (order[j], order[i]);
                }

                BallState[] found = Played(crowd, seed, order, out int again, out _);
                Assert.Equal(meetings, again);
                for (int i = 0; i < order.Length; i++)
                {
                    Assert.True(Snapshot.Same(in expected[order[i]], in found[i]), $"{crowd} {seed}, ball {order[i]} as {i}: {Snapshot.Difference(in expected[order[i]], in found[i])}");
                }
            }
        }
    }

    /// <summary>Of two impacts at one time the ball of the lower number has its first: it gets more of the push, on whichever side it lies.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    public void At_one_time_the_lower_number_comes_first(int seed)
    {
        BallState[] found = Played("two at once", seed, [0, 1, 2, 3], out int meetings, out List<BallEvent[]> steps);
        BallState[] mirrored = Played("two at once", seed, [0, 2, 1, 3], out int again, out _);
        Assert.Equal(meetings, again);
        BallEvent[] first = [.. steps.SelectMany(step => step.Where(item => item.OtherBall >= 0)).Take(4)];
        Assert.Equal([(0, 1), (0, 2)], first.Select(item => (Math.Min(item.Ball, item.OtherBall), Math.Max(item.Ball, item.OtherBall))).Distinct());
        Assert.Equal(first[0].Time, first[3].Time);
        Assert.Equal(found[0].Position.X, -mirrored[0].Position.X, 9);
    }

    /// <summary>Two balls that meet do so in the step in which they touch, both of them, whichever is the first of the group.</summary>
    [Fact]
    public void Both_balls_of_an_impact_have_it_in_the_same_step()
    {
        foreach (int[] order in new int[][] { [0, 1, 2], [2, 1, 0], [1, 2, 0] })
        {
            _ = Played("row", 0, order, out int meetings, out List<BallEvent[]> steps);
            Assert.True(meetings >= 2);
            Assert.All(steps, step => Assert.Equal(0, step.Count(item => item.OtherBall >= 0) % 2));
            Assert.All(steps.SelectMany(step => step.Where(item => item.OtherBall >= 0).Select(item => (Step: step, Item: item))), pair =>
                Assert.Contains(pair.Step, item => item.Ball == pair.Item.OtherBall && item.OtherBall == pair.Item.Ball && item.Time == pair.Item.Time));
        }
    }

    private static BallState[] Played(string crowd, int seed, int[]? order, out int meetings, out List<BallEvent[]> steps)
    {
        var random = new Random(seed);
        Scene scene = Scene.Default;
        BallProperties[] kinds = [BallProperties.Tunnel];
        List<(Vector3d Place, Vector3d Velocity, Vector3d Spin)> launches = [];
        void Add(double x, double y, double z, double vx, double vy, double vz, double spin = 0) =>
            launches.Add((new Vector3d(x, y, z), new Vector3d(vx, vy, vz), spin * new Vector3d(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5)));
        switch (crowd)
        {
            case "row":
                Add(0, 0.11, 0, 6, 0, 0.2);
                Add(1, 0.11, 0, 0, 0, 0);
                Add(1.4, 0.11, 0.02, 0, 0, 0);
                break;
            case "rack":
                // Touching to rounding, and hit a little off the middle.
                for (int row = 0; row < 4; row++)
                {
                    for (int i = 0; i <= row; i++)
                    {
                        Add((i - (0.5 * row)) * 0.22, 0.11, -row * 0.22 * Math.Sqrt(0.75), 0, 0, 0);
                    }
                }

                Add(0.01 * seed, 0.11, 1.5, 0, 0, -9, 20);
                break;
            case "two at once":
                // Exactly as far from both, and with a third that is hit by both.
                Add(0, 0.11, 1, 0, 0, -5 - seed);
                Add(0.11, 0.11, 0, 0, 0, 0);
                Add(-0.11, 0.11, 0, 0, 0, 0);
                Add(0, 0.11, -0.4, 0, 0, 0);
                break;
            default:
                for (int i = 0; i < 9; i++)
                {
                    double angle = random.NextDouble() * 6.28;
                    double far = 0.6 + (0.35 * i);
                    double speed = 3 + (4 * random.NextDouble());
                    Add(far * Math.Cos(angle), 0.12 + (0.3 * random.NextDouble()), far * Math.Sin(angle), -speed * Math.Cos(angle), random.NextDouble(), -speed * Math.Sin(angle), 40);
                }

                break;
        }

        if (crowd == "among things")
        {
            var bodies = new KinematicBodies();
            KinematicBody boot = bodies.Add("boot", BodyKind.Player with { Mass = 3 });
            boot.MoveTo(new Vector3d(0.2, 0, 0.1), new Vector3d(0.5, 0, 0.2), 0);
            scene = scene with
            {
                Bodies = bodies,
                Obstacles = [new Obstacle { Name = "bin", Shape = new SphereShape(new Vector3d(-0.5, 0.3, 0), 0.3), Mass = 2 }, new Obstacle { Name = "board", Shape = new BoxShape(new Vector3d(0, 0.5, -1.5), new Vector3d(3, 0.5, 0.05)) }],
            };
        }

        if (crowd == "two sizes")
        {
            kinds = [BallProperties.Tunnel, BallProperties.Tunnel with { Mass = 0.3, Radius = 0.09 }];
        }

        int[] at = order ?? [.. Enumerable.Range(0, launches.Count)];
        var group = new BallGroup(scene, [.. at.Select(i => kinds[i % kinds.Length])]);
        BallState[] balls = [.. at.Select((i, k) => group.SimulatorOf(k).Launch(launches[i].Place, launches[i].Velocity, launches[i].Spin))];
        meetings = 0;
        steps = [];
        var log = new StepLog();
        for (int k = 0; k < 100; k++)
        {
            log.Clear();
            group.Step(balls, Step, log);
            BallEvent[] events = log.Events.Span.ToArray();
            meetings += events.Count(item => item.OtherBall >= 0);
            steps.Add(events);
        }

        return balls;
    }

    [Fact]
    public void A_look_ahead_of_all_is_their_future_and_pushes_nothing()
    {
        var scene = Scene.Default with
        {
            Obstacles = [new Obstacle { Name = "bin", Shape = new SphereShape(new Vector3d(4, 0.3, 0), 0.3), Mass = 2 }],
        };
        var simulator = new Simulator(scene);
        var group = new BallGroup(simulator, 3);
        BallState[] balls =
        [
            simulator.Launch(new Vector3d(0, 0.3, 0), new Vector3d(9, 1, 0), default),
            simulator.Launch(new Vector3d(1.85, 0.42, 0.6), new Vector3d(0, 0.8, -3), default),
            simulator.Launch(new Vector3d(8, 0.4, 0.1), new Vector3d(-9, 1, 0), default),
        ];
        Trajectory[] paths = [new(), new(), new()];
        group.LookAhead(balls, new LookAheadRequest { Duration = 2, TimeStep = 0.02 }, paths);
        var log = new StepLog();
        group.Run(balls, 0.02, 2, StopAt.Rest, log);
        for (int i = 0; i < 3; i++)
        {
            BallState foreseen = paths[i].Final;
            Assert.True(Snapshot.Same(in foreseen, in balls[i]));
            Assert.True(paths[i].IsComplete);
            Assert.Equal(log.Events.Span.ToArray().Count(item => item.Ball == i), paths[i].Events.Count);
        }

        Assert.Contains(log.Events.Span.ToArray(), item => item.OtherBall >= 0);
        Assert.Contains(log.Events.Span.ToArray(), item => simulator.NameOf(item.ColliderIndex) == "bin");
        Assert.Throws<ArgumentOutOfRangeException>(() =>
            group.LookAhead(balls, new LookAheadRequest { UntilPlane = new Plane3d(default, new Vector3d(1, 0, 0)) }, paths));
    }

    /// <summary>Balls that roll to rest in about 2 s: a look-ahead ends there only if it stops at rest.</summary>
    [Theory]
    [InlineData(StopAt.Rest)]
    [InlineData(StopAt.Time)]
    public void A_look_ahead_ends_once_all_balls_rest(StopAt stop)
    {
        var simulator = new Simulator();
        var group = new BallGroup(simulator, 2);
        BallState[] balls = [simulator.Launch(simulator.OnGround(0, 0), new Vector3d(1, 0, 0), Vector3d.Zero), simulator.Launch(simulator.OnGround(0, 5), new Vector3d(2, 0, 0), Vector3d.Zero)];
        Trajectory[] paths = [new Trajectory(), new Trajectory()];
        group.LookAhead(balls, new LookAheadRequest { Duration = 20, StopAt = stop }, paths);
        Assert.All(paths, path => Assert.Equal(MotionState.Rest, path.Final.Motion));
        Assert.Equal(stop == StopAt.Time, paths[0].Final.Time > 19.9);
        Assert.True(paths[1].TryGetRest(out BallEvent rest));
        Assert.InRange(paths[1].Final.Time, rest.Time, stop == StopAt.Rest ? rest.Time + 0.1 : 20);
    }

    [Fact]
    public void A_look_ahead_up_to_an_impact_ends_at_the_first_one()
    {
        var simulator = new Simulator();
        var group = new BallGroup(simulator, 2);
        BallState[] balls = [simulator.Launch(new Vector3d(0, 1.5, 0), Vector3d.Zero, Vector3d.Zero), simulator.Launch(new Vector3d(0, 3, 5), Vector3d.Zero, Vector3d.Zero)];
        Trajectory[] paths = [new Trajectory(), new Trajectory()];
        group.LookAhead(balls, new LookAheadRequest { Duration = 20, StopAt = StopAt.Impact }, paths);
        Assert.True(paths[0].TryGetTouchdown(0, out BallEvent touchdown));
        Assert.InRange(touchdown.Time, 0.5, 0.6);
        Assert.All(paths, path => Assert.Equal(touchdown.Time, path.Final.Time, 1e-9));
    }

    [Fact]
    public void A_look_ahead_of_several_balls_names_the_condition_that_it_does_not_support()
    {
        var simulator = new Simulator();
        var group = new BallGroup(simulator, 1);
        BallState[] balls = [simulator.Launch(simulator.OnGround(0, 0), new Vector3d(1, 0, 0), Vector3d.Zero)];
        void Refused(string field, LookAheadRequest request) =>
            Assert.Contains(field, Assert.ThrowsAny<ArgumentException>(() => group.LookAhead(balls, request, [new Trajectory()])).Message, StringComparison.Ordinal);
        Refused("lookAhead.untilPassing", new LookAheadRequest { UntilPassing = Vector3d.Zero });
        Refused("lookAhead.untilPlane", new LookAheadRequest { UntilPlane = new Plane3d(default, new Vector3d(1, 0, 0)) });
    }

    [Fact]
    public void A_step_allocates_nothing()
    {
        var simulator = new Simulator();
        var group = new BallGroup(simulator, 8);
        BallState[] start = [.. Enumerable.Range(0, 8).Select(i => simulator.Launch(new Vector3d(0.4 * i, 0.11, 0), new Vector3d(i % 2 == 0 ? 3 : -3, 2, 0), default))];
        BallState[] balls = [.. start];
        var log = new StepLog();
        Assert.Equal(0, Allocation.Of(() =>
        {
            Array.Copy(start, balls, balls.Length);
            log.Clear();
            for (int k = 0; k < 60; k++)
            {
                group.Step(balls, Step, log);
            }
        }));
        Assert.Contains(log.Events.Span.ToArray(), item => item.OtherBall >= 0);
    }

    [Fact]
    public void What_cannot_be_stepped_is_refused_and_nothing_changes()
    {
        var simulator = new Simulator();
        var group = new BallGroup(simulator, 2);
        BallState[] balls = [Shot(simulator, 0), Shot(simulator, 1)];
        simulator.Step(ref balls[1], 0.01, new StepLog());
        BallState first = balls[0];
        Assert.Contains("states[1].time", Assert.Throws<ArgumentException>(() => group.Step(balls, 0.01, new StepLog())).Message, StringComparison.Ordinal);
        Assert.True(Snapshot.Same(in first, in balls[0]));
        Assert.Throws<ArgumentException>(() => group.Step([first], 0.01, new StepLog()));
        Assert.Throws<ArgumentException>(() => group.Step([first, default], 0.01, new StepLog()));
        Assert.Throws<ArgumentOutOfRangeException>(() => group.Step([first, first], double.NaN, new StepLog()));
        Assert.Throws<ArgumentOutOfRangeException>(() => new BallGroup(simulator, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => new BallGroup(simulator, 2, SurfaceMaterial.Ball with { NormalRestitution = 2 }));
    }

    private static BallState Shot(Simulator simulator, int i) => simulator.Launch(
        new Vector3d(12.0 * i - 30, 0.11, 5), new Vector3d(0.4 * i, 3 + i, -14 - i), new Vector3d(10 * i, 20 - (8 * i), 5));

    private static double Energy(BallState[] balls) => balls.Sum(ball =>
        (0.5 * 0.43 * ball.Velocity.LengthSquared) + (0.5 * BallProperties.Tunnel.MomentOfInertia * ball.Spin.LengthSquared) + (0.43 * 9.81 * ball.Position.Y));

    private sealed class Steady(Vector3d force, Vector3d torque) : IForce
    {
        public void Apply(in ForceContext ball, ref ForceAndTorque sum)
        {
            sum.AddForce(in force);
            sum.AddTorque(in torque);
        }
    }
}
