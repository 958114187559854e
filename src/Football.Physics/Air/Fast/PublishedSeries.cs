namespace Football.Physics;

/// <summary>The published laws as series about a step's start, in ε = |u|²/|u₀|² − 1 and δ = |ω|/|ω₀| − 1.</summary>
internal struct PublishedSeries
{
    /// <summary>1/|u₀|², s²/m².</summary>
    public double PerSpeedSquared;

    /// <summary>1/|ω₀|, s, or 0 for a ball without spin.</summary>
    public double PerSpin;

    /// <summary>Drag along ε, at δ = 0.</summary>
    public Quartic Drag;

    /// <summary>Lift along ε, at δ = 0.</summary>
    public Quartic Lift;

    /// <summary>The part of the lift that goes with the drag coefficient, along ε.</summary>
    public double LiftByDrag0;

    /// <summary>Its factor of ε.</summary>
    public double LiftByDrag1;

    /// <summary>Its factor of ε².</summary>
    public double LiftByDrag2;

    /// <summary>Spin decay along ε.</summary>
    public double Decay0;

    /// <summary>Its factor of ε.</summary>
    public double Decay1;

    /// <summary>Its factor of ε².</summary>
    public double Decay2;

    /// <summary>Its factor of ε³.</summary>
    public double Decay3;

    /// <summary>Its factor of δ.</summary>
    public double DecayBySpin;
}
