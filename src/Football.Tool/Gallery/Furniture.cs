using FootballPhysics.Tool.Replay;

namespace FootballPhysics.Tool.Gallery;

/// <summary>Creates objects around the shots of the gallery. Their positions are given along the view and to its left, in m.</summary>
internal static class Furniture
{
    /// <summary>Returns a goal that faces the spectator.</summary>
    public static Goal Goal(double along) => new() { Center = new Vector3d(0, 0, -along), Facing = new Vector3d(0, 0, 1) };

    /// <summary>Returns a wall of players.</summary>
    public static Obstacle Wall(double along, double leftFrom, double leftTo, double height) => new()
    {
        Name = "wall",
        Shape = new BoxShape(new Vector3d(-0.5 * (leftFrom + leftTo), 0.5 * height, -along), new Vector3d(0.5 * (leftTo - leftFrom), 0.5 * height, 0.2)),
    };

    /// <summary>The halfway line before a goal kick.</summary>
    public static SceneShape HalfwayLine { get; } = new("halfway line", SceneShapeKind.Marking) { Lines = [[new Vector3d(-30, 0.005, -47), new Vector3d(30, 0.005, -47)]] };
}
