namespace Football.Physics.Headless.Schema;

/// <summary>How large a vector may be, and how to say so.</summary>
internal sealed class VectorBound
{
    private readonly Func<Vector3d, bool> _contains;

    private VectorBound(string allowed, Func<Vector3d, bool> contains)
    {
        Allowed = allowed;
        _contains = contains;
    }

    /// <summary>A velocity.</summary>
    public static VectorBound Velocity { get; } = new("three finite numbers [x, y, z], speed at most 1000 m/s", v => v.Length <= Limits.Speed);

    /// <summary>A spin.</summary>
    public static VectorBound Spin { get; } = new("three finite numbers [x, y, z], size at most 10000 rad/s", v => v.Length <= Limits.Spin);

    /// <summary>A point.</summary>
    public static VectorBound Position { get; } = new(
        "three finite numbers [x, y, z], each within ±1000000 m",
        v => Math.Abs(v.X) <= Limits.Length && Math.Abs(v.Y) <= Limits.Length && Math.Abs(v.Z) <= Limits.Length);

    /// <summary>What is allowed, for a message.</summary>
    public string Allowed { get; }

    public bool Contains(Vector3d vector) => _contains(vector);
}
