using FootballPhysics.Contacts;
using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Several;

/// <summary>Balls that meet within a step: closed forms without air and weight, and long steps against short ones.</summary>
public sealed class BallClusterTests
{
    private static readonly Scene Empty = Scene.Default with
    {
        Gravity = 0,
        Ground = Ground.None,
        Forces = new ForceSet { Buoyancy = false, Drag = ForceLaw.None, Magnus = ForceLaw.None, SpinDecay = ForceLaw.None },
    };

    private static readonly BallProperties Heavy = new() { Mass = 3, Radius = 0.15 };
    private static readonly BallProperties Light = new() { Mass = 1, Radius = 0.1 };

    /// <summary>What overlaps is put apart, the center of mass of the two stays: each by its share.</summary>
    [Fact]
    public void Balls_that_overlap_are_put_apart_by_their_masses()
    {
        var group = new BallGroup(Empty, [Heavy, Light]);
        BallState[] balls = Launched(group, (new Vector3d(0, 5, 0), default), (new Vector3d(0.246, 5, 0), default));
        var log = new StepLog();
        group.Step(balls, 0.01, log);
        Assert.Equal(-0.001, balls[0].Position.X, 1e-12);
        Assert.Equal(0.249, balls[1].Position.X, 1e-12);
        Assert.Equal((default, default, 0, 0L), (balls[0].Velocity, balls[1].Velocity, log.Events.Count, log.UnreportedImpacts));
        Assert.Equal((0.01, 0.01), (balls[0].Time, balls[1].Time));
    }

    /// <summary>Slower than a centimeter a second they press each other: no bounce, Coulomb's friction μ J_n, nothing told; faster they bounce.</summary>
    [Theory]
    [InlineData(0.0099, true)]
    [InlineData(0.0101, false)]
    public void Slow_balls_press_each_other(double speed, bool presses)
    {
        var contact = SurfaceMaterial.GoalFrame with { NormalRestitution = 0.5, RestitutionSpeedScale = 1e9, ImpactFriction = 0.4, TangentialRestitution = 0 };
        var group = new BallGroup(Empty, [Heavy, Light], contact: contact);
        BallState[] balls = Launched(group, (new Vector3d(0, 5, 0), default), (new Vector3d(0.25 + (2e-4 * speed), 5, 0), new Vector3d(-speed, 0.1, 0)));
        var log = new StepLog();
        group.Step(balls, 0.003, log);

        // J_n = (1 + e) u/(1/m₁ + 1/m₂), J_t = μ J_n.
        double impulse = (presses ? 1 : 1.5) * speed / ((1 / Heavy.Mass) + (1 / Light.Mass));
        Assert.Equal(-impulse / 3, balls[0].Velocity.X, 1e-5);
        Assert.Equal(-speed + impulse, balls[1].Velocity.X, 1e-5);
        Assert.Equal(0.4 * impulse / 3, balls[0].Velocity.Y, 1e-5);
        Assert.Equal(0.1 - (0.4 * impulse), balls[1].Velocity.Y, 1e-5);
        Assert.Equal(presses ? (0, 1L) : (2, 0L), (log.Events.Count, log.UnreportedImpacts));
    }

    /// <summary>Pressed by a force a ball leaves the other no place: they are solved as one, in parts of 2 ms, and told of once at most.</summary>
    [Fact]
    public void Balls_that_are_pressed_are_solved_as_one()
    {
        Scene scene = Empty with { Forces = Empty.Forces with { CustomForces = [IForce.From(ball => new Vector3d(0, 0, -2 * ball.Position.Z))] } };
        var group = new BallGroup(scene, [Light, Light]);
        BallState[] balls = Launched(group, (new Vector3d(0, 5, 0.1), default), (new Vector3d(0, 5, -0.1), default));
        var log = new StepLog();
        group.Step(balls, 0.05, log);
        Assert.Equal(0, log.Events.Count);
        Assert.InRange(log.UnreportedImpacts, 0, 1);
        Assert.InRange(log.Evaluations, 2 * 16, 2 * 20);
        Assert.InRange((balls[0].Position - balls[1].Position).Length, 0.2 - 1e-9, 0.2 + 1e-9);
        Assert.InRange(balls[0].Velocity.Length + balls[1].Velocity.Length, 0, 1e-9);
    }

    /// <summary>The first impact of any ball ends the step of all of them: each is where it would be then, as one of them is that meets nothing.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void An_impact_ends_the_step_of_all_balls(bool bin)
    {
        Scene scene = bin ? Empty with { Obstacles = [new Obstacle { Name = "bin", Shape = new BoxShape(new Vector3d(-1, 5, 0), new Vector3d(0.5, 3, 3)), Mass = 2 }] } : Empty;
        var group = new BallGroup(scene, [Light, Light, Light, Light]);
        BallState[] balls = Launched(
            group,
            (new Vector3d(0, 9, 0), new Vector3d(0, 3, 0)),
            (new Vector3d(0, 5, 0), bin ? new Vector3d(-4, 0, 0) : default),
            (new Vector3d(bin ? 30 : 0.6, 5, 0), new Vector3d(-4, 0, 0)),
            (new Vector3d(5, 1, 0), new Vector3d(0, 0, 2)));
        var log = new StepLog();
        Assert.True(group.Run(balls, 0.5, 5, StopAt.Impact, log));
        Assert.All(balls, ball => Assert.Equal(0.1, ball.Time, 1e-9));
        Assert.Equal(9.3, balls[0].Position.Y, 1e-8);
        Assert.Equal(0.2, balls[3].Position.Z, 1e-8);
        Assert.Equal(bin ? 1 : 2, log.Events.Count);
        Assert.Equal(bin ? -0.4 : 0, balls[1].Position.X, 1e-8);

        // On from there, as if nothing had been.
        Assert.False(group.Run(balls, 0.05, 0.1, StopAt.Time, log));
        Assert.All(balls, ball => Assert.Equal(balls[0].Time, ball.Time));
        Assert.Equal(9.6, balls[0].Position.Y, 1e-8);
        Assert.Equal(0.4, balls[3].Position.Z, 1e-8);
    }

