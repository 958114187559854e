using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Several;

/// <summary>Players of finite mass press and walk balls: a group of one is the ball alone, and only balls that can reach a pushed object end their steps at a push.</summary>
public sealed class PressedGroupTests
{
    private const double Tick = 1.0 / 60;

    /// <summary>The most events of one ball in a step.</summary>
    private const int MostEvents = 24;

    /// <summary>The limit of a step, and the trials of a group beside it.</summary>
    private const long MostEvaluations = 32_768;

    [Theory]
    [InlineData(0, 75)]
    [InlineData(0, double.PositiveInfinity)]
    [InlineData(1, 75)]
    [InlineData(2, 20)]
    [InlineData(3, 5)]
    [InlineData(777, 1.5)]
    public void A_player_presses_a_ball_to_a_board_alone_in_a_group_of_one_and_beside_a_ball_far_off(int seed, double mass)
    {
        Walk alone = AgainstBoard(seed, mass);
        Walk one = AgainstBoard(seed, mass);
        Walk two = AgainstBoard(seed, mass);
        BallState ball = alone.Start;
        BallState[] single = [one.Start];
        BallState[] pair = [two.Start, two.Simulator.Launch(new Vector3d(30, 0.11, 30), new Vector3d(2, 0, 1), Vector3d.Zero)];
        var groupOfOne = new BallGroup(one.Simulator, 1);
        var groupOfTwo = new BallGroup(two.Simulator, 2);
        var log = new StepLog();
        var logOfOne = new StepLog();
        var logOfTwo = new StepLog();
        for (int tick = 0; tick < 300; tick++)
        {
            alone.Move(tick);
            one.Move(tick);
            two.Move(tick);
            log.Clear();
            logOfOne.Clear();
            logOfTwo.Clear();
            alone.Simulator.Step(ref ball, Tick, log);
            groupOfOne.Step(single, Tick, logOfOne);
            groupOfTwo.Step(pair, Tick, logOfTwo);
            Assert.True(Snapshot.Same(in ball, in single[0]), $"tick {tick}: {ball.Position}, in a group of one {single[0].Position}");
            Assert.Equal(ball.Position, pair[0].Position);
            Assert.Equal(ball.Velocity, pair[0].Velocity);
            Assert.Equal(ball.Spin, pair[0].Spin);
            Assert.Equal(log.Events.Count, logOfOne.Events.Count);
            Assert.Equal(log.Events.Count, Count(logOfTwo, 0));
            Assert.Equal(log.Evaluations, logOfOne.Evaluations);
            Assert.InRange(log.Events.Count, 0, MostEvents);
            Assert.Equal(alone.Player.Velocity, one.Player.Velocity);
            Assert.Equal(alone.Player.Velocity, two.Player.Velocity);
        }
    }

    /// <summary>Both balls reach the player in each step: their steps end at each push, and keep their limits.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Two_balls_that_one_player_presses_to_a_board_keep_the_limits_of_a_step(int seed)
    {
        Walk walk = AgainstBoard(seed, 75);
        BallState[] balls = [walk.Start, walk.Simulator.Launch(new Vector3d(0.26, 0.11, -4.6), Vector3d.Zero, Vector3d.Zero)];
        var group = new BallGroup(walk.Simulator, 2);
        var log = new StepLog();
        for (int tick = 0; tick < 300; tick++)
        {
            walk.Move(tick);
            log.Clear();
            group.Step(balls, Tick, log);
            Assert.InRange(Count(log, 0), 0, MostEvents);
            Assert.InRange(Count(log, 1), 0, MostEvents);
            Assert.InRange(log.Evaluations, 0, MostEvaluations);
            Assert.Equal(0, log.StalledSteps);
            Assert.All(balls, ball => Assert.True(ball.Position.Y >= 0.11 - 1e-9 && ball.Position.Z >= -4.89 - 1e-9, $"tick {tick}: {ball.Position}"));
        }
    }

