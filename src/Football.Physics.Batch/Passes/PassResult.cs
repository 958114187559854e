namespace FootballPhysics.Batch;

/// <summary>The best pass of a fan.</summary>
public readonly struct PassResult
{
    /// <summary>True if there is a pass. Otherwise only the counts are valid.</summary>
    public bool IsFound { get; internal init; }

    /// <summary>The velocity of the kick, in m/s.</summary>
    public Vector3d Velocity { get; internal init; }

    /// <summary>The spin of the kick, in rad/s.</summary>
    public Vector3d Spin { get; internal init; }

    /// <summary>The index of the team mate who reaches the ball first; −1 if none were given.</summary>
    public int Receiver { get; internal init; }

    /// <summary>The point and time at which the team mate reaches the ball.</summary>
    /// <remarks>Without team mates, this is the point at which the ball lands, or comes to rest on the ground.</remarks>
    public PathPoint Meeting { get; internal init; }

    /// <summary>The lead over the fastest opponent, in s; infinite if no opponent can reach the ball.</summary>
    /// <remarks>Opponents are considered until the ball lands, or comes to rest on the ground, for at most <see cref="PassFanRequest.Duration"/>.</remarks>
    public double TimeMargin { get; internal init; }

    /// <summary>The number of simulated kicks.</summary>
    public int Kicks { get; internal init; }

    /// <summary>The number of kicks that a team mate seems to reach before any opponent.</summary>
    /// <remarks>Without team mates, this is the number of kicks that no opponent seems to reach.</remarks>
    public int Open { get; internal init; }

    /// <inheritdoc/>
    public override string ToString() => IsFound
        ? FormattableString.Invariant($"pass to player {Receiver}: {Velocity:0.###} m/s, met at {Meeting.Position:0.###} after {Meeting.Time:0.###} s")
        : FormattableString.Invariant($"no pass among {Kicks} kicks");
}
