namespace FootballPhysics.Labs.Derivatives;

/// <summary>A difference quotient of the end of a flight.</summary>
/// <param name="Place">How the place at the end changes.</param>
/// <param name="Time">How its time changes.</param>
/// <param name="PlaceError">By how much the place's may be wrong: the largest component of what it differs by from those of twice and of half the width.</param>
/// <param name="TimeError">The same of the time's.</param>
internal readonly record struct Difference(Vector3d Place, double Time, double PlaceError, double TimeError);
