namespace FootballPhysics.Labs.Stability;

/// <summary>What went wrong in a scene.</summary>
/// <param name="Check">The invariant that was broken.</param>
/// <param name="Detail">Numbers.</param>
internal sealed record StressFailure(string Check, string Detail);
