namespace FootballPhysics.Tests.Game;

/// <summary>A ball and a runner go on in another scene between steps.</summary>
public sealed class SceneChangeTests
{
    private static readonly Simulator s_dry = new(Scene.Published);
    private static readonly Simulator s_windy = new(Scene.Published with { Air = new Air { Wind = new Vector3d(12, 0, 0) } });
    private static readonly Simulator s_high = new(Scene.Published with { Ground = Ground.PublishedTurf with { Height = 2 } });
    private static readonly Vector3d s_velocity = new(0, 6, -20);

    [Fact]
    public void A_ball_flies_on_where_it_is_in_the_other_wind()
    {
        var ball = new Ball(s_dry);
        ball.Kick(s_velocity, new Vector3d(0, 20, 0));
        ball.Step(0.3);
        BallState state = ball.State;
        ball.Simulator = s_windy;
        Assert.Equal((state.Position, state.Velocity, state.Spin, state.Time), (ball.State.Position, ball.State.Velocity, ball.State.Spin, ball.State.Time));
        ball.Step(0.5);
        s_dry.Step(ref state, 0.5, new StepLog());
        Assert.InRange(ball.State.Position.X - state.Position.X, 0.1, 6);
    }

    [Fact]
    public void A_ball_at_rest_stays_so_and_one_below_the_new_ground_is_raised()
    {
        var ball = new Ball(s_dry) { Simulator = s_windy };
        Assert.Equal(MotionState.Rest, ball.Motion);
        ball.Simulator = s_high;
        Assert.Equal((MotionState.Rest, s_high.ContactHeight), (ball.Motion, ball.State.Position.Y));
        ball.Simulator = s_dry;
        Assert.Equal(MotionState.Airborne, ball.Motion);
    }

    /// <summary>Obstacles that the ball has pushed stay where they are in a scene that differs in its ground alone; only the game puts them back.</summary>
    [Theory]
    [InlineData(8)]
    [InlineData(10)]
    [InlineData(14)]
    public void A_pushed_obstacle_stays_where_it_is_when_the_ground_changes(double speed)
    {
        var cone = new Obstacle { Name = "cone", Shape = new SphereShape(new Vector3d(0, 0.11, -3), 0.1), Mass = 0.3 };
        var scene = new Scene { Obstacles = [cone] };
        var ball = new Ball(scene);
        ball.Kick(new Vector3d(0, 0, -speed), Vector3d.Zero);
        Assert.True(Hits(120), "The first ball knocks the cone away.");
        ball.Simulator = new Simulator(scene with { Ground = Ground.Of(SurfaceMaterial.WetTurf) });
        Assert.False(Again(), "The cone is back at its start.");
        ball.Simulator.ResetObstacles();
        Assert.True(Again(), "The game has put it back.");

        bool Again()
        {
            ball.State = ball.Simulator.Launch(new Vector3d(0, 0.11, -1), new Vector3d(0, 0, -speed), Vector3d.Zero);
            return Hits(30);
        }

        // Where the cone stands at the start.
        bool Hits(int ticks)
        {
            bool hits = false;
            for (int i = 0; i < ticks; i++)
            {
                ball.Step(1.0 / 60);
                foreach (BallEvent happened in ball.Events)
                {
                    hits |= happened.ColliderIndex > 0 && Math.Abs(happened.Position.Z + 2.79) < 0.05;
                }
            }

            return hits;
        }
    }

    [Fact]
    public void A_runner_goes_on_at_its_tick_and_its_recording_ends()
    {
        var runner = new FixedStepRunner(s_dry);
        runner.QueueKick(s_velocity, Vector3d.Zero);
        runner.Record();
        runner.Step();
        Vector3d place = runner.State.Position;
        runner.Simulator = s_windy;
        Assert.Equal((1L, place, (Recording?)null), (runner.Tick, runner.State.Position, runner.Recording));
        for (int i = 0; i < 50; i++)
        {
            runner.Step();
        }

        Assert.InRange(runner.State.Position.X, 0.1, 6);
        Assert.Throws<ArgumentNullException>(() => runner.Simulator = null!);
    }
}
