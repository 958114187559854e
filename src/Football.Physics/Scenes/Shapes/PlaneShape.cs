namespace FootballPhysics.Shapes;

/// <summary>A half-space: a wall, a board, a tilted pitch.</summary>
public sealed class PlaneShape : IShape
{
    private readonly double _offset;

    /// <summary>Makes a plane.</summary>
    /// <param name="point">A point on it, m; components within ±1e6.</param>
    /// <param name="normal">Its normal, towards the side where the ball may be; any length but 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names it.</exception>
    public PlaneShape(Vector3d point, Vector3d normal)
    {
        Check.Place("point", point);
        Point = point;
        Normal = Check.Direction("normal", normal);
        _offset = Vector3d.Dot(in point, Normal);
    }

    /// <summary>A point on it, m.</summary>
    public Vector3d Point { get; }

    /// <summary>Its normal, of length 1.</summary>
    public Vector3d Normal { get; }

    /// <inheritdoc/>
    public double MaximumConcaveCurvature => 0;

    /// <inheritdoc/>
    public Bounds3d Bounds => Normal == Vector3d.Up
        ? new(Bounds3d.Everywhere.Min, new Vector3d(double.PositiveInfinity, Point.Y, double.PositiveInfinity))
        : Bounds3d.Everywhere;

    /// <inheritdoc/>
    public ShapePoint At(in Vector3d point) => new(DistanceTo(in point), Normal, SymmetricMatrix3d.Zero);

    /// <summary>Signed distance of a point, m.</summary>
    internal double DistanceTo(in Vector3d point) => Vector3d.Dot(in point, Normal) - _offset;
}
