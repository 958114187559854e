using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Game;

/// <summary>Searches for touches whose result is known: a touch that was simulated first, a slow foot, and requests without a solution.</summary>
public sealed class TouchSearchTests
{
    private static readonly Simulator s_simulator = new();

    /// <summary>A kick with backspin is simulated; a touch must then be found that has the same position and speed at the end.</summary>
    [Fact]
    public void A_dribble_finds_the_speed_that_needs_spin()
    {
        var random = new Shots(61);
        var touches = new Touches(foot: new Foot(), spread: new TouchSpread { Draws = 0 });
        for (int i = 0; i < 30; i++)
        {
            BallState ball = s_simulator.Launch(new Vector3d(random.Uniform(-1, 1), 0, random.Uniform(-1, 1)), Vector3d.Zero, Vector3d.Zero);
            Vector3d direction = random.Direction().Horizontal;
            direction /= direction.Length;
            Vector3d velocity = random.Uniform(7, 14) * direction;
            Vector3d rolling = Vector3d.Cross(Vector3d.Up, velocity) / s_simulator.Scene.Ball.Radius;
            Vector3d spin = rolling - (random.Uniform(50, 115) / rolling.Length * rolling);
            double duration = random.Uniform(0.4, 0.8);
            BallState end = ball;
            s_simulator.Kick(ref end, velocity, spin);
            s_simulator.Run(ref end, 0.01, duration, StopAt.Time, new StepLog());
            double speed = end.Velocity.Horizontal.Length;

            // With the rolling spin alone, the ball would be faster at the same position.
            BallState rolls = ball;
            s_simulator.Kick(ref rolls, velocity, rolling);
            s_simulator.Run(ref rolls, 0.01, duration, StopAt.Time, new StepLog());
            Assert.True(rolls.Velocity.Horizontal.Length > speed + 0.3);
            var request = new DribbleRequest
            {
                Position = end.Position - (((speed * duration) + 0.6) * direction),
                Direction = 2 * direction,
                RunSpeed = speed,
                Duration = duration,
            };
            Touch touch = touches.Dribble(in ball, request);
            Assert.True(touch.Succeeds);
            Assert.InRange(touch.SpeedError, 0, 0.02);
            Assert.InRange(touch.Miss, 0, 0.01);
            Assert.InRange(Vector3d.Distance(touch.Velocity, velocity), 0, 0.5);
        }
    }

    [Fact]
    public void A_dribble_at_the_speed_of_a_rolling_ball_makes_it_roll()
    {
        var random = new Shots(62);
        var touches = new Touches(foot: new Foot { Friction = 2 }, spread: new TouchSpread { Draws = 0 });
        for (int i = 0; i < 20; i++)
        {
            BallState ball = s_simulator.Launch(new Vector3d(random.Uniform(-1, 1), 0, random.Uniform(-1, 1)), Vector3d.Zero, Vector3d.Zero);
            Vector3d direction = random.Direction().Horizontal;
            direction /= direction.Length;
            BallState end = ball;
            Vector3d velocity = random.Uniform(3, 8) * direction;
            Vector3d rolling = Vector3d.Cross(Vector3d.Up, velocity) / s_simulator.Scene.Ball.Radius;
            s_simulator.Kick(ref end, velocity, rolling);
            s_simulator.Run(ref end, 0.01, 0.5, StopAt.Time, new StepLog());
            double speed = end.Velocity.Length;
            Touch touch = touches.Dribble(in ball, new DribbleRequest { Position = end.Position - (((speed * 0.5) + 0.6) * direction), Direction = direction, RunSpeed = speed });
            Assert.InRange(touch.SpeedError, 0, 0.01);
            Assert.InRange(Vector3d.Distance(touch.Velocity, velocity), 0, 1e-3);
            Assert.InRange(Vector3d.Distance(touch.Spin, rolling), 0, 1e-2);
        }
    }

