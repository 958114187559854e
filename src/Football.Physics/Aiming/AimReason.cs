using System.Globalization;
using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>The reason for a verdict: the bound that excludes every kick, the undefined quantity, or the kind of the nearest miss.</summary>
/// <remarks>Each reason has one status, so that a search cannot exclude every kick without naming a bound.</remarks>
internal enum AimReason
{
    /// <summary>The kick hits.</summary>
    Hit = 0,

    /// <summary>Bound: the energy of every kick is too small for the height of the target.</summary>
    TooHigh,

    /// <summary>Bound: every kick is nearer at the requested time.</summary>
    TooFarInTime,

    /// <summary>Bound: every kick is slower at the target than the requested speed.</summary>
    TooSlow,

    /// <summary>Bound: flights at close elevations, all of which pass below the target or fall short of it (<see cref="ReachCover"/>).</summary>
    TooShort,

    /// <summary>Bound: flights at close elevations, some of which pass above the target.</summary>
    BetweenBounds,

    /// <summary>Undefined: the direction of the kick.</summary>
    NoDirection,

    /// <summary>Undefined: the order of the waypoint and the target, for the thesis' two-point method.</summary>
    NoOrder,

    /// <summary>Miss: the closest kick found.</summary>
    NoneFound,

    /// <summary>Miss: the closest kick found before the search reached its limit.</summary>
    Spent,

    /// <summary>Miss: a kick whose measured flight differs from that of the search.</summary>
    Deviates,

    /// <summary>Miss: a kick that touches the ground before it is due.</summary>
    TooEarly,

    /// <summary>Miss: a kick that arrives at another speed.</summary>
    OtherSpeed,

    /// <summary>Miss: the closest of the kicks that hit the given objects in order.</summary>
    NoSequence,

    /// <summary>Miss: the closer one of the lowest and the highest kick, between which the thesis' methods search.</summary>
    SameSide,

    /// <summary>Miss: a kick that hits the target, but not the waypoint.</summary>
    PastWaypoint,

    /// <summary>Miss: a kick that an object blocks.</summary>
    InTheWay,
}

/// <summary>The statuses and sentences of reasons.</summary>
internal static class AimReasons
{
    /// <summary>Returns the status that a reason has.</summary>
    public static AimStatus Status(this AimReason reason) => reason switch
    {
        AimReason.Hit => AimStatus.Hit,
        AimReason.TooHigh or AimReason.TooFarInTime or AimReason.TooSlow or AimReason.TooShort or AimReason.BetweenBounds => AimStatus.OutOfReach,
        AimReason.NoDirection or AimReason.NoOrder => AimStatus.Degenerate,
        AimReason.PastWaypoint => AimStatus.WaypointMissed,
        AimReason.InTheWay => AimStatus.Blocked,
        <= AimReason.InTheWay => AimStatus.NotConverged,
        _ => throw Check.Unknown(nameof(reason), reason),
    };

    /// <summary>Returns the sentences for a reason; null for a hit.</summary>
    /// <param name="reason">The reason.</param>
    /// <param name="kick">The result, which contains the nearest miss.</param>
    public static string? Text(this AimReason reason, in AimResult kick)
    {
        AimStatus status = reason.Status();
        if (status == AimStatus.Hit)
        {
            return null;
        }

        string sentence = status == AimStatus.Blocked ? $"The kick would hit, but an object is in its path: {kick.BlockedBy}." : Sentence(reason);
        double miss = status == AimStatus.WaypointMissed ? kick.WaypointMiss.GetValueOrDefault() : kick.Miss;
        return status is AimStatus.OutOfReach or AimStatus.Degenerate ? sentence : $"{sentence} The nearest miss is {miss.ToString("G3", CultureInfo.InvariantCulture)} m.";
    }

    private static string Sentence(AimReason reason) => reason switch
    {
        AimReason.TooHigh => "Every allowed kick has too little energy for the height of the target.",
        AimReason.TooFarInTime => "Every allowed kick is too slow to cover the distance in the requested time.",
        AimReason.TooSlow => "Every allowed kick is slower at the target than the requested arrival speed.",
        AimReason.TooShort => "Flights at close elevations all pass below the target or fall short of it.",
        AimReason.BetweenBounds => "Flights at close elevations all pass above the target or below it.",
        AimReason.NoDirection => "The direction of the kick is undefined, because the target is at the ball's position.",
        AimReason.NoOrder => "The order of the points is undefined, because the waypoint is not between the ball and the target.",
        AimReason.NoneFound => "The search found no hit, but no bound excludes one.",
        AimReason.Spent => "The search reached its limit of iterations or path segments.",
        AimReason.Deviates => "The measured flight of the kick found touches the ground first, or passes the target.",
        AimReason.TooEarly => "The closest kick found touches the ground before the requested time.",
        AimReason.OtherSpeed => "The closest kick found arrives at another speed than the requested one.",
        AimReason.NoSequence => "No kick found hits the given objects in order and then the target.",
        AimReason.SameSide => "The lowest and the highest kick pass on the same side of the target, where this method ends.",
        AimReason.PastWaypoint => "No spin found within the limits takes the ball past the waypoint.",
        _ => throw Check.Unknown(nameof(reason), reason),
    };
}
