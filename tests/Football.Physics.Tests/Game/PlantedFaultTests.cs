using FootballPhysics.Game;

namespace FootballPhysics.Tests.Game;

/// <summary>One bit of one field on one of two machines: it is named within the tick in which it happens.</summary>
public sealed class PlantedFaultTests
{
    private const int FaultTick = 40;

    public static TheoryData<int> Fields => [.. Enumerable.Range(0, StateFields.Count)];

    /// <summary>Two machines that compare hashes at every tick; the state goes over where they differ.</summary>
    [Theory]
    [MemberData(nameof(Fields))]
    public void Two_machines_name_the_field_within_one_tick(int field)
    {
        FixedStepRunner here = Match();
        FixedStepRunner there = Match();
        StateDifference? found = null;
        while (found is null && here.Tick < 60)
        {
            here.Step();
            there.Step();
            if (there.Tick == FaultTick)
            {
                there.GoTo(there.Tick, [Changed(there.State, field)]);
            }

            if (Snapshot.Hash(here.State) != Snapshot.Hash(there.State))
            {
                // What the other machine sends: any bits, as memory may have them.
                found = Snapshot.Difference(here.State, there.State);
            }
        }

        Assert.Equal(FaultTick, here.Tick);
        AssertNames(field, found);
    }

    /// <summary>One machine that plays its last ticks again: the state that was kept is not what comes out.</summary>
    [Theory]
    [MemberData(nameof(Fields))]
    public void A_sync_test_names_the_field_within_one_tick(int field)
    {
        FixedStepRunner runner = Match();
        var rollback = new Rollback(runner);
        while (runner.Tick < FaultTick)
        {
            runner.Step();
            Assert.Null(rollback.SyncTest(8));
        }

        rollback.Put(FaultTick, Changed(runner.State, field), 0);
        StateDifference? found = rollback.SyncTest(1);
        Assert.Equal(FaultTick, found?.Tick);

        // The other way round: what is kept stands first.
        Assert.Equal(StateFields.NameOf(field).Name, found?.Field);
        Assert.Equal(StateFields.NameOf(field).IsNumber ? 1UL : 0, found?.Ulps);
        Assert.Null(rollback.SyncTest(8));
    }

    /// <summary>Flags and indices are told as whole numbers, and have no distance in units in the last place.</summary>
    [Fact]
    public void Flags_and_indices_are_no_numbers()
    {
        string[] whole = ["motion", "dragRegion", "carrier", "nets", "netSides", "goalsPassed", "clearIn", "goalsEntered", "reserved", "reservedToo"];
        string[] told = [.. Enumerable.Range(0, StateFields.Count).Select(StateFields.NameOf).Where(field => !field.IsNumber).Select(field => field.Name)];
        Assert.Equal(whole, told);
        BallState state = Match().State;
        BallState other = state;
        other.Motion = state.Motion == MotionState.Rolling ? MotionState.Sliding : MotionState.Rolling;
        StateDifference? found = Snapshot.Difference(state, other);
        Assert.Equal((((int)state.Motion).ToString(System.Globalization.CultureInfo.InvariantCulture), ((int)other.Motion).ToString(System.Globalization.CultureInfo.InvariantCulture)), (found?.Expected, found?.Actual));
    }

    private static void AssertNames(int field, StateDifference? found)
    {
        (string name, bool isNumber) = StateFields.NameOf(field);
        Assert.Equal(name, found?.Field);
        Assert.Equal(isNumber ? 1UL : 0, found?.Ulps);
        Assert.NotEqual(found?.Expected, found?.Actual);
        Assert.Contains(name, found.ToString());
    }

    /// <summary>A number by one unit in its last place, flags and indices by one bit.</summary>
    private static BallState Changed(in BallState state, int field)
    {
        var words = new ulong[StateFields.Count];
        StateFields.Read(in state, words);
        words[field] ^= 1;
        BallState changed = default;
        StateFields.Write(words, ref changed);
        return changed;
    }

    private static FixedStepRunner Match()
    {
        var runner = new FixedStepRunner(new Simulator(Pitch.Standard.On()), 1.0 / 60);
        runner.QueueKick(speed: 22, direction: new Vector3d(0.1, 0.4, -1), topSpin: -10, sideSpin: 30);
        return runner;
    }
}
