using FootballPhysics.Contacts;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>A ball on several things at once: closed forms, the order of the scene, rest.</summary>
public sealed class ContactSetTests
{
    private const double Radius = 0.11;

    /// <summary>A ball that rolls beside a board and merely touches it bears on the ground alone.</summary>
    [Theory]
    [ProfileData]
    public void Beside_a_board_it_rests_where_it_rests_on_open_ground(Profile profile)
    {
        Scene open = profile.Scene();
        Scene beside = open with { Obstacles = [Board("board", new Vector3d(0, 0.5, -0.05 - Radius), new Vector3d(200, 0.5, 0.05))] };
        foreach (double speed in new[] { 0.5, 3.0, 12.0 })
        {
            var velocity = new Vector3d(speed, 0, 0);
            var spin = new Vector3d(0, 0, -speed / Radius);
            BallState expected = Flight.Play(open, Flight.With(Integrator.Rk4), 1.0 / 60, 60, StopAt.Rest, new Vector3d(0, Radius, 0), velocity, spin, out _);
            BallState actual = Flight.Play(beside, Flight.With(Integrator.Rk4), 1.0 / 60, 60, StopAt.Rest, new Vector3d(0, Radius, 0), velocity, spin, out _);
            Assert.Equal(MotionState.Rest, actual.Motion);
            Assert.Equal(0, (expected.Position - actual.Position).Length, 1e-6);
        }
    }

    /// <summary>A ball that rolls on the ground and touches a wall is carried by the ground, whichever of the two a state names.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void The_surface_with_the_only_load_takes_the_ball_over(bool moves)
    {
        // A far body that moves leaves no whole steps.
        var bodies = new KinematicBodies();
        KinematicBody body = bodies.Add("far", new SphereShape(default, 0.4));
        body.MoveTo(new Vector3d(0, 20, 30), new Vector3d(0, 0, 0.1), 0);
        Scene scene = Vacuum() with { Bodies = moves ? bodies : null, Obstacles = [new Obstacle { Name = "wall", Shape = new PlaneShape(Vector3d.Zero, new Vector3d(1, 0, 0)), Surface = SurfaceMaterial.Board }] };
        var simulator = new Simulator(scene, Flight.With(Integrator.Rk4));
        BallState onGround = simulator.Launch(new Vector3d(Radius, Radius, 0), new Vector3d(0, 0, 2), new Vector3d(2 / Radius, 0, 0));
        Assert.Equal(MotionState.Rolling, onGround.Motion);
        BallState onWall = onGround;
        onWall.Carrier = 1;
        onWall.Motion = MotionState.Sliding;
        Assert.Equal("wall", simulator.NameOf(1));
        var log = new StepLog();
        for (int i = 0; i < 5; i++)
        {
            simulator.Step(ref onGround, 0.01, log);
            simulator.Step(ref onWall, 0.01, log);
        }

        Assert.Equal(onGround.Carrier, onWall.Carrier);
        Assert.Equal(onGround.Motion, onWall.Motion);
        Assert.InRange(Vector3d.Distance(onGround.Position, onWall.Position), 0, 1e-9);
        Assert.InRange(Vector3d.Distance(onGround.Velocity, onWall.Velocity), 0, 1e-9);
        Assert.DoesNotContain(log.Events.Span.ToArray(), e => e.Kind is BallEventKind.Impact or BallEventKind.ContactEnd);
    }

