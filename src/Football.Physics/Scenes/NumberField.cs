namespace FootballPhysics.Scenes;

/// <summary>One number of a part of the scene: its name in JSON and messages, unit, range and access.</summary>
/// <typeparam name="T">The type of the part.</typeparam>
/// <param name="name">The name, as in a scenario.</param>
/// <param name="unit">The unit; empty for a dimensionless number.</param>
/// <param name="meaning">A short description.</param>
/// <param name="evidence">The evidence of the default: measured, law, derived, published or guess, and the source.</param>
/// <param name="least">The minimum.</param>
/// <param name="most">The maximum. If it is infinite, the number may be infinite too, and JSON writes that as null.</param>
/// <param name="get">Returns the number.</param>
/// <param name="with">Returns a copy of the part with another number.</param>
/// <param name="isAboveLeast">True if the minimum itself is not allowed.</param>
internal sealed class NumberField<T>(string name, string unit, string meaning, string evidence, double least, double most, Func<T, double> get, Func<T, double, T> with, bool isAboveLeast = false)
{
    public string Name { get; } = name;

    public string Unit { get; } = unit;

    public string Meaning { get; } = meaning;

    public string Evidence { get; } = evidence;

    public double Least { get; } = least;

    public double Most { get; } = most;

    public bool IsAboveLeast { get; } = isAboveLeast;

    public double Get(T part) => get(part);

    public T With(T part, double value) => with(part, value);
}
