namespace FootballPhysics;

/// <summary>One number of a part of the scene: its name in JSON and messages, unit, range and access.</summary>
/// <typeparam name="T">The part.</typeparam>
/// <param name="name">Name, as in a scenario.</param>
/// <param name="unit">Unit; empty for a plain number.</param>
/// <param name="meaning">What it is.</param>
/// <param name="evidence">What the default rests on: measured, law, derived, published or guess, and the source.</param>
/// <param name="least">The least value.</param>
/// <param name="most">The largest value; infinite: the field may be infinite, which JSON writes as null.</param>
/// <param name="get">Reads the number.</param>
/// <param name="with">Copies the part with another number.</param>
/// <param name="isAboveLeast">True when the least value itself is not allowed.</param>
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
