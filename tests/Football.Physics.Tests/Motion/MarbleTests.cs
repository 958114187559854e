namespace FootballPhysics.Tests.Motion;

/// <summary>Balls of 5 mm and of table football: they bounce, roll and rest as large ones do.</summary>
public sealed class MarbleTests
{
    private static readonly BallProperties s_marble = new() { Mass = 0.0013, Radius = 0.005, InertiaFactor = 0.4, KnuckleForce = 0 };

    private static readonly BallProperties s_table = new() { Mass = 0.02, Radius = 0.017, InertiaFactor = 0.4, KnuckleForce = 0 };

    public static TheoryData<bool> Balls => [true, false];

    private static BallProperties Of(bool marble) => marble ? s_marble : s_table;

    /// <summary>By hand: s = v₀²/(2 μ g), t = v₀/(μ g), in air that does not act on the ground.</summary>
    [Theory]
    [MemberData(nameof(Balls))]
    public void A_roll_ends_where_rolling_friction_says(bool marble)
    {
        BallProperties ball = Of(marble);
        Ground ground = new Ground
        {
            Material = SurfaceMaterial.Concrete with
            {
                RollingResistance = 0.02,
                RollingResistancePerSpeed = 0,
                SpinDamping = 0,
            },
            Aerodynamics = GroundAerodynamics.None,
            RestEnergy = 1e-9
        };
        var simulator = new Simulator(new Scene { Ball = ball, Ground = ground, Forces = new ForceSet { Buoyancy = false } });
        const double Speed = 1.5;
        BallState s = simulator.Launch(new Vector3d(0, ball.Radius, 0), new Vector3d(0, 0, -Speed), new Vector3d(-Speed / ball.Radius, 0, 0));
        var log = new StepLog();
        Assert.True(simulator.Run(ref s, 0.01, 60, StopAt.Rest, log));
        Assert.Equal(MotionState.Rest, s.Motion);
        double last = Math.Sqrt(2 * 1e-9 * (marble ? 1.0 / 64 : Math.Pow(0.85, 3)) / (ball.Mass * 1.4));
        Assert.Equal(-((Speed * Speed) - (last * last)) / (2 * 0.02 * 9.81), s.Position.Z, 9);
        Assert.Equal((Speed - last) / (0.02 * 9.81), s.Time, 9);
        Assert.Equal(ball.Radius, s.Position.Y);
        Assert.Equal(0, log.StalledSteps);
    }

    /// <summary>The rest energy of a football would stop a marble at 0.33 m/s.</summary>
    [Fact]
    public void A_marble_on_the_default_ground_rolls_on_until_it_is_slow()
    {
        var simulator = new Simulator(new Scene { Ball = s_marble });
        BallState s = simulator.Launch(new Vector3d(0, s_marble.Radius, 0), new Vector3d(0, 0, -1), new Vector3d(-200, 0, 0));
        var log = new StepLog();
        Assert.True(simulator.Run(ref s, 0.01, 60, StopAt.Rest, log));
        BallEvent rest = log.Events[log.Events.Count - 1];
        Assert.Equal(BallEventKind.Rest, rest.Kind);
        Assert.InRange(rest.Velocity.Length, 0.03, 0.05);
    }

