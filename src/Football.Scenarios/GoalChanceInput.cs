using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Scenarios;

/// <summary>Reads a shot and the scatter of the player's kicks, for the probability of a goal.</summary>
public static class GoalChanceInput
{
    /// <summary>Reads the request. The library checks the numbers during the search.</summary>
    /// <param name="shot">The object that describes the shot.</param>
    /// <param name="goals">The goals of the scene; the member "goal" is the index of one of them.</param>
    /// <exception cref="RefusedException">The scene has no such goal.</exception>
    public static GoalChanceRequest Request(InputObject shot, IReadOnlyList<Goal> goals) =>
        Request(shot, goals, shot.Vector("position"), shot.Vector("velocity"), shot.Vector("spin", Vector3d.Zero), Scenario.OrientationOf(shot));

    /// <summary>Reads the request for a kick that is given elsewhere.</summary>
    /// <inheritdoc cref="Request(InputObject, IReadOnlyList{Goal})"/>
    /// <param name="shot">The object that describes keeper, spread and kicks.</param>
    /// <param name="goals">The goals of the scene.</param>
    /// <param name="position">The position of the ball, in m.</param>
    /// <param name="velocity">The intended velocity, in m/s.</param>
    /// <param name="spin">The intended spin, in rad/s.</param>
    /// <param name="orientation">The orientation of the ball; null for that of a launch without one.</param>
    public static GoalChanceRequest Request(InputObject shot, IReadOnlyList<Goal> goals, Vector3d position, Vector3d velocity, Vector3d spin, Quaterniond? orientation)
    {
        InputObject spread = shot.Object("spread");
        var defaults = new KickSpread();
        int goal = shot.Whole("goal", 0);
        if (goal < 0 || goal >= goals.Count)
        {
            throw new RefusedException("goal", FormattableString.Invariant($"{goal}"), goals.Count == 0 ? "none, because the scene has no goals" : FormattableString.Invariant($"0 … {goals.Count - 1}"));
        }

        return new GoalChanceRequest
        {
            Position = position,
            Velocity = velocity,
            Spin = spin,
            Orientation = orientation,
            Goal = goals[goal],
            Keeper = shot.Has("keeper") ? PlayerInput.Player(shot.Object("keeper")) : null,
            Kicks = shot.Whole("kicks", GoalChance.Flights),
            Seed = shot.OptionalWhole("seed", 0) ?? 0,
            AlwaysSimulate = shot.Flag("alwaysSimulate", false),
            Spread = new KickSpread
            {
                SpeedPercent = spread.Number("speedPercent", defaults.SpeedPercent),
                ElevationDegrees = spread.Number("elevationDegrees", defaults.ElevationDegrees),
                AzimuthDegrees = spread.Number("azimuthDegrees", defaults.AzimuthDegrees),
                SpinPercent = spread.Number("spinPercent", defaults.SpinPercent),
                SpeedWithElevation = spread.Number("speedWithElevation", defaults.SpeedWithElevation),
                SpeedWithAzimuth = spread.Number("speedWithAzimuth", defaults.SpeedWithAzimuth),
                SpeedWithSpin = spread.Number("speedWithSpin", defaults.SpeedWithSpin),
                ElevationWithAzimuth = spread.Number("elevationWithAzimuth", defaults.ElevationWithAzimuth),
                ElevationWithSpin = spread.Number("elevationWithSpin", defaults.ElevationWithSpin),
                AzimuthWithSpin = spread.Number("azimuthWithSpin", defaults.AzimuthWithSpin),
            },
        };
    }
}
