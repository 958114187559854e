namespace FootballPhysics.Tests.Game;

/// <summary>How a keeper moves: never faster than he can, from the pose and velocity that he has, near his line, and also for slow balls.</summary>
public sealed class KeeperMotionTests
{
    private const double TimeStep = 1.0 / 60;

    /// <summary>The turning rate of a dive that <see cref="KeeperDive"/> states, in rad/s.</summary>
    private const double Turning = 8;

    private static readonly Goal s_goal = new() { Center = new Vector3d(0, 0, -20), Facing = new Vector3d(0, 0, 1) };

    /// <summary>A kick, and one or two touches on the way, also one when he is already in the air.</summary>
    [Theory]
    [InlineData(3.0)]
    [InlineData(5.0)]
    public void He_never_moves_faster_than_he_can_however_often_the_ball_is_touched(double speed)
    {
        const double Rounding = 1e-9;
        double fastest = 0, quickest = 0, jump = 0, turn = 0, gain = 0;
        for (int seed = 0; seed < 120; seed++)
        {
            var random = new Random(seed);
            (Ball ball, BallScene stage) = Futsal(KeeperDive.Typical with { Speed = speed });
            KinematicBody body = stage.Game.Scene.Bodies![0];
            ball.Launch(new Vector3d(6 * (random.NextDouble() - 0.5), 0.1, -14), Vector3d.Zero, Vector3d.Zero);
            (Vector3d place, Vector3d velocity, Vector3d spin) = (body.Position, body.Velocity, body.Spin);
            for (int tick = 0; tick < 150; tick++)
            {
                if (tick == 10)
                {
                    ball.Kick(new Vector3d(6 * (random.NextDouble() - 0.5), 1, -12), default);
                }

                if (tick == 24 || (seed % 2 == 1 && tick == 31))
                {
                    ball.Kick(new Vector3d(8 * (random.NextDouble() - 0.5), 1.5, -8), default);
                }

                stage.BeforeStep(ball.State);
                fastest = Math.Max(fastest, Math.Max(body.Velocity.Length, Vector3d.Distance(place, body.Position) / TimeStep));
                quickest = Math.Max(quickest, body.Spin.Length);
                jump = Math.Max(jump, Vector3d.Distance(velocity, body.Velocity));
                turn = Math.Max(turn, Vector3d.Distance(spin, body.Spin));
                (place, velocity, spin) = (body.Position, body.Velocity, body.Spin);
                ball.Step(TimeStep);
                foreach (BallEvent item in ball.Events)
                {
                    gain = ball.NameOf(item) == "keeper" ? Math.Max(gain, item.Velocity.Length - item.VelocityBefore.Length) : gain;
                }
            }
        }

        string moved = $"{fastest} m/s and {quickest} rad/s; in a step by {jump} m/s and {turn} rad/s; the ball by {gain} m/s";
        Assert.True(fastest <= speed + Rounding && quickest <= Turning + Rounding, moved);

        // He changes his velocity in a tenth of a second, not in a step.
        Assert.True(jump <= (2.02 * speed * TimeStep / 0.1) + Rounding && turn <= (2.02 * Turning * TimeStep / 0.1) + Rounding, moved);
        Assert.True(gain < speed, moved);
    }

    /// <summary>Balls that take longer to the line than he looks ahead: he looks again.</summary>
    [Theory]
    [InlineData(0.8, 0, -14)]
    [InlineData(0.6, 0, -10)]
    [InlineData(0.5, 11, -8)]
    public void He_also_saves_a_slow_ball(double x, double y, double z)
    {
        (Ball ball, BallScene stage) = Shot(new Vector3d(x, y, z), s_goal);
        bool touched = false;
        while (ball.Time < 9 && !touched)
        {
            stage.BeforeStep(ball.State);
            ball.Step(TimeStep);
            foreach (BallEvent item in ball.Events)
            {
                Assert.NotEqual(BallEventKind.Goal, item.Kind);
                touched |= ball.NameOf(item) == "keeper";
            }
        }

        Assert.Equal((true, 1), (touched, stage.Keepers[0].Count));
    }

