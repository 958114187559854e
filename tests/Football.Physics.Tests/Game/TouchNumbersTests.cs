using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Game;

/// <summary>The numbers of touches: each is computed again from a simulation of the touch.</summary>
public sealed class TouchNumbersTests
{
    private static readonly Simulator s_simulator = new();

    [Fact]
    public void The_numbers_of_a_dribble_are_those_of_its_simulation()
    {
        var random = new Shots(51);
        var touches = new Touches(spread: new TouchSpread { Draws = 0 });
        int done = 0;
        for (int i = 0; i < 40; i++)
        {
            BallState ball = Low(random, i % 2 == 0 ? 3 : 8);
            var request = new DribbleRequest { Direction = random.Direction(), RunSpeed = random.Uniform(2, 7), Duration = random.Uniform(0.4, 1) };
            Touch touch = touches.Dribble(in ball, request);
            BallState end = Played(in ball, in touch, request.Duration);
            Assert.Equal(request.Duration, touch.Time);
            Assert.InRange(Vector3d.Distance(end.Position, touch.Position), 0, 1e-3);
            Assert.InRange(Vector3d.Distance(end.Velocity, touch.BallVelocity), 0, 1e-2);
            Vector3d wanted = request.Position + (((request.RunSpeed * request.Duration) + request.Lead) * request.Direction.Horizontal / request.Direction.Horizontal.Length);
            Assert.Equal((touch.Position - wanted).Horizontal.Length, touch.Miss, 1e-9);
            Assert.Equal(Math.Abs(touch.BallVelocity.Horizontal.Length - request.RunSpeed), touch.SpeedError, 1e-9);
            Assert.Equal(touch.Succeeds, touch.Miss <= request.Tolerance);
            Assert.True(double.IsNaN(touch.Chance));
            Assert.Contains($"after {touch.Time:0.###} s", touch.ToString());
            done += touch.Succeeds ? 1 : 0;
        }

        Assert.InRange(done, 30, 40);
    }

    [Fact]
    public void The_numbers_of_a_trap_are_those_of_its_simulation()
    {
        var random = new Shots(52);
        var touches = new Touches(spread: new TouchSpread { Draws = 0 });
        for (int i = 0; i < 40; i++)
        {
            BallState ball = Low(random, 15);
            var request = new TrapRequest { Velocity = i % 3 == 0 ? default : random.Uniform(1, 6) * random.Direction(), Duration = random.Uniform(0.3, 1) };
            Touch touch = touches.Trap(in ball, request);
            BallState end = Played(in ball, in touch, request.Duration);
            Assert.Equal(request.Duration, touch.Time);
            Assert.InRange(Vector3d.Distance(end.Position, touch.Position), 0, 1e-3);
            Assert.InRange(Vector3d.Distance(end.Velocity, touch.BallVelocity), 0, 1e-2);

            // In the player's frame, the ball starts at the point of the touch.
            Vector3d point = ball.Position + (request.Duration * request.Velocity);
            Assert.Equal((touch.Position - point).Horizontal.Length, touch.Miss, 1e-9);
            Assert.Equal((touch.BallVelocity - request.Velocity).Horizontal.Length, touch.SpeedError, 1e-9);
            Assert.Equal(touch.Succeeds, touch.SpeedError <= request.Tolerance);
        }
    }

    /// <summary>In every direction, also behind the player and from any direction of the ball.</summary>
    [Fact]
    public void A_first_time_shot_hits_in_every_direction_within_its_elevation()
    {
        var random = new Shots(53);
        var touches = new Touches(foot: new Foot(), spread: new TouchSpread { Draws = 0 });
        for (int i = 0; i < 36; i++)
        {
            BallState ball = Low(random, 10);
            double azimuth = i * Math.PI / 18;
            var request = new FirstTimeRequest
            {
                Target = ball.Position.Horizontal + new Vector3d(18 * Math.Sin(azimuth), random.Uniform(0.3, 2.4), 18 * Math.Cos(azimuth)),
                Speed = random.Uniform(20, 30),
                SideSpin = random.Uniform(-30, 30),
                TopSpin = random.Uniform(-20, 20),
            };
            Touch touch = touches.FirstTimeShot(in ball, request);
            Assert.Equal(TouchStatus.Done, touch.Status);
            Assert.Equal(request.Speed, touch.Velocity.Length, 1e-9);
            BallState end = Played(in ball, in touch, touch.Time);
            Assert.InRange(Vector3d.Distance(end.Position, touch.Position), 0, 1e-3);
            Assert.InRange(Vector3d.Distance(end.Velocity, touch.BallVelocity), 0, 1e-2);
            Assert.Equal(Vector3d.Distance(touch.Position, request.Target), touch.Miss, 1e-9);
            Assert.InRange(touch.Miss, 0, request.Tolerance);
            Assert.Equal(0, touch.SpeedError);
        }
    }

    /// <summary>Slow shots at a near crossbar need more than the allowed elevation.</summary>
    [Fact]
    public void A_first_time_shot_stays_within_its_elevation_even_if_it_misses()
    {
        var random = new Shots(54);
        var touches = new Touches(foot: new Foot(), spread: new TouchSpread { Draws = 0 });
        int misses = 0;
        for (int i = 0; i < 30; i++)
        {
            BallState ball = Low(random, 5);
            var request = new FirstTimeRequest
            {
                Target = ball.Position + new Vector3d(random.Uniform(-3, 3), random.Uniform(2, 5), random.Uniform(-12, -6)),
                Speed = random.Uniform(12, 20),
                MaximumElevationDegrees = random.Uniform(5, 40),
            };
            Touch touch = touches.FirstTimeShot(in ball, request);
            double elevation = Math.Asin(touch.Velocity.Y / touch.Velocity.Length) * 180 / Math.PI;
            Assert.InRange(elevation, -5 - 1e-9, request.MaximumElevationDegrees + 1e-9);
            Touch free = touches.FirstTimeShot(in ball, request with { MaximumElevationDegrees = 80 });
            misses += free.Succeeds && !touch.Succeeds ? 1 : 0;
        }

        Assert.InRange(misses, 5, 29);
    }

