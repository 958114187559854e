namespace FootballPhysics.Tool.Gallery;

/// <summary>The directions of a goal.</summary>
internal static class GoalAxes
{
    /// <summary>Returns the unit vector towards the pitch.</summary>
    public static Vector3d Outward(this Goal goal) => goal.Facing.Normalized();

    /// <summary>Returns the unit vector along the goal line towards "right post", which is on the goalkeeper's right.</summary>
    public static Vector3d Right(this Goal goal) => Vector3d.Cross(goal.Outward(), Vector3d.Up);
}
