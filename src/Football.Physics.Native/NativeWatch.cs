namespace FootballPhysics.Native;

/// <summary>Watches a long call: shows its progress, and cancels it. Set bytes to sizeof(fp_watch) and the other members to 0 before the call.</summary>
internal struct NativeWatch
{
    /// <summary>sizeof(fp_watch); the call compares it with its own.</summary>
    public int Bytes;

    /// <summary>0. Another thread or a signal handler sets it to 1 to cancel the call, which then returns FP_CANCELLED soon. A call with 1 returns at once.</summary>
    public int Cancel;

    /// <summary>The progress, 0 ... 1, which the call writes and another thread may read meanwhile.</summary>
    public double Progress;
}
