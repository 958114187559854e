using FootballPhysics.Game;

namespace FootballPhysics.Labs.Fuzz;

/// <summary>Snapshots: an accepted snapshot is a ball that every scene can simulate.</summary>
internal sealed class SnapshotFuzz : FuzzTarget
{
    /// <summary>The bytes of the words in use: a reader clears the others.</summary>
    private const int Used = sizeof(ulong) * StateFields.Used;

    private static readonly double[] s_steps = [0.01, 1.0 / 60, 0.1, 1];

    /// <summary>Scenes with different stepping code.</summary>
    public static IReadOnlyList<Simulator> Simulators { get; } =
    [
        new(),
        new(Scene.Published with { Air = new Air { Wind = new Vector3d(4, 1, -7) } }),
        new(Scene.Published with { Forces = ForceSet.Regularized, Ground = Ground.Presets["publishedWetTurf"] }),
        new(Scene.Published with { Forces = ForceSet.Constant }, new SolverSettings { Integrator = Integrator.Rk2 }),
        new(Scene.Vacuum, new SolverSettings { Integrator = Integrator.SemiImplicitEuler, CollisionTiming = CollisionTiming.Bisection }),
        new(Scene.Published with { Ball = BallProperties.BeachBall }, new SolverSettings { Integrator = Integrator.Euler }),
    ];

    public override string Name => "snapshots";

    /// <summary>Returns a ball state from some moment of a match.</summary>
    public static BallState State(SeededRandom random) => State(random, Simulators[random.Below(Simulators.Count)]);

    /// <summary>Returns a ball state of a given scene.</summary>
    public static BallState State(SeededRandom random, Simulator simulator)
    {
        BallState state = simulator.Launch(new Vector3d(0, 0.11, 0), random.Velocity(0, 30, 0, 60), 60 * random.Next() * random.Direction());
        var log = new StepLog(1);
        for (int i = random.Below(120); i > 0; i--)
        {
            simulator.Step(ref state, 0.05, log);
        }

        return state;
    }

    /// <summary>Returns the words of a state, some of them extreme.</summary>
    public static byte[] Changed(SeededRandom random, in BallState state, int mutations)
    {
        var bytes = new byte[Snapshot.Size];
        Snapshot.Write(in state, bytes);
        for (int i = 0; i < mutations; i++)
        {
            int at = sizeof(ulong) * random.Below(StateFields.Count);
            int change = random.Below(4);
            if (change == 0)
            {
                bytes[at + random.Below(8)] ^= (byte)(1 << random.Below(8));
                continue;
            }

            BitConverter.TryWriteBytes(bytes.AsSpan(at), change == 1 ? (ulong)random.Below(6) : BitConverter.DoubleToUInt64Bits(FuzzNumbers.AnyBits(random)));
        }

        return bytes;
    }

    public override byte[] Make(SeededRandom random, int mutations)
    {
        byte[] changed = Changed(random, State(random), mutations);
        if (random.Chance(0.1))
        {
            changed = FuzzBytes.Changed(random, changed, 1);
        }

        return random.Chance(0.9) ? FuzzBytes.Sealed(changed) : changed;
    }

    public override bool Try(byte[] input)
    {
        if (!IsAccepted(() => Snapshot.Read(input), out BallState state, "source"))
        {
            return true;
        }

        Must(Crc32.Holds(input.AsSpan(0, Snapshot.Size)), "changed bytes are accepted");
        var again = new byte[Snapshot.Size];
        Snapshot.Write(in state, again);
        Must(again.AsSpan(0, Used).SequenceEqual(input.AsSpan(0, Used)), "a state does not come back");
        MustBeFinite(in state);
        var log = new StepLog(1);
        var path = new Trajectory(64);
        foreach (Simulator simulator in Simulators)
        {
            BallState played = state;
            foreach (double step in s_steps)
            {
                for (int i = 0; i < 3; i++)
                {
                    simulator.Step(ref played, step, log);
                    MustBeFinite(in played);
                }
            }

            if (state.Time < Limits.Time)
            {
                simulator.LookAhead(in state, new LookAheadRequest { Duration = 1 }, path);
                MustBeFinite(path.Final);
                Must(double.IsFinite(path.Apex), "an apex is not finite");
            }
        }

        return false;
    }
}
