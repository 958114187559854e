using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Fuzz;

/// <summary>One kind of input from an untrusted source.</summary>
internal abstract class FuzzTarget
{
    /// <summary>All kinds of inputs.</summary>
    public static IReadOnlyList<FuzzTarget> All { get; } = [new ScenarioFuzz(), new KickLogFuzz(), new SegmentFuzz(), new SnapshotFuzz()];

    /// <summary>The limit of evaluations per step, docs/troubleshooting.md.</summary>
    private const long MostEvaluations = 32_768;

    /// <summary>The name of the inputs, in the plural.</summary>
    public abstract string Name { get; }

    /// <summary>Makes an input from a valid one.</summary>
    /// <param name="random">The random numbers.</param>
    /// <param name="mutations">The number of changes.</param>
    public abstract byte[] Make(SeededRandom random, int mutations);

    /// <summary>Reads an input and uses it.</summary>
    /// <returns>True if the input was rejected, false if it was accepted and the result is valid.</returns>
    /// <exception cref="FuzzException">The result is invalid.</exception>
    public abstract bool Try(byte[] input);

    /// <summary>Returns the input as text for messages.</summary>
    public virtual string Text(byte[] input) => Convert.ToHexString(input);

    /// <summary>Throws if a condition does not hold.</summary>
    protected static void Must(bool holds, string what)
    {
        if (!holds)
        {
            throw new FuzzException(what);
        }
    }

    /// <summary>Steps a ball; throws unless the step is short and ends at a finite position.</summary>
    protected static void MustBeShort(Simulator simulator, ref BallState state, double step, long most = MostEvaluations)
    {
        var log = new StepLog(1);
        simulator.Step(ref state, step, log);
        Must(log.Evaluations <= most, "a step has more evaluations than it may");
        MustBeFinite(in state);
    }

    /// <summary>Throws unless the ball's state is finite.</summary>
    protected static void MustBeFinite(in BallState state) => Must(
        state.Position.IsFinite && state.Velocity.IsFinite && state.Spin.IsFinite && double.IsFinite(state.Time)
        && Math.Abs(state.Orientation.LengthSquared - 1) < 1e-5,
        "a ball is not finite");
}

/// <summary>Thrown when an input leads to an invalid result.</summary>
internal sealed class FuzzException(string what) : Exception(what);
