using System.Diagnostics;

namespace FootballPhysics.Labs.People;

/// <summary>Steps balls and records the largest cost of a step: time, memory, events.</summary>
internal sealed class StepMeter
{
    /// <summary>A step that takes longer, s, is repeated: another program may have delayed it.</summary>
    private const double Suspicious = 0.0005;
    private const int Repeats = 2;

    private readonly StepLog _again = new();

    /// <summary>The time limit of a step, s.</summary>
    public const double Longest = 0.001;

    /// <summary>The limit of events per step.</summary>
    public const int MostAllowed = 24;

    public long Steps { get; private set; }

    /// <summary>The slowest step, best of three from the same state, s.</summary>
    public Peak<double, FormattableString> Slowest { get; } = new($"");

    /// <summary>The number of steps that took longer than a millisecond.</summary>
    public long Slow { get; private set; }

    /// <summary>The number of bytes that all steps allocated.</summary>
    public long Bytes { get; private set; }

    public Peak<int, FormattableString> Events { get; } = new($"");

    /// <summary>The largest number of evaluations of the right-hand side in a step: its work, independent of other programs.</summary>
    public Peak<long, FormattableString> Evaluations { get; } = new($"");

    /// <summary>Runs one step.</summary>
    public void Step(Ball ball, double duration, FormattableString at)
    {
        BallState start = ball.State;
        long bytes = GC.GetAllocatedBytesForCurrentThread();
        long began = Stopwatch.GetTimestamp();
        ball.Step(duration);
        double took = Stopwatch.GetElapsedTime(began).TotalSeconds;
        Bytes += GC.GetAllocatedBytesForCurrentThread() - bytes;
        for (int i = 0; i < Repeats && took > Suspicious; i++)
        {
            BallState state = start;
            _again.Clear();
            began = Stopwatch.GetTimestamp();
            ball.Simulator.Step(ref state, duration, _again);
            took = Math.Min(took, Stopwatch.GetElapsedTime(began).TotalSeconds);
        }

        Steps++;
        Slow += took > Longest ? 1 : 0;
        Slowest.See(took, at);
        Evaluations.See(ball.Evaluations, at);
        Events.See(ball.Events.Count, at);
    }
}