    /// <summary>The same errors from another random generator, about other axes.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void The_chance_is_the_share_of_random_touches_that_succeed(int kind)
    {
        const int Draws = 1500;
        var spread = new TouchSpread { Draws = Draws, SpeedPercent = 8, DirectionDegrees = 4, Contact = 0.01 };
        var touches = new Touches(spread: spread);
        BallState ball = s_simulator.Launch(new Vector3d(1, 0.4, 8), kind == 3 ? new Vector3d(-3, -6, 2) : new Vector3d(-4, 0, 3), new Vector3d(0, 20, 5));
        var dribble = new DribbleRequest { Position = new Vector3d(1, 0, 8), RunSpeed = 5, SuccessRadius = 0.6 };
        var trap = new TrapRequest { SuccessSpeed = 0.25 };
        var shot = new FirstTimeRequest { Target = new Vector3d(0, 1, 0), Speed = 18, SuccessRadius = 0.4 };
        Touch touch = kind == 0 ? touches.Dribble(in ball, dribble) : kind == 2 ? touches.FirstTimeShot(in ball, shot) : touches.Trap(in ball, trap);
        Assert.InRange(touch.Chance, 0.1, 0.9);

        var random = new Shots(55 + kind);
        var path = new Trajectory();
        int good = 0;
        for (int i = 0; i < Draws; i++)
        {
            double turn = spread.DirectionDegrees * Math.PI / 180;
            Vector3d foot = (1 + (spread.SpeedPercent / 100 * Normal(random))) * Turned(touch.Strike.FootVelocity, turn, random);
            Vector3d normal = Turned(touch.Strike.Normal, spread.Contact / s_simulator.Scene.Ball.Radius, random);
            FootStrike strike = touches.Foot.Strike(s_simulator.Scene.Ball, ball.Velocity, ball.Spin, foot, normal);
            BallState end = ball;
            s_simulator.Kick(ref end, strike.Velocity, strike.Spin);
            if (kind == 2)
            {
                s_simulator.LookAhead(in end, new LookAheadRequest { Duration = 3 }, path);
                good += Vector3d.Distance(path.ClosestApproach(shot.Target).Position, shot.Target) <= shot.SuccessRadius ? 1 : 0;
            }
            else
            {
                s_simulator.Run(ref end, 0.01, touch.Time, StopAt.Time, new StepLog());
                Vector3d wanted = dribble.Position + (((dribble.RunSpeed * dribble.Duration) + dribble.Lead) * new Vector3d(0, 0, -1));
                good += (kind == 0 ? (end.Position - wanted).Horizontal.Length <= dribble.SuccessRadius : end.Velocity.Horizontal.Length <= trap.SuccessSpeed) ? 1 : 0;
            }
        }

        double share = (double)good / Draws;
        double deviation = Math.Sqrt(2 * share * (1 - share) / Draws);
        Assert.InRange(touch.Chance, share - (4 * deviation), share + (4 * deviation));
    }

    [Fact]
    public void A_touch_without_errors_always_succeeds()
    {
        var touches = new Touches(spread: new TouchSpread { SpeedPercent = 0, DirectionDegrees = 0, Contact = 0, Draws = 5 });
        BallState ball = s_simulator.Launch(new Vector3d(4, 0.6, 16), new Vector3d(-9, 1, 3), new Vector3d(0, 30, 20));
        Assert.Equal(1, touches.FirstTimeShot(in ball, new FirstTimeRequest { Target = new Vector3d(2, 1.8, 0), Speed = 24 }).Chance);
        Assert.Equal(1, touches.Trap(in ball, new TrapRequest()).Chance);
        Assert.Equal(0, touches.Trap(in ball, new TrapRequest { SuccessSpeed = 1e-9 }).Chance);
    }

    /// <summary>A low ball near the player, which has moved for a while.</summary>
    private static BallState Low(Shots random, double speed)
    {
        BallState ball = s_simulator.Launch(
            new Vector3d(random.Uniform(-0.3, 0.3), random.Uniform(0.11, 0.5), random.Uniform(-0.3, 0.3)), speed * random.Direction(), random.Uniform(0, 20) * random.Direction());
        s_simulator.Step(ref ball, 0.01, new StepLog());
        return ball;
    }

    private static BallState Played(in BallState ball, in Touch touch, double duration)
    {
        BallState state = ball;
        s_simulator.Kick(ref state, touch.Velocity, touch.Spin);
        s_simulator.Run(ref state, 1 / 240.0, duration, StopAt.Time, new StepLog());
        return state;
    }

    private static double Normal(Shots random) => Math.Sqrt(-2 * Math.Log(1 - random.Uniform(0, 1))) * Math.Cos(2 * Math.PI * random.Uniform(0, 1));

    private static Vector3d Turned(Vector3d vector, double angle, Shots random)
    {
        // Two independent normal numbers in a plane: a direction at random, and a length with Rayleigh's distribution.
        Vector3d axis = Vector3d.Cross(vector, random.Direction());
        return vector + (angle * Math.Sqrt(-2 * Math.Log(1 - random.Uniform(0, 1))) * vector.Length / axis.Length * axis);
    }
}
