using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Predictors;

/// <summary>What a path passes is found, and a look-ahead does not end before it.</summary>
public sealed class PassingTests
{
    [Fact]
    public void A_plane_that_is_crossed_twice_within_a_piece_is_crossed()
    {
        var random = new Shots(31);
        var simulator = new Simulator(Scene.Published);
        var path = new Trajectory();
        int twice = 0;
        for (int i = 0; i < 1000; i++)
        {
            BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), random.Uniform(8, 25) * (random.Direction().Horizontal + new Vector3d(0, random.Uniform(0.3, 1.5), 0)), default);
            simulator.LookAhead(in ball, new LookAheadRequest { StopAt = StopAt.Impact }, path);
            double height = path.Apex - random.Uniform(1e-4, 0.01);
            Assert.True(path.TryGetCrossing(new Plane3d(new Vector3d(0, height, 0), Vector3d.Up), out PathPoint crossing), $"{i}: {height} below {path.Apex}");
            Assert.Equal(height, crossing.Position.Y, 1e-9);
            Assert.True(crossing.Velocity.Y >= 0);
            twice++;
        }

        Assert.Equal(1000, twice);
    }

    [Fact]
    public void Until_passing_does_not_end_before_the_closest_approach()
    {
        var random = new Shots(32);
        var simulator = new Simulator(Scene.Published);
        var whole = new Trajectory(2048);
        var until = new Trajectory(2048);
        int shorter = 0;
        for (int i = 0; i < 500; i++)
        {
            Vector3d direction = random.Direction().Horizontal;
            BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), random.Uniform(8, 25) * (direction + new Vector3d(0, random.Uniform(0.1, 2), 0)), random.Uniform(0, 20) * random.Direction());
            simulator.LookAhead(in ball, new LookAheadRequest { StopAt = StopAt.Impact, Duration = 20 }, whole);
            Vector3d point = i % 2 == 0 ? whole.Final.Position : whole.PositionAt(random.Uniform(0, whole.EndTime)) + (random.Uniform(0, 1) * random.Direction());
            simulator.LookAhead(in ball, new LookAheadRequest { StopAt = StopAt.Impact, Duration = 20, UntilPassing = point }, until);
            Assert.Equal(whole.ClosestApproach(point).Distance, until.ClosestApproach(point).Distance, 1e-6);
            shorter += until.EndTime < whole.EndTime ? 1 : 0;
        }

        Assert.InRange(shorter, 50, 500);
    }

    /// <summary>Along the ground, backspin turns the ball back: v = (v₀ − α r ω)/(1 + α). In wind, a slow ball turns back too.</summary>
    [Theory]
    [InlineData(2, 150, 0, -1)]
    [InlineData(2, 150, 0, -3)]
    [InlineData(1, 0, -15, -1)]
    public void Until_passing_goes_on_if_the_ball_turns_back(double speed, double backspin, double wind, double behind)
    {
        Scene scene = Scene.Measured;
        var simulator = new Simulator(scene with { Air = scene.Air with { Wind = new Vector3d(wind, 0, 0) } });
        BallState ball = simulator.Launch(simulator.OnGround(0, 0), new Vector3d(speed, wind == 0 ? 0 : 4, 0), new Vector3d(0, 0, backspin));
        var point = new Vector3d(behind, 0.11, 0);
        var whole = new Trajectory(2048);
        var until = new Trajectory(2048);
        simulator.LookAhead(in ball, new LookAheadRequest { StopAt = StopAt.Rest }, whole);
        simulator.LookAhead(in ball, new LookAheadRequest { StopAt = StopAt.Rest, UntilPassing = point }, until);
        Assert.InRange(whole.ClosestApproach(point).Distance, 0, 0.5 * -behind);
        Assert.Equal(whole.ClosestApproach(point).Distance, until.ClosestApproach(point).Distance, 1e-6);
    }

    /// <summary>Without drag and weight, sidespin takes the ball round in a circle, and back past a point behind its start.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(40)]
    public void Until_passing_goes_on_if_the_ball_flies_in_a_circle(double clock)
    {
        const double Speed = 10;
        const double Behind = 0.5;
        Simulator simulator = Circling(gravity: 0, Ground.None, 10, out double turn);
        BallState ball = simulator.Launch(new Vector3d(0, 1, 0), new Vector3d(0, 0, -Speed), new Vector3d(0, 10, 0));
        ball.Time = clock;
        var point = new Vector3d(0, 1, Behind);
        var path = new Trajectory(4096);
        simulator.LookAhead(in ball, new LookAheadRequest { Duration = 1.1 * 2 * Math.PI / turn, UntilPassing = point }, path);
        double radius = Speed / turn;
        Assert.Equal(Math.Sqrt((radius * radius) + (Behind * Behind)) - radius, path.ClosestApproach(point).Distance, 1e-5);
    }

    /// <summary>A ball on a springy ground without friction hops in a wide circle, and comes back after the first hops.</summary>
    [Fact]
    public void Until_passing_goes_on_if_the_ball_hops_in_a_circle()
    {
        Ground springy = Ground.PublishedTurf with
        {
            Material = SurfaceMaterial.PublishedTurf with { NormalRestitution = 0.98, ImpactFriction = 0, SlidingFriction = 0, SpinDamping = 0, SpinRestitution = 1 },
        };
        Simulator simulator = Circling(gravity: 9.81, springy, 0.86, out double turn);
        BallState ball = simulator.Launch(simulator.OnGround(0, 0), new Vector3d(0, 8, -10), new Vector3d(0, 0.86, 0));
        Vector3d point = ball.Position + new Vector3d(0, 0, 6);
        var request = new LookAheadRequest { Duration = 1.1 * 2 * Math.PI / turn, StopAt = StopAt.Rest };
        var whole = new Trajectory(8192);
        var until = new Trajectory(8192);
        simulator.LookAhead(in ball, request, whole);
        simulator.LookAhead(in ball, request with { UntilPassing = point }, until);
        Assert.InRange(whole.ClosestApproach(point).Distance, 0, 4);
        Assert.Equal(whole.ClosestApproach(point).Distance, until.ClosestApproach(point).Distance, 1e-6);
    }

    /// <summary>In still air, a spin that would need the whole look-ahead to turn the ball back cannot do so in the few seconds up to its last hop.</summary>
    [Fact]
    public void Until_passing_ends_soon_after_a_ball_that_bounces_on()
    {
        Simulator simulator = Circling(gravity: 9.81, Ground.PublishedTurf, 0.86, out double turn);
        Assert.InRange(turn, 0.08, 0.12);
        BallState ball = simulator.Launch(simulator.OnGround(0, 0), new Vector3d(0, 3, -20), new Vector3d(0, 0.86, 0));
        var path = new Trajectory(4096);
        simulator.LookAhead(in ball, new LookAheadRequest { Duration = 30, UntilPassing = new Vector3d(0.3, 0.5, -5) }, path);
        Assert.InRange(path.EndTime, 0.25, 0.5);
    }

    /// <summary>Only gravity and a constant Magnus coefficient act. The velocity turns at C π ρ r³ ω/m about the vertical.</summary>
    private static Simulator Circling(double gravity, Ground ground, double spin, out double turn)
    {
        const double Coefficient = 10;
        Scene scene = Scene.Vacuum with
        {
            Gravity = gravity,
            Ground = ground,
            Forces = ForceSet.None with { Magnus = ForceLaw.Constant, MagnusCoefficient = Coefficient },
        };
        turn = Coefficient * Math.PI * scene.Air.Density * Math.Pow(scene.Ball.Radius, 3) * spin / scene.Ball.Mass;
        return new Simulator(scene);
    }

    [Fact]
    public void Memory_that_fits_exactly_is_complete()
    {
        var simulator = new Simulator(Scene.Published);
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(3, 6, -15), new Vector3d(0, 20, 0));
        var request = new LookAheadRequest { StopAt = StopAt.Rest, Duration = 60 };
        var path = new Trajectory(4096);
        simulator.LookAhead(in ball, request, path);
        var exact = new Trajectory(new PathSegment[path.Pieces.Length]);
        simulator.LookAhead(in ball, request, exact);
        Assert.True(exact.IsComplete && exact.TryGetRest(out _));
        Assert.Equal(path.Events.Count, exact.Events.Count);
        var small = new Trajectory(new PathSegment[path.Pieces.Length - 1]);
        simulator.LookAhead(in ball, request, small);
        Assert.False(small.IsComplete);
        Assert.Equal(small.Pieces.Length, path.Pieces.Length - 1);
        Assert.Equal(small.Final.Time, small.Pieces[^1].EndTime, 1e-12);
    }

    [Theory]
    [InlineData(15, 0)]
    [InlineData(0, 500)]
    public void Stiff_forces_do_not_diverge_at_the_default_step(double damping, double stiffness)
    {
        IForce net = IForce.From(ball => (-damping * ball.Velocity) - (stiffness * new Vector3d(0, 0, Math.Min(0, ball.Position.Z + 11))));
        var simulator = new Simulator(Scene.Published with { Forces = ForceSet.Published with { CustomForces = [net] } });
        BallState ball = simulator.Launch(new Vector3d(0, 1.5, 0), new Vector3d(1, 3, -20), default);
        var path = new Trajectory(16384);
        simulator.LookAhead(in ball, new LookAheadRequest { Duration = 1.5, StopAt = StopAt.Impact }, path);
        var fine = new Trajectory(65536);
        simulator.LookAhead(in ball, new LookAheadRequest { Duration = 1.5, StopAt = StopAt.Impact, TimeStep = 1e-4 }, fine);
        for (double time = 0; time < 1; time += 0.05)
        {
            Assert.True(Vector3d.Distance(path.PositionAt(time), fine.PositionAt(time)) < 1e-2, $"{time}: {path.PositionAt(time)}, {fine.PositionAt(time)}");
        }
    }

    [Fact]
    public void A_time_that_is_no_number_is_refused()
    {
        var simulator = new Simulator(Scene.Published);
        BallState ball = simulator.Launch(new Vector3d(0, 1, 0), new Vector3d(1, 3, -20), default);
        var path = new Trajectory();
        simulator.LookAhead(in ball, new LookAheadRequest(), path);
        Assert.Throws<ArgumentOutOfRangeException>(() => path.PositionAt(double.NaN));
        Assert.Throws<ArgumentOutOfRangeException>(() => path.VelocityAt(double.NaN));
    }
}
