namespace FootballPhysics.Tests.Things;

/// <summary>Flush surfaces of different curvature: a ball rolls from the ground into a quarter pipe or a bowl as on one surface.</summary>
public sealed class SeamTests
{
    private const double Frame = 1 / 60.0;

    public enum Made
    {
        Obstacle,
        Body,
        EngineCollider,
    }

    /// <summary>The path fits into the default trajectory, the game follows it, and no step has hundreds of pieces.</summary>
    [Theory]
    [InlineData(1.2, 1.5, 0, Made.Obstacle, 0.02)]
    [InlineData(1.2, 1.5, 0, Made.Body, 0.02)]
    [InlineData(1.2, 1.5, 0, Made.EngineCollider, 0.02)]
    [InlineData(1.2, 2.9, 0, Made.Obstacle, 0.02)]
    [InlineData(0.3, 2, 0.5, Made.Obstacle, 0.05)]
    [InlineData(0.5, 6, -0.3, Made.Body, 0.05)]
    [InlineData(2.5, 12, 0.2, Made.EngineCollider, 0.05)]
    [InlineData(4, 20, 0, Made.Obstacle, 0.05)]
    public void A_roll_into_a_pipe_takes_a_few_pieces(double radius, double speed, double angle, Made made, double tolerance)
    {
        foreach (bool alongX in new[] { false, true })
        {
            Simulator simulator = Scene(new QuarterPipe(radius, 1, alongX), made, SurfaceMaterial.MatchTurf, out Action<double> before);
            Vector3d velocity = alongX ? new Vector3d(speed * Math.Cos(angle), 0, speed * Math.Sin(angle)) : new Vector3d(speed * Math.Sin(angle), 0, -speed * Math.Cos(angle));
            BallState state = simulator.Launch(new Vector3d(0, 0.11, 0), velocity, Vector3d.Cross(Vector3d.Up, velocity) / 0.11);
            var path = new Trajectory();
            simulator.LookAhead(in state, new LookAheadRequest { Duration = 2, StopAt = StopAt.Time }, path);
            Assert.True(path.IsComplete && path.Pieces.Length <= 512, $"{path.Pieces.Length} pieces");
            for (int i = 0; i < 120; i++)
            {
                var log = new StepLog();
                before(state.Time);
                simulator.Step(ref state, Frame, log);
                Assert.InRange(log.Steps, 0, 250);
                Assert.InRange(Vector3d.Distance(state.Position, path.PositionAt(Math.Min(state.Time, path.EndTime))), 0, tolerance);
            }
        }
    }

    /// <summary>The ground and a pipe act as the pipe with a level part of its own, of the same material.</summary>
    [Theory]
    [InlineData(1.2, 1.5)]
    [InlineData(1.2, 4)]
    [InlineData(0.4, 2)]
    [InlineData(3, 9)]
    public void The_path_is_that_of_one_shape(double radius, double speed)
    {
        var ends = new List<Vector3d>();
        foreach (bool own in new[] { false, true })
        {
            var ground = new Ground { Height = 0, Material = SurfaceMaterial.MatchTurf };
            var scene = new Scene
            {
                Ground = own ? Ground.None with { Aerodynamics = ground.Aerodynamics } : ground,
                Obstacles = [new Obstacle { Name = "pipe", Shape = new QuarterPipe(radius, 1, alongX: false) { HasFlat = own }, Surface = SurfaceMaterial.MatchTurf }],
            };
            var simulator = new Simulator(scene);
            BallState state = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(0, 0, -speed), new Vector3d(-speed / 0.11, 0, 0));
            for (int i = 0; i < 90; i++)
            {
                simulator.Step(ref state, Frame, new StepLog());
                ends.Add(state.Position);
            }
        }