    /// <summary>Down a straight gutter of two planes at ±β, tilted by θ, without slip: g sin θ/(1 + α/cos² β), ω = v/(r cos β).</summary>
    [Theory]
    [InlineData(20, 5)]
    [InlineData(45, 10)]
    [InlineData(60, 3)]
    public void It_runs_down_a_gutter_as_its_turning_about_both_sides_says(double beta, double theta)
    {
        Scene scene = Vacuum() with { Ground = Ground.None, Obstacles = Gutter(beta, theta, SurfaceMaterial.GoalFrame with { SlidingFriction = 5, RollingResistance = 0, RollingResistancePerSpeed = 0, SpinDamping = 0, TorsionalPatchRadius = 0, NormalRestitution = 0 }) };
        double b = beta * Math.PI / 180;
        double t = theta * Math.PI / 180;
        var simulator = new Simulator(scene, Flight.With(Integrator.Rk4));
        Vector3d start = Radius / Math.Cos(b) * new Vector3d(Math.Sin(t), Math.Cos(t), 0);
        BallState state = simulator.Launch(start, Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        simulator.Run(ref state, 0.01, 1, StopAt.Time, log);
        double acceleration = 9.81 * Math.Sin(t) / (1 + (scene.Ball.InertiaFactor / (Math.Cos(b) * Math.Cos(b))));
        Assert.Equal(acceleration, state.Velocity.Length, 1e-6);
        Assert.Equal(0.5 * acceleration, (state.Position - start).Length, 1e-6);
        Assert.Equal(acceleration / (Radius * Math.Cos(b)), state.Spin.Length, 1e-4);
        Assert.True(log.Events.Count <= 4, Flight.Kinds(log));
    }

    /// <summary>
    /// Pressed by P against a wall while it slides along it on the ground: each contact takes its own friction along its own slip, and turns the ball by it, until
    /// one of them grips. Ground: −μ_g g, wall: −μ_w P/m; the slip at the ground falls at μ_g g (1 + 1/α) + μ_w P/m, at the wall at μ_w P/m (1 + 1/α) + μ_g g.
    /// </summary>
    [Fact]
    public void Pressed_against_a_wall_each_contact_takes_its_own_friction()
    {
        const double Pressing = 6; // P/m, m/s²
        const double GroundFriction = 0.3;
        const double WallFriction = 0.2;
        Scene scene = Vacuum() with
        {
            Ground = Vacuum().Ground with
            {
                Material = Vacuum().Ground.Material with
                {
                    SlidingFriction = GroundFriction,
                    RollingResistance = 0,
                    RollingResistancePerSpeed = 0,
                    SpinDamping = 0,
                    TorsionalPatchRadius = 0,
                },
            },
            Obstacles = [Board("wall", new Vector3d(0, 5, -0.5 - Radius), new Vector3d(200, 5, 0.5)) with { Surface = SurfaceMaterial.GoalFrame with { SlidingFriction = WallFriction, RollingResistance = 0 } }],
            Forces = Vacuum().Forces with { CustomForces = [IForce.From(ball => new Vector3d(0, 0, -Pressing * Vacuum().Ball.Mass))] },
        };
        double alpha = scene.Ball.InertiaFactor;
        double ground = GroundFriction * 9.81;
        double wall = WallFriction * Pressing;
        var simulator = new Simulator(scene, Flight.With(Integrator.Rk4));
        BallState state = simulator.Launch(new Vector3d(0, Radius, 0), new Vector3d(8, 0, 0), Vector3d.Zero);
        var log = new StepLog();
        double until = 0.8 * 8 / Math.Max((ground * (1 + (1 / alpha))) + wall, (wall * (1 + (1 / alpha))) + ground);
        int steps = (int)(until / 0.01);
        simulator.Run(ref state, 0.01, 0.01 * steps, StopAt.Time, log);
        double time = 0.01 * steps;
        Assert.Equal(8 - ((ground + wall) * time), state.Velocity.X, 1e-6);
        Assert.Equal((8 * time) - (0.5 * (ground + wall) * time * time), state.Position.X, 1e-6);
        Assert.Equal(-ground * time / (alpha * Radius), state.Spin.Z, 1e-5);
        Assert.Equal(wall * time / (alpha * Radius), state.Spin.Y, 1e-5);
    }

    /// <summary>The order in which things stand in the scene changes nothing.</summary>
    [Theory]
    [ProfileData]
    public void The_order_of_the_scene_changes_nothing(Profile profile)
    {
        Obstacle[] things =
        [
            Board("end", new Vector3d(0, 0.5, -0.05 - Radius), new Vector3d(3, 0.5, 0.05)),
            Board("side", new Vector3d(1.05 + Radius, 0.5, 0), new Vector3d(0.05, 0.5, 3)),
            new Obstacle { Name = "ramp", Shape = new PlaneShape(new Vector3d(0.4, 0, 0), new Vector3d(-0.3, 1, 0.1).Normalized()) },
            Board("box", new Vector3d(-1.5, 0.05, 0.3), new Vector3d(0.5, 0.05, 0.5)),
        ];
        int[][] orders = [[0, 1, 2, 3], [3, 2, 1, 0], [1, 3, 0, 2], [2, 0, 3, 1]];
        foreach (Vector3d velocity in new[] { new Vector3d(2, 0, -0.1), new Vector3d(5, 0, -1), new Vector3d(-3, 0, -0.5) })
        {
            BallState[] ends =
            [
                .. orders.Select(order => Flight.Play(
                    profile.Scene() with { Obstacles = [.. order.Select(i => things[i])] },
                    Flight.With(Integrator.Rk4), 0.01, 3, StopAt.Time, new Vector3d(0, Radius, 0), velocity, new Vector3d(0, 3, -velocity.X / Radius), out _)),
            ];
            Assert.All(ends, end => Assert.Equal(0, (end.Position - ends[0].Position).Length, 1e-7));
        }
    }

    /// <summary>Its spin presses a ball that flies along a board against that; when it comes down the ground bears it, and names what it does.</summary>
    [Theory]
    [ProfileData]
    public void Whatever_it_came_from_what_bears_most_carries_it(Profile profile)
    {
        Scene scene = profile.Scene() with { Obstacles = [Board("board", new Vector3d(0.05 + Radius, 0.5, 0), new Vector3d(0.05, 0.5, 400))] };
        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(new Vector3d(0, 0.16, 0), new Vector3d(0, 0, -6), new Vector3d(-50, -30, 0));
        var log = new StepLog();
        simulator.Run(ref state, 1.0 / 60, 2, StopAt.Time, log);
        Assert.Contains(log.Events.Span.ToArray(), item => item.Kind == BallEventKind.Slide && simulator.NameOf(item.ColliderIndex) == "board");
        Assert.Equal(0, state.Position.X, 1e-9);
        Assert.Equal(MotionState.Rolling, state.Motion);
        Assert.Equal(0, state.Carrier);
    }

    /// <summary>A ball that leans in a corner, between two boards and the ground, comes to rest there.</summary>
    [Theory]
    [ProfileData]
    public void It_comes_to_rest_in_a_corner(Profile profile)
    {
        Scene scene = profile.Scene() with
        {
            Obstacles =
            [
                Board("end", new Vector3d(0, 0.5, -0.05 - Radius), new Vector3d(3, 0.5, 0.05)),
                Board("side", new Vector3d(1.05 + Radius, 0.5, 0), new Vector3d(0.05, 0.5, 3)),
            ],
        };
        foreach (Vector3d velocity in new[] { new Vector3d(4, 0, -0.5), new Vector3d(9, 1, -4), new Vector3d(1, 3, -1) })
        {
            BallState state = Flight.Play(scene, Flight.With(Integrator.Rk2), 1.0 / 60, 20, StopAt.Rest, new Vector3d(0, Radius, 0), velocity, new Vector3d(5, 20, -9), out StepLog log);
            Assert.Equal(MotionState.Rest, state.Motion);
            Assert.True(log.Events.Count < 100, $"{log.Events.Count} events");
        }
    }

    [Fact]
    public void A_ball_that_touches_more_than_its_carrier_is_found()
    {
        var simulator = new Simulator(Vacuum() with { Obstacles = [new Obstacle { Shape = new PlaneShape(Vector3d.Zero, new Vector3d(1, 0, 0)), Surface = SurfaceMaterial.Board }] });
        World world = simulator.World;
        int ground = Array.IndexOf(world.Colliders, world.Ground);
        BallState beside = simulator.Launch(new Vector3d(Radius, Radius, 0), Vector3d.Zero, Vector3d.Zero);
        BallState alone = simulator.Launch(new Vector3d(3, Radius, 0), Vector3d.Zero, Vector3d.Zero);
        BallState flying = simulator.Launch(new Vector3d(3, 2, 0), Vector3d.Zero, Vector3d.Zero);
        Assert.True(ContactSet.TouchesMore(world, in beside, ground));
        Assert.False(ContactSet.TouchesMore(world, in alone, ground));
        Assert.True(ContactSet.TouchesMore(world, in alone, -1));
        Assert.False(ContactSet.TouchesMore(world, in flying, -1));
    }

    private static Scene Vacuum() => Scene.Default with
    {
        Gravity = 9.81,
        Forces = new ForceSet { Buoyancy = false, Drag = ForceLaw.None, Magnus = ForceLaw.None, SpinDecay = ForceLaw.None },
    };

    private static Obstacle Board(string name, Vector3d center, Vector3d half) => new() { Name = name, Shape = new BoxShape(center, half), Surface = SurfaceMaterial.Board };

    private static Obstacle[] Gutter(double beta, double theta, SurfaceMaterial surface)
    {
        double b = beta * Math.PI / 180;
        double t = theta * Math.PI / 180;
        var up = new Vector3d(Math.Sin(t), Math.Cos(t), 0);
        Vector3d Normal(double side) => ((Math.Cos(b) * up) + (side * Math.Sin(b) * new Vector3d(0, 0, 1))).Normalized();
        return
        [
            new Obstacle { Name = "left", Shape = new PlaneShape(Vector3d.Zero, Normal(1)), Surface = surface },
            new Obstacle { Name = "right", Shape = new PlaneShape(Vector3d.Zero, Normal(-1)), Surface = surface },
        ];
    }
}
