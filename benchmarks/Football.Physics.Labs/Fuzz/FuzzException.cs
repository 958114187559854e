namespace FootballPhysics.Labs.Fuzz;

/// <summary>An input led to what must not be.</summary>
internal sealed class FuzzException(string what) : Exception(what);
