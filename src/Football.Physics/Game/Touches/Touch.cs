using System.Globalization;
using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>The result of a search for a touch: the strike, its effect on the ball, and its chance of success.</summary>
/// <remarks>Whatever the status, the result contains the best touch found, with finite numbers.</remarks>
public readonly struct Touch : IFormattable
{
    internal Touch(TouchStatus status, in FootStrike strike, in Vector3d place, in Vector3d ballVelocity, double time, double miss, double paceMiss, double chance)
    {
        Status = status;
        Strike = strike;
        Position = place;
        BallVelocity = ballVelocity;
        Time = time;
        Miss = miss;
        SpeedError = paceMiss;
        Chance = chance;
    }

    /// <summary>The outcome of the search.</summary>
    public TouchStatus Status { get; }

    /// <summary>True if the touch meets the request within its tolerance.</summary>
    public bool Succeeds => Status == TouchStatus.Done;

    /// <summary>The foot's motion, the point of contact, and the effect on foot and ball.</summary>
    public FootStrike Strike { get; }

    /// <summary>The velocity of the ball just after the touch, in m/s; pass it to <see cref="Simulator.Kick"/>.</summary>
    public Vector3d Velocity => Strike.Velocity;

    /// <summary>The spin of the ball just after the touch, in rad/s; pass it to <see cref="Simulator.Kick"/>.</summary>
    public Vector3d Spin => Strike.Spin;

    /// <summary>The position of the ball at the evaluation time, in m.</summary>
    /// <remarks>The evaluation time is the requested time for a dribble, the settling time for a trap, and the time of closest approach to the target for a
    /// shot.</remarks>
    public Vector3d Position { get; }

    /// <summary>The velocity of the ball at the evaluation time, in m/s.</summary>
    public Vector3d BallVelocity { get; }

    /// <summary>The evaluation time, in s after the touch.</summary>
    public double Time { get; }

    /// <summary>The distance of the ball from its target at the evaluation time, in m.</summary>
    /// <remarks>
    /// For a dribble, it is the horizontal distance; for a shot, the distance in three dimensions. For a trap, it is the horizontal distance from the
    /// point of the touch, which moves with the player.
    /// </remarks>
    public double Miss { get; }

    /// <summary>The error in the ball's horizontal velocity at the evaluation time, in m/s; 0 for a shot.</summary>
    /// <remarks>For a dribble, it is the error of the speed.</remarks>
    public double SpeedError { get; }

    /// <summary>The share of random touches, with the player's errors (<see cref="TouchSpread"/>), that succeed; 0 … 1.</summary>
    /// <remarks>NaN if no random touches were requested.</remarks>
    public double Chance { get; }

    /// <summary>Returns the touch as one line of text.</summary>
    public override string ToString() => ToString(null, CultureInfo.InvariantCulture);

    /// <summary>Returns the touch as one line of text, in a given number format.</summary>
    /// <param name="format">A number format; null or empty for at most three decimals.</param>
    /// <param name="formatProvider">The culture; default: the invariant culture.</param>
    public string ToString(string? format, IFormatProvider? formatProvider = null)
    {
        format = NumberFormat.OrShort(format);
        IFormatProvider culture = formatProvider ?? CultureInfo.InvariantCulture;
        return $"{Status}: ball {Velocity.ToString(format, culture)} m/s by a foot of {Strike.FootVelocity.ToString(format, culture)} m/s, after {Time.ToString(format, culture)} s {Miss.ToString(format, culture)} m and {SpeedError.ToString(format, culture)} m/s off";
    }
}

/// <summary>The outcome of a search for a touch.</summary>
public enum TouchStatus
{
    /// <summary>The touch meets the request within its tolerance.</summary>
    Done = 0,

    /// <summary>The touch needs a faster foot than <see cref="Foot.MaximumSpeed"/>.</summary>
    FootTooSlow = 1,

    /// <summary>No touch meets the request.</summary>
    /// <remarks>The target is out of reach, an object is in the way, or the foot cannot give the spin required.</remarks>
    OutOfReach = 2,

    /// <summary>The request has no direction: the ball is already at the target, or already moves as requested.</summary>
    Degenerate = 3,
}
