namespace FootballPhysics.Labs.Stability;

/// <summary>The energy that a ball gained in a frame, and the part of it that the method's own error and rounding can explain.</summary>
/// <param name="Gained">Energy at the end less energy at the start, J.</param>
/// <param name="ByMethod">The most that the method creates in its pieces, J.</param>
/// <param name="ByContact">The most that finding contact, and the slip at its end, creates, J.</param>
/// <param name="ByRounding">The most that rounding creates, J.</param>
internal readonly record struct FrameEnergy(double Gained, double ByMethod, double ByContact, double ByRounding)
{
    /// <summary>A larger gain, J, was created from nothing.</summary>
    public double Allowed => ByMethod + ByContact + ByRounding;

    public bool Holds => Gained <= Allowed;

    /// <summary>The share of the method's allowance that it used; 0 if rounding alone could create as much.</summary>
    public double Share => ByMethod > ByContact + ByRounding ? Gained / Allowed : 0;
}
