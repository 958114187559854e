namespace FootballPhysics;

/// <summary>A symmetric 3×3 matrix: for example, the curvature of a shape.</summary>
public readonly struct SymmetricMatrix3d
{
    /// <summary>Creates a matrix from its six entries.</summary>
    /// <param name="xx">The entry in row x, column x.</param>
    /// <param name="xy">The entry in row x, column y.</param>
    /// <param name="xz">The entry in row x, column z.</param>
    /// <param name="yy">The entry in row y, column y.</param>
    /// <param name="yz">The entry in row y, column z.</param>
    /// <param name="zz">The entry in row z, column z.</param>
    public SymmetricMatrix3d(double xx, double xy, double xz, double yy, double yz, double zz)
    {
        XX = xx;
        XY = xy;
        XZ = xz;
        YY = yy;
        YZ = yz;
        ZZ = zz;
    }

    /// <summary>The zero matrix.</summary>
    public static SymmetricMatrix3d Zero => default;

    /// <summary>The entry in row x, column x.</summary>
    internal double XX { get; }

    /// <summary>The entry in row x, column y.</summary>
    internal double XY { get; }

    /// <summary>The entry in row x, column z.</summary>
    internal double XZ { get; }

    /// <summary>The entry in row y, column y.</summary>
    internal double YY { get; }

    /// <summary>The entry in row y, column z.</summary>
    internal double YZ { get; }

    /// <summary>The entry in row z, column z.</summary>
    internal double ZZ { get; }

    /// <summary>Returns the Hessian of the distance from a point: (1 − nnᵀ)/l.</summary>
    /// <param name="normal">n, the unit vector from the point.</param>
    /// <param name="distance">l, in m; above 0.</param>
    public static SymmetricMatrix3d AroundPoint(in Vector3d normal, double distance) => AroundAxis(in normal, default, distance);

    /// <summary>Returns the Hessian of the distance from an axis: (1 − nnᵀ − aaᵀ)/l.</summary>
    /// <param name="normal">n, the unit vector from the axis.</param>
    /// <param name="axis">a, the unit vector along the axis.</param>
    /// <param name="distance">l, in m; above 0.</param>
    public static SymmetricMatrix3d AroundAxis(in Vector3d normal, in Vector3d axis, double distance)
    {
        // Entry by entry, because every query of a post computes it.
        double s = 1.0 / distance;
        return new(
            s * (1.0 - (normal.X * normal.X) - (axis.X * axis.X)),
            s * (0.0 - (normal.X * normal.Y) - (axis.X * axis.Y)),
            s * (0.0 - (normal.X * normal.Z) - (axis.X * axis.Z)),
            s * (1.0 - (normal.Y * normal.Y) - (axis.Y * axis.Y)),
            s * (0.0 - (normal.Y * normal.Z) - (axis.Y * axis.Z)),
            s * (1.0 - (normal.Z * normal.Z) - (axis.Z * axis.Z)));
    }

    /// <summary>Returns the outer product v vᵀ.</summary>
    /// <param name="v">A vector.</param>
    public static SymmetricMatrix3d OuterProduct(in Vector3d v) =>
        new(v.X * v.X, v.X * v.Y, v.X * v.Z, v.Y * v.Y, v.Y * v.Z, v.Z * v.Z);

    /// <summary>Returns the matrix of the bilinear form in other axes.</summary>
    /// <param name="x">The first new axis in the current axes; a unit vector.</param>
    /// <param name="y">The second new axis.</param>
    /// <param name="z">The third new axis.</param>
    public SymmetricMatrix3d Transformed(in Vector3d x, in Vector3d y, in Vector3d z)
    {
        Vector3d ofX = this * x;
        Vector3d ofY = this * y;
        Vector3d ofZ = this * z;
        return new(
            Vector3d.Dot(in x, in ofX),
            Vector3d.Dot(in x, in ofY),
            Vector3d.Dot(in x, in ofZ),
            Vector3d.Dot(in y, in ofY),
            Vector3d.Dot(in y, in ofZ),
            Vector3d.Dot(in z, in ofZ));
    }

    /// <summary>Subtracts one matrix from another.</summary>
    /// <param name="a">A matrix.</param>
    /// <param name="b">The matrix to subtract.</param>
    public static SymmetricMatrix3d operator -(in SymmetricMatrix3d a, in SymmetricMatrix3d b) =>
        new(a.XX - b.XX, a.XY - b.XY, a.XZ - b.XZ, a.YY - b.YY, a.YZ - b.YZ, a.ZZ - b.ZZ);

    /// <summary>Scales a matrix.</summary>
    /// <param name="s">A number.</param>
    /// <param name="a">A matrix.</param>
    public static SymmetricMatrix3d operator *(double s, in SymmetricMatrix3d a) =>
        new(s * a.XX, s * a.XY, s * a.XZ, s * a.YY, s * a.YZ, s * a.ZZ);

    /// <summary>Multiplies a matrix by a vector.</summary>
    /// <param name="a">A matrix.</param>
    /// <param name="v">A vector.</param>
    public static Vector3d operator *(in SymmetricMatrix3d a, in Vector3d v) => new(
        (a.XX * v.X) + (a.XY * v.Y) + (a.XZ * v.Z),
        (a.XY * v.X) + (a.YY * v.Y) + (a.YZ * v.Z),
        (a.XZ * v.X) + (a.YZ * v.Y) + (a.ZZ * v.Z));
}
