namespace FootballPhysics.Tests.Game;

/// <summary>How a keeper moves: never faster than he can, from the pose and velocity that he has.</summary>
public sealed class KeeperMotionTests
{
    private const double TimeStep = 1.0 / 60;

    /// <summary>The turning rate of a dive that <see cref="KeeperDive"/> states, in rad/s.</summary>
    private const double Turning = 8;

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

    private static (Ball Ball, BallScene Stage) Futsal(Player abilities)
    {
        var stage = new BallScene(new Scene { Ball = BallProperties.Futsal, Ground = Ground.Of(SurfaceMaterial.Indoor) });
        stage.Add(Pitch.Futsal.Goals[0]);
        stage.AddKeeper(0, new Vector3d(0, 0, -19.2), abilities);
        stage.Compile();
        return (new Ball(stage.Game), stage);
    }
}
