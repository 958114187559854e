namespace FootballPhysics.Batch;

/// <summary>A 3×3 matrix, such as the derivative of one vector with respect to another.</summary>
/// <remarks>For a derivative, entry (i, j) is the derivative of component i with respect to component j of the other vector.</remarks>
public readonly struct Matrix3d
{
    /// <summary>Creates a matrix from its rows.</summary>
    /// <param name="x">Row x.</param>
    /// <param name="y">Row y.</param>
    /// <param name="z">Row z.</param>
    public Matrix3d(in Vector3d x, in Vector3d y, in Vector3d z)
    {
        X = x;
        Y = y;
        Z = z;
    }

    /// <summary>Row x.</summary>
    public Vector3d X { get; }

    /// <summary>Row y.</summary>
    public Vector3d Y { get; }

    /// <summary>Row z.</summary>
    public Vector3d Z { get; }

    /// <summary>Multiplies a matrix by a vector.</summary>
    /// <param name="a">The matrix.</param>
    /// <param name="v">The vector.</param>
    public static Vector3d operator *(in Matrix3d a, in Vector3d v) => new(Vector3d.Dot(a.X, in v), Vector3d.Dot(a.Y, in v), Vector3d.Dot(a.Z, in v));

    /// <summary>Multiplies a vector by a matrix, vᵀA.</summary>
    /// <param name="v">The vector.</param>
    /// <param name="a">The matrix.</param>
    public static Vector3d operator *(in Vector3d v, in Matrix3d a) => (v.X * a.X) + (v.Y * a.Y) + (v.Z * a.Z);

    /// <summary>Adds two matrices.</summary>
    /// <param name="a">One matrix.</param>
    /// <param name="b">The other.</param>
    public static Matrix3d operator +(in Matrix3d a, in Matrix3d b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);
}
