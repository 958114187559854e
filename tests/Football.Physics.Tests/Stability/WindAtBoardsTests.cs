using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Stability;

/// <summary>A steady wind presses balls to boards, and nothing else moves: they come to rest at a bounded cost, and nothing squeezes them.</summary>
public sealed class WindAtBoardsTests
{
    private const double Tick = 1.0 / 60;

    /// <summary>A board, 16 parts, and the pieces that lead there: no step of one ball has needed more than two thirds of this.</summary>
    private const long MostEvaluations = 1600;

    private const double RestsWithin = 10;

    /// <summary>The component of the wind along the board is below the rolling friction, so the ball comes to rest.</summary>
    [Theory]
    [InlineData(0, 0, 8)]
    [InlineData(3, 10, 12)]
    [InlineData(7, 20, 30)]
    [InlineData(10, 5, 40)]
    public void A_ball_at_one_board_comes_to_rest(double speed, double degrees, double mean)
    {
        double angle = degrees * Math.PI / 180;
        var wind = new Vector3d(speed * Math.Sin(angle), 0, -speed * Math.Cos(angle));
        var box = new BoxShape(new Vector3d(0, 0.5, -5.05), new Vector3d(500, 0.5, 0.05));
        var board = new Obstacle { Name = "board", Shape = box, Surface = SurfaceMaterial.Board };
        var simulator = new Simulator(Scene.Default with { Air = new Air { Wind = wind }, Obstacles = [board] });
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, -3.8), new Vector3d(0.4, 0, -2.2), Vector3d.Zero);
        Cost cost = Play(simulator, ref ball);
        Assert.Equal(MotionState.Rest, ball.Motion);
        Assert.InRange(cost.Mean, 0, mean);
        Assert.InRange(cost.Worst, 0, MostEvaluations);
    }

    [Theory]
    [InlineData(1, true)]
    [InlineData(1, false)]
    [InlineData(2, false)]
    [InlineData(3, false)]
    [InlineData(777, false)]
    public void Balls_in_a_corner_come_to_rest_and_are_not_squeezed(int seed, bool isCalm)
    {
        for (int i = 0; i < 12; i++)
        {
            var random = new Shots((100 * seed) + i);
            double speed = random.Uniform(4, 14);
            double angle = random.Uniform(5, 85) * Math.PI / 180;
            Simulator simulator = Cage(isCalm ? Vector3d.Zero : new Vector3d(speed * Math.Cos(angle), 0, speed * Math.Sin(angle)));
            var position = new Vector3d(9.89 - random.Uniform(0, 2), 0.11, 19.89 - random.Uniform(0, 2));
            BallState ball = simulator.Launch(position, new Vector3d(random.Uniform(0, 5), 0, random.Uniform(0, 5)), Vector3d.Zero);
            Cost cost = Play(simulator, ref ball);
            Assert.True(ball.Motion == MotionState.Rest, $"ball {i}, wind of {speed} m/s at {angle} rad: {ball.Motion} at {ball.Position}, {ball.Velocity}");
            Assert.True(cost.Worst <= MostEvaluations, $"ball {i}: {cost.Worst} evaluations in a step");
            Assert.Equal(0, cost.Squeezed);
            Assert.Equal(0, cost.Stalled);
            Assert.InRange(cost.MostEvents, 0, 24);
        }
    }

    [Theory]
    [InlineData(0, 0)]
    [InlineData(8, 0)]
    [InlineData(8, 1)]
    [InlineData(8, 2)]
    [InlineData(8, 3)]
    public void Balls_of_a_group_in_a_corner_come_to_rest_and_nothing_happens_to_them_then(double speed, int seed)
    {
        var random = new Shots(seed);
        Simulator simulator = Cage(new Vector3d(0.8 * speed, 0, 0.6 * speed));
        var balls = new BallState[3];
        for (int i = 0; i < balls.Length; i++)
        {
            double spread = seed > 0 ? 0.05 : 0;
            var place = new Vector3d(9.3 - (0.5 * i) + random.Uniform(-spread, spread), 0.11, 19.3 - (0.3 * i) + random.Uniform(-spread, spread));
            balls[i] = simulator.Launch(place, new Vector3d(1, 0, 1), Vector3d.Zero);
        }

        var group = new BallGroup(simulator, balls.Length);
        var log = new StepLog();
        for (int tick = 0; tick < 600; tick++)
        {
            log.Clear();
            group.Step(balls, Tick, log);
            Assert.InRange(log.Evaluations, 0, balls.Length * MostEvaluations);
            Assert.Equal(0, log.StalledSteps);
            Assert.True(tick < 300 || log.Events.Count == 0, $"an event at {tick / 60.0} s");
        }

        Assert.All(balls, ball => Assert.Equal(MotionState.Rest, ball.Motion));
    }

    /// <summary>Rolling resistance alone does not hold the ball against the wind along the board, but the friction of the board does.</summary>
    [Fact]
    public void Friction_of_a_board_holds_a_ball_that_rolling_resistance_does_not_hold()
    {
        var wind = new Vector3d(5.86, 0, 4.68);
        Simulator simulator = Cage(wind);
        BallState ball = simulator.Launch(new Vector3d(8.9, 0.11, 19.89), new Vector3d(0, 0, 0), Vector3d.Zero);
        Play(simulator, ref ball);
        Assert.Equal(MotionState.Rest, ball.Motion);
        Assert.InRange(ball.Position.X, 8.9 - 1e-6, 8.9 + 1e-3);

        // Without the board it rolls on.
        BallState open = simulator.Launch(new Vector3d(8.9, 0.11, 10), Vector3d.Zero, Vector3d.Zero);
        simulator.Run(ref open, Tick, 1, StopAt.Time, new StepLog());
        Assert.True(open.Position.X > 8.95);
    }

    private static Simulator Cage(Vector3d wind) => new(Pitch.Cage.On(Profiles.Tunnel with { Air = new Air { Wind = wind } }));

    private static Cost Play(Simulator simulator, ref BallState ball)
    {
        var log = new StepLog();
        var cost = new Cost();
        while (ball.Time < RestsWithin && ball.Motion != MotionState.Rest)
        {
            log.Clear();
            simulator.Step(ref ball, Tick, log);
            cost.Steps++;
            cost.Evaluations += log.Evaluations;
            cost.Worst = Math.Max(cost.Worst, log.Evaluations);
            cost.MostEvents = Math.Max(cost.MostEvents, log.Events.Count);
            cost.Stalled += log.StalledSteps;
            foreach (BallEvent happened in log.Events)
            {
                cost.Squeezed += happened.Kind == BallEventKind.Pinned ? 1 : 0;
            }
        }

        return cost;
    }

    private sealed class Cost
    {
        public int Steps { get; set; }

        public long Evaluations { get; set; }

        public long Worst { get; set; }

        public int MostEvents { get; set; }

        public int Squeezed { get; set; }

        public long Stalled { get; set; }

        public double Mean => (double)Evaluations / Steps;
    }
}
