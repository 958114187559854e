namespace FootballPhysics.Engines;

/// <summary>A sphere that is moved along a straight way, to see what it touches.</summary>
public readonly struct SphereCast
{
    internal SphereCast(in Vector3d from, in Vector3d to, double radius, double ballRadius)
    {
        From = from;
        Vector3d way = to - from;

        // Without a way there is no direction: engines want one of length 1 all the same.
        Distance = way.Length;
        Direction = Distance > 0 ? way / Distance : Vector3d.Up;
        Radius = radius;
        BallRadius = ballRadius;
    }

    /// <summary>Centre of the sphere where it starts, m.</summary>
    public Vector3d From { get; }

    /// <summary>Direction of its way, of length 1.</summary>
    public Vector3d Direction { get; }

    /// <summary>Length of its way, m; 0 where only what touches it there is asked for.</summary>
    public double Distance { get; }

    /// <summary>Its radius, m: more than the ball's, by what the path bends and colliders may move.</summary>
    public double Radius { get; }

    /// <summary>Radius of the ball, m: for a normal where the ball itself would touch a collider that has no shape of its own here.</summary>
    public double BallRadius { get; }
}
