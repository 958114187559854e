namespace FootballPhysics.Tests;

/// <summary>Bytes that a call allocates once it is warm.</summary>
internal static class Allocation
{
    private const int Runs = 5;

    /// <summary>
    /// The least of some runs after a first one: what the runtime itself allocates on this thread while it recompiles is not the call's; what the call allocates
    /// is there every time.
    /// </summary>
    public static long Of(Action action)
    {
        action();
        long least = long.MaxValue;
        for (int i = 0; i < Runs; i++)
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            action();
            least = Math.Min(least, GC.GetAllocatedBytesForCurrentThread() - before);
        }

        return least;
    }
}
