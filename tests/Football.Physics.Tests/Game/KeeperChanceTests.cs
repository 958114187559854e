namespace FootballPhysics.Tests.Game;

/// <summary>A keeper who is played lets in as many goals as the chance of a goal says for the same abilities.</summary>
public sealed class KeeperChanceTests
{
    private const double TimeStep = 1.0 / 60;
    private const double Kicked = 0.5;
    private const int Plays = 400;

    [Theory]
    [InlineData(-3.1, 1.9, 31)]
    [InlineData(-3.0, 0.5, 30)]
    [InlineData(-2.6, 1.0, 28)]
    public void A_played_keeper_agrees_with_the_chance_of_a_goal(double x, double y, double speed)
    {
        var goal = new Goal { Center = new Vector3d(0, 0, -22), Facing = new Vector3d(0, 0, 1) };
        Vector3d feet = goal.Center + new Vector3d(0.6, 0, 0);
        var spot = new Vector3d(2, 0.11, 0);
        var spread = new KickSpread();
        AimResult aim = new Aimer().Find(new AimRequest { From = spot, Target = new Vector3d(x, y, -22), Speed = speed });
        GoalChanceResult chance = new GoalChance().Find(new GoalChanceRequest
        {
            Position = spot,
            Velocity = aim.Velocity,
            Spin = aim.Spin,
            Spread = spread,
            Goal = goal,
            Keeper = KeeperDive.Typical with { Position = feet },
            AlwaysSimulate = true,
            Kicks = 20_000,
        });
        var random = new Random(1);
        int goals = 0;
        for (int play = 0; play < Plays; play++)
        {
            (Vector3d velocity, Vector3d spin) = spread.Draw(random, aim.Velocity, aim.Spin);
            goals += IsGoal(goal, feet, spot, velocity, spin) ? 1 : 0;
        }

        double scores = goals / (double)Plays;
        double deviation = Math.Sqrt(chance.Scores * (1 - chance.Scores) / Plays);
        Assert.True(Math.Abs(scores - chance.Scores) <= 3 * deviation, $"played {scores}, computed {chance.Scores} ± {deviation}");
    }

    private static bool IsGoal(Goal goal, Vector3d feet, Vector3d spot, Vector3d velocity, Vector3d spin)
    {
        var stage = new BallScene();
        stage.Add(goal);
        stage.AddKeeper(0, feet);
        stage.Compile();
        var ball = new Ball(stage.Game);
        ball.Place(spot);
        bool isKicked = false;
        while (ball.Time < 2.5)
        {
            if (!isKicked && ball.Time >= Kicked - 0.01)
            {
                ball.Kick(velocity, spin);
                isKicked = true;
            }

            stage.BeforeStep(ball.State);
            ball.Step(TimeStep);
            foreach (BallEvent item in ball.Events)
            {
                if (item.Kind == BallEventKind.Goal)
                {
                    return true;
                }
            }
        }

        return false;
    }
}
