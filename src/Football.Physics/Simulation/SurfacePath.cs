using System.Runtime.CompilerServices;
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

    /// <summary>Maximum number of pieces that are tried until one ends at a jump of the curvature. Each shorter one locates the jump more exactly.</summary>
    private const int MostBends = 6;

    /// <summary>The halvings that locate a jump, and those after which a change of the curvature counts as a jump if this share of it is left.</summary>
    private const int MostHalvings = 32;
    private const int FirstHalvings = 6;
    private const double JumpShare = 0.25;

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
                break;
            }

            // The deviation grows at least with the square of the length, so this shorter length is sufficient, except at an edge.
            double share = Math.Sqrt(farthest / off);
            sweep.Step(Math.Max(0.1, Math.Min(0.8, share)) * path.Length);
        }

        if (carrier.MayBend)
        {
            EndAtBend(ref sweep, in s, carrier, order);
        }
    }

    /// <summary>Ends a piece just before a jump of the curvature, as at the foot of a quarter pipe, and the next one just beyond it.</summary>
    /// <remarks>A piece across the jump would lose the order of the integrator, and would cut through surfaces that are flush with the carrier. A stage of the
    /// integrator beyond the jump would do so too.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void EndAtBend<TSweep>(ref TSweep sweep, in BallState s, Collider carrier, int order)
        where TSweep : struct, ISweep
    {
        double start = BendAt(carrier, s.Position, s.Velocity, s.Time);
        for (int i = 0; i < MostBends; i++)
        {
            var path = PathCubic.Between(s.Position, s.Velocity, sweep.Position, sweep.Velocity, sweep.Length, isQuadratic: order <= 2);
            double beyond = Math.Max(ContactTolerances.Beyond * path.Length, ContactTolerances.LeastBeyondEdge / Math.Max(ContactTolerances.SlowestAtEdge, sweep.Velocity.Length));
            double jump = Jump(carrier, in path, s.Time, start);
            double before = jump - (ContactTolerances.BeforeBend * path.Length);
            double end = before > beyond ? before : jump + beyond;
            if (!(end < path.Length * (1.0 - ContactTolerances.BeyondJump)))
            {
                return;
            }

            sweep.Step(end);
        }
    }

    /// <summary>Returns the time just after a jump of the curvature along a path, s; infinite if there is none.</summary>
    private static double Jump(Collider carrier, in PathCubic path, double time, double start)
    {
        double before = 0;
        double after = path.Length;
        double first = start;
        double last = BendAt(carrier, path.At(after), path.VelocityAt(after), time + after);
        double change = Math.Abs(last - first);
        for (int i = 0; i < MostHalvings; i++)
        {
            // Halve towards the greater change. A continuous change vanishes; a jump stays.
            if (!(Math.Abs(last - first) > Math.Max(ContactTolerances.SameBend, i < FirstHalvings ? 0 : JumpShare * change)))
            {
                return double.PositiveInfinity;
            }

            double half = 0.5 * (before + after);
            double middle = BendAt(carrier, path.At(half), path.VelocityAt(half), time + half);
            bool isBefore = Math.Abs(middle - first) > Math.Abs(last - middle);
            before = isBefore ? before : half;
            first = isBefore ? first : middle;
            after = isBefore ? half : after;
            last = isBefore ? middle : last;
        }

        return after;
    }

    private static double BendAt(Collider carrier, in Vector3d position, in Vector3d velocity, double time) =>
        carrier.BendAt(carrier.At(in position, time), in position, in velocity, time).Along;
}
