namespace FootballPhysics.Scenarios.Input;

/// <summary>The numbers that are allowed where the library has no range of its own, with their unit.</summary>
public readonly record struct NumberRange(double Low, double High, string Unit)
{
    public bool Contains(double value) => value >= Low && value <= High;

    public override string ToString() => FormattableString.Invariant($"{Low} … {High} {Unit}");
}
