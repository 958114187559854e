namespace FootballPhysics.Tool.Aim;

/// <summary>The kick found for an aim scenario.</summary>
/// <param name="Kick">The kick.</param>
/// <param name="Orientation">The orientation of the ball at the kick; null if the scenario has none and no knuckle force acts.</param>
internal sealed record AimAnswer(AimResult Kick, Quaterniond? Orientation)
{
    /// <summary>Finds the kick.</summary>
    /// <exception cref="Scenarios.Input.RefusedException">The motion overflowed, although each number is allowed.</exception>
    public static AimAnswer To(AimScenario scenario) => new(
        AimRun.Find(scenario),
        scenario.Request.Orientation?.Normalized() ?? (scenario.Scene.Forces.KnuckleSeed is null ? null : new Simulator(scenario.Scene, scenario.Settings).LaunchOrientation));
}
