using FootballPhysics.Scenarios.Input;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Intercept;

/// <summary>A shot, and the players who run to the ball.</summary>
internal sealed record InterceptScenario
{
    public required Scenario Shot { get; init; }

    public required IReadOnlyList<string> Names { get; init; }

    public required Player[] Runners { get; init; }

    /// <summary>Reads a scenario. The library checks the numbers when it is simulated.</summary>
    /// <exception cref="RefusedException">A field is unknown, missing or of the wrong type.</exception>
    public static InterceptScenario Read(InputFields fields)
    {
        InputObject root = fields.Root;
        IReadOnlyList<InputObject> runners = root.Objects("runners");
        var scenario = new InterceptScenario
        {
            Shot = Scenario.Take(root),
            Names = [.. runners.Select((item, i) => item.Text("name", FormattableString.Invariant($"runner {i}")))],
            Runners = [.. runners.Select(PlayerInput.Player)],
        };
        fields.Check();
        return scenario;
    }
}
