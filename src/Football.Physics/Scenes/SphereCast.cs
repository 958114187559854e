namespace FootballPhysics.Engines;

/// <summary>A sphere that moves along a straight line: a query for the colliders near the path.</summary>
public readonly struct SphereCast
{
    internal SphereCast(in Vector3d from, in Vector3d to, double radius, double ballRadius)
    {
        From = from;
        Vector3d way = to - from;

        // Engines require a unit direction, even if the length is 0.
        Distance = way.Length;
        Direction = Distance > 0 ? way / Distance : Vector3d.Up;
        Radius = radius;
        BallRadius = ballRadius;
    }

    /// <summary>The centre of the sphere at the start, in m.</summary>
    public Vector3d From { get; }

    /// <summary>The direction of the cast, a unit vector.</summary>
    public Vector3d Direction { get; }

    /// <summary>The length of the cast, in m; 0 for an overlap test at the start.</summary>
    public double Distance { get; }

    /// <summary>The radius of the sphere, in m.</summary>
    /// <remarks>This radius exceeds the ball's radius by the deviation of the curved path from the line, and by the distance that colliders can move.</remarks>
    public double Radius { get; }

    /// <summary>The radius of the ball, in m.</summary>
    /// <remarks>Use it to find the contact normal of a collider that has no shape in the library.</remarks>
    public double BallRadius { get; }
}