    /// <summary>The search for one touch leaves nothing behind for the next.</summary>
    [Fact]
    public void A_touch_does_not_depend_on_the_touches_before()
    {
        var random = new Shots(63);
        var used = new Touches(spread: new TouchSpread { Draws = 3 });
        for (int i = 0; i < 60; i++)
        {
            BallState ball = s_simulator.Launch(
                new Vector3d(0, random.Uniform(0.11, 1), 0), random.Uniform(0, 12) * random.Direction(), random.Uniform(0, 30) * random.Direction());
            var dribble = new DribbleRequest { Direction = random.Direction(), RunSpeed = random.Uniform(1, 9), Lead = random.Uniform(0, 3) };
            var trap = new TrapRequest { Velocity = random.Uniform(0, 6) * random.Direction() };
            var shot = new FirstTimeRequest { Target = new Vector3d(random.Uniform(-5, 5), random.Uniform(0, 4), -16), Speed = random.Uniform(10, 35), MaximumElevationDegrees = 30 };
            var fresh = new Touches(spread: new TouchSpread { Draws = 3 });
            Touch expected = (i % 3) switch { 0 => fresh.Dribble(in ball, dribble), 1 => fresh.Trap(in ball, trap), _ => fresh.FirstTimeShot(in ball, shot) };
            Touch touch = (i % 3) switch { 0 => used.Dribble(in ball, dribble), 1 => used.Trap(in ball, trap), _ => used.FirstTimeShot(in ball, shot) };
            Assert.Equal(expected, touch);
        }
    }

    /// <summary>For a ball at rest, the fastest kick of a foot is (1 + e)/(1 + m/M) times the foot's speed.</summary>
    [Fact]
    public void A_slow_foot_shoots_nearly_as_fast_as_it_can_and_hits()
    {
        var random = new Shots(64);
        for (int i = 0; i < 25; i++)
        {
            var foot = new Foot { MaximumSpeed = random.Uniform(8, 14) };
            var touches = new Touches(foot: foot, spread: new TouchSpread { Draws = 0 });
            BallState ball = s_simulator.Launch(Vector3d.Zero, Vector3d.Zero, Vector3d.Zero);
            var request = new FirstTimeRequest { Target = new Vector3d(random.Uniform(-4, 4), random.Uniform(0.2, 0.8), -9), Speed = random.Uniform(20, 40) };
            Touch touch = touches.FirstTimeShot(in ball, request);
            double fastest = (1 + foot.Restitution) / (1 + (s_simulator.Scene.Ball.Mass / foot.Mass)) * foot.MaximumSpeed;
            Assert.Equal(TouchStatus.Done, touch.Status);
            Assert.InRange(touch.Velocity.Length, 0.94 * fastest, fastest);
            Assert.True(touch.Strike.FastEnough);
        }
    }

