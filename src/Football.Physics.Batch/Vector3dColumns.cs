using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>Many vectors, stored as one array per component.</summary>
public sealed class Vector3dColumns
{
    /// <summary>Creates zero vectors.</summary>
    /// <param name="length">The number of vectors; at least 0.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="length"/> is negative.</exception>
    public Vector3dColumns(int length)
    {
        Check.AtLeast(nameof(length), length, 0);
        X = new double[length];
        Y = new double[length];
        Z = new double[length];
    }

    /// <summary>The x components.</summary>
    public double[] X { get; }

    /// <summary>The y components, up.</summary>
    public double[] Y { get; }

    /// <summary>The z components.</summary>
    public double[] Z { get; }

    /// <summary>The number of vectors.</summary>
    public int Length => X.Length;

    /// <summary>Gets or sets the vector at an index.</summary>
    /// <param name="index">The index, 0 … <see cref="Length"/> − 1.</param>
    /// <exception cref="IndexOutOfRangeException"><paramref name="index"/> is out of range.</exception>
    public Vector3d this[int index]
    {
        get => new(X[index], Y[index], Z[index]);
        set
        {
            X[index] = value.X;
            Y[index] = value.Y;
            Z[index] = value.Z;
        }
    }
}
