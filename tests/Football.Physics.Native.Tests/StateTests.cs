namespace FootballPhysics.Native.Tests;

/// <summary>Simulator.Validate: what it lets through is what a ball can have.</summary>
public sealed class StateTests
{
    [Fact]
    public unsafe void States_on_their_way_are_let_through_and_changed_bytes_are_judged_as_a_snapshot_is()
    {
        var simulator = new Simulator(Pitch.Standard.On(new Scene()));
        var log = new StepLog();
        var random = new Random(7);
        byte[] bytes = new byte[Snapshot.Size];
        int refused = 0;
        int elsewhere = 0;
        int all = 0;
        for (int kick = 0; kick < 200; kick++)
        {
            BallState state = simulator.Launch(new(random.NextDouble() * 30, 1, -40), new((random.NextDouble() * 20) - 10, 5, (random.NextDouble() * 60) - 30), new(random.NextDouble() * 50, 20, 0));
            for (int tick = 0; tick < 600; tick++)
            {
                simulator.Validate(in state);
                log.Clear();
                simulator.Step(ref state, 1.0 / 60, log);
                BallState changed = state;
                ((byte*)&changed)[random.Next(sizeof(BallState))] ^= (byte)(1 << random.Next(8));
                bool accepted = Accepts(simulator, in changed);
                bool read = Reads(in changed, bytes);
                Assert.True(read || !accepted, changed.ToString());
                refused += read ? 0 : 1;
                elsewhere += read && !accepted ? 1 : 0;
                all++;
            }
        }

        // What is refused here alone is no ball of this scene: its carrier or position contradicts the scene, or a reserved word is not zero: eight of 27 words.
        Assert.InRange(refused, all / 20, all / 2);
        Assert.InRange(elsewhere, 1, all * 8 / 27);
    }

    private static bool Accepts(Simulator simulator, in BallState state)
    {
        try
        {
            simulator.Validate(in state);
            return true;
        }
        catch (ArgumentOutOfRangeException)
        {
            return false;
        }
    }

    private static bool Reads(in BallState state, byte[] bytes)
    {
        Snapshot.Write(in state, bytes);
        try
        {
            Snapshot.Read(bytes);
            return true;
        }
        catch (FormatException)
        {
            return false;
        }
    }
}
