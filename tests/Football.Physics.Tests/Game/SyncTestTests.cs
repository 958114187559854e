namespace FootballPhysics.Tests.Game;

/// <summary>A state that comes out otherwise is named by its field, in one tick.</summary>
public sealed class SyncTestTests
{
    [Fact]
    public void A_match_that_depends_on_its_state_alone_plays_the_same_again_at_every_tick()
    {
        var runner = new FixedStepRunner(new Simulator(Pitch.Standard.On()));
        var rollback = new Rollback(runner);
        for (int tick = 0; tick < 400; tick++)
        {
            if (tick % 60 == 0)
            {
                runner.QueueKick(speed: 20 + (tick / 60), direction: new Vector3d(0.1, 0.3, -1), sideSpin: 30);
            }

            runner.Step();
            Assert.Null(rollback.SyncTest(8));
        }
    }

    [Fact]
    public void A_force_that_remembers_is_found_out_in_one_tick()
    {
        double calls = 0;
        IForce wobble = IForce.From(_ => new Vector3d(1e-3 * ++calls, 0, 0));
        var runner = new FixedStepRunner(new Simulator(new Scene { Forces = ForceSet.Measured with { CustomForces = [wobble] } }));
        var rollback = new Rollback(runner);
        runner.QueueKick(speed: 25, direction: new Vector3d(0, 0.3, -1));
        runner.Step();
        StateDifference? found = rollback.SyncTest(1);
        Assert.NotNull(found);
        Assert.Equal((1, "position.x"), (found.Value.Tick, found.Value.Field));
        Assert.NotEqual(found.Value.Expected, found.Value.Actual);
    }

    /// <summary>A keeper whom the game moves outside MoveBodies, or a callback that remembers: the body is named, before the ball that it hits.</summary>
    [Fact]
    public void A_body_that_is_elsewhere_is_named()
    {
        var bodies = new KinematicBodies();
        bodies.Add("left foot", BodyKind.Boot);
        KinematicBody keeper = bodies.Add("keeper", BodyKind.Player);
        double calls = 0;
        var runner = new FixedStepRunner(new Simulator(new Scene { Bodies = bodies })) { MoveBodies = time => keeper.MoveTo(new Vector3d(0, 0.9, -1e-3 * ++calls), default, time) };
        var rollback = new Rollback(runner);
        for (int i = 0; i < 5; i++)
        {
            runner.Step();
        }

        StateDifference found = rollback.SyncTest(3)!.Value;
        Assert.Equal((3L, -1, 1, "keeper", "position.z"), (found.Tick, found.Ball, found.Body, found.BodyName, found.Field));
        Assert.StartsWith("tick 3, body 1 (keeper), position.z: -0.003 and -0.006, ", found.ToString(), StringComparison.Ordinal);

        // If a ball differs first, the ball is reported, although it pushes the bag differently later.
        var pushed = new FixedStepRunner(new Simulator(new Scene { Obstacles = [new Obstacle { Name = "bag", Shape = new SphereShape(new Vector3d(0, 0.3, -1), 0.3), Mass = 4 }] }));
        rollback = new Rollback(pushed, 60);
        pushed.QueueKick(20, new Vector3d(0, 0.05, -1));
        while (pushed.Tick < 30)
        {
            pushed.Step();
        }

        Assert.Null(rollback.SyncTest(30));
        pushed.Kicks.Add(new KickInput(0, new Vector3d(0, 1, -10), default));
        found = rollback.SyncTest(30)!.Value;
        Assert.Equal((0, -1, (string?)null), (found.Ball, found.Body, found.BodyName));
    }

    [Theory]
    [InlineData("position.y")]
    [InlineData("velocity.z")]
    [InlineData("spinRate")]
    public void One_ulp_in_one_field_is_named(string field)
    {
        BallState a = new Simulator().Launch(new Vector3d(0, 1, 0), new Vector3d(3, 5, -20), new Vector3d(0, 30, 10));
        BallState b = a;
        switch (field)
        {
            case "position.y":
                b.Position = new Vector3d(b.Position.X, Math.BitIncrement(b.Position.Y), b.Position.Z);
                break;
            case "velocity.z":
                b.Velocity = new Vector3d(b.Velocity.X, b.Velocity.Y, Math.BitDecrement(b.Velocity.Z));
                break;
            default:
                b.Flight.SpinRate = Math.BitIncrement(b.Flight.SpinRate);
                break;
        }

        Assert.Null(Snapshot.Difference(in a, in a));
        StateDifference found = Snapshot.Difference(in a, in b)!.Value;
        Assert.Equal((field, 1UL, -1L), (found.Field, found.Ulps, found.Tick));
        Assert.Contains("1 ulp apart", found.ToString());
    }

    /// <summary>What was changed in the kicks, or by whoever says where the bodies are, counts once it is played again from there.</summary>
    [Fact]
    public void Playing_from_a_tick_takes_up_all_that_has_changed_since()
    {
        FixedStepRunner inTime = New();
        FixedStepRunner late = New();
        var rollback = new Rollback(late);
        KickInput[] kicks = [new(10, new Vector3d(3, 4, -12), Vector3d.Zero), new(14, new Vector3d(-2, 5, 3), new Vector3d(0, 20, 0))];
        foreach (KickInput kick in kicks)
        {
            inTime.Kicks.Add(in kick);
        }

        while (late.Tick < 30)
        {
            inTime.Step();
            late.Step();
        }

        foreach (KickInput kick in kicks)
        {
            late.Kicks.Add(in kick);
        }

        Assert.Equal(11, rollback.ResimulateFrom(10));
        Assert.True(Snapshot.Same(inTime.State, late.State));
        Assert.Null(rollback.ResimulateFrom(10));
        Assert.Null(rollback.ResimulateFrom(30));
        Assert.Throws<ArgumentOutOfRangeException>(() => rollback.ResimulateFrom(31));
    }

    [Fact]
    public void The_hash_of_a_match_is_that_of_all_that_must_be_the_same()
    {
        ulong here = New().SessionHash;
        Assert.Equal(here, New().SessionHash);
        FixedStepRunner[] others =
        [
            new(new Simulator(Scene.Windy(new Vector3d(0, 0, 1e-3))), 0.01),
            new(new Simulator(settings: new SolverSettings { Integrator = Integrator.Rk2 }), 0.01),
            new(timeStep: 0.011),
            new(timeStep: 0.01) { QuantizationInterval = 5 },
            new(new BallGroup(new Simulator(), 1), 0.01),
            new(new BallGroup(new Simulator(), 2), 0.01),
        ];
        Assert.Equal(others.Length + 1, others.Select(other => other.SessionHash).Append(here).Distinct().Count());
    }

    private static FixedStepRunner New() => new(timeStep: 0.01);
}
