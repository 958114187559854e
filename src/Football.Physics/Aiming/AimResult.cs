namespace Football.Physics;

/// <summary>A kick that was found. Whatever the status, it is the best one found, and finite.</summary>
public readonly struct AimResult
{
    internal AimResult(
        AimStatus status, in Vector3d velocity, in Vector3d spin, double miss, double? throughMiss, double time, in Vector3d closest, int iterations, int simulations)
    {
        Status = status;
        Velocity = velocity;
        Spin = spin;
        Miss = miss;
        ThroughMiss = throughMiss;
        Time = time;
        Closest = closest;
        Iterations = iterations;
        Simulations = simulations;
    }

    /// <summary>What became of the search.</summary>
    public AimStatus Status { get; }

    /// <summary>Velocity of the kick, m/s.</summary>
    public Vector3d Velocity { get; }

    /// <summary>Spin of the kick, rad/s, world frame.</summary>
    public Vector3d Spin { get; }

    /// <summary>Distance of the kick's closest approach to the target before its first impact, m: measured, or where that was not asked for, estimated.</summary>
    public double Miss { get; }

    /// <summary>The same for the point on the way; null without one.</summary>
    public double? ThroughMiss { get; }

    /// <summary>When the ball is closest to the target, s after the kick.</summary>
    public double Time { get; }

    /// <summary>Where it is then, m.</summary>
    public Vector3d Closest { get; }

    /// <summary>Iterations of the method.</summary>
    public int Iterations { get; }

    /// <summary>Forward simulations by the method, the measurement of the miss not counted.</summary>
    public int Simulations { get; }

    internal AimResult With(AimStatus status) => new(status, Velocity, Spin, Miss, ThroughMiss, Time, Closest, Iterations, Simulations);
}