    /// <summary>Heights of bounces in vacuum fall by e².</summary>
    [Theory]
    [MemberData(nameof(Balls))]
    public void A_ball_that_falls_bounces_to_e_squared_of_its_height_and_rests(bool marble)
    {
        BallProperties ball = Of(marble);
        Ground ground = new Ground
        {
            Material = SurfaceMaterial.Concrete with
            {
                NormalRestitution = 0.8,
                RestitutionSpeedScale = double.PositiveInfinity,
                GrazingRestitutionGain = 0,
                SpinDamping = 0,
            },
            MinimumBounceSpeed = 0.01
        };
        var simulator = new Simulator(new Scene { Ball = ball, Ground = ground, Forces = ForceSet.None });
        BallState s = simulator.Launch(new Vector3d(0, 0.3 + ball.Radius, 0), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        simulator.Run(ref s, 0.005, 20, StopAt.Rest, log);
        BallEvent[] impacts = [.. log.Events.Span.ToArray().Where(e => e.Kind == BallEventKind.Impact)];
        Assert.True(impacts.Length > 20, $"{impacts.Length} impacts");
        for (int i = 0; i < impacts.Length; i++)
        {
            Assert.Equal(Math.Pow(0.8, i) * Math.Sqrt(2 * 9.81 * 0.3), impacts[i].ApproachSpeed, 9);
        }

        Assert.Equal(MotionState.Rest, s.Motion);
        Assert.Equal(ball.Radius, s.Position.Y);
    }

    /// <summary>In a box of boards, over a gutter and a step, by the default laws: nothing is entered or passed, no energy is gained, and the ball rests.</summary>
    [Theory]
    [MemberData(nameof(Balls))]
    public void A_ball_in_a_box_with_a_gutter_rests_and_enters_nothing(bool marble)
    {
        BallProperties ball = Of(marble);
        double r = ball.Radius;
        var obstacles = new List<Obstacle>
        {
            new() { Name = "left", Shape = new BoxShape(new Vector3d(-0.4, 0.1, 0), new Vector3d(0.01, 0.2, 0.6)) },
            new() { Name = "right", Shape = new BoxShape(new Vector3d(0.4, 0.1, 0), new Vector3d(0.01, 0.2, 0.6)) },
            new() { Name = "near", Shape = new BoxShape(new Vector3d(0, 0.1, 0.6), new Vector3d(0.4, 0.2, 0.01)) },
            new() { Name = "far", Shape = new BoxShape(new Vector3d(0, 0.1, -0.6), new Vector3d(0.4, 0.2, 0.01)) },
            new() { Name = "rail", Shape = new CapsuleShape(new Vector3d(0.1, 0, -0.5), new Vector3d(0.1, 0, 0.5), r) },
            new() { Name = "rail 2", Shape = new CapsuleShape(new Vector3d(0.1 + (2.4 * r), 0, -0.5), new Vector3d(0.1 + (2.4 * r), 0, 0.5), r) },
            new() { Name = "step", Shape = new BoxShape(new Vector3d(-0.3, 0.5 * r, 0), new Vector3d(0.05, 0.5 * r, 0.3)) },
        };
        Scene scene = new() { Ball = ball, Ground = Ground.Of(SurfaceMaterial.Indoor), Obstacles = obstacles, Forces = new ForceSet { Buoyancy = false } };
        var simulator = new Simulator(scene);
        int rested = 0;
        for (int seed = 0; seed < 40; seed++)
        {
            var random = new Random(seed);
            double At(double low, double high) => low + ((high - low) * random.NextDouble());
            BallState s = simulator.Launch(new Vector3d(At(-0.1, 0.05), At(r, 0.2), At(-0.3, 0.3)), new Vector3d(At(-3, 3), At(0, 1), At(-3, 3)), new Vector3d(At(-200, 200), At(-200, 200), At(-200, 200)));
            var log = new StepLog();
            double Energy() => (0.5 * ball.Mass * s.Velocity.LengthSquared) + (0.5 * ball.MomentOfInertia * s.Spin.LengthSquared) + (ball.Mass * 9.81 * s.Position.Y);
            double start = Energy();
            for (int i = 0; i < 6000 && s.Motion != MotionState.Rest; i++)
            {
                double before = Energy();
                log.Clear();
                simulator.Step(ref s, 0.01, log);
                Assert.True(Energy() <= before + (1e-9 * start), $"{seed}: {before} to {Energy()}");
                Assert.Equal(0, log.StalledSteps);
                Assert.True(s.Position.Y >= r - 1e-9, $"{seed}: {s.Position}");
                foreach (Obstacle obstacle in obstacles)
                {
                    Assert.True(obstacle.Shape.At(s.Position).Distance >= r - 1e-7, $"{seed}: {obstacle.Shape.At(s.Position).Distance - r} from {obstacle.Name}, {s.Motion}");
                }
            }

            rested += s.Motion == MotionState.Rest ? 1 : 0;
        }

        Assert.Equal(40, rested);
    }

    /// <summary>A rod of a table strikes the ball: it leaves with the velocity that the impulse gives, and is not passed.</summary>
    [Fact]
    public void A_figure_of_a_table_strikes_the_ball()
    {
        var bodies = new KinematicBodies();
        KinematicBody figure = bodies.Add("figure", new BoxShape(Vector3d.Zero, new Vector3d(0.012, 0.03, 0.006)), SurfaceMaterial.Wood);
        var simulator = new Simulator(new Scene { Ball = s_table, Ground = Ground.Of(SurfaceMaterial.Indoor), Bodies = bodies });
        BallState s = simulator.Launch(new Vector3d(0, 0.017, 0), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        for (int i = 0; i < 60; i++)
        {
            figure.MoveTo(new Vector3d(0, 0.03, 0.1 - (2 * s.Time)), new Vector3d(0, 0, -2), s.Time);
            simulator.Step(ref s, 1.0 / 60, log);
        }

        BallEvent hit = log.Events.Span.ToArray().First(e => e.Kind == BallEventKind.Impact && e.ColliderIndex > 0);
        Assert.Equal((0.1 - 0.006 - 0.017) / 2, hit.Time, 9);
        double e = SurfaceMaterial.Wood.NormalRestitution * Math.Sqrt((1 + (36.0 / 900)) / (1 + (4.0 / 900)));
        Assert.Equal(-2 * (1 + e), hit.Velocity.Z, 9);
        Assert.True(s.Position.Z < 0.1 - (2 * s.Time));
    }

    /// <summary>Marbles dropped into a corner: they meet, pile, and rest without overlap.</summary>
    [Fact]
    public void Marbles_meet_and_rest_without_overlap()
    {
        const int Count = 8;
        double r = s_marble.Radius;
        Scene scene = new()
        {
            Ball = s_marble,
            Ground = Ground.Of(SurfaceMaterial.Indoor),
            Obstacles =
            [
                new Obstacle { Shape = new BoxShape(new Vector3d(-0.06, 0.05, 0), new Vector3d(0.01, 0.1, 0.1)) },
                new Obstacle { Shape = new BoxShape(new Vector3d(0.06, 0.05, 0), new Vector3d(0.01, 0.1, 0.1)) },
                new Obstacle { Shape = new BoxShape(new Vector3d(0, 0.05, -0.06), new Vector3d(0.1, 0.1, 0.01)) },
                new Obstacle { Shape = new BoxShape(new Vector3d(0, 0.05, 0.06), new Vector3d(0.1, 0.1, 0.01)) },
            ],
        };
        var group = new BallGroup(new Simulator(scene), Count);
        var random = new Random(3);
        BallState[] states = [.. Enumerable.Range(0, Count).Select(i => group.SimulatorOf(0).Launch(
            new Vector3d(-0.03 + (0.02 * (i % 4)), r + 0.01 + (0.015 * (i / 4)), 0.01 * (i % 2)), new Vector3d(random.NextDouble() - 0.5, 0, random.NextDouble() - 0.5), Vector3d.Zero))];
        var log = new StepLog();
        int met = 0;
        for (int step = 0; step < 3000 && !states.All(s => s.Motion == MotionState.Rest); step++)
        {
            log.Clear();
            group.Step(states, 0.01, log);
            met += log.Events.Span.ToArray().Count(e => e.OtherBall >= 0);
            for (int i = 0; i < Count; i++)
            {
                Assert.True(states[i].Position.IsFinite && states[i].Position.Y >= r - 1e-7);
                for (int j = 0; j < i; j++)
                {
                    double gap = (states[i].Position - states[j].Position).Length - (2 * r);
                    Assert.True(gap > -1e-6, $"step {step}: {i} and {j} overlap by {-gap}");
                }
            }
        }

        Assert.True(met > 5, $"{met} meetings");
        Assert.All(states, s => Assert.Equal(MotionState.Rest, s.Motion));
    }
}
