namespace FootballPhysics.Batch;

/// <summary>Terms of the spin that a law in lanes computes once a step. No more than four fields: the compiler keeps them in registers.</summary>
#if NET8_0_OR_GREATER
internal struct LaneSpin<F>
    where F : struct, ILane<F>
#else
internal struct LaneSpin<TLane>
#endif
{
    /// <summary>|ω| at the start, rad/s.</summary>
    public F Rate;

    /// <summary>1/|ω|, or 0 without spin.</summary>
    public F PerRate;

    /// <summary>The spin's factor of the drag.</summary>
    public F Drag;

    /// <summary>The spin's factor of the lift.</summary>
    public F Lift;
}
