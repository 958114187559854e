namespace FootballPhysics.Tests.Things;

/// <summary>A ball in the ground is raised straight up, to the least height at which it is not in the ground, by every member that takes a position.</summary>
public sealed class RaisedTests
{
    private static readonly Scene s_hill = new() { Ground = new Ground { Heights = Hill() } };

    /// <summary>A hill of 3 m at the origin, of people.ndjson, F13.</summary>
    private static HeightField Hill()
    {
        var heights = new double[41, 41];
        for (int i = 0; i <= 40; i++)
        {
            for (int j = 0; j <= 40; j++)
            {
                double x = -20 + i;
                double z = -20 + j;
                heights[i, j] = 3 * Math.Exp(-((x * x) + (z * z)) / 50);
            }
        }

        return HeightField.FromControlValues(-20, -20, 1, heights);
    }

    [Theory]
    [InlineData(3, 2.5933)]
    [InlineData(1, 3.0134)]
    public void On_a_hill_x_and_z_stay(double x, double y)
    {
        var ball = new Ball(s_hill);
        ball.Place(new Vector3d(x, 0, 0));
        Assert.Equal((x, 0.0), (ball.Position.X, ball.Position.Z));
        Assert.Equal(y, ball.Position.Y, 1e-4);
    }

    [Fact]
    public void The_height_of_the_ground_raises_its_hills()
    {
        var low = new Simulator(s_hill);
        var high = new Simulator(s_hill with { Ground = s_hill.Ground with { Height = 2.5 } });
        foreach (double x in new[] { 0, 1.3, -6, 19 })
        {
            double lifted = high.Launch(new Vector3d(x, -9, 2), Vector3d.Zero, Vector3d.Zero).Position.Y;
            Assert.Equal(low.Launch(new Vector3d(x, -9, 2), Vector3d.Zero, Vector3d.Zero).Position.Y + 2.5, lifted, 1e-9);
        }

        Assert.Equal(Hill().Bounds.Max.Y + 2.5, Hill().Raised(2.5).Bounds.Max.Y, 1e-12);
    }

    [Fact]
    public void Wherever_it_is_put_the_height_is_the_least_one()
    {
        var simulator = new Simulator(s_hill);
        var shape = Hill();
        var random = new Random(13);
        int raised = 0;
        for (int i = 0; i < 2000; i++)
        {
            // From far below to just above; half of them touch the ground with a part of the ball.
            double x = (30 * random.NextDouble()) - 15;
            double z = (30 * random.NextDouble()) - 15;
            double surface = shape.HeightAt(x, z);
            double y = i % 2 == 0 ? surface - (1e4 * Math.Pow(random.NextDouble(), 9)) : surface + (0.2 * random.NextDouble());
            var from = new Vector3d(x, y, z);
            Vector3d at = simulator.Launch(from, new Vector3d(0, 30, 0), default).Position;
            double gap = shape.At(at).Distance - 0.11;
            Assert.Equal((x, z), (at.X, at.Z));
            if (at == from)
            {
                Assert.InRange(gap, -5e-10, 1);
                continue;
            }

            // It touches; a little lower it is in the ground.
            raised++;
            Assert.InRange(gap, -1e-13, 1e-13);
            Assert.InRange(shape.At(at - new Vector3d(0, 1e-6, 0)).Distance - 0.11, -1e-6, -0.7e-6);
        }

        Assert.InRange(raised, 1200, 1800);
    }

    [Theory]
    [InlineData(0.3, 1, 0)]
    [InlineData(-2, 1, 1.5)]
    [InlineData(0, 0.05, 1)]
    public void On_a_tilted_plane_it_is_raised_by_r_over_the_cosine(double nx, double ny, double nz)
    {
        Vector3d normal = new Vector3d(nx, ny, nz).Normalized();
        var simulator = new Simulator(new Scene { Ground = new Ground { Material = SurfaceMaterial.DryTurf, Normal = normal, Height = 0.7 } });
        foreach ((double x, double z) in ((double, double)[])[(0, 0), (4, -7), (-30, 11)])
        {
            double y = 0.7 - (((normal.X * x) + (normal.Z * z)) / normal.Y) + (0.11 / normal.Y);
            BallState ball = simulator.Launch(new Vector3d(x, y - 5, z), new Vector3d(0, 9, 0), default);
            Assert.Equal((x, z), (ball.Position.X, ball.Position.Z));
            Assert.Equal(y, ball.Position.Y, 1e-12 * (1 + Math.Abs(y)));

            // Above the ground nothing is moved.
            var above = new Vector3d(x, y + 1e-6, z);
            Assert.Equal(above, simulator.Launch(above, new Vector3d(0, 9, 0), default).Position);
        }
    }

