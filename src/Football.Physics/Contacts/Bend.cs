namespace FootballPhysics.Contacts;

/// <summary>The curvature of a surface below a ball, 1/m: negative if the surface rises towards the ball, positive if it falls away.</summary>
/// <remarks>
/// Of two surfaces that touch the ball with the same normal, the one that curves least presses against the ball in the next instant: the hollow of a pipe
/// before the ground, the ground before the edge of a box.
/// </remarks>
internal readonly struct Bend
{
    /// <summary>The curvature in the direction of motion.</summary>
    public readonly double Along;

    /// <summary>The sum of both principal curvatures.</summary>
    private readonly double _sum;

    /// <param name="at">The surface at the ball.</param>
    /// <param name="velocity">The velocity of the ball relative to the shape, m/s.</param>
    public Bend(in ShapePoint at, in Vector3d velocity)
    {
        if (at.IsFlat)
        {
            return;
        }

        double squared = velocity.LengthSquared;
        SymmetricMatrix3d curvature = at.Curvature;
        _sum = curvature.XX + curvature.YY + curvature.ZZ;
        Along = squared > ContactTolerances.Standstill * ContactTolerances.Standstill ? Vector3d.Dot(in velocity, curvature * velocity) / squared : 0;
    }

    /// <summary>Returns a negative number if this surface rises more than another one, 0 if both curve alike.</summary>
    public double CompareTo(in Bend other)
    {
        double along = Along - other.Along;
        double sum = _sum - other._sum;
        return Math.Abs(along) > ContactTolerances.SameBend ? along : Math.Abs(sum) > ContactTolerances.SameBend ? sum : 0;
    }
}
