namespace FootballPhysics.Native;

/// <summary>Watches a long call: shows its progress, and cancels it. Set bytes to sizeof(fp_watch) and the other members to 0 before the call.</summary>
internal struct NativeWatch
{
    /// <summary>sizeof(fp_watch). The call compares it with the size in the library.</summary>
    public int Bytes;

    /// <summary>0. Another thread or a signal handler sets it to 1 to cancel the call, which then returns FP_CANCELLED soon. If it is 1 before, the call returns at once.</summary>
    public int Cancel;

    /// <summary>The progress, 0 ... 1. The call writes it; another thread may read it during the call.</summary>
    public double Progress;
}
