using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Shapes;

/// <summary>A capsule, a segment with a radius: a post, a crossbar, a leg, an arm.</summary>
public sealed class CapsuleShape : IShape, IExactHollow
{
    private readonly Vector3d _axis;
    private readonly Vector3d _middle;
    private readonly double _half;

    /// <summary>Creates a capsule.</summary>
    /// <param name="from">One end of the segment, in m; components within ±1e6.</param>
    /// <param name="to">The other end, in m; different from the first.</param>
    /// <param name="radius">The radius around the segment, in m; above 0, at most 1e6.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names it.</exception>
    public CapsuleShape(Vector3d from, Vector3d to, double radius)
    {
        Check.Place("from", from);
        Check.Place("to", to);
        Check.Within("radius", radius, 0, Limits.Length, exclusiveLow: true);
        From = from;
        To = to;
        Radius = radius;
        double length = (to - from).Length;
        if (!(length > 0))
        {
            throw Check.Refusal("to", to.ToString(), "a point other than from");
        }

        _axis = (to - from) / length;
        _middle = 0.5 * (from + to);
        _half = 0.5 * length;
    }

    /// <summary>One end of the segment, in m.</summary>
    public Vector3d From { get; }

    /// <summary>The other end of the segment, in m.</summary>
    public Vector3d To { get; }

    /// <summary>The radius around the segment, in m.</summary>
    public double Radius { get; }

    /// <inheritdoc/>
    double IShape.MaximumConcaveCurvature => 0;

    /// <inheritdoc/>
    public Bounds3d Bounds => Bounds3d.Around(From, Radius, Radius, Radius).Union(Bounds3d.Around(To, Radius, Radius, Radius));

    /// <inheritdoc/>
    public ShapePoint At(in Vector3d point)
    {
        // Measure from the midpoint, so that both ends give bit-identical results.
        Vector3d from = point - _middle;
        double along = Vector3d.Dot(in from, in _axis);

        // Next to the segment, the surface is a cylinder; beyond the ends, it is a sphere.
        bool beside = Math.Abs(along) < _half;
        Vector3d nearest = (beside ? along : along > 0 ? _half : -_half) * _axis;
        Vector3d away = from - nearest;
        double l = away.Length;

        // A point on the axis has no unique normal: use any direction perpendicular to the axis.
        if (!(l > 0))
        {
            return new ShapePoint(-Radius, Across(in _axis), SymmetricMatrix3d.Zero);
        }

        Vector3d normal = away / l;
        return new ShapePoint(l - Radius, in normal, beside ? _axis : Vector3d.Zero, l);
    }

    /// <summary>Returns a unit vector across an axis, for a point on the axis.</summary>
    private static Vector3d Across(in Vector3d axis)
    {
        Vector3d across = Vector3d.Cross(in axis, Math.Abs(axis.Y) < 0.9 ? Vector3d.Up : new Vector3d(1, 0, 0));
        return across / across.Length;
    }
}
