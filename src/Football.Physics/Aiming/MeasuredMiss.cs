namespace Football.Physics;

/// <summary>The measured closest approach of a kick before its first impact.</summary>
internal readonly struct MeasuredMiss
{
    /// <summary>Nothing is in the way.</summary>
    public const int NoThing = -1;

    public MeasuredMiss(double distance, double? throughDistance, double time, in Vector3d position, int blocker = NoThing)
    {
        Distance = distance;
        ThroughDistance = throughDistance;
        Time = time;
        Position = position;
        Blocker = blocker;
    }

    /// <summary>Distance from the target, m.</summary>
    public double Distance { get; }

    /// <summary>Distance from the point on the way, m; null without one.</summary>
    public double? ThroughDistance { get; }

    /// <summary>When the ball is closest to the target, s.</summary>
    public double Time { get; }

    /// <summary>Where it is then, m.</summary>
    public Vector3d Position { get; }

    /// <summary>The first thing but the ground that the ball meets on its way, as events number them; <see cref="NoThing"/> where it meets none.</summary>
    public int Blocker { get; }
}
