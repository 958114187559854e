namespace FootballPhysics;

/// <summary>Places on the ground: where a ball lies above a point of the map, and how far one in the ground is raised.</summary>
/// <remarks>Vertical: x and z stay as they are.</remarks>
internal static class GroundPlace
{
    /// <summary>A smaller overlap is rounding, or counts as touching, and is left alone, m.</summary>
    private const double Overlap = 5e-10;

    /// <summary>The gap to the ground is this small at the end, as a share of the height, or of 1 m.</summary>
    private const double Closeness = 1e-14;

    /// <summary>Steps of Newton's method at most: five near the ground; far from uneven ground each leaves less than a third of the way.</summary>
    private const int MostSteps = 64;

    /// <summary>A plane that leans further than this, by the y of its normal, is a wall: nothing is above it.</summary>
    private const double Wall = 1e-6;

    /// <summary>The centre of a ball that lies on the ground; at height 0 if there is no ground.</summary>
    /// <param name="world">The world.</param>
    /// <param name="x">x, m.</param>
    /// <param name="z">z, m.</param>
    public static Vector3d At(World world, double x, double z) =>
        world.Ground is null ? new Vector3d(x, 0, z) : Onto(world, new Vector3d(x, 0, z));

    /// <summary>A position of the ball's centre; one in the ground is raised to the least height at which the ball is not in the ground.</summary>
    /// <param name="world">The world.</param>
    /// <param name="position">The position, m.</param>
    public static Vector3d Raised(World world, in Vector3d position)
    {
        if (world.IsLevel)
        {
            // Set the exact height: other code compares heights on level ground exactly.
            return position.Y < world.LevelContact ? new Vector3d(position.X, world.LevelContact, position.Z) : position;
        }

        return world.Ground is { } ground && world.Ball.Radius - ground.At(in position).Distance > Overlap
            ? Onto(world, in position)
            : position;
    }

    /// <summary>The place straight above or below a position where a ball touches the ground, which there is.</summary>
    /// <param name="world">The world.</param>
    /// <param name="position">The position, m.</param>
    public static Vector3d Onto(World world, in Vector3d position)
    {
        if (world.IsLevel)
        {
            return new Vector3d(position.X, world.LevelContact, position.Z);
        }

        // Newton's method for d(y) = r with d' = n_y: one step on a plane. On uneven ground n_y is 0.7 … 1 and changes by less than a third
        // within the ball's reach; far off, the lower bound used for d never overshoots the root. So it always converges.
        Vector3d at = position;
        for (int i = 0; i < MostSteps; i++)
        {
            ShapePoint point = world.Ground!.At(in at);
            double below = world.Ball.Radius - point.Distance;
            if (!(Math.Abs(below) > Closeness * (1.0 + Math.Abs(at.Y))))
            {
                break;
            }

            if (point.Normal.Y < Wall)
            {
                return at + (below * point.Normal);
            }

            at = new Vector3d(at.X, at.Y + (below / point.Normal.Y), at.Z);
        }

        return at;
    }
}
