using System.Diagnostics;

namespace FootballPhysics.Labs.People;

/// <summary>Steps balls and keeps what a step took at most: time, memory, events.</summary>
internal sealed class StepMeter
{
    /// <summary>More, s, is worth repeating: the machine may have done something else.</summary>
    private const double Suspicious = 0.0005;
    private const int Repeats = 2;

    private readonly StepLog _again = new();

    /// <summary>More than this is too slow, s.</summary>
    public const double Longest = 0.001;

    /// <summary>More than this in a step is too many.</summary>
    public const int MostAllowed = 24;

    public long Steps { get; private set; }

    /// <summary>The slowest step, best of three from the same state, s.</summary>
    public double Slowest { get; private set; }

    /// <summary>How many took longer than a millisecond.</summary>
    public long Slow { get; private set; }

    /// <summary>Bytes that steps allocated, all together.</summary>
    public long Bytes { get; private set; }

    public int MostEvents { get; private set; }

    /// <summary>Right-hand sides that a step evaluated at most: its work, whatever else the machine does.</summary>
    public long MostEvaluations { get; private set; }

    /// <summary>Where that was.</summary>
    public string MostEvaluationsAt { get; private set; } = "";

    /// <summary>Where that was.</summary>
    public string MostEventsAt { get; private set; } = "";

    /// <summary>Where the slowest step was.</summary>
    public string SlowestAt { get; private set; } = "";

    /// <summary>One step.</summary>
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

        if (ball.Evaluations > MostEvaluations)
        {
            MostEvaluations = ball.Evaluations;
            MostEvaluationsAt = FormattableString.Invariant(at);
        }

        Steps++;
        Slow += took > Longest ? 1 : 0;
        if (took > Slowest)
        {
            Slowest = took;
            SlowestAt = FormattableString.Invariant(at);
        }

        if (ball.Events.Count > MostEvents)
        {
            MostEvents = ball.Events.Count;
            MostEventsAt = FormattableString.Invariant(at);
        }
    }
}
