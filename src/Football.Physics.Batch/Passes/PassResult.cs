namespace FootballPhysics.Batch;

/// <summary>The best pass of a fan.</summary>
public readonly struct PassResult
{
    /// <summary>True when there is one; without it only the counts below count.</summary>
    public bool IsFound { get; init; }

    /// <summary>Velocity of the kick, m/s.</summary>
    public Vector3d Velocity { get; init; }

    /// <summary>Spin of the kick, rad/s.</summary>
    public Vector3d Spin { get; init; }

    /// <summary>Which team mate meets it first; −1 where none were given.</summary>
    public int Receiver { get; init; }

    /// <summary>Where and when he meets it; without team mates where it comes down, or along the ground comes to rest.</summary>
    public PathPoint Meeting { get; init; }

    /// <summary>How much earlier that is than an opponent could meet the ball, s; infinite where none can while the pass is judged: until it comes down, or along the ground until it rests, for <see cref="PassFanRequest.Duration"/> at most.</summary>
    public double TimeMargin { get; init; }

    /// <summary>Kicks that were flown.</summary>
    public int Kicks { get; init; }

    /// <summary>Those of them that a team mate seems to meet before any opponent; without team mates those that no opponent seems to meet.</summary>
    public int Open { get; init; }

    /// <inheritdoc/>
    public override string ToString() => IsFound
        ? FormattableString.Invariant($"pass to player {Receiver}: {Velocity:0.###} m/s, met at {Meeting.Position:0.###} after {Meeting.Time:0.###} s")
        : FormattableString.Invariant($"no pass among {Kicks} kicks");
}
