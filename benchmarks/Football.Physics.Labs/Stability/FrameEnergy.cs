namespace FootballPhysics.Labs.Stability;

/// <summary>The energy that a ball has gained in a frame, and how much of that can be the method's own error and rounding.</summary>
/// <param name="Gained">Energy at the end less energy at the start, J.</param>
/// <param name="ByMethod">What the method makes at most in the pieces that it took, J.</param>
/// <param name="ByContact">What finding contact, and slip at its end, leaves at most, J.</param>
/// <param name="ByRounding">What rounding makes at most, J.</param>
internal readonly record struct FrameEnergy(double Gained, double ByMethod, double ByContact, double ByRounding)
{
    /// <summary>More than this, J, was made out of nothing.</summary>
    public double Allowed => ByMethod + ByContact + ByRounding;

    public bool Holds => Gained <= Allowed;

    /// <summary>Which share of what the method may make it has made; 0 where rounding could make as much.</summary>
    public double Share => ByMethod > ByContact + ByRounding ? Gained / Allowed : 0;
}
