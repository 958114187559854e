namespace Football.Physics;

/// <summary>
/// Keeps a piece along surfaces so short that its path stays on them. How far a step goes off a surface depends on how that bends where the step
/// leads: so it is taken, looked at, and taken again where it went astray.
/// </summary>
internal static class SurfacePath
{
    /// <summary>A path may be so far off its surface, as a share of the ball's radius.</summary>
    private const double Farthest = 0.01;

    /// <summary>How often a piece is taken again at most.</summary>
    private const int MostTries = 40;

    /// <summary>Shortens a piece whose path leads off what the ball is carried by or slides along.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="s">The ball at its start.</param>
    /// <param name="world">The world.</param>
    /// <param name="carrier">What carries the ball; null where nothing does.</param>
    /// <param name="guides">What it slides along.</param>
    /// <param name="order">Order of the method.</param>
    public static void Shorten<TSweep>(ref TSweep sweep, in BallState s, World world, Collider? carrier, in Guides guides, int order)
        where TSweep : struct, ISweep
    {
        // A ball between two surfaces may begin off one of them.
        double farthest = Farthest * world.Ball.Radius;
        double start = Off(world, carrier, in guides, s.Position, s.Time);
        for (int i = 0; i < MostTries; i++)
        {
            var path = PathCubic.Of(ref sweep, s.Position, s.Velocity, order);
            double half = 0.5 * path.Length;
            double off = Math.Max(
                Off(world, carrier, in guides, path.At(half), s.Time + half), Off(world, carrier, in guides, sweep.Position, s.Time + path.Length));
            if (!(off > start + farthest))
            {
                return;
            }

            // It goes off with the square of its length, or faster: so much shorter is enough, but where it begins at an edge.
            double share = Math.Sqrt(farthest / (off - start));
            sweep.Step(Math.Max(0.1, Math.Min(0.8, share)) * path.Length);
        }
    }

    /// <summary>How far a place is off the surfaces, m.</summary>
    private static double Off(World world, Collider? carrier, in Guides guides, in Vector3d position, double time)
    {
        double off = guides.Off(world, in position, time);
        return carrier is null ? off : Math.Max(off, Math.Abs(carrier.At(in position, time).Distance - world.Ball.Radius));
    }
}
