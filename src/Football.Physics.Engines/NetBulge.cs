namespace FootballPhysics.Engines;

/// <summary>The bulge of a net, for drawing.</summary>
public readonly struct NetBulge
{
    internal NetBulge(in Vector3d position, in Vector3d direction, double depth)
    {
        Position = position;
        Direction = direction;
        Depth = depth;
    }

    /// <summary>The deepest point of the bulge, in m.</summary>
    public Vector3d Position { get; }

    /// <summary>The unit direction of the bulge, perpendicular to the net's plane.</summary>
    public Vector3d Direction { get; }

    /// <summary>The depth of the bulge, in m; 0 if the net hangs flat.</summary>
    public double Depth { get; }

    /// <inheritdoc/>
    public override string ToString() => FormattableString.Invariant($"{Depth:0.###} m deep at {Position:0.###}");
}
