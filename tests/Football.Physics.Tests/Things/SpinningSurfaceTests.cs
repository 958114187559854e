namespace FootballPhysics.Tests.Things;

/// <summary>The spin of an obstacle moves its surface but not its shape: in sustained contact, only its velocity along the shape acts.</summary>
public sealed class SpinningSurfaceTests
{
    private const double Radius = 0.11;
    private const double Step = 0.01;

    private static readonly SurfaceMaterial s_smooth = SurfaceMaterial.GoalFrame with
    {
        ImpactFriction = 0,
        SlidingFriction = 0,
        RollingResistance = 0,
        RollingResistancePerSpeed = 0,
        TorsionalPatchRadius = 0,
        SpinDamping = 0,
    };

    private static readonly SurfaceMaterial s_rough = s_smooth with { ImpactFriction = 5, SlidingFriction = 0.5 };

    public enum Kind
    {
        Plane,
        Box,
        Sphere,
        Capsule,
    }

    public static TheoryData<Kind, double, double, double> Spins
    {
        get
        {
            var all = new TheoryData<Kind, double, double, double>();
            foreach (Kind kind in Enum.GetValues<Kind>())
            {
                all.Add(kind, 0, 2, 0);
                all.Add(kind, 5, 0, 0);
                all.Add(kind, 3, 20, 0);
            }

            return all;
        }
    }

    /// <summary>Without friction and restitution, a surface that recedes into its shape stops the ball as one that stands still.</summary>
    [Theory]
    [MemberData(nameof(Spins))]
    public void Without_friction_a_receding_surface_acts_as_a_still_one(Kind kind, double x, double y, double z)
    {
        (BallState[] still, long impacts) = Play(SceneOf(kind, Vector3d.Zero));
        (BallState[] spun, long sameImpacts) = Play(SceneOf(kind, new Vector3d(x, y, z)));
        Assert.InRange(impacts, 1, 50);
        Assert.Equal(impacts, sameImpacts);
        for (int i = 0; i < still.Length; i++)
        {
            Assert.Equal(0, (still[i].Position - spun[i].Position).Length, 1e-9);
            Assert.Equal(0, (still[i].Velocity - spun[i].Velocity).Length, 1e-8);
            Assert.Equal(still[i].Motion, spun[i].Motion);
        }
    }

    /// <summary>So it is for balls in a group, which touch each other as well.</summary>
    [Theory]
    [MemberData(nameof(Spins))]
    public void Without_friction_a_receding_surface_acts_as_a_still_one_for_a_group(Kind kind, double x, double y, double z)
    {
        BallState[] still = PlayGroup(SceneOf(kind, Vector3d.Zero));
        BallState[] spun = PlayGroup(SceneOf(kind, new Vector3d(x, y, z)));
        for (int i = 0; i < still.Length; i++)
        {
            Assert.Equal(0, (still[i].Position - spun[i].Position).Length, 1e-8);
        }
    }

    /// <summary>A skew capsule whose surface turns about a far pivot, beside a sliding ball: the ball passes it, in a few impacts.</summary>
    [Fact]
    public void A_ball_beside_a_spinning_capsule_does_not_freeze()
    {
        var capsule = new CapsuleShape(new Vector3d(-2, 0.5, 0), new Vector3d(2, 0.5, -6), 0.3);
        var scene = new Scene { Obstacles = [new Obstacle { Name = "capsule", Shape = capsule, Spin = new Vector3d(0, 2, 0), Pivot = new Vector3d(0, 0.5, -6) }] };
        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(new Vector3d(0, Radius, 6), new Vector3d(3, 0, -18), new Vector3d(0, 40, -20));
        var log = new StepLog();
        for (int i = 0; i < 150; i++)
        {
            Vector3d before = state.Position;
            simulator.Step(ref state, Step, log);
            Assert.True((state.Position - before).Length > 0.5 * Step * Math.Min(1, state.Velocity.Length), $"{state.Position} at {state.Time} s");
        }

        Assert.InRange(log.Events.Impacts, 1, 40);
    }

