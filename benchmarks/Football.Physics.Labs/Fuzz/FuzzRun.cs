using System.Diagnostics;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Fuzz;

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

    public long Refused { get; private set; }

    public long Right { get; private set; }

    /// <summary>The longest time that an input took, ms.</summary>
    public double Slowest { get; private set; }

    /// <summary>The input that took longest.</summary>
    public long SlowestInput { get; private set; }

    /// <summary>The findings: the number of times, and the first input that leads to each.</summary>
    public SortedDictionary<string, (long Times, long Index)> Findings { get; } = new(StringComparer.Ordinal);

    /// <summary>Returns the input with a number.</summary>
    public byte[] Input(long index)
    {
        var random = new SeededRandom(SeededRandom.Mix(KindSeed(), index));
        return Target.Make(random, random.Below(MostMutations + 1));
    }

    /// <summary>Tries the input with a number.</summary>
    public void Try(long index)
    {
        byte[] input = Input(index);
        long before = GC.GetAllocatedBytesForCurrentThread();
        (bool? refused, string? found, double time) = Try(input);
        for (int i = 0; i < Again && found is null && time > Suspicious; i++)
        {
            // The minimum excludes the time of other programs on the machine.
            time = Math.Min(time, Try(input).Milliseconds);
        }

        found ??= time > Slow ? $"slow: more than {Slow} ms" : null;

        if (found is null && GC.GetAllocatedBytesForCurrentThread() - before > MostMemory)
        {
            found = $"memory: more than {MostMemory >> 20} MiB allocated";
        }

        lock (_lock)
        {
            (Slowest, SlowestInput) = time > Slowest ? (time, index) : (Slowest, SlowestInput);
            Refused += found is null && refused == true ? 1 : 0;
            Right += found is null && refused == false ? 1 : 0;
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

    private long KindSeed() => unchecked((long)SeededRandom.Mix(seed, Target.Name.Length));
}
