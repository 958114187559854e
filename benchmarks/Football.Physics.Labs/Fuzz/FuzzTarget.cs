using System.Diagnostics;
using System.Diagnostics.CodeAnalysis;

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

    /// <summary>Reads an input. Returns false if the reader rejects it: with a <see cref="FormatException"/>, or by the name of a parameter.</summary>
    protected static bool IsAccepted<T>(Func<T> read, [MaybeNullWhen(false)] out T value, string? parameter = null)
    {
        try
        {
            value = read();
            return true;
        }
        catch (Exception e) when (e is FormatException || (e is ArgumentException refusal && refusal.ParamName == parameter && parameter is not null))
        {
            value = default;
            return false;
        }
    }

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

/// <summary>Tries inputs of one kind, and counts the results.</summary>
internal sealed class FuzzRun(FuzzTarget target, long seed)
{
    /// <summary>An input that takes longer, ms, is tried again; it is a finding if every try takes longer.</summary>
    private const double Slow = 10_000;

    /// <summary>The number of further tries, and the time limit of an input, ms.</summary>
    private const int Again = 4;
    private const double Suspicious = 2000;

    /// <summary>The limit of memory that an input may allocate, bytes.</summary>
    private const long MostMemory = 64L << 20;

    private const int MostMutations = 4;

    private readonly Lock _lock = new();

    public FuzzTarget Target { get; } = target;

    /// <summary>The inputs that were refused, and those with a right result.</summary>
    public LabCounts Counts { get; } = new();

    /// <summary>The longest time that an input took, ms, and the number of that input.</summary>
    public Peak<double, long> Slowest { get; } = new(0);

    /// <summary>The findings: the number of times, and the first input that leads to each.</summary>
    public SortedDictionary<string, (long Times, long Index)> Findings { get; } = new(StringComparer.Ordinal);

    /// <summary>Returns the input with a number.</summary>
    public byte[] Input(long index)
    {
        var random = new SeededRandom(SeededRandom.Mix(unchecked((long)SeededRandom.Mix(seed, Target.Name.Length)), index));
        return Target.Make(random, random.Below(MostMutations + 1));
    }

    /// <summary>Tries the input with a number.</summary>
    public void Try(long index)
    {
        byte[] input = Input(index);
        long before = GC.GetAllocatedBytesForCurrentThread();
        (bool? refused, string? found, double time) = Try(input);
        long allocated = GC.GetAllocatedBytesForCurrentThread() - before;
        for (int i = 0; i < Again && found is null && time > Suspicious; i++)
        {
            // The minimum excludes the time of other programs on the machine.
            time = Math.Min(time, Try(input).Milliseconds);
        }

        found ??= time > Slow ? $"slow: more than {Slow} ms" : null;

        if (found is null && allocated > MostMemory)
        {
            found = $"memory: more than {MostMemory >> 20} MiB allocated";
        }

        lock (_lock)
        {
            Slowest.See(time, index);
            Counts.AddIf(found is null && refused == true, "refused");
            Counts.AddIf(found is null && refused == false, "right");
            if (found is not null)
            {
                (long times, long first) = Findings.GetValueOrDefault(found, (0, long.MaxValue));
                Findings[found] = (times + 1, Math.Min(first, index));
            }
        }
    }

    private (bool? Refused, string? Found, double Milliseconds) Try(byte[] input)
    {
        long start = Stopwatch.GetTimestamp();
        bool? refused = null;
        string? found = null;
        try
        {
            refused = Target.Try(input);
        }
        catch (FuzzException e)
        {
            found = e.Message;
        }
        catch (Exception e)
        {
            // Any other exception of the library or the reader is a finding.
            found = $"{e.GetType().Name}: {e.StackTrace?.Split('\n')[0].Trim()}";
        }

        return (refused, found, Stopwatch.GetElapsedTime(start).TotalMilliseconds);
    }
}
