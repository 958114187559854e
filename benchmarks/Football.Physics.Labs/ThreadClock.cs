using System.Diagnostics;
using System.Runtime.InteropServices;

namespace FootballPhysics.Labs;

/// <summary>The processor time of the current thread, so that other threads and processes do not count. Outside Linux, it is the wall time.</summary>
internal static partial class ThreadClock
{
    /// <summary>CLOCK_THREAD_CPUTIME_ID of Linux.</summary>
    private const int ThreadTime = 3;

    private static readonly bool s_isLinux = OperatingSystem.IsLinux();

    /// <summary>The time, ms, from an arbitrary start.</summary>
    public static double Milliseconds =>
        s_isLinux && Read(ThreadTime, out Time time) == 0 ? (time.Seconds * 1e3) + (time.Nanoseconds * 1e-6) : Stopwatch.GetTimestamp() * 1e3 / Stopwatch.Frequency;

    [LibraryImport("libc", EntryPoint = "clock_gettime")]
    private static partial int Read(int clock, out Time time);

    [StructLayout(LayoutKind.Sequential)]
    private readonly struct Time
    {
        public readonly nint Seconds;
        public readonly nint Nanoseconds;
    }
}
