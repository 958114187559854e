namespace FootballPhysics.Labs.Derivatives;

/// <summary>A difference quotient of the end of a flight.</summary>
/// <param name="Place">The change of the position at the end.</param>
/// <param name="Time">The change of the time at the end.</param>
/// <param name="PlaceError">The uncertainty of the position's change: the largest component of its difference from the quotients of twice and half the width.</param>
/// <param name="TimeError">The uncertainty of the time's change.</param>
internal readonly record struct Difference(Vector3d Place, double Time, double PlaceError, double TimeError);
