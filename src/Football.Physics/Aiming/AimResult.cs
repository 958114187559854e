using System.Globalization;
using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>The result of a search for a kick.</summary>
/// <remarks>Whatever the status, the result contains the best kick found, with finite numbers.</remarks>
public readonly struct AimResult : IFormattable
{
    private const double Degrees = 180.0 / Math.PI;

    internal AimResult(AimReason reason, in Vector3d velocity, in Vector3d spin, in MeasuredMiss measured, AimArc arc, bool rolls, int iterations, int simulations, string? blockedBy)
    {
        Cause = reason;
        Status = reason.Status();
        Velocity = velocity;
        Spin = spin;
        Miss = measured.Distance;
        WaypointMiss = measured.ThroughDistance;
        Time = measured.Time;
        Closest = measured.Position;
        Arc = arc;
        Rolls = rolls;
        Iterations = iterations;
        Simulations = simulations;
        BlockedBy = blockedBy;
    }

    /// <summary>The outcome of the search.</summary>
    public AimStatus Status { get; init; }

    /// <summary>True if the kick passes within tolerance of the target, even if it misses the waypoint.</summary>
    public bool HitsTarget => Status is AimStatus.Hit or AimStatus.WaypointMissed;

    /// <summary>The velocity of the kick, in m/s.</summary>
    public Vector3d Velocity { get; init; }

    /// <summary>The spin of the kick in the world frame, in rad/s.</summary>
    public Vector3d Spin { get; init; }

    /// <summary>The speed of the kick, in m/s.</summary>
    public double Speed => Velocity.Length;

    /// <summary>The elevation of the kick above the horizontal, in degrees.</summary>
    public double ElevationDegrees => Degrees * Elementary.Atan2(Velocity.Y, Velocity.Horizontal.Length);

    /// <summary>The horizontal direction of the kick, in degrees from forward (−z), positive to the left (−x).</summary>
    /// <remarks>0 for a vertical kick.</remarks>
    public double AzimuthDegrees => Velocity.X == 0 && Velocity.Z == 0 ? 0 : Degrees * Elementary.Atan2(-Velocity.X, -Velocity.Z);

    /// <summary>The topspin of the kick, in rad/s; 0 for a vertical kick, whose topspin axis is undefined.</summary>
    public double TopSpin
    {
        get
        {
            // The part of the spin ω along ŷ × d, the axis of topspin for the horizontal direction d.
            Vector3d flat = Velocity.Horizontal;
            double length = flat.Length;
            return length > 0 ? ((Spin.X * flat.Z) - (Spin.Z * flat.X)) / length : 0;
        }
    }

    /// <summary>The sidespin of the kick, in rad/s.</summary>
    public double SideSpin => Spin.Y;

    /// <summary>The distance from the ball to the target at the closest approach before the first impact, in m.</summary>
    /// <remarks>If no measurement was requested, this is an estimate. If the arrival time is fixed, this is the distance at that time.</remarks>
    public double Miss { get; init; }

    /// <summary>The distance from the ball to the waypoint at the closest approach, in m; null without a waypoint.</summary>
    public double? WaypointMiss { get; init; }

    /// <summary>The time of the closest approach to the target, in s after the kick.</summary>
    public double Time { get; init; }

    /// <summary>The position of the ball at the closest approach, in m.</summary>
    public Vector3d Closest { get; init; }

    /// <summary>The arc of a kick that hits. Two kicks at this speed can reach the target, one on each arc.</summary>
    /// <remarks>The arc differs from the requested one if only the other kick is within the bounds.</remarks>
    public AimArc Arc { get; init; }

    /// <summary>True if the ball stays on the ground and slides or rolls to the target.</summary>
    public bool Rolls { get; init; }

    /// <summary>The number of iterations performed.</summary>
    public int Iterations { get; init; }

    /// <summary>The number of forward simulations, not including the measurement of the miss.</summary>
    public int Simulations { get; init; }

    /// <summary>The name of the object that blocks the kick, such as "left post"; null if the status is not <see cref="AimStatus.Blocked"/>.</summary>
    public string? BlockedBy { get; init; }

    /// <summary>The reason for the status, in one or two English sentences; null for a hit.</summary>
    /// <remarks>
    /// If the target is out of reach, the reason names the bound that excludes every kick; if the request is degenerate, the undefined quantity.
    /// Otherwise it contains the nearest miss. The text is created by each call, so do not read it in every frame.
    /// </remarks>
    public string? Reason => Cause.Text(in this);

    /// <summary>The reason for the status.</summary>
    internal AimReason Cause { get; }

    /// <summary>Returns the kick as one line of text.</summary>
    public override string ToString() => FormattableString.Invariant(
        $"{Status}: {Speed:0.##} m/s, elevation {ElevationDegrees:0.##}°, azimuth {AzimuthDegrees:0.##}°, spin ({TopSpin:0.#}, {SideSpin:0.#}) rad/s, {Miss:0.####} m off after {Time:0.###} s");

    /// <summary>Returns the kick as one line of text, in a given number format.</summary>
    /// <param name="format">A number format; null or empty for the digits of <see cref="ToString()"/>.</param>
    /// <param name="formatProvider">The culture; default: the invariant culture.</param>
    public string ToString(string? format, IFormatProvider? formatProvider = null)
    {
        if (string.IsNullOrEmpty(format))
        {
            return ToString();
        }

        IFormatProvider culture = formatProvider ?? CultureInfo.InvariantCulture;
        return $"{Status}: {Speed.ToString(format, culture)} m/s, elevation {ElevationDegrees.ToString(format, culture)}°, azimuth {AzimuthDegrees.ToString(format, culture)}°, "
            + $"spin ({TopSpin.ToString(format, culture)}, {SideSpin.ToString(format, culture)}) rad/s, {Miss.ToString(format, culture)} m off after {Time.ToString(format, culture)} s";
    }
}

/// <summary>The outcome of a search for a kick.</summary>
public enum AimStatus
{
    /// <summary>The kick passes within tolerance of the target, and of the waypoint if there is one.</summary>
    Hit = 0,

    /// <summary>No kick within the bounds hits the target; the result is the closest kick found.</summary>
    /// <remarks>
    /// A bound excludes every kick. Either the target needs more energy or time than any kick has, or flights over all elevations bound the miss
    /// (in still air over level ground, for a target at rest). The constants of this second bound are exact in vacuum, and measured in air.
    /// </remarks>
    OutOfReach = 1,

    /// <summary>The search found no kick that hits, but nothing excludes one; the result is the closest kick found.</summary>
    /// <remarks>
    /// Most targets with this status are out of reach: in wind, on a slope, or only slightly. The search may also have reached
    /// <see cref="AimRequest.MaximumIterations"/>.
    /// </remarks>
    NotConverged = 2,

    /// <summary>The request has no direction: the target is at the ball's position.</summary>
    Degenerate = 3,

    /// <summary>The kick passes within tolerance of the target, but misses the waypoint: the allowed spins do not bend it enough.</summary>
    WaypointMissed = 4,

    /// <summary>The kick would hit, but an object blocks it; see <see cref="AimResult.BlockedBy"/>.</summary>
    Blocked = 5,
}
