namespace Football.Physics;

/// <summary>What the published laws compute once a step: the branch it is locked to, factors of the spin, and series about its start.</summary>
internal struct PublishedStep
{
    /// <summary>Branch of the drag law.</summary>
    public DragBranch Branch;

    /// <summary>Spin at the start, rad/s, and its reciprocal (0 for none).</summary>
    public double Spin;

    /// <summary>1/Spin, or 0.</summary>
    public double PerSpin;

    /// <summary>Factor of the spin decay's power of |u|²; 0 for a ball without spin, which stays without.</summary>
    public double Decay;

    /// <summary>Factor of the drag's power of |u|².</summary>
    public double Drag;

    /// <summary>Factor of the lift's first power of |u|².</summary>
    public double Lift;

    /// <summary>Factor of the lift's second power of |u|².</summary>
    public double LiftByDrag;

    /// <summary>|u|² at the start.</summary>
    public double SpeedSquared;

    /// <summary>Drag at the start.</summary>
    public double StartDrag;

    /// <summary>Lift at the start as if C_D were 0.</summary>
    public double StartLift;

    /// <summary>What C_D takes from that.</summary>
    public double StartLiftByDrag;

    /// <summary>Spin decay at the start, but for what the spin adds to it.</summary>
    public double StartDecay;

    /// <summary>(r|ω|/2|u|)² at the start.</summary>
    public double StartRatio;

    /// <summary>Whether the later stages are near enough to the start for the series.</summary>
    public bool Near;

    /// <summary>The series; only where <see cref="Near"/> is true.</summary>
    public PublishedSeries Series;
}
