using FootballPhysics.Scenarios.Input;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Intercept;

/// <summary>A shot, and those who go for the ball.</summary>
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
            Runners = [.. runners.Select(Read)],
        };
        fields.Check();
        return scenario;
    }

    private static Player Read(InputObject item)
    {
        var defaults = new Player();
        double[] heights = item.Numbers("heights", "[lowest, highest]", [defaults.MinimumHeight, defaults.MaximumHeight]);
        return new Player
        {
            Position = item.Vector("position"),
            Velocity = item.Vector("velocity", Vector3d.Zero),
            Reaction = item.Number("reaction", defaults.Reaction),
            Acceleration = item.Number("acceleration", defaults.Acceleration),
            Speed = item.Number("speed", defaults.Speed),
            Reach = item.Number("reach", defaults.Reach),
            MinimumHeight = heights[0],
            MaximumHeight = heights[1],
        };
    }
}
