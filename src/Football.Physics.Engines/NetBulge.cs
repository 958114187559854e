namespace FootballPhysics.Engines;

/// <summary>How a net bulges, for drawing it.</summary>
public readonly struct NetBulge
{
    internal NetBulge(in Vector3d position, in Vector3d direction, double depth)
    {
        Position = position;
        Direction = direction;
        Depth = depth;
    }

    /// <summary>The deepest point of the bulge, m.</summary>
    public Vector3d Position { get; }

    /// <summary>Where it bulges to: off the net's plane, of length 1.</summary>
    public Vector3d Direction { get; }

    /// <summary>How deep it is, m; 0 where the net hangs as it was made.</summary>
    public double Depth { get; }

    /// <inheritdoc/>
    public override string ToString() => FormattableString.Invariant($"{Depth:0.###} m deep at {Position:0.###}");
}
