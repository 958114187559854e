namespace Football.Physics.Tests.Game;

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
        IForce wobble = Force.From(_ => new Vector3d(1e-3 * ++calls, 0, 0));
        var runner = new FixedStepRunner(new Simulator(new Scene { Forces = ForceSet.Measured with { Custom = [wobble] } }));
        var rollback = new Rollback(runner);
        runner.QueueKick(speed: 25, direction: new Vector3d(0, 0.3, -1));
        runner.Step();
        StateDifference? found = rollback.SyncTest(1);
        Assert.NotNull(found);
        Assert.Equal((1, "position.x"), (found.Value.Tick, found.Value.Field));
        Assert.NotEqual(found.Value.Expected, found.Value.Actual);
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
}
