namespace Football.Physics;

/// <summary>A kick, and its closest approach to the target before its first impact.</summary>
internal struct Approach
{
    /// <summary>The kick; in still air already turned so that it passes the target with its closest point.</summary>
    public Kick Kick;

    /// <summary>Distance of the closest approach, m.</summary>
    public double Miss;

    /// <summary>Whether the target is below the way, not above or beyond it.</summary>
    public bool Above;

    /// <summary>When the ball is closest, s.</summary>
    public double Time;

    /// <summary>Where it is then as seen from the target, m.</summary>
    public Vector3d Gap;

    /// <summary>The miss distance, negative where the kick is too low or too short: smooth in the elevation, and zero at a hit.</summary>
    public readonly double SignedMiss => Above ? Miss : -Miss;

    public readonly double Elevation => Kick.Elevation;
}
