namespace FootballPhysics.Batch;

/// <summary>The terms of the spin that a lane law computes once per step. At most four fields, so that the compiler keeps them in registers.</summary>
#if NET8_0_OR_GREATER
internal struct LaneSpin<F>
    where F : struct, ILane<F>
#else
internal struct LaneSpin<TLane>
#endif
{
    /// <summary>|ω| at the start, rad/s.</summary>
    public F Rate;

    /// <summary>1/|ω|; 0 without spin.</summary>
    public F PerRate;

    /// <summary>The factor of the spin on the drag.</summary>
    public F Drag;

    /// <summary>The factor of the spin on the lift.</summary>
    public F Lift;
}
