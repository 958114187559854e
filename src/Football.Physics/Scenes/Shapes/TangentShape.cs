namespace FootballPhysics.Scenes;

/// <summary>An approximation of a surface near its origin: a plane, or a sphere with the same curvature.</summary>
internal sealed class TangentShape : IShape, IExactHollow
{
    private Vector3d _normal = Vector3d.Up;
    private double _curvature;

    /// <inheritdoc/>
    public double MaximumConcaveCurvature => 0;

    /// <inheritdoc/>
    public Bounds3d Bounds => Bounds3d.Everywhere;

    /// <summary>Sets the normal and curvature.</summary>
    /// <param name="normal">The outward unit normal.</param>
    /// <param name="curvature">The curvature, in 1/m; at least 0.</param>
    public void Set(in Vector3d normal, double curvature)
    {
        _normal = normal;
        _curvature = curvature;
    }

    /// <inheritdoc/>
    public ShapePoint At(in Vector3d point)
    {
        double above = Vector3d.Dot(in point, in _normal);
        if (_curvature == 0)
        {
            return new ShapePoint(above, in _normal, SymmetricMatrix3d.Zero);
        }

        // d is the distance of the point p, n the normal, and κ the curvature.
        // d = |p + n/κ| − 1/κ = (2 p·n + κ p²)/(1 + √(1 + κ (2 p·n + κ p²))), without cancellation for small κ.
        double inner = (2.0 * above) + (_curvature * point.LengthSquared);
        double ratio = Math.Sqrt(Math.Max(0, 1.0 + (_curvature * inner)));
        double distance = inner / (1.0 + ratio);
        Vector3d normal = ratio > 0 ? ((_curvature * point) + _normal) / ratio : _normal;
        return ratio > 0 ? new ShapePoint(distance, in normal, Vector3d.Zero, ratio / _curvature) : new ShapePoint(distance, in normal, SymmetricMatrix3d.Zero);
    }
}