    /// <summary>A ball that another player takes before he dives for it: he stays.</summary>
    [Fact]
    public void He_stays_if_a_slow_ball_is_taken_before_he_dives()
    {
        (Ball ball, BallScene stage) = Shot(new Vector3d(0.8, 0, -14), s_goal);
        for (int tick = 0; tick < 400; tick++)
        {
            if (tick == 60)
            {
                ball.Kick(new Vector3d(3, 0, 6), default);
            }

            stage.BeforeStep(ball.State);
            Assert.False(stage.Keepers[0].Dives);
            ball.Step(TimeStep);
        }

        Assert.Equal(0, stage.Keepers[0].Count);
    }

    /// <summary>A ball at rest, or on its predicted path, costs him no prediction.</summary>
    [Fact]
    public void He_looks_again_only_while_the_ball_moves_and_does_not_reach_his_line()
    {
        (Ball ball, BallScene stage) = Shot(new Vector3d(8, 0, 1), s_goal);
        var looks = new List<double>();
        byte[] memory = stage.Keepers[0].ToBytes(double.PositiveInfinity);
        while (ball.Time < 20)
        {
            stage.BeforeStep(ball.State);
            byte[] now = stage.Keepers[0].ToBytes(double.PositiveInfinity);
            if (!now.AsSpan().SequenceEqual(memory))
            {
                memory = now;
                looks.Add(ball.Time);
            }

            ball.Step(TimeStep);
        }

        Assert.InRange(looks.Count, 3, 8);
        Assert.True(looks[^1] < 8 && ball.State.Velocity.Length == 0, string.Join(" ", looks));
    }

    /// <summary>He goes to the point of the path that is next to him, not to the first that he can reach.</summary>
    [Theory]
    [InlineData(1.2, 3, -18)]
    [InlineData(0.8, 4, -13)]
    [InlineData(2.2, 3, -18)]
    public void He_stays_near_his_line(double x, double y, double z)
    {
        (Ball ball, BallScene stage) = Shot(new Vector3d(x, y, z), s_goal);
        KinematicBody body = stage.Game.Scene.Bodies![0];
        double farthest = 0;
        bool touched = false;
        while (ball.Time < 4)
        {
            stage.BeforeStep(ball.State);
            farthest = Math.Max(farthest, body.Position.Z - s_goal.Center.Z);
            ball.Step(TimeStep);
            foreach (BallEvent item in ball.Events)
            {
                Assert.NotEqual(BallEventKind.Goal, item.Kind);
                touched |= ball.NameOf(item) == "keeper";
            }
        }

        Assert.True(touched && farthest < 1, $"{farthest} m before the line, touched: {touched}");
    }

    private static (Ball Ball, BallScene Stage) Shot(Vector3d velocity, Goal goal)
    {
        var stage = new BallScene();
        stage.Add(goal);
        stage.AddKeeper(0, goal.Center + new Vector3d(0, 0, 0.5));
        stage.Compile();
        var ball = new Ball(stage.Game);
        for (int tick = 0; tick < 30; tick++)
        {
            stage.BeforeStep(ball.State);
            ball.Step(TimeStep);
        }

        ball.Kick(velocity, default);
        return (ball, stage);
    }

    private static (Ball Ball, BallScene Stage) Futsal(Player abilities)
    {
        var stage = new BallScene(new Scene { Ball = BallProperties.Futsal, Ground = Ground.Of(SurfaceMaterial.Indoor) });
        stage.Add(Pitch.Futsal.Goals[0]);
        stage.AddKeeper(0, new Vector3d(0, 0, -19.2), abilities);
        stage.Compile();
        return (new Ball(stage.Game), stage);
    }
}
