namespace FootballPhysics.Tool.Intercept;

/// <summary>Who gets to the ball, and when.</summary>
/// <param name="Scenario">What was asked.</param>
/// <param name="Windows">The windows of each runner.</param>
/// <param name="Shares">Who owns which part of the way.</param>
internal sealed record InterceptOutcome(InterceptScenario Scenario, IReadOnlyList<InterceptWindow[]> Windows, IReadOnlyList<PossessionInterval> Shares)
{
    /// <summary>Who is first; −1 where nobody is.</summary>
    public required int First { get; init; }

    /// <summary>By how much, s.</summary>
    public required double Lead { get; init; }
}