        for (int i = 0; i < 90; i++)
        {
            Assert.InRange(Vector3d.Distance(ends[i], ends[90 + i]), 0, 0.01);
        }
    }

    /// <summary>Without air and friction, the ball swings in the pipe as s'' = −g sin θ, and its energy stays.</summary>
    [Theory]
    [InlineData(1.2, 2)]
    [InlineData(0.5, 1.5)]
    [InlineData(4, 5)]
    public void A_ball_without_friction_obeys_the_pendulum(double radius, double speed)
    {
        SurfaceMaterial ice = SurfaceMaterial.Wood with { SlidingFriction = 0, ImpactFriction = 0, RollingResistance = 0, RollingResistancePerSpeed = 0, TorsionalPatchRadius = 0, SpinDamping = 0 };
        var scene = new Scene
        {
            Air = new Air { Density = 0 },
            Ground = Ground.Of(ice),
            Obstacles = [new Obstacle { Shape = new QuarterPipe(radius, 0.5, alongX: false), Surface = ice }],
        };
        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(0, 0, -speed), Vector3d.Zero);

        // The pendulum by small steps, with the length R − r, from the foot of the pipe until the ball is back there.
        double length = radius - 0.11;
        double theta = 0;
        double rate = speed / length;
        double foot = 0.5 / speed;
        double time = foot;
        const double Small = 1e-5;
        int compared = 0;
        for (int i = 0; i < 60; i++)
        {
            simulator.Step(ref state, Frame, new StepLog());
            for (; time + Small <= state.Time && theta >= 0; time += Small)
            {
                rate -= 9.81 / length * Math.Sin(theta) * Small;
                theta += rate * Small;
            }

            if (state.Time > foot && theta > 0)
            {
                compared++;
                Assert.InRange(Math.Abs(state.Position.Z + 0.5 + (length * Math.Sin(theta))), 0, 1e-3);
                Assert.InRange(Math.Abs(state.Position.Y - 0.11 - (length * (1 - Math.Cos(theta)))), 0, 1e-3);
            }

            Assert.Equal(0.5 * speed * speed, (0.5 * state.Velocity.LengthSquared) + (9.81 * (state.Position.Y - 0.11)), 1e-5);
        }

        Assert.InRange(compared, 10, 60);
    }

    /// <summary>A ball that rolls along the foot of a pipe on the ground, and one that circles in a bowl, do not search for thousands of contacts.</summary>
    [Fact]
    public void A_roll_along_the_foot_asks_the_shape_seldom()
    {
        var pipe = new QuarterPipe(0.3, 0, alongX: false) { HasFlat = true };
        Simulator simulator = Scene(pipe, Made.Obstacle, SurfaceMaterial.MatchTurf, out _);
        BallState state = simulator.Launch(new Vector3d(0, 0.11, 0.002), new Vector3d(18, 0, 0), new Vector3d(0, 0, -18 / 0.11));
        for (int i = 0; i < 60; i++)
        {
            int calls = pipe.Calls;
            simulator.Step(ref state, Frame, new StepLog());
            Assert.InRange(pipe.Calls - calls, 0, 8000);
        }
    }

    private static Simulator Scene(IShape shape, Made made, SurfaceMaterial turf, out Action<double> before)
    {
        var scene = new Scene { Ground = Ground.Of(turf) };
        before = _ => { };
        if (made == Made.Obstacle)
        {
            return new Simulator(scene with { Obstacles = [new Obstacle { Name = "pipe", Shape = shape, Surface = SurfaceMaterial.Wood }] });
        }

        if (made == Made.Body)
        {
            var bodies = new KinematicBodies();
            KinematicBody body = bodies.Add("pipe", shape, SurfaceMaterial.Wood);
            before = time => body.MoveTo(Vector3d.Zero, Vector3d.Zero, time);
            before(0);
            return new Simulator(scene with { Bodies = bodies });
        }

        var engine = new ShapesAsEngine();
        engine.Add("pipe", shape);
        return new Simulator(scene with { EngineColliders = engine });
    }

    /// <summary>A quarter pipe that rises at a distance before the origin, and ends in an upright wall.</summary>
    private sealed class QuarterPipe(double radius, double foot, bool alongX) : IShape
    {
        public int Calls { get; private set; }

        public bool HasFlat { get; init; }

        public double MaximumConcaveCurvature => 1 / radius;

        public Bounds3d Bounds => HasFlat ? Bounds3d.Everywhere : alongX ? new Bounds3d(new Vector3d(foot, -1e6, -1e6), new Vector3d(1e6, 1e6, 1e6)) : new Bounds3d(new Vector3d(-1e6, -1e6, -1e6), new Vector3d(1e6, 1e6, -foot));

        public ShapePoint At(in Vector3d point)
        {
            Calls++;
            Vector3d ahead = alongX ? new Vector3d(1, 0, 0) : new Vector3d(0, 0, -1);
            double along = Vector3d.Dot(in point, in ahead) - foot;
            double below = radius - point.Y;
            if (along <= 0 && (below > 0 || point.Y < radius - along))
            {
                return new ShapePoint(point.Y, Vector3d.Up, default);
            }

            if (below <= 0)
            {
                return new ShapePoint(radius - along, -ahead, default);
            }

            double distance = Math.Max(Math.Sqrt((along * along) + (below * below)), 1e-12);
            Vector3d normal = ((below * Vector3d.Up) - (along * ahead)) / distance;
            return new ShapePoint(radius - distance, normal, -1.0 * SymmetricMatrix3d.AroundAxis(normal, Vector3d.Cross(Vector3d.Up, in ahead), distance));
        }
    }
}
