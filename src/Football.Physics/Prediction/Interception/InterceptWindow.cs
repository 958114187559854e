namespace FootballPhysics.Prediction;

/// <summary>A time interval during which a player can reach the ball.</summary>
public readonly struct InterceptWindow
{
    internal InterceptWindow(int runner, double from, double to, in Vector3d position, in Vector3d velocity)
    {
        Player = runner;
        From = from;
        To = to;
        Position = position;
        Velocity = velocity;
    }

    /// <summary>The index of the player.</summary>
    public int Player { get; }

    /// <summary>The start of the interval, in s since the launch.</summary>
    public double From { get; }

    /// <summary>The end of the interval, in s since the launch.</summary>
    public double To { get; }

    /// <summary>The position of the ball at the start of the interval, in m.</summary>
    public Vector3d Position { get; }

    /// <summary>The velocity of the ball at the start of the interval, in m/s.</summary>
    public Vector3d Velocity { get; }

    /// <inheritdoc/>
    public override string ToString() => FormattableString.Invariant($"player {Player}: {From:0.###} … {To:0.###} s, first at {Position:0.###}");
}

/// <summary>A part of the ball's path that one player owns, because he can reach it first.</summary>
/// <remarks>Only players who can reach the ball in this interval are considered.</remarks>
public readonly struct PossessionInterval
{
    internal PossessionInterval(int runner, double from, double to, double lead)
    {
        Player = runner;
        From = from;
        To = to;
        TimeMargin = lead;
    }

    /// <summary>The index of the player.</summary>
    public int Player { get; }

    /// <summary>The start of the interval, in s since the launch.</summary>
    public double From { get; }

    /// <summary>The end of the interval, in s since the launch.</summary>
    public double To { get; }

    /// <summary>The lead of the owner over the second player at the start of the interval, in s.</summary>
    /// <remarks>Infinite if no other player can reach the ball.</remarks>
    public double TimeMargin { get; }

    /// <inheritdoc/>
    public override string ToString() => FormattableString.Invariant($"player {Player}: {From:0.###} … {To:0.###} s, {TimeMargin:0.###} s before others");
}
