using FootballPhysics.Tool.Replay;

namespace FootballPhysics.Tool.Gallery;

/// <summary>What stands and lies around the shots of the gallery, by its place along the view and to the left of it, m.</summary>
internal static class Furniture
{
    /// <summary>A goal that is looked at from the front.</summary>
    public static Goal Goal(double along) => new() { Center = new Vector3d(0, 0, -along), Facing = new Vector3d(0, 0, 1) };

    /// <summary>A wall of players.</summary>
    public static Obstacle Wall(double along, double leftFrom, double leftTo, double height) => new()
    {
        Name = "wall",
        Shape = new BoxShape(new Vector3d(-0.5 * (leftFrom + leftTo), 0.5 * height, -along), new Vector3d(0.5 * (leftTo - leftFrom), 0.5 * height, 0.2)),
    };

    /// <summary>The halfway line.</summary>
    public static SceneShape HalfwayLine(double along) => new("halfway line", SceneShapeKind.Marking)
    {
        Lines = [[new Vector3d(-30, 0.005, -along), new Vector3d(30, 0.005, -along)]],
    };
}
