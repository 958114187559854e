using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Shapes;

/// <summary>A half-space bounded by a plane: a wall, a board, a tilted pitch.</summary>
public sealed class PlaneShape : IShape, IExactHollow
{
    private readonly double _offset;

    /// <summary>Creates a half-space.</summary>
    /// <param name="point">A point on the plane, in m; components within ±1e6.</param>
    /// <param name="normal">The normal, towards the side of the ball; any length except 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names it.</exception>
    public PlaneShape(Vector3d point, Vector3d normal)
    {
        Check.Place("point", point);
        Point = point;
        Normal = Check.Direction("normal", normal);
        _offset = Vector3d.Dot(in point, Normal);
    }

    /// <summary>Creates a half-space from a unit normal and its distance from the origin; the numbers are already validated.</summary>
    internal PlaneShape(in Vector3d normal, double offset)
    {
        Point = offset * normal;
        Normal = normal;
        _offset = offset;
    }

    /// <summary>A point on the plane, in m.</summary>
    public Vector3d Point { get; }

    /// <summary>The unit normal.</summary>
    public Vector3d Normal { get; }

    /// <inheritdoc/>
    double IShape.MaximumConcaveCurvature => 0;

    /// <inheritdoc/>
    public Bounds3d Bounds => Normal == Vector3d.Up
        ? new(Bounds3d.Everywhere.Min, new Vector3d(double.PositiveInfinity, Point.Y, double.PositiveInfinity))
        : Bounds3d.Everywhere;

    /// <inheritdoc/>
    public ShapePoint At(in Vector3d point) => new(DistanceTo(in point), Normal, curvature: default);

    /// <summary>Returns the signed distance of a point, in m.</summary>
    internal double DistanceTo(in Vector3d point) => Vector3d.Dot(in point, Normal) - _offset;
}
