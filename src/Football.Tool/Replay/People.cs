namespace FootballPhysics.Tool.Replay;

/// <summary>Recognises obstacles that drawings show as people, by name and size. For the ball, they are boxes and capsules.</summary>
internal static class People
{
    /// <summary>The width per person in a wall, in m.</summary>
    private const double Room = 0.52;

    private static readonly Vector3d s_ahead = new(0, 0, 1);

    /// <summary>
    /// Returns the people of an obstacle: the players of "wall", the goalkeeper of "keeper", or the player under "head". Each has feet, shoulders,
    /// hands and a facing direction. Returns null for other obstacles.
    /// </summary>
    public static IReadOnlyList<Vector3d[]>? Of(Obstacle obstacle) => (obstacle.Name, obstacle.Shape) switch
    {
        ("wall", FootballPhysics.Shapes.BoxShape box) when IsWall(box) => Row(box),
        ("wall", FootballPhysics.Shapes.CapsuleShape rod) => [Standing(new Vector3d(rod.From.X, rod.From.Y - rod.Radius, rod.From.Z), 1.45)],
        ("wall", FootballPhysics.Shapes.SphereShape) => [],
        ("keeper", FootballPhysics.Shapes.CapsuleShape rod) => [Stretched(rod)],
        ("head", FootballPhysics.Shapes.SphereShape head) => [Jumping(head, obstacle.Velocity)],
        _ => null,
    };

    /// <summary>True if a box is as tall as people, less than 0.8 m thick, and upright.</summary>
    private static bool IsWall(FootballPhysics.Shapes.BoxShape box) => box.HalfSize.Y is > 0.8 and < 1.2 && box.HalfSize.Z < 0.4 && box.Rotation == Quaterniond.Identity;

    private static Vector3d[][] Row(FootballPhysics.Shapes.BoxShape box)
    {
        int count = Math.Max(1, (int)Math.Round(2 * box.HalfSize.X / Room));
        double step = 2 * box.HalfSize.X / count;
        double ground = box.Center.Y - box.HalfSize.Y;
        return [.. Enumerable.Range(0, count).Select(i => Standing(
            new Vector3d(box.Center.X - box.HalfSize.X + ((i + 0.5) * step), ground, box.Center.Z), (2 * box.HalfSize.Y) - 0.4))];
    }

    /// <summary>Returns a standing person with his hands in front of him.</summary>
    private static Vector3d[] Standing(Vector3d feet, double shoulders) =>
        [feet, feet + new Vector3d(0, shoulders, 0), feet + new Vector3d(0, 0.62 * shoulders, 0.2), s_ahead];

    private static Vector3d[] Stretched(FootballPhysics.Shapes.CapsuleShape rod)
    {
        Vector3d along = (rod.To - rod.From).Normalized();
        Vector3d hands = rod.To + (rod.Radius * along);
        Vector3d feet = along.Y > 0.8 ? new Vector3d(rod.From.X, rod.From.Y - rod.Radius, rod.From.Z) : hands - (2.15 * along);
        return along.Y > 0.8
            ? [feet, feet + (1.42 * along), feet + new Vector3d(0, 1.15, 0.35), s_ahead]
            : [feet, feet + (1.42 * along), hands, s_ahead];
    }

    private static Vector3d[] Jumping(FootballPhysics.Shapes.SphereShape head, Vector3d velocity)
    {
        Vector3d forward = velocity.Horizontal.Length > 0.1 ? velocity.Horizontal.Normalized() : s_ahead;
        Vector3d shoulders = head.Center - new Vector3d(0, 0.24, 0) - (0.06 * forward);
        Vector3d feet = shoulders - new Vector3d(0, 1.38, 0) - (0.28 * forward);
        return [feet, shoulders, shoulders + (0.25 * forward) - new Vector3d(0, 0.45, 0), forward];
    }
}
