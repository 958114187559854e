using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Shapes;

/// <summary>A sphere: a head, a fist.</summary>
public sealed class SphereShape : IShape, IExactHollow
{
    /// <summary>Creates a sphere.</summary>
    /// <param name="center">The centre, in m; components within ±1e6.</param>
    /// <param name="radius">The radius, in m; above 0, at most 1e6.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names it.</exception>
    public SphereShape(Vector3d center, double radius)
    {
        Check.Place("center", center);
        Check.Within("radius", radius, 0, Limits.Length, exclusiveLow: true);
        Center = center;
        Radius = radius;
    }

    /// <summary>The centre, in m.</summary>
    public Vector3d Center { get; }

    /// <summary>The radius, in m.</summary>
    public double Radius { get; }

    /// <inheritdoc/>
    double IShape.MaximumConcaveCurvature => 0;

    /// <inheritdoc/>
    public Bounds3d Bounds => Bounds3d.Around(Center, Radius, Radius, Radius);

    /// <inheritdoc/>
    public ShapePoint At(in Vector3d point)
    {
        // At the centre, every direction points outwards: use up.
        Vector3d from = point - Center;
        double l = from.Length;
        return l > 0 ? new ShapePoint(l - Radius, from / l, Vector3d.Zero, l) : new ShapePoint(-Radius, Vector3d.Up, SymmetricMatrix3d.Zero);
    }
}
