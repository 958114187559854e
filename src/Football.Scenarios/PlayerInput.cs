using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Scenarios;

/// <summary>Reads a player who runs to the ball: an item of "runners", or a goalkeeper.</summary>
public static class PlayerInput
{
    /// <summary>Reads the player. The library checks the numbers when it uses them.</summary>
    /// <param name="item">The object that describes the player.</param>
    public static Player Player(InputObject item)
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
