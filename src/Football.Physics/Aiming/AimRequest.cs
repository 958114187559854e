using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>A request for a kick: start, target, speed and bounds.</summary>
/// <remarks>All points refer to the ball's centre.</remarks>
public sealed record AimRequest
{
    /// <summary>The position of the ball, in m; components within ±1e6. Default: the origin.</summary>
    /// <remarks>If the ball would overlap the ground there, the position is raised vertically onto it.</remarks>
    public Vector3d From { get; init; }

    /// <summary>The target, in m; components within ±1e6. Required.</summary>
    /// <remarks>If the ball would overlap the ground there, the position is raised vertically onto it.</remarks>
    public Vector3d Target { get; init; } = new(double.NaN, double.NaN, double.NaN);

    /// <summary>The velocity of the target, in m/s; at most 1000. Default: at rest.</summary>
    /// <remarks>It cannot be combined with <see cref="Waypoint"/>, or with the objects of a <see cref="BankShotAimer"/>.</remarks>
    public Vector3d TargetVelocity { get; init; }

    /// <summary>A waypoint that the ball must pass before the target, in m; default none.</summary>
    public Vector3d? Waypoint { get; init; }

    /// <summary>The speed of the kick, in m/s. Above 0, at most 1000; default 25.</summary>
    public double Speed { get; init; } = 25;

    /// <summary>The topspin, in rad/s. Within ±10 000; default 0.</summary>
    /// <remarks>With a waypoint, this is only the initial value of the search.</remarks>
    public double TopSpin { get; init; }

    /// <summary>The sidespin, in rad/s. Within ±10 000; default 0.</summary>
    /// <remarks>With a waypoint, this is only the initial value of the search.</remarks>
    public double SideSpin { get; init; }

    /// <summary>The minimum elevation, in degrees. −90 … 90; default 0.</summary>
    public double MinimumElevationDegrees { get; init; }

    /// <summary>The maximum elevation, in degrees. From the minimum to 90; default 45.</summary>
    public double MaximumElevationDegrees { get; init; } = 45;

    /// <summary>The maximum topspin or backspin of a kick with a waypoint, in rad/s. 0 … 10 000; default 40.</summary>
    public double MaximumTopSpin { get; init; } = 40;

    /// <summary>The maximum sidespin of a kick with a waypoint, in rad/s. 0 … 10 000; default 40.</summary>
    public double MaximumSideSpin { get; init; } = 40;

    /// <summary>The maximum distance from the target for a hit, in m. Above 0; default 0.01.</summary>
    public double Tolerance { get; init; } = 0.01;

    /// <summary>The tolerance at the waypoint, in m. Above 0; default 0.1.</summary>
    public double WaypointTolerance { get; init; } = 0.1;

    /// <summary>The maximum number of iterations. At least 1; default 60.</summary>
    /// <remarks>
    /// In <see cref="Aimer"/>, one iteration is a flight and its correction. In searches over elevations, directions or times, one iteration is 16 flights. The
    /// search gives up after this number of iterations or 200 000 path segments.
    /// </remarks>
    public int MaximumIterations { get; init; } = 60;

    /// <summary>The choice between the two kicks that reach a target. Default: the low one.</summary>
    /// <remarks>
    /// Used by <see cref="Aimer"/>. The high kick is usually steeper than 45°, so raise <see cref="MaximumElevationDegrees"/> for it.
    /// <see cref="AimResult.Arc"/> reports the arc found.
    /// </remarks>
    public AimArc Arc { get; init; } = AimArc.Low;

    /// <summary>True if the search may change the spin to bend a kick around an obstacle. Default false.</summary>
    /// <remarks>
    /// The spin stays within <see cref="MaximumTopSpin"/> and <see cref="MaximumSideSpin"/>. Used by <see cref="Aimer"/> if the request has no waypoint.
    /// </remarks>
    public bool SpinIsFree { get; init; }

    /// <summary>The orientation of the ball at the kick; it is normalised. Default null: that of a launch without one.</summary>
    /// <remarks>Only the knuckle force depends on it. A kick of a ball in play keeps the ball's orientation, so pass that one.</remarks>
    public Quaterniond? Orientation { get; init; }

    /// <summary>The time of the kick on the clock of the scene's bodies, in s; within ±1e12, default 0.</summary>
    /// <remarks>Only the positions of moving bodies depend on it.</remarks>
    public double KickTime { get; init; }

    /// <summary>Throws if a number is out of range.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public void Validate()
    {
        Check.Place("aim.from", From);
        Check.Place("aim.target", Target);
        Check.Size("aim.targetVelocity", TargetVelocity, Limits.Speed, "m/s");
        if (Waypoint is { } through)
        {
            Check.Place("aim.waypoint", through);
            if (TargetVelocity != Vector3d.Zero)
            {
                throw Check.Conflict("aim.targetVelocity", "aim.targetVelocity cannot be combined with aim.waypoint. Leave one of them unset.");
            }
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
        if (Orientation is { } orientation)
        {
            Check.Rotation("aim.orientation", orientation);
        }

        Check.Within("aim.kickTime", KickTime, -Limits.Time, Limits.Time);
    }
}

/// <summary>The choice between the two kicks that reach a target.</summary>
public enum AimArc
{
    /// <summary>The kick that arrives first, usually the flatter one.</summary>
    /// <remarks>The other kick is used if it is the only one within the elevation bounds.</remarks>
    Low = 0,

    /// <summary>The kick that arrives later, usually the steeper one.</summary>
    /// <remarks>The other kick is used if it is the only one within the elevation bounds.</remarks>
    High = 1,
}
