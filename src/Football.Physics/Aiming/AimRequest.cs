namespace FootballPhysics.Aiming;

/// <summary>A request for a kick: from where, at which target, how fast, within which bounds. Points are for the ball's centre.</summary>
public sealed record AimRequest
{
    /// <summary>Where the ball is, m; components within ±1e6. A place in the ground is raised straight up out of it. Default the origin.</summary>
    public Vector3d From { get; init; }

    /// <summary>Where it is to go, m; components within ±1e6. A place in the ground is raised straight up out of it. Without one a request is refused.</summary>
    public Vector3d Target { get; init; } = new(double.NaN, double.NaN, double.NaN);

    /// <summary>Velocity of the target, m/s; at most 1000. Default at rest. Used by <see cref="Aimer"/> without a point on the way.</summary>
    public Vector3d TargetVelocity { get; init; }

    /// <summary>A point to pass on the way, m; default none.</summary>
    public Vector3d? Waypoint { get; init; }

    /// <summary>Speed of the kick, m/s. Above 0, at most 1000; default 25.</summary>
    public double Speed { get; init; } = 25;

    /// <summary>Topspin, rad/s; with a point on the way only a start value. Within ±10 000; default 0.</summary>
    public double TopSpin { get; init; }

    /// <summary>Sidespin, rad/s; with a point on the way only a start value. Within ±10 000; default 0.</summary>
    public double SideSpin { get; init; }

    /// <summary>Lowest elevation, degrees. −90 … 90; default 0.</summary>
    public double MinimumElevationDegrees { get; init; }

    /// <summary>Highest elevation, degrees. At least the lowest, at most 90; default 45.</summary>
    public double MaximumElevationDegrees { get; init; } = 45;

    /// <summary>Largest topspin or backspin of a two-point kick, rad/s. 0 … 10 000; default 40.</summary>
    public double MaximumTopSpin { get; init; } = 40;

    /// <summary>Largest sidespin of a two-point kick, rad/s. 0 … 10 000; default 40.</summary>
    public double MaximumSideSpin { get; init; } = 40;

    /// <summary>How close to the target is a hit, m. Above 0; default 0.01.</summary>
    public double Tolerance { get; init; } = 0.01;

    /// <summary>How close to the point on the way is good enough, m. Above 0; default 0.1.</summary>
    public double WaypointTolerance { get; init; } = 0.1;

    /// <summary>
    /// Iterations that a method may take. At least 1; default 60. An iteration of <see cref="Aimer"/> is one flight and one correction,
    /// or, in its searches over elevations, directions and times, 16 simulations; after as many, or 200 000 integrated pieces of motion, it ends without a verdict.
    /// </summary>
    public int MaximumIterations { get; init; } = 60;

    /// <summary>
    /// Which of the two kicks that reach a target. Default the low one. Used by <see cref="Aimer"/>. The high one is mostly steeper than
    /// 45°: raise <see cref="MaximumElevationDegrees"/> for it; <see cref="AimResult.Arc"/> says which one was found.
    /// </summary>
    public AimArc Arc { get; init; } = AimArc.Low;

    /// <summary>
    /// True when the spin may be changed, within <see cref="MaximumTopSpin"/> and <see cref="MaximumSideSpin"/>, to bring a kick round what is in its way.
    /// Default not. Used by <see cref="Aimer"/> without a point on the way.
    /// </summary>
    public bool SpinIsFree { get; init; }

    /// <summary>When the ball is kicked, on the clock of the bodies of the scene, s; within ±1e12, default 0. Nothing else depends on it.</summary>
    public double KickTime { get; init; }

    /// <summary>Checks every number.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public void Validate()
    {
        Check.Place("aim.from", From);
        Check.Place("aim.target", Target);
        Check.Size("aim.targetVelocity", TargetVelocity, Limits.Speed, "m/s");
        if (Waypoint is { } through)
        {
            Check.Place("aim.waypoint", through);
        }

        Check.Within("aim.speed", Speed, 0, Limits.Speed, exclusiveLow: true);
        Check.Within("aim.spin.top", TopSpin, -Limits.Spin, Limits.Spin);
        Check.Within("aim.spin.side", SideSpin, -Limits.Spin, Limits.Spin);
        Check.Size("aim.spin", new Vector3d(TopSpin, SideSpin, 0), Limits.Spin, "rad/s");
        Check.Within("aim.elevation.min", MinimumElevationDegrees, -90, 90);
        Check.Within("aim.elevation.max", MaximumElevationDegrees, MinimumElevationDegrees, 90);
        Check.Within("aim.maxSpin.top", MaximumTopSpin, 0, Limits.Spin);
        Check.Within("aim.maxSpin.side", MaximumSideSpin, 0, Limits.Spin);
        Check.Positive("aim.tolerance", Tolerance);
        Check.Positive("aim.waypointTolerance", WaypointTolerance);
        Check.Defined("aim.arc", Arc, (int)Arc, 2);
        Check.AtLeast("aim.maxIterations", MaximumIterations, 1);
        Check.Within("aim.kickTime", KickTime, -Limits.Time, Limits.Time);
    }
}

/// <summary>Which of the two kicks that reach a target to find.</summary>
public enum AimArc
{
    /// <summary>The one that is there first, mostly the flatter; the other where only that lies within the elevation bounds.</summary>
    Low = 0,

    /// <summary>The one that is there later, mostly the steeper; the other where only that lies within the elevation bounds.</summary>
    High = 1,
}
