namespace FootballPhysics.Tests.Game;

/// <summary>A keeper who commits to a side before the kick: he dives there, adapts only to a ball on that side, and repeats it under rollback.</summary>
public sealed class KeeperGuessTests
{
    private const double TimeStep = 1.0 / 60;
    private const int Kicked = 30;
    private const int Late = 20;
    private static readonly Goal s_goal = new() { Center = new Vector3d(0, 0, -11), Facing = new Vector3d(0, 0, 1) };
    private static readonly Vector3d s_feet = new(0, 0, -10.7);

    [Theory]
    [InlineData(1)]
    [InlineData(-1)]
    public void He_dives_to_his_side_before_the_kick_and_whatever_the_ball_does(int side)
    {
        foreach (double ball in new[] { 6.0, -6.0 })
        {
            (FixedStepRunner runner, BallScene stage) = Match(Guess(side));
            runner.Kicks.Add(new KickInput(Kicked, new Vector3d(ball, 2.5, -24), default));
            while (runner.Tick < Kicked)
            {
                runner.Step();
            }

            double before = stage.Keepers[0].BodyPose.Position.X;
            Assert.True(side * before > 0.02, $"{before} m at the kick");
            while (runner.Time < 0.5 + 0.45)
            {
                runner.Step();
            }

            Assert.True(side * stage.Keepers[0].BodyPose.Position.X > 0.5, $"{stage.Keepers[0].BodyPose.Position}");
            Assert.Equal(1, stage.Keepers[0].Count);
        }
    }

    [Fact]
    public void He_adapts_to_a_ball_on_his_side_after_his_reaction()
    {
        // The guess is at a height of 0.6 m, and the ball comes higher.
        (FixedStepRunner runner, BallScene stage) = Match(Guess(1));
        runner.Kicks.Add(new KickInput(Kicked, new Vector3d(4, 4.5, -18), default));
        double reaction = KeeperDive.Penalty.Reaction;
        while (runner.Time < 0.5 + reaction - 0.02)
        {
            runner.Step();
        }

        Assert.False(stage.Keepers[0].Answer.Crosses);
        while (runner.Time < 0.5 + reaction + 0.04)
        {
            runner.Step();
        }

        Assert.True(stage.Keepers[0].Answer is { Crosses: true, IsOnTarget: true });
        Assert.Equal(1, stage.Keepers[0].Count);
    }

    [Fact]
    public void Without_a_side_he_only_reacts()
    {
        double[] heights = new double[2];
        for (int i = 0; i < 2; i++)
        {
            (FixedStepRunner runner, BallScene stage) = Match(i == 0 ? null : new KeeperGuess(0.3, new Vector3d(0.2, 0.5, -11)));
            runner.Kicks.Add(new KickInput(Kicked, new Vector3d(5, 2.5, -20), default));
            while (runner.Time < 1.1)
            {
                runner.Step();
            }

            heights[i] = stage.Keepers[0].BodyPose.Position.X;
        }

        Assert.Equal(heights[0], heights[1]);
        Assert.True(heights[0] > 0.2);
    }

    [Theory]
    [InlineData(1, 5)]
    [InlineData(-1, 5)]
    [InlineData(1, 0.5)]
    public void A_late_kick_ends_in_the_same_bits(int side, double aside)
    {
        ulong inTime = Play(side, aside, 0);
        for (int late = 1; late <= Late; late += 1 + (late / 4))
        {
            Assert.Equal(inTime, Play(side, aside, late));
        }
    }

    [Fact]
    public void Sides_are_drawn_with_the_shares_of_people()
    {
        const int Kicks = 20_000;
        int[] sides = new int[3];
        for (int kick = 0; kick < Kicks; kick++)
        {
            KeeperGuess guess = KeeperGuess.Draw(s_goal, 0.3, seed: 5, kick);
            Assert.Equal(guess, KeeperGuess.Draw(s_goal, 0.3, seed: 5, kick));
            Assert.InRange(Math.Abs(guess.Target.X), 0, 0.5 * s_goal.Width);
            sides[1 + Math.Sign(guess.Target.X)]++;
        }

        // He faces +z: his left is at +x.
        Assert.Equal(0.444, sides[2] / (double)Kicks, 0.011);
        Assert.Equal(0.063, sides[1] / (double)Kicks, 0.006);
        Assert.Equal(0.493, sides[0] / (double)Kicks, 0.011);
    }

    [Fact]
    public void Bad_arguments_are_rejected()
    {
        Assert.Throws<ArgumentNullException>(() => KeeperGuess.Draw(null!, 0, 1, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => KeeperGuess.Draw(s_goal, double.NaN, 1, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => KeeperGuess.Draw(s_goal, 0, 1, -1));
    }

    private static KeeperGuess Guess(int side) => new(0.3, new Vector3d(2.5 * side, 0.6, -11));

    private static ulong Play(int side, double aside, int late)
    {
        (FixedStepRunner runner, _) = Match(Guess(side));
        var rollback = new Rollback(runner, Late + 2);
        KickInput[] kicks = [new(Kicked, new Vector3d(aside, 2.5, -22), new Vector3d(0, 20, 0)), new(110, new Vector3d(-1, 3, -9), default, 2)];
        ulong all = 0;
        for (int tick = 0; tick < 200; tick++)
        {
            foreach (KickInput kick in kicks.Where(kick => kick.Tick + late == tick))
            {
                rollback.ApplyKick(in kick);
            }

            runner.Step();
            all = tick >= Late ? (all * 31) ^ rollback.HashAt(tick - Late) : 0;
        }

        Assert.Null(rollback.SyncTest(Late));
        return (all * 31) ^ rollback.HashAt(200);
    }

    private static (FixedStepRunner Runner, BallScene Stage) Match(KeeperGuess? guess)
    {
        var stage = new BallScene();
        stage.Add(s_goal);
        stage.AddKeeper(0, s_feet, KeeperDive.Penalty);
        stage.Compile();
        stage.Keepers[0].Guess = guess;
        var runner = new FixedStepRunner(stage.Game, TimeStep);
        runner.MoveBodies = _ => stage.BeforeStep(runner);
        return (runner, stage);
    }
}
