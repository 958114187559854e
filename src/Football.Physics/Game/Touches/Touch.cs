using System.Globalization;

namespace FootballPhysics.Aiming;

/// <summary>A touch of the ball that was found: how the foot moves, what the ball does then, and how surely. Whatever the status, it is the best one found, and finite.</summary>
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

    /// <summary>True where the touch does what was wanted, within its tolerance.</summary>
    public bool Succeeds => Status == TouchStatus.Done;

    /// <summary>The foot's motion, where it touches the ball, and what it does to both.</summary>
    public FootStrike Strike { get; }

    /// <summary>Velocity of the ball just after the touch, m/s: for <see cref="Simulator.Kick"/>.</summary>
    public Vector3d Velocity => Strike.Velocity;

    /// <summary>Spin of the ball just after the touch, rad/s: for <see cref="Simulator.Kick"/>.</summary>
    public Vector3d Spin => Strike.Spin;

    /// <summary>Where the ball is at the end, m: of a dribbling touch at its time, of a trap when it has settled, of a shot where it is closest to the target.</summary>
    public Vector3d Position { get; }

    /// <summary>Velocity of the ball then, m/s.</summary>
    public Vector3d BallVelocity { get; }

    /// <summary>When that is, s after the touch.</summary>
    public double Time { get; }

    /// <summary>
    /// How far the ball is then from where it was wanted, m: of a dribbling touch over the ground, of a shot in space. Of a trap how far it is from where it was touched, seen by
    /// the player.
    /// </summary>
    public double Miss { get; }

    /// <summary>Difference of the ball's velocity over the ground then from what was wanted, m/s: of a dribbling touch that of its speed. 0 for a shot.</summary>
    public double SpeedError { get; }

    /// <summary>The share of touches with the player's errors (<see cref="TouchSpread"/>) that come off, 0 … 1; not a number where that was not asked for.</summary>
    public double Chance { get; }

    /// <summary>The touch in a line.</summary>
    public override string ToString() => ToString(null, CultureInfo.InvariantCulture);

    /// <summary>The touch in a line, its numbers with a format each, such as "F2".</summary>
    /// <param name="format">A format of numbers; null or empty for three decimals at most.</param>
    /// <param name="formatProvider">The culture; default the invariant one.</param>
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
    /// <summary>The touch does what was wanted, within its tolerance.</summary>
    Done = 0,

    /// <summary>It would take a faster foot than <see cref="Foot.MaximumSpeed"/>.</summary>
    FootTooSlow = 1,

    /// <summary>No touch does: the target is out of reach, something is in the way, or no foot gives the ball the spin that it would need.</summary>
    OutOfReach = 2,

    /// <summary>The request has no direction: the ball is at the target, or moves already as it should.</summary>
    Degenerate = 3,
}