    [Fact]
    public void A_touch_without_a_solution_names_the_reason()
    {
        BallState ball = s_simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(0, 0, 20), Vector3d.Zero);
        var slow = new Touches(foot: new Foot { MaximumSpeed = 1 });
        var fast = new Touches(foot: new Foot());
        var dribble = new DribbleRequest { RunSpeed = 15, Duration = 0.2, Lead = 10 };
        Assert.Equal((TouchStatus.FootTooSlow, TouchStatus.OutOfReach), (slow.Dribble(in ball, dribble).Status, fast.Dribble(in ball, dribble).Status));
        Assert.Equal((TouchStatus.FootTooSlow, TouchStatus.OutOfReach), (slow.Trap(in ball, new TrapRequest { Velocity = new Vector3d(0, 0, -5) }).Status, fast.Trap(in ball, new TrapRequest { Velocity = new Vector3d(1, 0, -5), Tolerance = 1e-15 }).Status));
        var shot = new FirstTimeRequest { Target = new Vector3d(0, 5, -10), MaximumElevationDegrees = 5 };
        BallState resting = s_simulator.Launch(Vector3d.Zero, Vector3d.Zero, Vector3d.Zero);
        var slowest = new Touches(foot: new Foot { MaximumSpeed = 0.1 });
        Assert.Equal((TouchStatus.FootTooSlow, TouchStatus.OutOfReach), (slowest.FirstTimeShot(in resting, shot).Status, fast.FirstTimeShot(in ball, shot).Status));
        Touch none = fast.FirstTimeShot(in ball, shot with { Target = ball.Position + new Vector3d(0.003, 2, 0) });
        Assert.Equal((TouchStatus.Degenerate, 0.0, ball.Position, ball.Velocity), (none.Status, none.Time, none.Position, none.BallVelocity));
        Assert.Equal(2, none.Miss, 1e-5);
    }

    /// <summary>The axes about which errors turn a foot exist in every direction.</summary>
    [Fact]
    public void The_chance_is_a_number_for_a_foot_along_each_axis()
    {
        var touches = new Touches(foot: new Foot { Friction = 0 });
        foreach (Vector3d velocity in new[] { new Vector3d(8, 0, 0), new Vector3d(0, -8, 0), new Vector3d(0, 0, 8) })
        {
            BallState ball = s_simulator.Launch(new Vector3d(0, 0.5, 0), velocity, Vector3d.Zero);
            Assert.InRange(touches.Trap(in ball, new TrapRequest { SuccessSpeed = 3 }).Chance, 0.5, 1);
        }
    }

    [Fact]
    public void Every_number_out_of_range_is_refused_by_name()
    {
        BallState ball = s_simulator.Launch(default, default, default);
        var touches = new Touches();
        foreach ((string name, DribbleRequest request) in new (string, DribbleRequest)[]
        {
            ("dribble.position", new() { Position = new Vector3d(2e6, 0, 0) }),
            ("dribble.direction", new() { Direction = default }),
            ("dribble.runSpeed", new() { RunSpeed = -1 }),
            ("dribble.duration", new() { Duration = 0.04 }),
            ("dribble.lead", new() { Lead = 11 }),
            ("dribble.tolerance", new() { Tolerance = 0 }),
            ("dribble.successRadius", new() { SuccessRadius = 0 }),
        })
        {
            Refused(name, () => touches.Dribble(in ball, request));
        }

        foreach ((string name, TrapRequest request) in new (string, TrapRequest)[]
        {
            ("trap.velocity", new() { Velocity = new Vector3d(16, 0, 0) }),
            ("trap.duration", new() { Duration = 6 }),
            ("trap.tolerance", new() { Tolerance = -1 }),
            ("trap.successSpeed", new() { SuccessSpeed = 0 }),
        })
        {
            Refused(name, () => touches.Trap(in ball, request));
        }

        var shot = new FirstTimeRequest { Target = new Vector3d(0, 1, -10) };
        foreach ((string name, FirstTimeRequest request) in new (string, FirstTimeRequest)[]
        {
            ("firstTime.speed", shot with { Speed = 0.4 }),
            ("firstTime.topSpin", shot with { TopSpin = 201 }),
            ("firstTime.sideSpin", shot with { SideSpin = -201 }),
            ("firstTime.maximumElevationDegrees", shot with { MaximumElevationDegrees = 81 }),
            ("firstTime.tolerance", shot with { Tolerance = 0 }),
            ("firstTime.within", shot with { SuccessRadius = 0 }),
        })
        {
            Refused(name, () => touches.FirstTimeShot(in ball, request));
        }

        foreach ((string name, TouchSpread spread) in new (string, TouchSpread)[]
        {
            ("spread.speedPercent", new() { SpeedPercent = 101 }), ("spread.directionDegrees", new() { DirectionDegrees = 46 }), ("spread.contact", new() { Contact = -0.01 }),
        })
        {
            Refused(name, () => new Touches(spread: spread));
        }

        foreach ((string name, ShieldRequest request) in new (string, ShieldRequest)[]
        {
            ("runner.speed", new() { Player = new Player { Speed = -1 } }),
            ("runner.speed", new() { Opponents = [new Player { Speed = -1 }] }),
            ("shield.opponents", new() { Opponents = new Player[65] }),
            ("shield.maximumDistance", new() { MaximumDistance = 0 }),
            ("shield.bodyRadius", new() { BodyRadius = 1.1 }),
            ("shield.time", new() { Time = double.NaN }),
        })
        {
            Refused(name, () => Touches.Shield(request));
        }

        Assert.Throws<ArgumentNullException>(() => touches.Dribble(in ball, null!));
        Assert.Throws<ArgumentNullException>(() => touches.Trap(in ball, null!));
        Assert.Throws<ArgumentNullException>(() => touches.FirstTimeShot(in ball, null!));
        Assert.Throws<ArgumentNullException>(() => Touches.Shield(null!));
        Assert.Throws<ArgumentException>(() => touches.Dribble(default, new DribbleRequest()));
        Assert.Throws<ArgumentException>(() => touches.FirstTimeShot(default, shot));
    }

    private static void Refused(string name, Action call) => Assert.StartsWith(name, Assert.Throws<ArgumentOutOfRangeException>(call).Message, StringComparison.Ordinal);
}
