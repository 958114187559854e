using System.Globalization;

namespace FootballPhysics.Aiming;

/// <summary>A kick that was found. Whatever the status, it is the best one found, and finite.</summary>
public readonly struct AimResult : IFormattable
{
    private const double Degrees = 180.0 / Math.PI;

    internal AimResult(AimStatus status, in Vector3d velocity, in Vector3d spin, in MeasuredMiss measured, AimArc arc, bool rolls, int iterations, int simulations, string? blockedBy)
    {
        Status = status;
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

    /// <summary>True where the kick passes the target within the tolerance, whatever becomes of a point on the way.</summary>
    public bool HitsTarget => Status is AimStatus.Hit or AimStatus.WaypointMissed;

    /// <summary>Velocity of the kick, m/s.</summary>
    public Vector3d Velocity { get; init; }

    /// <summary>Spin of the kick, rad/s, world frame.</summary>
    public Vector3d Spin { get; init; }

    /// <summary>Speed of the kick, m/s.</summary>
    public double Speed => Velocity.Length;

    /// <summary>Angle of the kick above the horizontal, degrees.</summary>
    public double ElevationDegrees => Degrees * Elementary.Atan2(Velocity.Y, Velocity.Horizontal.Length);

    /// <summary>Horizontal direction of the kick, degrees from forward (−z), positive to the left (−x); 0 for a vertical kick.</summary>
    public double AzimuthDegrees => Velocity.X == 0 && Velocity.Z == 0 ? 0 : Degrees * Elementary.Atan2(-Velocity.X, -Velocity.Z);

    /// <summary>Topspin of the kick, rad/s; 0 for a vertical kick, which has no axis for it.</summary>
    public double TopSpin
    {
        get
        {
            // ω · (ŷ × d)
            Vector3d flat = Velocity.Horizontal;
            double length = flat.Length;
            return length > 0 ? ((Spin.X * flat.Z) - (Spin.Z * flat.X)) / length : 0;
        }
    }

    /// <summary>Sidespin of the kick, rad/s.</summary>
    public double SideSpin => Spin.Y;

    /// <summary>
    /// Distance of the kick's closest approach to the target before its first impact, m: measured, or where that was not asked for, estimated.
    /// Of a kick for a time, the distance at that time.
    /// </summary>
    public double Miss { get; init; }

    /// <summary>Distance of the closest approach to the point on the way, m; null without one.</summary>
    public double? WaypointMiss { get; init; }

    /// <summary>When the ball is closest to the target, s after the kick.</summary>
    public double Time { get; init; }

    /// <summary>Where it is then, m.</summary>
    public Vector3d Closest { get; init; }

    /// <summary>Of the two kicks of this speed that reach a target, which one a hit is: the other than was asked for where only that lies within the bounds.</summary>
    public AimArc Arc { get; init; }

    /// <summary>True where the kick stays on the ground from its start: it slides or rolls to the target.</summary>
    public bool Rolls { get; init; }

    /// <summary>Iterations of the method.</summary>
    public int Iterations { get; init; }

    /// <summary>Forward simulations by the method, the measurement of the miss not counted.</summary>
    public int Simulations { get; init; }

    /// <summary>The name of what is in the way of a kick that is <see cref="AimStatus.Blocked"/>: an obstacle's, a net's, "left post" …; else null.</summary>
    public string? BlockedBy { get; init; }

    /// <summary>The kick in a line.</summary>
    public override string ToString() => FormattableString.Invariant(
        $"{Status}: {Speed:0.##} m/s, elevation {ElevationDegrees:0.##}°, azimuth {AzimuthDegrees:0.##}°, spin ({TopSpin:0.#}, {SideSpin:0.#}) rad/s, {Miss:0.####} m off after {Time:0.###} s");

    /// <summary>The kick in a line, its numbers with a format each, such as "F2".</summary>
    /// <param name="format">A format of numbers; null or empty for the digits of <see cref="ToString()"/>.</param>
    /// <param name="formatProvider">The culture; default the invariant one.</param>
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
    /// <summary>The kick passes the target within the tolerance, and the point on the way, where there is one, within its own.</summary>
    Hit = 0,

    /// <summary>No kick within the bounds does; the one returned comes closest, as far as the method can tell.</summary>
    OutOfReach = 1,

    /// <summary>The method ended at its bound, <see cref="AimRequest.MaximumIterations"/>, or a miss is too small for its own steps; the kick returned is the best it found.</summary>
    NotConverged = 2,

    /// <summary>The request has no direction: the target is where the ball is.</summary>
    Degenerate = 3,

    /// <summary>The kick passes the target within the tolerance, but not the point on the way: the spins allowed do not bend it enough.</summary>
    WaypointMissed = 4,

    /// <summary>The kick returned would hit, but something of the scene is in its way: <see cref="AimResult.BlockedBy"/> says what.</summary>
    Blocked = 5,
}
