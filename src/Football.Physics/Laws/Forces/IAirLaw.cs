namespace FootballPhysics.Laws;

/// <summary>One aerodynamic force or torque: drag, Magnus force or spin decay, independent of the others.</summary>
/// <remarks>
/// <see cref="Factor"/> is D in a = −D u for drag, and L in a = L (ω̂ × u) for the Magnus force. For spin decay it is the angular deceleration along
/// the spin, in rad/s². All are at least 0, except for a negative constant Magnus coefficient.
/// </remarks>
internal interface IAirLaw
{
    /// <summary>Reads the constants of the law from the scene.</summary>
    void Prepare(Scene scene);

    /// <summary>Returns the factor of the law in a flow.</summary>
    double Factor(in AirFlow flow);

    /// <summary>An upper bound on the factor, relative to the motion that it changes, in 1/s.</summary>
    RateBound Bound { get; }
}

/// <summary>The values of up to four functions of one variable. The law defines their meaning.</summary>
internal struct LawFactors
{
    public double First;
    public double Second;
    public double Third;
    public double Fourth;
}
