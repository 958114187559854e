using FootballPhysics.Contacts;
using FootballPhysics.Integration;

namespace FootballPhysics.Simulation;

/// <summary>A slip in a hollow that is so slow that friction keeps it in the direction of the push.</summary>
/// <remarks>
/// Where the push c hardly exceeds the friction k, the slip s stays slow, and friction turns it to the direction of c at the rate k/|s|: too fast for the
/// integrator. Friction then acts along c at each instant. The slip lags behind c by the angle ψ̇ |s|/k, where ψ̇ is the turning rate of c; this neglects the
/// velocity ψ̇ s²/k.
/// </remarks>
internal static class SlowSlip
{
    /// <summary>Maximum number of repetitions of a piece.</summary>
    private const int MostTries = 8;

    /// <summary>The least squared push, relative to the squared friction: otherwise friction ends the slip before it turns.</summary>
    private const double LeastPush = 0.5;

    /// <summary>True if a slip follows the push.</summary>
    /// <param name="system">The ball on its surface.</param>
    /// <param name="on">The forces.</param>
    /// <param name="at">The motion.</param>
    public static bool Follows(in SurfaceSystem system, in SurfaceForces on, in Motion at)
    {
        // On a convex surface, the load falls, so that the slip soon is fast. In a net, the parts of a piece follow the direction.
        double friction = system.SlipFriction(in on);
        return !system.Rolls && friction > 0 && system.Carrier.HollowCurvature > 0 && on.Turning != Vector3d.Zero && system.Nets == 0
            && system.SlipPush(in on, in at.Spin).LengthSquared >= LeastPush * friction * friction && Off(in system, in on, in at) <= 0.5 * ContactTolerances.SlowSlip;
    }

    /// <summary>Shortens a piece in which the slip parts from the push.</summary>
    public static void EndPiece<TMethod>(ref MotionSweep<SurfaceSystem, TMethod> sweep, in BallState s)
        where TMethod : struct, IMotionMethod
    {
        if (!sweep.System.FollowsPush)
        {
            return;
        }

        var from = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
        sweep.System.ForcesOn(s.Time, in from, out SurfaceForces first);
        Vector3d start = first.Slip;
        sweep.Evaluations++;
        for (int i = 0; i < MostTries; i++)
        {
            Motion end = sweep.Taken.End;
            sweep.System.ForcesOn(s.Time + sweep.Length, in end, out SurfaceForces on);
            sweep.Evaluations++;

            // Beyond an edge, the push is another one: there, the change of the slip bounds the error.
            double off = Math.Min(Off(in sweep.System, in on, in end), 2.0 * (on.Slip - start).Length);
            if (off <= ContactTolerances.SlowSlip)
            {
                return;
            }

            sweep.Step(Math.Max(0.1, Math.Min(0.5, Math.Sqrt(ContactTolerances.SlowSlip / off))) * sweep.Length);
        }
    }

    /// <summary>Returns the error of the direction as a velocity, m/s: the slip across the push, and its lag, which turns as fast as the normal.</summary>
    private static double Off(in SurfaceSystem system, in SurfaceForces on, in Motion at)
    {
        Vector3d slip = on.Slip;
        Vector3d push = system.SlipPush(in on, in at.Spin);
        double along = Vector3d.Dot(in slip, in push);
        double across = (slip - (along / push.LengthSquared * push)).Length;
        double friction = system.SlipFriction(in on);
        double lag = friction > 0 ? on.Turning.Length * slip.LengthSquared / friction : 0;
        return along > 0 ? Math.Min(across + lag, slip.Length) : slip.Length;
    }
}
