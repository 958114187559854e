using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Shapes;

/// <summary>A box in any orientation: a board, a dummy, a wall of players.</summary>
public sealed class BoxShape : IShape, IExactHollow
{
    private readonly Vector3d _x;
    private readonly Vector3d _y;
    private readonly Vector3d _z;

    /// <summary>Creates a box along the axes of the world.</summary>
    /// <inheritdoc cref="BoxShape(Vector3d, Vector3d, Quaterniond)"/>
    public BoxShape(Vector3d center, Vector3d halfSize)
        : this(center, halfSize, Quaterniond.Identity)
    {
    }

    /// <summary>Creates a box.</summary>
    /// <param name="center">The centre, in m; components within ±1e6.</param>
    /// <param name="halfSize">Half the size along the box's axes, in m; each above 0, at most 1e6.</param>
    /// <param name="rotation">The rotation, body to world; it is normalized.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names it.</exception>
    public BoxShape(Vector3d center, Vector3d halfSize, Quaterniond rotation)
    {
        Check.Place("center", center);
        Check.Within("halfSize[0]", halfSize.X, 0, Limits.Length, exclusiveLow: true);
        Check.Within("halfSize[1]", halfSize.Y, 0, Limits.Length, exclusiveLow: true);
        Check.Within("halfSize[2]", halfSize.Z, 0, Limits.Length, exclusiveLow: true);
        Check.Rotation("rotation", rotation);
        Center = center;
        HalfSize = halfSize;
        Rotation = rotation.Normalized();

        // The box's axes in the world, which every query needs.
        _x = Rotation.Rotate(new Vector3d(1, 0, 0));
        _y = Rotation.Rotate(new Vector3d(0, 1, 0));
        _z = Rotation.Rotate(new Vector3d(0, 0, 1));
    }

    /// <summary>The centre, in m.</summary>
    public Vector3d Center { get; }

    /// <summary>Half the size along the box's axes, in m.</summary>
    public Vector3d HalfSize { get; }

    /// <summary>The rotation, body to world.</summary>
    public Quaterniond Rotation { get; }

    /// <inheritdoc/>
    double IShape.MaximumConcaveCurvature => 0;

    /// <inheritdoc/>
    public Bounds3d Bounds => Bounds3d.Around(
        Center,
        (Math.Abs(_x.X) * HalfSize.X) + (Math.Abs(_y.X) * HalfSize.Y) + (Math.Abs(_z.X) * HalfSize.Z),
        (Math.Abs(_x.Y) * HalfSize.X) + (Math.Abs(_y.Y) * HalfSize.Y) + (Math.Abs(_z.Y) * HalfSize.Z),
        (Math.Abs(_x.Z) * HalfSize.X) + (Math.Abs(_y.Z) * HalfSize.Y) + (Math.Abs(_z.Z) * HalfSize.Z));

    /// <summary>Returns the distance of a point inside the border of the face below it, in m; negative outside the border.</summary>
    internal double FaceMargin(in Vector3d point)
    {
        Vector3d from = point - Center;
        double x = HalfSize.X - Math.Abs(Vector3d.Dot(in from, in _x));
        double y = HalfSize.Y - Math.Abs(Vector3d.Dot(in from, in _y));
        double z = HalfSize.Z - Math.Abs(Vector3d.Dot(in from, in _z));

        // Choose the face along whose axis the point lies farthest outside.
        return x <= y && x <= z ? Math.Min(y, z) : y <= z ? Math.Min(x, z) : Math.Min(x, y);
    }

    /// <inheritdoc/>
    public ShapePoint At(in Vector3d point)
    {
        // In the box's axes, the distance beyond each pair of faces.
        Vector3d from = point - Center;
        double x = Vector3d.Dot(in from, in _x);
        double y = Vector3d.Dot(in from, in _y);
        double z = Vector3d.Dot(in from, in _z);
        double beyondX = Math.Abs(x) - HalfSize.X;
        double beyondY = Math.Abs(y) - HalfSize.Y;
        double beyondZ = Math.Abs(z) - HalfSize.Z;
        double outX = Math.Max(0, beyondX);
        double outY = Math.Max(0, beyondY);
        double outZ = Math.Max(0, beyondZ);
        double l = Math.Sqrt((outX * outX) + (outY * outY) + (outZ * outZ));
        if (!(l > 0))
        {
            // The point is inside: use the nearest face.
            return beyondX >= beyondY && beyondX >= beyondZ ? new ShapePoint(beyondX, x < 0 ? -_x : _x, SymmetricMatrix3d.Zero)
                : beyondY >= beyondZ ? new ShapePoint(beyondY, y < 0 ? -_y : _y, SymmetricMatrix3d.Zero)
                : new ShapePoint(beyondZ, z < 0 ? -_z : _z, SymmetricMatrix3d.Zero);
        }

        // The point is outside: the normal points away from the nearest point of the box.
        Vector3d normal = ((x < 0 ? -outX : outX) / l * _x) + ((y < 0 ? -outY : outY) / l * _y) + ((z < 0 ? -outZ : outZ) / l * _z);

        // Beyond one pair of faces, the nearest surface is a plane; beyond two, an edge; beyond three, a corner.
        int beyond = (outX > 0 ? 1 : 0) + (outY > 0 ? 1 : 0) + (outZ > 0 ? 1 : 0);
        return beyond == 1 ? new ShapePoint(l, in normal, SymmetricMatrix3d.Zero)
            : new ShapePoint(l, in normal, beyond == 3 ? Vector3d.Zero : outX > 0 ? (outY > 0 ? _z : _y) : _x, l);
    }
}
