namespace FootballPhysics.Tool.Intercept;

/// <summary>The times at which players can reach the ball, and the first player.</summary>
/// <param name="Scenario">The scenario.</param>
/// <param name="Windows">The time windows of each runner.</param>
/// <param name="Shares">The part of the path that each player owns.</param>
internal sealed record InterceptOutcome(InterceptScenario Scenario, IReadOnlyList<InterceptWindow[]> Windows, IReadOnlyList<PossessionInterval> Shares)
{
    /// <summary>The index of the first player; −1 if nobody reaches the ball.</summary>
    public required int First { get; init; }

    /// <summary>The lead of the first player over the second, in s.</summary>
    public required double Lead { get; init; }
}
