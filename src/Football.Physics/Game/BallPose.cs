namespace Football.Physics;

/// <summary>Where to draw the ball.</summary>
public readonly struct BallPose
{
    internal BallPose(in Vector3d position, in Quaterniond orientation)
    {
        Position = position;
        Orientation = orientation;
    }

    /// <summary>Position of the centre, m.</summary>
    public Vector3d Position { get; }

    /// <summary>Orientation, body to world; norm 1.</summary>
    public Quaterniond Orientation { get; }

    /// <summary>Place and orientation.</summary>
    public override string ToString() => FormattableString.Invariant($"{Position:0.###}, {Orientation:0.###}");
}
