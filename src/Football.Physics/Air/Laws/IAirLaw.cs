namespace FootballPhysics;

/// <summary>One aerodynamic force or torque: drag, Magnus force or spin decay. It knows nothing of the others.</summary>
/// <remarks>
/// <see cref="Factor"/> is, for drag, D in a = −D u; for the Magnus force, L in a = L (ω̂ × u); for spin decay, the angular
/// deceleration along the spin (rad/s²). All three are in SI and not negative, but for a negative constant Magnus coefficient.
/// </remarks>
internal interface IAirLaw
{
    /// <summary>Reads the law's constants from the scene.</summary>
    void Prepare(Scene scene);

    /// <summary>The law's factor in a flow.</summary>
    double Factor(in AirFlow flow);

    /// <summary>An upper bound for the factor, relative to the motion it changes, as a + b: a per m/s of speed, b per rad/s of spin, c at rest (all 1/s).</summary>
    RateBound Bound { get; }
}

/// <summary>The values of up to four functions of one number; the law says what each of them is.</summary>
internal struct LawFactors
{
    public double First;
    public double Second;
    public double Third;
    public double Fourth;
}
