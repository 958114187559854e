namespace FootballPhysics.Labs.Pipes;

/// <summary>A quarter circle that rises from level ground to an upright wall: straight, as a quarter pipe, or around a disc, as a bowl.</summary>
/// <param name="radius">Radius of the quarter circle, m.</param>
/// <param name="foot">The foot of a straight pipe, or the centre of a bowl.</param>
/// <param name="heading">The horizontal direction in which a straight pipe rises; zero for a bowl.</param>
/// <param name="disc">The radius of the level bottom of a bowl, m.</param>
/// <param name="stated">The concave curvature that the shape states, relative to the true one.</param>
internal sealed class HollowWall(double radius, Vector3d foot, Vector3d heading, double disc, double stated = 1) : IShape
{
    private readonly bool _isBowl = heading == Vector3d.Zero;

    public double MaximumConcaveCurvature => stated / radius;

    /// <summary>The bounds of a straight pipe along an axis begin at its foot, so that it does not contain the level ground before it.</summary>
    public Bounds3d Bounds { get; init; } = Bounds3d.Everywhere;

    public ShapePoint At(in Vector3d point)
    {
        Vector3d from = point - foot;
        double across = from.Horizontal.Length;
        Vector3d outward = !_isBowl ? heading : across > 1e-12 ? from.Horizontal / across : new Vector3d(1, 0, 0);
        double along = _isBowl ? across - disc : Vector3d.Dot(from, heading);
        double below = radius - from.Y;
        Vector3d tangent = Vector3d.Cross(Vector3d.Up, outward);
        if (along <= 0 && (below > 0 || from.Y < radius - along))
        {
            return new ShapePoint(from.Y, Vector3d.Up, default);
        }

        double distance = below <= 0 ? along : Math.Max(Math.Sqrt((along * along) + (below * below)), 1e-12);
        Vector3d normal = below <= 0 ? -outward : (below * Vector3d.Up - along * outward) / distance;
        SymmetricMatrix3d curvature = below <= 0 ? default : -1.0 * SymmetricMatrix3d.AroundAxis(normal, tangent, distance);
        if (_isBowl)
        {
            curvature -= -Vector3d.Dot(normal, outward) / Math.Max(across, 1e-12) * SymmetricMatrix3d.OuterProduct(tangent);
        }

        return new ShapePoint(radius - distance, normal, curvature);
    }
}