    /// <summary>A plane with its pivot below is a belt with one velocity, Ω d: a ball that it sets rolling ends at α/(1 + α) of it, wherever on the plane it lies.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(5)]
    [InlineData(-30)]
    public void A_belt_has_one_velocity_along_all_of_its_length(double x)
    {
        const double Depth = 2;
        const double Rate = 1.5;
        var belt = new Obstacle { Name = "belt", Shape = new PlaneShape(Vector3d.Zero, Vector3d.Up), Surface = s_rough, Spin = new Vector3d(0, 0, Rate), Pivot = new Vector3d(0, -Depth, 0) };
        var scene = new Scene { Air = new Air { Density = 0 }, Ground = Ground.None, Obstacles = [belt] };
        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(new Vector3d(x, Radius, 0), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        for (int i = 0; i < 200; i++)
        {
            simulator.Step(ref state, Step, log);
            Assert.Equal(Radius, state.Position.Y, 1e-9);
        }

        double alpha = scene.Ball.InertiaFactor;
        Assert.Equal(MotionState.Rolling, state.Motion);
        Assert.Equal(0, (state.Velocity - new Vector3d(-Rate * Depth * alpha / (1 + alpha), 0, 0)).Length, 1e-8);
    }

    /// <summary>A ball that rests on a belt moves along it, with the velocity of its material, and stays on the surface.</summary>
    [Fact]
    public void A_ball_at_rest_moves_along_the_belt()
    {
        const double Rate = 0.02;
        var belt = new Obstacle
        {
            Name = "belt",
            Shape = new PlaneShape(Vector3d.Zero, Vector3d.Up),
            Surface = SurfaceMaterial.WetTurf with { RollingResistance = 0.2 },
            Spin = new Vector3d(0, 0, Rate),
            Pivot = new Vector3d(0, -1, 0),
        };
        var simulator = new Simulator(new Scene { Air = new Air { Density = 0 }, Ground = Ground.None, Obstacles = [belt] });
        BallState state = simulator.Launch(new Vector3d(-1, Radius, 0), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        for (int i = 0; i < 1000; i++)
        {
            simulator.Step(ref state, Step, log);
            Assert.Equal(Radius, state.Position.Y, 1e-9);
        }

        Assert.Equal(MotionState.Rest, state.Motion);
        Assert.Equal(0, (state.Velocity - new Vector3d(-Rate * (1 + Radius), 0, 0)).Length, 1e-9);
    }

    private static Scene SceneOf(Kind kind, Vector3d spin)
    {
        IShape shape = kind switch
        {
            Kind.Plane => new PlaneShape(new Vector3d(0, 0, -3), new Vector3d(0.1, 0.2, 1).Normalized()),
            Kind.Box => new BoxShape(new Vector3d(0, 0.5, -3), new Vector3d(1, 0.5, 1)),
            Kind.Sphere => new SphereShape(new Vector3d(0.3, 0.2, -3), 0.6),
            _ => new CapsuleShape(new Vector3d(-2, 0.2, 0), new Vector3d(2, 0.2, -6), 0.3),
        };
        return new Scene { Obstacles = [new Obstacle { Name = "obstacle", Shape = shape, Surface = s_smooth with { NormalRestitution = 0, GrazingRestitutionGain = 0 }, Spin = spin, Pivot = new Vector3d(-3, 3, -3) }] };
    }

    private static (BallState[] States, long Impacts) Play(Scene scene)
    {
        var simulator = new Simulator(scene);
        var states = new BallState[200];
        BallState state = simulator.Launch(new Vector3d(0, Radius, 3), new Vector3d(0.3, 0, -12), new Vector3d(0, 40, -20));
        var log = new StepLog();
        for (int i = 0; i < states.Length; i++)
        {
            simulator.Step(ref state, Step, log);
            states[i] = state;
        }

        return (states, log.Events.Impacts);
    }

    private static BallState[] PlayGroup(Scene scene)
    {
        var group = new BallGroup(new Simulator(scene), 2);
        BallState[] states = [.. new[] { 0.0, 2.5 * Radius }.Select(behind => group.SimulatorOf(0).Launch(new Vector3d(0, Radius, 3 + behind), new Vector3d(0.3, 0, -12), Vector3d.Zero))];
        var log = new StepLog();
        for (int i = 0; i < 100; i++)
        {
            group.Step(states, Step, log);
        }

        return states;
    }
}
