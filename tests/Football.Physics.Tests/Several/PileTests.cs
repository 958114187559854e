namespace FootballPhysics.Tests.Several;

/// <summary>Balls that lie on each other and against walls: nothing is entered, nothing gains, all come to rest, at a bounded cost.</summary>
public sealed class PileTests
{
    private const double Step = 1 / 60.0;

    private static readonly BallProperties[] s_sizes =
        [BallProperties.Tunnel, new() { Mass = 0.2, Radius = 0.09 }, new() { Mass = 0.6, Radius = 0.12, InertiaFactor = 0.4 }];

    public static TheoryData<string, double> Cases
    {
        get
        {
            var cases = new TheoryData<string, double>();
            foreach (string kind in new[] { "tube of 24 cm", "box of 70 cm", "ten in a tube", "ten in a box", "ten in a corner", "sizes", "wind" })
            {
                foreach (double step in new[] { 1 / 60.0, 1 / 120.0, 1 / 30.0, 0.1 })
                {
                    cases.Add(kind, step);
                }
            }

            return cases;
        }
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void A_pile_enters_nothing_and_comes_to_rest(string kind, double step)
    {
        Heap heap = Of(kind);
        heap.Run(step, 8);
        Assert.InRange(heap.Depth, 0, 1e-6);
        Assert.InRange(heap.Overlap, 0, 1e-3);
        Assert.True(heap.Rests, string.Join(", ", heap.Balls.Where(ball => ball.Motion != MotionState.Rest).Select(ball => ball.ToString())));
        Assert.InRange(heap.Log.Events.Count + heap.Log.Events.Dropped, 1, 5000);
        Assert.InRange(heap.EvaluationsPerBall, 0, 50);
        Assert.Equal(0, heap.Log.StalledSteps);

        // Wind alone gives energy.
        Assert.InRange(heap.Gain, double.NegativeInfinity, kind == "wind" ? 0.1 : 1e-5);
    }

    private static Heap Of(string kind) => kind switch
    {
        "tube of 24 cm" => Heap.Dropped(Heap.Box(0.12), 2, 0.009, 0.3, 0.4, 1),
        "box of 70 cm" => Heap.Dropped(Heap.Box(0.35), 9, 0.05, 0.4, 0.3, 2),
        "ten in a tube" => Heap.Dropped(Heap.Box(0.13), 10, 0.015, 0.2, 0.25, 3),
        "ten in a box" => Heap.Dropped(Heap.Box(0.3), 10, 0.1, 0.8, 0.5, 4),
        "ten in a corner" => Heap.Dropped(Heap.Corner(), 10, 0.15, 0.3, 0.3, 5),
        "sizes" => Heap.Dropped(Heap.Box(0.35), 10, 0.1, 0.4, 0.35, 6, s_sizes),
        _ => Heap.Dropped(Heap.Box(0.35) with { Air = new Air { Wind = new Vector3d(6, 0, 2) } }, 10, 0.1, 0.4, 0.3, 7),
    };

    /// <summary>Balls in one and the same place have no line of centres: they go apart, and stay finite and above the ground.</summary>
    [Theory]
    [InlineData(2)]
    [InlineData(3)]
    public void Balls_in_one_place_go_apart(int count)
    {
        var group = new BallGroup(Scene.Default, [.. Enumerable.Repeat(BallProperties.Tunnel, count)]);
        double r = BallProperties.Tunnel.Radius;
        BallState[] states = [.. Enumerable.Range(0, count).Select(i => group.SimulatorOf(i).Launch(new Vector3d(0, r, 0), Vector3d.Zero, Vector3d.Zero))];
        var log = new StepLog();
        for (int i = 0; i < 60; i++)
        {
            group.Step(states, 0.02, log);
            Assert.All(states, s => Assert.True(double.IsFinite(s.Position.Length + s.Velocity.Length + s.Spin.Length) && s.Position.Y >= r - 1e-6 && s.Position.Y < 5 * r, $"{s}"));
        }

        for (int i = 1; i < count; i++)
        {
            Assert.InRange(Vector3d.Distance(states[i].Position, states[0].Position), (2 * r) - 1e-6, 20);
        }
    }

    /// <summary>The balls of the last row keep out of each other and of the walls at every step; in a second each has few evaluations a step.</summary>
    [Fact]
    public void Sixty_balls_in_a_box_cost_few_evaluations()
    {
        Heap heap = Heap.Dropped(Heap.Box(0.5), 60, 0.1, 0.4, 0.3, 5);
        heap.Run(Step, 3);
        Assert.InRange(heap.Depth, 0, 1e-6);
        Assert.InRange(heap.Overlap, 0, 1e-4);
        Assert.InRange(heap.EvaluationsPerBall, 1, 50);
        Assert.InRange(heap.Gain, double.NegativeInfinity, 1e-5);
        Assert.Equal(0, heap.Log.StalledSteps);
        heap.Run(Step, 9, untilRest: true);
        Assert.True(heap.Rests);
    }

    /// <summary>Walls that lean, a sphere or a box between them, balls of any mass and size: nothing that stands still is entered and nothing gains, in steps of any length.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    [InlineData(5)]
    [InlineData(6)]
    public void Among_leaning_walls_a_pile_enters_nothing(int seed)
    {
        var random = new Random(seed);
        double Draw(double low, double high) => low + (random.NextDouble() * (high - low));
        Obstacle Leaning(double x, double z) => Heap.Wall(x, z) with { Shape = new PlaneShape(new Vector3d(x, 0, z), new Vector3d(-x, Draw(-0.1, 0.6) * 0.4, -z)) };
        IShape between = seed % 2 == 0
            ? new SphereShape(new Vector3d(Draw(-0.2, 0.2), Draw(-0.1, 0.2), Draw(-0.2, 0.2)), Draw(0.1, 0.2))
            : new BoxShape(new Vector3d(Draw(-0.2, 0.2), 0.1, Draw(-0.2, 0.2)), new Vector3d(0.1, Draw(0.05, 0.3), 0.12));
        Scene scene = Scene.Default with
        {
            Ground = Heap.Turf,
            Obstacles = [Leaning(0.4, 0), Leaning(-0.4, 0), Leaning(0, 0.4), Leaning(0, -0.4), new Obstacle { Name = "between", Shape = between, Surface = Heap.Board }],
        };
        BallProperties[] kinds = [.. Enumerable.Range(0, 7).Select(_ => new BallProperties { Mass = Draw(0.1, 3), Radius = Draw(0.06, 0.13), InertiaFactor = Draw(0.4, 0.66) })];
        Heap heap = Heap.Dropped(scene, 14, 0.1, 0.6, 0.32, seed, kinds);
        heap.Run(new[] { 1 / 60.0, 1 / 120.0, 1 / 30.0, 0.1 }[seed % 4], 5);
        Assert.InRange(heap.Depth, 0, 1e-7);
        Assert.InRange(heap.Overlap, 0, 1e-4);
        Assert.InRange(heap.Gain, double.NegativeInfinity, 1e-5);
    }

    /// <summary>
    /// A pyramid of four: each foot is held by two forces, that of the ball on top and that of the ground, along the line between the two contacts. It makes half of the angle
    /// asin(1/√3) with the normals, so friction of more than tan(17.6°) = 0.318 holds the pyramid whatever resists rolling; with less it spreads.
    /// </summary>
    [Theory]
    [InlineData(0.29, false)]
    [InlineData(0.34, true)]
    public void A_pyramid_stays_where_friction_holds_it(double friction, bool stays)
    {
        const double R = 0.11;
        double far = 2 * R / Math.Sqrt(3);
        Scene scene = Scene.Default with { Ground = Heap.Turf with { Material = Heap.Turf.Material with { RollingResistance = 0, RollingResistancePerSpeed = 0 } } };
        Vector3d[] places =
        [
            .. Enumerable.Range(0, 3).Select(i => new Vector3d(far * Math.Cos(2 * Math.PI * i / 3), R, far * Math.Sin(2 * Math.PI * i / 3))),
            new Vector3d(0, R + (2 * R * Math.Sqrt(2.0 / 3)), 0),
        ];
        var heap = new Heap(scene, [.. Enumerable.Repeat(BallProperties.Tunnel, 4)], places, SurfaceMaterial.Ball with { ImpactFriction = friction });
        heap.Run(Step, 1.5);
        Assert.Equal(stays, heap.Balls[3].Position.Y > 0.2);
        Assert.InRange(heap.Depth, 0, 1e-9);
        Assert.InRange(heap.Overlap, 0, 1e-4);
        Assert.InRange(heap.Gain, double.NegativeInfinity, 1e-7);

        // The feet go as far each.
        double[] run = [.. heap.Balls.Take(3).Select(ball => new Vector3d(ball.Position.X, 0, ball.Position.Z).Length)];
        Assert.Equal(run[0], run[1], 1e-3);
        Assert.Equal(run[0], run[2], 1e-3);
        if (stays)
        {
            Assert.True(heap.Rests);
            Assert.Equal(far, run[0], 1e-4);
        }
    }

    [Fact]
    public void A_pile_at_rest_stays_to_the_last_bit_and_costs_nothing()
    {
        Heap heap = Of("ten in a box");
        heap.Run(Step, 8, untilRest: true);
        Assert.True(heap.Rests);
        BallState[] rested = [.. heap.Balls];
        heap.Log.Clear();
        heap.Run(Step, 2);
        Assert.Equal((0L, 0L, 0), (heap.Log.Evaluations, heap.Log.Steps, heap.Log.Events.Count));
        for (int i = 0; i < rested.Length; i++)
        {
            rested[i].Time = heap.Balls[i].Time;
            Assert.True(Snapshot.Same(in rested[i], in heap.Balls[i]));
        }

        // Nor does it in another group, which knows the states alone.
        var other = new BallGroup(Heap.Box(0.3), [.. Enumerable.Repeat(BallProperties.Tunnel, 10)]);
        other.Step(rested, Step, heap.Log);
        Assert.Equal((0L, 0L, 0), (heap.Log.Evaluations, heap.Log.Steps, heap.Log.Events.Count));
    }

    /// <summary>What leans on a ball wakes when that is kicked away, taken away, or hit; and comes to rest again.</summary>
    [Theory]
    [InlineData("kicked")]
    [InlineData("taken")]
    [InlineData("hit")]
    public void What_leant_on_a_ball_wakes_with_it(string how)
    {
        Heap heap = Of("ten in a tube");
        heap.Run(Step, 8, untilRest: true);
        Assert.True(heap.Rests);
        int lowest = Enumerable.Range(0, 10).MinBy(i => heap.Balls[i].Position.Y);
        int highest = Enumerable.Range(0, 10).MaxBy(i => heap.Balls[i].Position.Y);
        Simulator simulator = heap.Group.SimulatorOf(0);
        double top = heap.Balls[highest].Position.Y;
        BallState[] balls = [.. heap.Balls];
        switch (how)
        {
            case "kicked":
                simulator.Kick(ref heap.Balls[lowest], new Vector3d(0, 1.5, 0), default);
                break;
            case "taken":
                heap.Balls[lowest] = simulator.Launch(new Vector3d(0, 9, 0), default, default);
                heap.Balls[lowest].Time = heap.Balls[highest].Time;
                break;
            default:
                heap.Balls[highest] = simulator.Launch(new Vector3d(0, top + 1, 0), new Vector3d(0, -6, 0), default);
                heap.Balls[highest].Time = heap.Balls[lowest].Time;
                break;
        }

        heap.Log.Clear();
        heap.Run(Step, 0.5);
        int moved = Enumerable.Range(0, 10).Count(i => i != lowest && i != highest && (heap.Balls[i].Position - balls[i].Position).Length > 1e-4);
        Assert.True(moved >= (how == "taken" ? 8 : 1), $"{moved} have moved");
        heap.Run(Step, 8, untilRest: true);
        Assert.True(heap.Rests);
        Assert.InRange(heap.Depth, 0, 1e-6);
        Assert.InRange(heap.Overlap, 0, 1e-3);
    }

    /// <summary>The state of the balls is all that there is: on from a copy in another group, again, and with other numbers, they go the same way.</summary>
    [Fact]
    public void A_pile_goes_the_same_way_from_a_copy_and_in_any_order()
    {
        Heap first = Of("sizes");
        Heap again = Of("sizes");
        first.Run(Step, 1.6);
        BallState[] copy = [.. first.Balls];
        first.Run(Step, 1.6);
        again.Run(Step, 3.2);
        Assert.Equal(Snapshot.Hash(first.Balls), Snapshot.Hash(again.Balls));

        // On from the copy, in a group that has seen nothing.
        BallProperties[] kinds = [.. Enumerable.Range(0, 10).Select(i => s_sizes[i % 3])];
        var group = new BallGroup(Heap.Box(0.35), kinds);
        int[] order = [9, 3, 1, 0, 7, 5, 8, 2, 6, 4];
        var turned = new BallGroup(Heap.Box(0.35), [.. order.Select(i => kinds[i])]);
        BallState[] other = [.. order.Select(i => copy[i])];
        for (int k = 0; k < first.Steps / 2; k++)
        {
            group.Step(copy, Step, new StepLog());
            turned.Step(other, Step, new StepLog());
        }

        Assert.Equal(Snapshot.Hash(first.Balls), Snapshot.Hash(copy));
        for (int i = 0; i < order.Length; i++)
        {
            Assert.True(Snapshot.Same(in copy[order[i]], in other[i]), $"ball {order[i]}: {Snapshot.Difference(in copy[order[i]], in other[i])}");
        }
    }

    /// <summary>Two piles of one group, and a ball that flies by itself, go as they go alone.</summary>
    [Fact]
    public void Piles_far_apart_know_nothing_of_each_other()
    {
        Scene scene = Scene.Default with { Ground = Heap.Turf };
        Vector3d[] Places(double x) => [.. Enumerable.Range(0, 4).Select(i => new Vector3d(x + (0.03 * (i % 2)), 0.11 + (0.23 * i), 0.02 * (i % 3)))];
        BallProperties[] four = [.. Enumerable.Repeat(BallProperties.Tunnel, 4)];
        var near = new Heap(scene, four, Places(0));
        var far = new Heap(scene, four, Places(20.5));
        var both = new Heap(scene, [.. four, .. four, BallProperties.Tunnel], [.. Places(20.5), .. Places(0), new Vector3d(-30, 3, 0)]);
        BallState alone = both.Balls[8];
        for (int k = 0; k < 200; k++)
        {
            near.Step(Step);
            far.Step(Step);
            both.Step(Step);
            both.Group.SimulatorOf(8).Step(ref alone, Step, new StepLog());
        }

        Assert.True(Snapshot.Same(in alone, in both.Balls[8]));
        for (int i = 0; i < 4; i++)
        {
            Assert.True(Snapshot.Same(in far.Balls[i], in both.Balls[i]), $"{far.Balls[i]} {both.Balls[i]}");
            Assert.True(Snapshot.Same(in near.Balls[i], in both.Balls[4 + i]), $"{near.Balls[i]} {both.Balls[4 + i]}");
        }
    }

    /// <summary>A watched pile goes as one that nobody watches, along pieces that follow each other.</summary>
    [Fact]
    public void A_look_ahead_of_a_pile_is_its_future()
    {
        Heap heap = Of("box of 70 cm");
        heap.Run(Step, 1);
        Trajectory[] paths = [.. Enumerable.Range(0, 9).Select(_ => new Trajectory())];
        heap.Group.LookAhead(heap.Balls, new LookAheadRequest { Duration = 1, TimeStep = Step }, paths);
        heap.Log.Clear();
        heap.Group.Run(heap.Balls, Step, 1, StopAt.Time, heap.Log);
        for (int i = 0; i < 9; i++)
        {
            BallState foreseen = paths[i].Final;
            Assert.True(Snapshot.Same(in foreseen, in heap.Balls[i]), $"{i}: {foreseen} {heap.Balls[i]}");
            Assert.Equal(heap.Log.Events.Span.ToArray().Count(item => item.Ball == i), paths[i].Events.Count);
        }
    }

    [Fact]
    public void A_step_of_a_pile_allocates_nothing()
    {
        Heap heap = Of("sizes");
        heap.Run(Step, 1.4);
        BallState[] start = [.. heap.Balls];
        BallState[] balls = [.. start];
        var log = new StepLog();
        Assert.Equal(0, Allocation.Of(() =>
        {
            Array.Copy(start, balls, balls.Length);
            log.Clear();
            for (int k = 0; k < 30; k++)
            {
                heap.Group.Step(balls, Step, log);
            }
        }));
        Assert.True(log.Evaluations > 100);
    }

    /// <summary>Balls that lie on each other still come through a goal: told once for each.</summary>
    [Fact]
    public void A_pile_rolls_over_the_line()
    {
        Scene scene = Scene.Default with { Goals = [new Goal { Center = new Vector3d(0, 0, -2), Facing = new Vector3d(0, 0, 1) }] };
        var simulator = new Simulator(scene);
        var group = new BallGroup(simulator, 2);
        BallState[] balls = [.. new[] { -0.11, 0.11 }.Select(x => simulator.Launch(new Vector3d(x, simulator.ContactHeight, -1), new Vector3d(0, 0, -4), new Vector3d(-4 / 0.11, 0, 0)))];
        var log = new StepLog();
        for (int k = 0; k < 40; k++)
        {
            group.Step(balls, Step, log);
        }

        BallEvent[] goals = [.. log.Events.Span.ToArray().Where(item => item.Kind == BallEventKind.Goal)];
        Assert.Equal([0, 1], goals.Select(item => item.Ball).Order());
        Assert.All(goals, goal => Assert.Equal(-2 - 0.11, goal.Position.Z, 0.15));
        Assert.All(balls, ball => Assert.True(ball.GoalsPassed == 1));
    }

    /// <summary>A body pushes a pile into a corner: it enters nothing that stands still, whatever the body does, and stays in the numbers.</summary>
    [Fact]
    public void A_pile_that_is_pushed_against_a_wall_enters_nothing()
    {
        var bodies = new KinematicBodies();
        KinematicBody pusher = bodies.Add("pusher", new BoxShape(new Vector3d(0, 0.5, 0), new Vector3d(0.1, 0.5, 1)));
        var heap = new Heap(Heap.Corner() with { Bodies = bodies }, [.. Enumerable.Repeat(BallProperties.Tunnel, 5)], [.. Enumerable.Range(0, 5).Select(i =>
            new Vector3d(-0.1 + (0.23 * (i % 2)), 0.11 + (0.1 * (i / 4)), -0.19 + (0.221 * (i / 2))))]);
        for (int k = 0; k < 120; k++)
        {
            double x = 1.2 - (0.012 * Math.Min(k, 80));
            pusher.MoveTo(new Vector3d(x, 0, 0), new Vector3d(k < 80 ? -0.72 : 0, 0, 0), heap.Balls[0].Time);
            heap.Step(Step);
            Assert.All(heap.Balls, ball => Assert.True(ball.Position.IsFinite && ball.Velocity.Length < 5, $"{k}: {ball}"));
        }

        Assert.InRange(heap.Depth, 0, 1e-6);
    }
}
