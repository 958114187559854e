namespace FootballPhysics.Contacts;

/// <summary>A hash of all values that a clear flight depends on (FNV-1a over their bits).</summary>
/// <remarks>A result is valid only in the scene with the same hash.</remarks>
internal struct ClearKey
{
    private ulong _hash;

    /// <summary>The hash so far; never 0.</summary>
    public readonly ulong Value => _hash | 1;

    /// <summary>Adds a number.</summary>
    public void Add(double value) => _hash = (_hash ^ (ulong)BitConverter.DoubleToInt64Bits(value) ^ 14695981039346656037UL) * 1099511628211UL;

    /// <summary>Adds a vector.</summary>
    public void Add(in Vector3d value)
    {
        Add(value.X);
        Add(value.Y);
        Add(value.Z);
    }

    /// <summary>Adds a box.</summary>
    public void Add(in Bounds3d value)
    {
        Add(value.Min);
        Add(value.Max);
    }
}
