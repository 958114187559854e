namespace FootballPhysics.Shapes;

/// <summary>A sphere: a head, a fist.</summary>
public sealed class SphereShape : IShape
{
    /// <summary>Makes a sphere.</summary>
    /// <param name="center">Its centre, m; components within ±1e6.</param>
    /// <param name="radius">Its radius, m; above 0, at most 1e6.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names it.</exception>
    public SphereShape(Vector3d center, double radius)
    {
        Check.Place("center", center);
        Check.Within("radius", radius, 0, Limits.Length, exclusiveLow: true);
        Center = center;
        Radius = radius;
    }

    /// <summary>Its centre, m.</summary>
    public Vector3d Center { get; }

    /// <summary>Its radius, m.</summary>
    public double Radius { get; }

    /// <inheritdoc/>
    public double MaximumConcaveCurvature => 0;

    /// <inheritdoc/>
    public Bounds3d Bounds => Bounds3d.Around(Center, Radius, Radius, Radius);

    /// <inheritdoc/>
    public ShapePoint At(in Vector3d point)
    {
        // At the centre itself every direction is outward: up is taken.
        Vector3d from = point - Center;
        double l = from.Length;
        Vector3d normal = l > 0 ? from / l : Vector3d.Up;
        return new ShapePoint(l - Radius, in normal, l > 0 ? SymmetricMatrix3d.AroundPoint(in normal, l) : SymmetricMatrix3d.Zero);
    }
}
