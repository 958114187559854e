namespace FootballPhysics.Scenarios.Input;

/// <summary>The range of a number for which the library defines none, with its unit.</summary>
public readonly record struct NumberRange(double Low, double High, string Unit)
{
    public bool Contains(double value) => value >= Low && value <= High;

    public override string ToString() => FormattableString.Invariant($"{Low} … {High} {Unit}");
}