    /// <summary>Up to what they may get to in a step, with the touch: to the boundary.</summary>
    [Fact]
    public void Balls_may_meet_where_their_reaches_touch()
    {
        var simulators = new[] { new Simulator(Empty with { Ball = Heavy }), new Simulator(Empty with { Ball = Light }) };
        foreach ((double over, bool may) in new[] { (-1e-3, true), (5e-11, true), (2e-10, false), (1e-3, false) })
        {
            BallState[] before = [simulators[0].Launch(new Vector3d(1, 2, 3), default, default), simulators[1].Launch(new Vector3d(1, 2, 3 + 0.25 + 0.5 + over), default, default)];
            var cluster = new BallCluster(simulators, new ContactMaterial(SurfaceMaterial.Ball), 0.3, before, [0, 0], [new StepLog(), new StepLog()]);
            Assert.Equal(may, cluster.MayMeet(0, 0.3, 1, 0.2));
            Assert.Equal(may, cluster.MayMeet(1, 0.2, 0, 0.3));
            cluster.Join(1);
            cluster.Join(1);
            Assert.Equal((1, 1, true, false), (cluster.Count, cluster[0], cluster.Has(1), cluster.Has(0)));
            cluster.Clear();
            Assert.Equal((0, false), (cluster.Count, cluster.Has(1)));
        }
    }

    public static TheoryData<int> Draws => [.. Enumerable.Range(0, 24)];

    /// <summary>Balls among bins that give way, without air and weight: in one long step all that happens is what happens in many short ones, and impulse is kept.</summary>
    [Theory]
    [MemberData(nameof(Draws))]
    public void A_long_step_is_many_short_ones(int seed)
    {
        BallState[] whole = Played(seed, 1, out List<BallEvent> events, out Vector3d impulse);
        BallState[] parts = Played(seed, 40, out List<BallEvent> expected, out Vector3d again);
        Assert.Equal(expected.Select(item => (item.Ball, item.Kind, item.ColliderIndex, item.OtherBall)), events.Select(item => (item.Ball, item.Kind, item.ColliderIndex, item.OtherBall)));
        Assert.True(expected.Count > 0, "nothing happens");
        for (int k = 0; k < events.Count; k++)
        {
            Assert.Equal(expected[k].Time, events[k].Time, 1e-7);
        }

        for (int i = 0; i < whole.Length; i++)
        {
            Assert.InRange((whole[i].Position - parts[i].Position).Length, 0, 1e-6);
            Assert.InRange((whole[i].Velocity - parts[i].Velocity).Length, 0, 1e-5);
            Assert.Equal(whole[0].Time, whole[i].Time);
        }

        if (seed % 3 == 0)
        {
            Assert.InRange(impulse.Length, 0, 1e-9);
            Assert.InRange(again.Length, 0, 1e-9);
        }
    }

    private static BallState[] Played(int seed, int steps, out List<BallEvent> events, out Vector3d gained)
    {
        var random = new Random(seed);
        double Draw(double most) => ((2 * random.NextDouble()) - 1) * most;
        Obstacle[] bins = seed % 3 == 0 ? [] : [Bin("bin", 0.1, 0.5 + (seed % 3))];
        Scene scene = Empty with { Obstacles = bins };
        BallProperties[] kinds = [.. Enumerable.Range(0, 7).Select(i => i % 2 == 0 ? Heavy : Light)];
        var group = new BallGroup(scene, kinds);
        var launches = new (Vector3d, Vector3d)[kinds.Length];
        for (int i = 0; i < kinds.Length; i++)
        {
            double angle = (i + (0.3 * random.NextDouble())) * 2 * Math.PI / kinds.Length;
            var outward = new Vector3d(Math.Cos(angle), 0, Math.Sin(angle));
            double speed = 2 + (6 * random.NextDouble());
            launches[i] = ((1.2 + (0.2 * (i % 3))) * outward + new Vector3d(0, 5 + Draw(0.2), 0), (-speed * outward) + new Vector3d(Draw(0.4), Draw(0.2), Draw(0.4)));
        }

        BallState[] balls = Launched(group, launches);
        Vector3d before = Sum(balls, kinds);
        events = [];
        var log = new StepLog();
        for (int k = 0; k < steps; k++)
        {
            log.Clear();
            group.Step(balls, 0.5 / steps, log);
            events.AddRange(log.Events.Span.ToArray());
        }

        gained = Sum(balls, kinds) - before;
        return balls;
    }

    private static Vector3d Sum(BallState[] balls, BallProperties[] kinds) =>
        balls.Zip(kinds, (ball, kind) => kind.Mass * ball.Velocity).Aggregate(Vector3d.Zero, (sum, next) => sum + next);

    private static Obstacle Bin(string name, double x, double mass) => new() { Name = name, Shape = new SphereShape(new Vector3d(x, 5, 0), 0.25), Mass = mass };

    private static BallState[] Launched(BallGroup group, params (Vector3d Place, Vector3d Velocity)[] launches) =>
        [.. launches.Select((launch, i) => group.SimulatorOf(i).Launch(launch.Place, launch.Velocity, default))];
}
