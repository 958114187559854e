namespace FootballPhysics.Labs.Hostile;

/// <summary>One place where something was found.</summary>
/// <param name="Scene">Number of the scene.</param>
/// <param name="Size">How bad it is, in the unit of its kind.</param>
/// <param name="Absurdity">How many decades the scene lies outside ordinary numbers.</param>
/// <param name="Detail">Numbers.</param>
internal readonly record struct HostileSighting(ulong Scene, double Size, double Absurdity, string Detail);
