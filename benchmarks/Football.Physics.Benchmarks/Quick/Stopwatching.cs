using System.Diagnostics;
using System.Runtime;

namespace FootballPhysics.Benchmarks;

/// <summary>Times a subject against a yardstick in alternating rounds, so that a change of clock affects both.</summary>
internal static class Stopwatching
{
    /// <summary>The least number of rounds for a median.</summary>
    public const int LeastRounds = 15;

    private const int MostRounds = 2000;
    private const int WarmUpCalls = 40;

    /// <summary>Limits of the calls of one workload in a pass: after this time, s, and this number of calls, a slow workload has called the library often enough.</summary>
    private const double WarmUpSeconds = 0.1;
    private const int LeastCalls = 12;
    private const int LeastPasses = 5;
    private const int MostPasses = 16;

    /// <summary>A call that takes longer, ns, is seldom free of interruptions.</summary>
    private const double LongCall = 1e6;

    private static double _sink;

    /// <summary>Calls all workloads often enough for the runtime to compile the final code, with pauses for the compilation.</summary>
    public static void WarmUp(IReadOnlyCollection<Workload> workloads)
    {
        // Tier 0, counted calls, tier 1: each begins after a pause without new compilations, 100 ms, or ten times that on one core. Done when two passes in a row leave nothing to compile.
        bool slow = Environment.ProcessorCount == 1 && Environment.GetEnvironmentVariable(Child.DelayOnOneCore) != "1";
        int pause = slow ? 1100 : 150;
        int quiet = 0;
        for (int pass = 0; pass < LeastPasses || (pass < MostPasses && quiet < 2); pass++)
        {
            long compiled = JitInfo.GetCompiledMethodCount();
            foreach (Workload workload in workloads)
            {
                long began = Stopwatch.GetTimestamp();
                for (int i = 0; i < LeastCalls || (i < WarmUpCalls && Stopwatch.GetElapsedTime(began).TotalSeconds < WarmUpSeconds); i++)
                {
                    _sink += workload.Run();
                }
            }

            Thread.Sleep(pause);
            quiet = JitInfo.GetCompiledMethodCount() == compiled ? quiet + 1 : 0;
        }
    }

    /// <summary>Measures for about the given time, but at least the least number of rounds.</summary>
    /// <param name="subject">The measured workload.</param>
    /// <param name="yardstick">The workload that it is compared with.</param>
    /// <param name="seconds">The time, s.</param>
    /// <param name="ofProcessor">True if calls that are so long that other programs interrupt most of them are measured in processor time, which includes all threads.</param>
    public static Timing Measure(Workload subject, Workload yardstick, double seconds, bool ofProcessor = false)
    {
        // Other systems report processor time in units of several ms.
        bool isLong = ofProcessor && OperatingSystem.IsLinux() && Math.Max(Time(subject, false) * subject.Operations, Time(yardstick, false) * yardstick.Operations) > LongCall;
        var ours = new List<double>();
        var theirs = new List<double>();
        var ratios = new List<double>();
        long start = Stopwatch.GetTimestamp();
        while (ratios.Count < LeastRounds || (Stopwatch.GetElapsedTime(start).TotalSeconds < seconds && ratios.Count < MostRounds))
        {
            double a = Time(subject, isLong);
            double b = Time(yardstick, isLong);
            ours.Add(a);
            theirs.Add(b);
            ratios.Add(a / b);
        }

        long before = GC.GetAllocatedBytesForCurrentThread();
        _sink += subject.Run();
        long allocated = GC.GetAllocatedBytesForCurrentThread() - before;
        return new Timing(Median(ours), Median(theirs), Median(ratios), (double)allocated / subject.Operations);
    }

    /// <summary>Returns the median.</summary>
    public static double Median(List<double> values)
    {
        values.Sort();
        int middle = values.Count / 2;
        return values.Count % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
    }

    /// <summary>Returns the time of an operation, ns.</summary>
    private static double Time(Workload workload, bool ofProcessor)
    {
        if (ofProcessor)
        {
            TimeSpan before = Environment.CpuUsage.TotalTime;
            _sink += workload.Run();
            return (Environment.CpuUsage.TotalTime - before).TotalNanoseconds / workload.Operations;
        }

        long start = Stopwatch.GetTimestamp();
        _sink += workload.Run();
        return (Stopwatch.GetTimestamp() - start) * (1e9 / Stopwatch.Frequency) / workload.Operations;
    }
}
