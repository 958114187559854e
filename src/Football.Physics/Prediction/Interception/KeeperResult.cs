namespace FootballPhysics.Prediction;

/// <summary>A goalkeeper's answer to a shot.</summary>
public readonly struct KeeperResult
{
    /// <summary>True when the ball's centre crosses the vertical plane through the goal's line from the pitch, within the look-ahead.</summary>
    public bool Crosses { get; init; }

    /// <summary>Where and when it does.</summary>
    public PathPoint Crossing { get; init; }

    /// <summary>How far right of the goal's middle that is, seen by who stands in the goal and looks at the pitch, m.</summary>
    public double LateralOffset { get; init; }

    /// <summary>True when the ball's centre crosses between the posts and below the bar: what goes in comes through there, see <see cref="BallEventKind.Goal"/>.</summary>
    public bool IsOnTarget { get; init; }

    /// <summary>The left end of the part of the line that he can cover by then, m right of its middle; above <see cref="ReachRight"/> where it is none.</summary>
    public double ReachLeft { get; init; }

    /// <summary>The right end of it, m right of the middle.</summary>
    public double ReachRight { get; init; }

    /// <summary>How high he covers it, m: his height, or that of the opening.</summary>
    public double ReachHeight { get; init; }

    /// <summary>True when he can meet the ball before it crosses.</summary>
    public bool Saves { get; init; }

    /// <summary>Where and when he can meet it first, if he can.</summary>
    public PathPoint Save { get; init; }

    /// <summary>The latest moment at which he may react, or dive, and still meets it, s since the launch; before that he goes on as he does. NaN where he cannot meet it. Where he runs on, a later reaction may do where earlier ones do not: this is the latest of all; of reactions that would do for less than a microsecond one may be missed.</summary>
    public double LatestReaction { get; init; }

    /// <inheritdoc/>
    public override string ToString() => !Crosses ? "no shot at the goal" : FormattableString.Invariant(
        $"crosses at {Crossing.Position:0.###} after {Crossing.Time:0.###} s, {(IsOnTarget ? "on" : "off")} target, {(Saves ? "saved" : "not saved")}");
}
