namespace FootballPhysics.Prediction;

/// <summary>A goalkeeper's response to a shot.</summary>
public readonly struct KeeperResult
{
    /// <summary>True if the ball's centre crosses the goal line's vertical plane from the pitch within the look-ahead.</summary>
    public bool Crosses { get; internal init; }

    /// <summary>The point at which the ball crosses the plane.</summary>
    public PathPoint Crossing { get; internal init; }

    /// <summary>The distance to the right of the goal's centre at which the ball crosses the line, in m.</summary>
    /// <remarks>Right is as seen from the goal, facing the pitch.</remarks>
    public double LateralOffset { get; internal init; }

    /// <summary>True if the ball's centre crosses between the posts and below the bar.</summary>
    /// <remarks>A goal is scored through this opening; see <see cref="BallEventKind.Goal"/>.</remarks>
    public bool IsOnTarget { get; internal init; }

    /// <summary>The left end of the part of the goal line that the keeper can cover in time, in m to the right of the centre.</summary>
    /// <remarks>Greater than <see cref="ReachRight"/> if the keeper cannot cover any of the line.</remarks>
    public double ReachLeft { get; internal init; }

    /// <summary>The right end of the part of the goal line that the keeper can cover in time, in m to the right of the centre.</summary>
    public double ReachRight { get; internal init; }

    /// <summary>The height up to which the keeper covers the line, in m: his reach or the bar, whichever is lower.</summary>
    public double ReachHeight { get; internal init; }

    /// <summary>True if the keeper can reach the ball before it crosses the line.</summary>
    public bool Saves { get; internal init; }

    /// <summary>The first point at which the keeper can reach the ball, if there is one.</summary>
    public PathPoint Save { get; internal init; }

    /// <summary>The latest time at which the keeper can react and still save the shot, in s since the launch.</summary>
    /// <remarks>NaN if the keeper cannot reach the ball. Until he reacts, he continues his motion, so a later reaction may succeed when an earlier one fails;
    /// this is the latest that succeeds. A range of successful reaction times shorter than a microsecond may be missed.</remarks>
    public double LatestReaction { get; internal init; }

    /// <inheritdoc/>
    public override string ToString() => !Crosses ? "no shot at the goal" : FormattableString.Invariant(
        $"crosses at {Crossing.Position:0.###} after {Crossing.Time:0.###} s, {(IsOnTarget ? "on" : "off")} target, {(Saves ? "saved" : "not saved")}");
}
