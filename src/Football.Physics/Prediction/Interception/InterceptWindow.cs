namespace FootballPhysics.Prediction;

/// <summary>A time during which a runner can meet the ball.</summary>
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

    /// <summary>Which of the runners, from 0.</summary>
    public int Player { get; }

    /// <summary>When it begins, s since the launch.</summary>
    public double From { get; }

    /// <summary>When it ends, s since the launch.</summary>
    public double To { get; }

    /// <summary>Where the ball is when it begins, m: its height is that of the ball there.</summary>
    public Vector3d Position { get; }

    /// <summary>The ball's velocity when it begins, m/s: how fast it comes, and which way.</summary>
    public Vector3d Velocity { get; }

    /// <inheritdoc/>
    public override string ToString() => FormattableString.Invariant($"player {Player}: {From:0.###} … {To:0.###} s, first at {Position:0.###}");
}

/// <summary>A part of the ball's way that one runner owns: of those who can meet the ball there, he could be there first.</summary>
public readonly struct PossessionInterval
{
    internal PossessionInterval(int runner, double from, double to, double lead)
    {
        Player = runner;
        From = from;
        To = to;
        TimeMargin = lead;
    }

    /// <summary>Which of the runners, from 0.</summary>
    public int Player { get; }

    /// <summary>When it begins, s since the launch.</summary>
    public double From { get; }

    /// <summary>When it ends, s since the launch.</summary>
    public double To { get; }

    /// <summary>By how much he could be where the ball is when it begins before the second of them, s; infinite where no one else can.</summary>
    public double TimeMargin { get; }

    /// <inheritdoc/>
    public override string ToString() => FormattableString.Invariant($"player {Player}: {From:0.###} … {To:0.###} s, {TimeMargin:0.###} s before others");
}