    [Fact]
    public void A_kick_a_runner_and_a_batch_raise_it_as_a_launch_does()
    {
        var simulator = new Simulator(s_hill);
        var low = new Vector3d(3, 0, 0);
        var kick = new Vector3d(1, 12, -3);
        Vector3d expected = simulator.Launch(low, kick, default).Position;
        var level = new Ball();
        level.Place(low);
        BallState kicked = level.State;
        simulator.Kick(ref kicked, kick, default);
        Assert.Equal(expected.Y, kicked.Position.Y, 1e-12);
        Assert.Equal((3.0, 0.0), (kicked.Position.X, kicked.Position.Z));

        var runner = new FixedStepRunner(simulator);
        runner.Place(low);
        Assert.Equal(expected, runner.State.Position);

        // A new ball lies on top of the hill, not at the height that the field is measured from.
        Assert.Equal((MotionState.Rest, 0.0, 0.0), (new Ball(simulator).Motion, new Ball(simulator).Position.X, new Ball(simulator).Position.Z));

        var launches = new BatchLaunches(1);
        launches.Set(0, low, kick, default);
        var flights = new BatchFlights(1);
        new BallBatch(s_hill).Fly(launches, flights, 1, duration: 0.5);
        var path = new Trajectory();
        simulator.LookAhead(simulator.Launch(low, kick, default), new LookAheadRequest { Duration = 0.5 }, path);
        Assert.InRange((path.PositionAt(0.5) - flights.Position[0]).Length, 0, 1e-6);
    }

    [Fact]
    public void An_aim_raises_kick_and_target_in_the_same_way()
    {
        var simulator = new Simulator(s_hill);
        var aimer = new Aimer(simulator);
        var request = new AimRequest { From = new Vector3d(3, 0, 0), Target = new Vector3d(1, 0, -12), Speed = 16, MaximumElevationDegrees = 70 };
        AimResult low = aimer.Find(request);
        AimResult high = aimer.Find(request with
        {
            From = simulator.Launch(request.From, new Vector3d(0, 9, 0), default).Position,
            Target = simulator.Launch(request.Target, new Vector3d(0, 9, 0), default).Position,
        });
        Assert.Equal((high.Velocity, high.Status), (low.Velocity, low.Status));
    }

    [Fact]
    public void A_new_ball_lies_in_the_hollow_at_the_origin()
    {
        var heights = new double[21, 21];
        for (int i = 0; i <= 20; i++)
        {
            for (int j = 0; j <= 20; j++)
            {
                heights[i, j] = -2 * Math.Exp(-(((i - 10) * (i - 10)) + ((j - 10) * (j - 10))) / 18.0);
            }
        }

        var ball = new Ball(new Scene { Ground = new Ground { Heights = HeightField.FromControlValues(-10, -10, 1, heights) } });
        Assert.Equal((MotionState.Rest, 0.0, 0.0), (ball.Motion, ball.Position.X, ball.Position.Z));
        Assert.InRange(ball.Position.Y, -1.9, -1.5);

        // Several, each on the ground below it.
        var runner = new FixedStepRunner(new BallGroup(new Simulator(new Scene { Ground = new Ground { Material = SurfaceMaterial.DryTurf, Normal = new Vector3d(0.2, 1, 0).Normalized() } }), 3));
        Assert.All(Enumerable.Range(0, 3), i => Assert.NotEqual(MotionState.Airborne, runner.StateOf(i).Motion));
    }
}
