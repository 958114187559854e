namespace FootballPhysics.Contacts;

/// <summary>Positions on the ground: the centre of a ball above a point of the map, and the correction of a ball below the
/// surface.</summary>
/// <remarks>All corrections are vertical; x and z do not change.</remarks>
internal static class GroundPlace
{
    /// <summary>Maximum number of Newton iterations: five near the ground; far from uneven ground each leaves less than a third of the
    /// distance.</summary>
    private const int MostSteps = 64;

    /// <summary>Returns the centre of a ball on the ground; at height 0 if there is no ground.</summary>
    /// <param name="world">The world.</param>
    /// <param name="x">x, m.</param>
    /// <param name="z">z, m.</param>
    public static Vector3d At(World world, double x, double z) =>
        world.Ground is null ? new Vector3d(x, 0, z) : Onto(world, new Vector3d(x, 0, z));

    /// <summary>Returns the position of the centre, raised to the lowest free height if the ball overlaps the ground.</summary>
    /// <param name="world">The world.</param>
    /// <param name="position">The position, m.</param>
    public static Vector3d Raised(World world, in Vector3d position) =>
        world.Ground is not { } ground ? position
        : ground.IsLevelGround ? ground.SnapUp(in position)
        : world.Ball.Radius - ground.At(in position).Distance > ContactTolerances.Overlap ? Onto(world, in position)
        : position;

    /// <summary>Returns the position vertically above or below a point at which a ball touches the ground.</summary>
    /// <remarks>The scene must have ground.</remarks>
    /// <param name="world">The world.</param>
    /// <param name="position">The position, m.</param>
    public static Vector3d Onto(World world, in Vector3d position)
    {
        Collider ground = world.Ground!;
        if (ground.IsLevelGround)
        {
            return ground.Snap(in position);
        }

        // Find the height y at which the distance d(y) is the radius r, by Newton's method with d' = n_y: one step on a plane. On uneven ground, n_y
        // is 0.7 … 1 and changes by less than a third within the ball's reach. Far off, the lower bound used for d never overshoots the root, so the
        // method always converges.
        Vector3d at = position;
        for (int i = 0; i < MostSteps; i++)
        {
            ShapePoint point = ground.At(in at);
            double below = world.Ball.Radius - point.Distance;
            if (!(Math.Abs(below) > ContactTolerances.OnGround * (1.0 + Math.Abs(at.Y))))
            {
                break;
            }

            if (point.Normal.Y < ContactTolerances.Wall)
            {
                return at + (below * point.Normal);
            }

            at = new Vector3d(at.X, at.Y + (below / point.Normal.Y), at.Z);
        }

        return at;
    }
}
