using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Fuzz;

/// <summary>One kind of input that may come from anywhere.</summary>
internal abstract class FuzzTarget
{
    /// <summary>The kinds.</summary>
    public static IReadOnlyList<FuzzTarget> All { get; } = [new ScenarioFuzz(), new KickLogFuzz(), new SegmentFuzz(), new SnapshotFuzz()];

    /// <summary>A step has no more evaluations, docs/troubleshooting.md.</summary>
    private const long MostEvaluations = 32_768;

    /// <summary>What it is, in the plural.</summary>
    public abstract string Name { get; }

    /// <summary>Makes an input out of a right one.</summary>
    /// <param name="random">Where chance comes from.</param>
    /// <param name="mutations">How much is changed.</param>
    public abstract byte[] Make(SeededRandom random, int mutations);

    /// <summary>Reads an input and uses what it says.</summary>
    /// <returns>True when it was refused, false when the answer was right.</returns>
    /// <exception cref="FuzzException">What must not be.</exception>
    public abstract bool Try(byte[] input);

    /// <summary>The input as a message shows it.</summary>
    public virtual string Text(byte[] input) => Convert.ToHexString(input);

    /// <summary>Holds that something must be.</summary>
    protected static void Must(bool holds, string what)
    {
        if (!holds)
        {
            throw new FuzzException(what);
        }
    }

    /// <summary>Steps a ball, and holds that the step is short and ends somewhere.</summary>
    protected static void MustBeShort(Simulator simulator, ref BallState state, double step, long most = MostEvaluations)
    {
        var log = new StepLog(1);
        simulator.Step(ref state, step, log);
        Must(log.Evaluations <= most, "a step has more evaluations than it may");
        MustBeFinite(in state);
    }

    /// <summary>Holds that a ball is somewhere.</summary>
    protected static void MustBeFinite(in BallState state) => Must(
        state.Position.IsFinite && state.Velocity.IsFinite && state.Spin.IsFinite && double.IsFinite(state.Time)
        && Math.Abs(state.Orientation.LengthSquared - 1) < 1e-5,
        "a ball is not finite");
}
