namespace FootballPhysics.Batch;

/// <summary>Many vectors as three arrays of numbers, one a component.</summary>
public sealed class Vector3dColumns
{
    /// <summary>Makes zero vectors.</summary>
    /// <param name="length">How many; not negative.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="length"/> is negative.</exception>
    public Vector3dColumns(int length)
    {
        Check.AtLeast(nameof(length), length, 0);
        X = new double[length];
        Y = new double[length];
        Z = new double[length];
    }

    /// <summary>The components along x.</summary>
    public double[] X { get; }

    /// <summary>The components along y, up.</summary>
    public double[] Y { get; }

    /// <summary>The components along z.</summary>
    public double[] Z { get; }

    /// <summary>How many vectors.</summary>
    public int Length => X.Length;

    /// <summary>One of the vectors.</summary>
    /// <param name="index">Which; 0 … <see cref="Length"/> − 1.</param>
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