    /// <summary>A ball that the pushed obstacle reaches finds it where it was pushed to, whatever the numbers of the balls.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_ball_that_can_reach_a_pushed_object_meets_it_as_it_was_pushed(bool swaps)
    {
        var crate = new Obstacle { Name = "crate", Shape = new BoxShape(new Vector3d(0, 0.25, 0), new Vector3d(0.5, 0.25, 0.05)), Mass = 0.5 };
        var simulator = new Simulator(Scene.Default with { Obstacles = [crate], Ground = Ground.None, Gravity = 0 });

        // The first pushes the crate at 20 m/s; the other one rests 10 cm behind it, and is hit within the step.
        BallState pushes = simulator.Launch(new Vector3d(-0.2, 0.25, 0.2), new Vector3d(0, 0, -20), Vector3d.Zero);
        BallState isHit = simulator.Launch(new Vector3d(0.2, 0.25, -0.2), Vector3d.Zero, Vector3d.Zero);
        BallState[] balls = swaps ? [isHit, pushes] : [pushes, isHit];
        var log = new StepLog();
        new BallGroup(simulator, 2).Step(balls, 0.02, log);
        BallState hit = balls[swaps ? 0 : 1];
        Assert.True(hit.Velocity.Z < -1, $"{hit.Velocity}");
        Assert.Equal(2, log.Events.Count);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(777)]
    public void A_ball_that_a_player_walks_over_the_line_is_a_goal_alone_and_in_a_group_of_one(int seed)
    {
        int behind = 0;
        for (int i = 0; i < 25; i++)
        {
            Walk alone = IntoGoal((1000 * seed) + i);
            Walk one = IntoGoal((1000 * seed) + i);
            BallState ball = alone.Start;
            BallState[] single = [one.Start];
            var group = new BallGroup(one.Simulator, 1);
            var log = new StepLog();
            var logOfOne = new StepLog();
            for (int tick = 0; tick < 20; tick++)
            {
                alone.Move(tick);
                one.Move(tick);
                alone.Simulator.Step(ref ball, Tick, log);
                group.Step(single, Tick, logOfOne);
            }

            // All of it is over the line, posts included.
            bool isBehind = ball.Position.Z < -20.2;
            behind += isBehind ? 1 : 0;
            Assert.True(Snapshot.Same(in ball, in single[0]), $"walk {i}: {ball.Position}, in a group of one {single[0].Position}");
            Assert.True(!isBehind || Goals(log) == 1, $"walk {i}: {Goals(log)} goals");
            Assert.Equal(Goals(log), Goals(logOfOne));
        }

        Assert.True(behind > 0, "no walk leads over the line");
    }

    private static int Goals(StepLog log)
    {
        int goals = 0;
        foreach (BallEvent happened in log.Events)
        {
            goals += happened.Kind == BallEventKind.Goal ? 1 : 0;
        }

        return goals;
    }

    private static int Count(StepLog log, int ball)
    {
        int count = 0;
        foreach (BallEvent happened in log.Events)
        {
            count += happened.Ball == ball ? 1 : 0;
        }

        return count;
    }

    private static Walk AgainstBoard(int seed, double mass)
    {
        var random = new Shots(seed);
        double spread = seed > 0 ? 1 : 0;
        double aside = 0.04 + (spread * random.Uniform(-0.08, 0.08));
        double speed = 1.5 + (spread * random.Uniform(-0.5, 1.5));
        double radius = 0.25 + (spread * random.Uniform(-0.08, 0.08));
        var bodies = new KinematicBodies();
        KinematicBody player = bodies.Add("player", new CapsuleShape(new Vector3d(0, radius, 0), new Vector3d(0, 1.55, 0), radius), SurfaceMaterial.Boot, mass);
        var box = new BoxShape(new Vector3d(0, 0.5, -5.05), new Vector3d(50, 0.5, 0.05));
        var board = new Obstacle { Name = "board", Shape = box, Surface = SurfaceMaterial.Board };
        var simulator = new Simulator(Scene.Default with { Bodies = bodies, Obstacles = [board] });
        return new Walk(simulator, player, new Vector3d(0, 0.11, -4.7), new Vector3d(aside, 0, -3.5), speed, -4.9);
    }

    private static Walk IntoGoal(int seed)
    {
        // Half a millimetre of spread about a walk in which the player squeezes the ball over the line.
        const double Spread = 5e-4;
        var random = new Shots(seed);
        double radius = 0.2931 + random.Uniform(-Spread, Spread);
        double speed = 3.2587 + random.Uniform(-Spread, Spread);
        double aside = -0.0128 + random.Uniform(-Spread, Spread);
        double line = -19.9646 + random.Uniform(-Spread, Spread);
        double gap = 0.195 + random.Uniform(-Spread, Spread);
        var bodies = new KinematicBodies();
        KinematicBody player = bodies.Add("player", new CapsuleShape(new Vector3d(0, radius, 0), new Vector3d(0, 1.5, 0), radius), SurfaceMaterial.Boot, 75);
        var simulator = new Simulator(Pitch.Futsal.On(Scene.Default with { Bodies = bodies }));
        return new Walk(simulator, player, new Vector3d(0.25, 0.11, line), new Vector3d(0.25 + aside, 0, line + radius + 0.11 + gap), speed, -20.1);
    }

    /// <summary>A player who walks towards −z at a constant speed, up to a stop.</summary>
    private sealed class Walk(Simulator simulator, KinematicBody player, Vector3d ball, Vector3d from, double speed, double stop)
    {
        private Vector3d _at = from;

        public Simulator Simulator { get; } = simulator;

        public KinematicBody Player { get; } = player;

        public BallState Start { get; } = simulator.Launch(ball, Vector3d.Zero, Vector3d.Zero);

        /// <summary>Moves the player before a step.</summary>
        public void Move(int tick)
        {
            Vector3d velocity = _at.Z > stop ? new Vector3d(0, 0, -speed) : Vector3d.Zero;
            Player.MoveTo(_at, velocity, TimeOf(tick));
            _at += Tick * velocity;
        }

        private static double TimeOf(int tick)
        {
            // As the clock of the ball adds it up.
            double time = 0;
            for (int i = 0; i < tick; i++)
            {
                time += Tick;
            }

            return time;
        }
    }
}
