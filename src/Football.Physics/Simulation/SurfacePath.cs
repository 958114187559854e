namespace FootballPhysics;

/// <summary>
/// Keeps a piece along a surface so short that its path stays on it. How far a step goes off a surface depends on how that bends where the step
/// leads: so it is taken, looked at, and taken again where it went astray.
/// </summary>
internal static class SurfacePath
{
    /// <summary>A path may be so far off its surface, as a share of the ball's radius.</summary>
    private const double Farthest = 0.01;

    /// <summary>How often a piece is taken again at most.</summary>
    private const int MostTries = 40;

    /// <summary>Shortens a piece whose path leads off what carries the ball.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="s">The ball at its start.</param>
    /// <param name="carrier">What carries the ball.</param>
    /// <param name="radius">Radius of the ball, m.</param>
    /// <param name="order">Order of the method.</param>
    public static void Shorten<TSweep>(ref TSweep sweep, in BallState s, Collider carrier, double radius, int order)
        where TSweep : struct, ISweep
    {
        if (carrier.StandingPlane is not null)
        {
            return;
        }

        double farthest = Farthest * radius;
        for (int i = 0; i < MostTries; i++)
        {
            // How far the path is off its surface in the middle, and at the end.
            var path = PathCubic.Of(ref sweep, s.Position, s.Velocity, order);
            double half = 0.5 * path.Length;
            double off = Math.Max(
                Math.Abs(carrier.At(path.At(half), s.Time + half).Distance - radius),
                Math.Abs(carrier.At(sweep.Position, s.Time + path.Length).Distance - radius));
            if (!(off > farthest))
            {
                return;
            }

            // It goes off with the square of its length, or faster: so much shorter is enough, but where it begins at an edge.
            double share = Math.Sqrt(farthest / off);
            sweep.Step(Math.Max(0.1, Math.Min(0.8, share)) * path.Length);
        }
    }
}
