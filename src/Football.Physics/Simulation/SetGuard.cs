using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Guards the pieces on several contacts: as two normals become parallel, the loads grow, and a piece can gain energy.</summary>
internal static unsafe class SetGuard
{
    /// <summary>The largest change of the speed within a piece, in units of a surface's speed. A faster squeeze takes the parts of <see cref="ContactSetParts"/>.</summary>
    private const double MostBySurface = 2;

    /// <summary>False if the loads grew without bound within the piece.</summary>
    public static bool IsFinite(in Motion end) => end.Velocity.LengthSquared + end.Spin.LengthSquared < double.PositiveInfinity;

    /// <summary>True if a piece ends with more energy than it began with and its forces gave.</summary>
    /// <remarks>The loads of nearly parallel contacts, and their friction, then changed faster than the integrator can follow.</remarks>
    public static bool Overshoots(Surroundings around, in BallState s, in ContactSystem system, in Motion from, in Motion end, double h, int order)
    {
        // The energy of velocity and spin per mass, ½ |v|² + ½ α r² |ω|², with the inertia factor α.
        double turning = around.World.Ball.InertiaFactor * around.Radius * around.Radius;
        double before = 0.5 * (from.Velocity.LengthSquared + (turning * from.Spin.LengthSquared));
        double after = 0.5 * (end.Velocity.LengthSquared + (turning * end.Spin.LengthSquared));

        // The work of the weight, and the error of a method of first order, ½ |a|² h², with the acceleration a and the piece's length h.
        double given = Vector3d.Dot(around.Weight, end.Position - from.Position) + (order > 1 ? 0 : 0.5 * h * h * around.Weight.LengthSquared);
        double allowed = (before * (1.0 + ContactTolerances.PieceEnergy)) + given;
        if (after <= allowed)
        {
            return false;
        }

        // Moving surfaces, nets, the wind and custom forces do work too: they change the speed √(2 E) of the energy E by at most this.
        double change = 0;
        for (int i = 0; i < system.Count; i++)
        {
            change = Math.Max(change, MostBySurface * system.Contacts[i].Surface.Length);
        }

        if (s.Nets != 0 || around.Wind != Vector3d.Zero || around.Air.Varies || around.Air.HasOwnForces)
        {
            change += h * (Other(around, in system, s.Time, in from) + Other(around, in system, s.Time + h, in end));
        }

        return after > allowed + (change * (Math.Sqrt(2.0 * before) + Math.Sqrt(2.0 * after)));
    }

    /// <summary>Returns the acceleration by other forces than the weight, with the spin as the speed √α r |ω̇|, in m/s².</summary>
    private static double Other(Surroundings around, in ContactSystem system, double time, in Motion at)
    {
        MotionRates free = system.Free(time, in at);
        return (free.Acceleration - around.Weight).Length + (Math.Sqrt(around.World.Ball.InertiaFactor) * around.Radius * free.SpinAcceleration.Length);
    }
}
