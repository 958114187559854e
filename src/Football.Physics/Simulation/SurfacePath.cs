using FootballPhysics.Contacts;
using FootballPhysics.Integration;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>Limits a piece along a surface so that its path stays on the surface.</summary>
/// <remarks>
/// The deviation depends on the curvature along the path. The step is taken, checked, and repeated with a shorter length if it deviates
/// too much.
/// </remarks>
internal static class SurfacePath
{
    /// <summary>Maximum deviation of a path from its surface, as a share of the ball's radius.</summary>
    private const double Farthest = 0.01;

    /// <summary>Maximum number of repetitions.</summary>
    private const int MostTries = 40;

    /// <summary>Shortens a piece whose path leaves the carrier.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="s">The ball at its start.</param>
    /// <param name="carrier">The carrier of the ball.</param>
    /// <param name="radius">Radius of the ball, m.</param>
    /// <param name="order">Order of the integrator.</param>
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
            // The deviation of the path from its surface, at the middle and at the end.
            var path = PathCubic.Between(s.Position, s.Velocity, sweep.Position, sweep.Velocity, sweep.Length, isQuadratic: order <= 2);
            double half = 0.5 * path.Length;
            double off = Math.Max(
                Math.Abs(carrier.At(path.At(half), s.Time + half).Distance - radius),
                Math.Abs(carrier.At(sweep.Position, s.Time + path.Length).Distance - radius));
            if (!(off > farthest))
            {
                return;
            }

            // The deviation grows at least with the square of the length, so this shorter length is sufficient, except at an edge.
            double share = Math.Sqrt(farthest / off);
            sweep.Step(Math.Max(0.1, Math.Min(0.8, share)) * path.Length);
        }
    }
}
