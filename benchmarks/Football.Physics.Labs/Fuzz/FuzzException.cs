namespace FootballPhysics.Labs.Fuzz;

/// <summary>Thrown when an input leads to an invalid result.</summary>
internal sealed class FuzzException(string what) : Exception(what);
