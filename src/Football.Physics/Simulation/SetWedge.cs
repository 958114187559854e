using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>A ball in a wedge of two contacts: as the normals become opposite, the loads grow, and a piece can gain energy.</summary>
internal static unsafe class SetWedge
{
    /// <summary>Returns the smallest sine of the angle between two loaded normals on opposite sides of the ball; 1 if there are none.</summary>
    public static double Sharpest(in ContactSystem system)
    {
        double least = 1;
        for (int i = 0; i < system.Count; i++)
        {
            for (int j = 0; j < i; j++)
            {
                ref readonly SetContact one = ref system.Contacts[i];
                ref readonly SetContact other = ref system.Contacts[j];
                bool opposes = one.Bears && other.Bears && Vector3d.Dot(in one.Normal, in other.Normal) < 0;
                least = opposes ? Math.Min(least, Vector3d.Cross(in one.Normal, in other.Normal).Length) : least;
            }
        }

        return least;
    }

    /// <summary>True if a piece on stationary contacts ends with more energy than it began with and its forces gave.</summary>
    /// <remarks>The loads of nearly opposite contacts, and their friction, then changed faster than the integrator can follow.</remarks>
    public static bool Overshoots(Surroundings around, in BallState s, in ContactSystem system, in Motion from, in Motion end, double h)
    {
        if (s.Nets != 0)
        {
            return false;
        }

        for (int i = 0; i < system.Count; i++)
        {
            if (system.Contacts[i].Surface != Vector3d.Zero)
            {
                return false;
            }
        }

        // ½ |v|² + ½ α r² |ω|², the work of the weight, and the error of the explicit Euler method, ½ |a|² h².
        double turning = around.World.Ball.InertiaFactor * around.Radius * around.Radius;
        double before = 0.5 * (from.Velocity.LengthSquared + (turning * from.Spin.LengthSquared));
        double after = 0.5 * (end.Velocity.LengthSquared + (turning * end.Spin.LengthSquared));
        double given = Vector3d.Dot(around.Weight, end.Position - from.Position) + (0.5 * h * h * around.Weight.LengthSquared);
        double gained = after - (before * (1.0 + ContactTolerances.PieceEnergy)) - given;
        if (!(gained > 0) || (around.Wind == Vector3d.Zero && !around.Air.Varies && !around.Air.HasOwnForces))
        {
            return gained > 0;
        }

        // The wind and custom forces do work too.
        system.Free(s.Time, in from, out Vector3d acceleration, out Vector3d spinAcceleration, out _);
        double other = (acceleration - around.Weight).Length + (Math.Sqrt(turning) * spinAcceleration.Length);
        return gained > h * other * (Math.Sqrt(2.0 * before) + Math.Sqrt(2.0 * after));
    }
}
