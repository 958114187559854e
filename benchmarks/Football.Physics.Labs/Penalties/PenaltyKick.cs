namespace FootballPhysics.Labs.Penalties;

/// <summary>Plays penalties with their keepers.</summary>
internal static class PenaltyKick
{
    /// <summary>The distance of the penalty mark from the line, in m.</summary>
    private const double Distance = 11;

    /// <summary>The time of the kick, and the time before it at which a keeper who guesses starts, in s.</summary>
    private const double KickedAt = 0.5;
    private const double Before = 0.2;

    /// <summary>The mean speed of a kick and its half range, in m/s.</summary>
    private const double Speed = 25;
    private const double Range = 4;

    private const double Step = 1.0 / 120;

    private static readonly Goal s_goal = new() { Center = new Vector3d(0, 0, -Distance), Facing = new Vector3d(0, 0, 1) };

    /// <summary>The errors of a shooter: 5 % of the speed, 2° up and 2.2° aside.</summary>
    private static readonly KickSpread s_spread = new() { SpeedPercent = 5, ElevationDegrees = 2, AzimuthDegrees = 2.2, SpinPercent = 20 };

    /// <summary>Plays a penalty.</summary>
    /// <param name="random">The random numbers of this kick.</param>
    /// <param name="aim">Its aim.</param>
    /// <param name="keeper">The keeper.</param>
    /// <param name="index">The number of the kick, for the keeper's guess.</param>
    /// <param name="seed">The seed of the guesses.</param>
    public static PenaltyEnd Play(SeededRandom random, PenaltyAim aim, PenaltyKeeper keeper, int index, long seed)
    {
        var stage = new BallScene();
        stage.Add(s_goal);
        if (keeper.Abilities is { } abilities)
        {
            stage.AddKeeper(0, s_goal.Center + (0.2 * s_goal.Facing), abilities);
        }

        stage.Compile();
        if (keeper.Guesses)
        {
            stage.Keepers[0].Guess = KeeperGuess.Draw(s_goal, KickedAt - Before, seed, index);
        }

        (Vector3d velocity, Vector3d spin) = Kick(random, aim);
        BallState ball = stage.Game.Launch(new Vector3d(0, stage.Game.ContactHeight, 0), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        bool isKicked = false;
        bool hitsPost = false;
        bool hitsKeeper = false;
        for (int i = 0; i < 3 / Step; i++)
        {
            if (!isKicked && ball.Time >= KickedAt)
            {
                stage.Game.Kick(ref ball, velocity, spin);
                isKicked = true;
            }

            stage.BeforeStep(in ball);
            log.Clear();
            stage.Game.Step(ref ball, Step, log);
            foreach (BallEvent item in log.Events.Span)
            {
                if (item.Kind == BallEventKind.Goal)
                {
                    return PenaltyEnd.Scored;
                }

                string? name = item.Kind == BallEventKind.Impact ? stage.Game.NameOf(in item) : null;
                hitsKeeper |= name == "keeper";
                hitsPost |= name is "left post" or "right post" or "crossbar";
            }
        }

        return hitsKeeper ? PenaltyEnd.Saved : hitsPost ? PenaltyEnd.Post : PenaltyEnd.Missed;
    }

    /// <summary>Returns the kick that reaches the target, with the errors of the shooter.</summary>
    private static (Vector3d Velocity, Vector3d Spin) Kick(SeededRandom random, PenaltyAim aim)
    {
        Vector3d target = aim.Target(random, -Distance);
        double speed = Speed + (Range * ((2 * random.Next()) - 1));
        var ground = new Simulator();
        AimResult found = new Aimer(ground).Find(new AimRequest { From = new Vector3d(0, ground.ContactHeight, 0), Target = target, Speed = speed, MaximumElevationDegrees = 40 });
        return s_spread.Draw(new Random((int)(random.Next() * int.MaxValue)), found.Velocity, found.Spin);
    }
}
