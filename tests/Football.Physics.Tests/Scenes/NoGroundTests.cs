using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Scenes;

/// <summary>A scene without ground: every entry point that creates a ball puts it at height 0, in the air, and every query has numbers for an answer.</summary>
public sealed class NoGroundTests
{
    private static readonly Scene s_vacuum = Scene.Vacuum with { Ground = Ground.None, Gravity = 9.81 };

    [Fact]
    public void A_new_ball_falls_from_the_origin_by_half_g_t_squared()
    {
        var ball = new Ball(s_vacuum);
        Assert.Equal((Vector3d.Zero, MotionState.Airborne), (ball.Position, ball.Motion));
        for (int i = 0; i < 100; i++)
        {
            ball.Step(0.01);
        }

        Assert.Equal(-4.905, ball.Position.Y, 1e-9);
        Assert.Equal((0.0, 0.0), (ball.Position.X, ball.Position.Z));
    }

    [Theory]
    [ProfileData]
    public void Without_gravity_it_stays_to_the_bit(Profile profile)
    {
        Scene scene = profile.Scene();
        var ball = new Ball(scene with { Ground = Ground.None, Gravity = 0, Forces = scene.Forces with { Buoyancy = false } });
        for (int i = 0; i < 100; i++)
        {
            ball.Step(0.1);
        }

        Assert.Equal((Vector3d.Zero, Vector3d.Zero), (ball.Position, ball.Velocity));
    }

    [Fact]
    public void A_runner_a_group_and_a_stage_begin_at_height_0()
    {
        var runner = new FixedStepRunner(new Simulator(s_vacuum));
        Assert.Equal(Vector3d.Zero, runner.State.Position);
        var stage = new BallScene(s_vacuum);
        stage.Compile();
        foreach (FixedStepRunner one in (FixedStepRunner[])[runner, new FixedStepRunner(stage.Game), new FixedStepRunner(new BallGroup(new Simulator(s_vacuum), 3))])
        {
            for (int i = 0; i < 100; i++)
            {
                one.Step();
            }

            for (int ball = 0; ball < one.Balls; ball++)
            {
                Vector3d at = one.StateOf(ball).Position;
                Assert.Equal((0.275 * ball, 0.0), (at.X, at.Z));
                Assert.Equal(-4.905, at.Y, 1e-9);
            }
        }
    }

    [Fact]
    public void Looking_ahead_ends_when_the_ball_has_passed_and_every_number_is_finite()
    {
        var ball = new Ball(Scene.Default with { Ground = Ground.None });
        ball.Kick(new Vector3d(1, 8, -20), new Vector3d(0, 20, 0));
        var path = new Trajectory();
        ball.Simulator.LookAhead(ball.State, new LookAheadRequest { Duration = 10, UntilPassing = new Vector3d(0, 1, -8) }, path);
        Assert.True(path.IsComplete);
        Assert.InRange(path.EndTime, 0.3, 10);
        Assert.True(path.PositionAt(path.EndTime).IsFinite);

        // The same future without the early end: it passes at the same place.
        var whole = new Trajectory();
        ball.Simulator.LookAhead(ball.State, new LookAheadRequest { Duration = 10 }, whole);
        Assert.Equal(whole.ClosestApproach(new Vector3d(0, 1, -8)).Distance, path.ClosestApproach(new Vector3d(0, 1, -8)).Distance, 1e-12);
    }

    [Theory]
    [ProfileData]
    public void Warming_up_aims_and_batches_work(Profile profile)
    {
        Scene scene = profile.Scene() with { Ground = Ground.None };
        var simulator = new Simulator(scene);
        simulator.WarmUp();
        new BallBatch(scene).WarmUp();
        new BatchAimer(scene).WarmUp();
        var aimer = new Aimer(simulator);
        aimer.WarmUp();

        // A target below the kick, where a ground would be in the way.
        AimResult kick = aimer.Find(new AimRequest { From = Vector3d.Zero, Target = new Vector3d(2, -3, -20), Speed = 25 });
        Assert.Equal(AimStatus.Hit, kick.Status);
        BallState ball = simulator.Launch(Vector3d.Zero, kick.Velocity, kick.Spin);
        var path = new Trajectory();
        simulator.LookAhead(in ball, new LookAheadRequest { Duration = 3 }, path);
        Assert.InRange(path.ClosestApproach(new Vector3d(2, -3, -20)).Distance, 0, 0.01);

        // A batch flies as long as it may.
        var launches = new BatchLaunches(1);
        launches.Set(0, Vector3d.Zero, kick.Velocity, kick.Spin);
        var flights = new BatchFlights(1);
        new BallBatch(scene).Fly(launches, flights, 1, duration: 1);
        Vector3d after = path.PositionAt(1);
        Assert.InRange((flights.Position[0] - after).Length, 0, 1e-3);
    }

    [Fact]
    public void A_fan_of_passes_names_the_ground_that_it_misses() =>
        Assert.StartsWith("ground is none, but passes are played on a level pitch.", Assert.Throws<ArgumentOutOfRangeException>(() => new PassFan(s_vacuum)).Message, StringComparison.Ordinal);

    [Fact]
    public void A_wire_form_of_a_ball_on_the_ground_is_rejected()
    {
        var onGround = new FixedStepRunner(new Simulator()) { QuantizationInterval = 1 };
        var nowhere = new FixedStepRunner(new Simulator(Scene.Default with { Ground = Ground.None })) { QuantizationInterval = 1 };
        var bytes = new byte[Snapshot.QuantizedSize];
        Assert.True(onGround.TryWriteQuantized(onGround.State, bytes));
        Assert.Throws<FormatException>(() => nowhere.ReadQuantized(bytes));
        nowhere.Step();
        Assert.True(nowhere.TryWriteQuantized(nowhere.State, bytes));
        Assert.Equal(nowhere.State.Position, nowhere.ReadQuantized(bytes).Position);
    }

    [Fact]
    public void The_hash_of_a_scene_tells_it_from_one_with_a_ground_far_below() =>
        Assert.NotEqual(new Simulator(Scene.Published with { Ground = Ground.None }).SceneHash, new Simulator(Scene.Published with { Ground = Ground.PublishedTurf with { Height = -1e6 } }).SceneHash);
}
