using System.Runtime.InteropServices;
using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Checks and corrects what the solver of a contact set returns.</summary>
internal static class SolvedSet
{
    /// <summary>Maximum number of projections of a velocity.</summary>
    private const int MostRounds = 20;

    /// <summary>Corrects the velocity and the spin after a part: no contact closes, and stationary contacts do no work on the ball.</summary>
    /// <remarks>An exact solution stays as it is.</remarks>
    /// <param name="set">The contacts.</param>
    /// <param name="ball">The ball.</param>
    /// <param name="h">Length of the part, s; 0 for an impact.</param>
    /// <param name="solved">True if the solver found impulses for all contacts.</param>
    /// <param name="free">Velocity and spin without contacts.</param>
    /// <param name="v">Velocity, m/s.</param>
    /// <param name="w">Spin, rad/s.</param>
    public static void Correct(Span<Contact> set, BallProperties ball, double h, bool solved, in Motion free, ref Vector3d v, ref Vector3d w)
    {
        if (!solved)
        {
            double speed = v.Length;
            double most = free.Velocity.Length;
            v = speed > most ? most / speed * v : v;
            if (!KeepOff(set, h, movers: true, ref v) && !ContactSet.HasMover(set))
            {
                v = AlongWedge(set, in v);
            }
        }

        var pressed = new PressedBall(ball) { V = v, W = w, FreeV = free.Velocity, FreeW = free.Spin };
        ImpulseSolver.LimitWork(MemoryMarshal.CreateSpan(ref pressed, 1), set);
        v = pressed.V;
        w = pressed.W;
    }

    /// <summary>Removes the closing components of a velocity at stationary contacts, and optionally at moving ones.</summary>
    /// <returns>False if the contacts still close: in a narrow wedge, projections need too many rounds.</returns>
    public static bool KeepOff(Span<Contact> set, double h, bool movers, ref Vector3d v)
    {
        double most = 0;
        bool closes = true;
        for (int round = 0; round < MostRounds && closes; round++)
        {
            closes = false;
            most = 0;
            foreach (ref readonly Contact contact in set)
            {
                // If (v − V)·n + gap/h < 0, the ball would overlap the collider within the part. Project out the excess, contact by
                // contact.
                double closing = Vector3d.Dot(v - contact.Velocity, in contact.Normal) + (h > 0 ? Math.Max(0, contact.Gap) / h : 0);
                if ((movers || !contact.Moves) && closing < 0)
                {
                    v -= closing * contact.Normal;
                    closes = true;
                    most = Math.Max(most, -closing);
                }
            }
        }

        return most <= ContactTolerances.Approaching;
    }

    /// <summary>Returns the component of a velocity along the narrowest wedge; zero if that closes on another contact.</summary>
    private static Vector3d AlongWedge(Span<Contact> set, in Vector3d v)
    {
        double least = 0;
        Vector3d edge = default;
        for (int i = 0; i < set.Length; i++)
        {
            for (int j = 0; j < i; j++)
            {
                double cosine = Vector3d.Dot(in set[i].Normal, in set[j].Normal);
                edge = cosine < least ? Vector3d.Cross(in set[i].Normal, in set[j].Normal) : edge;
                least = Math.Min(least, cosine);
            }
        }

        double square = edge.LengthSquared;
        Vector3d along = square > 0 ? Vector3d.Dot(in v, in edge) / square * edge : Vector3d.Zero;
        foreach (ref readonly Contact contact in set)
        {
            along = Vector3d.Dot(in along, in contact.Normal) < -ContactTolerances.Approaching ? Vector3d.Zero : along;
        }

        return along;
    }

    /// <summary>Takes the energy of a lift from the speed and the spin of a ball: a projection onto stationary contacts does no work.</summary>
    /// <param name="s">The ball after the projection.</param>
    /// <param name="set">The contacts.</param>
    /// <param name="ball">Its properties.</param>
    /// <param name="weight">The acceleration by gravity and buoyancy, m/s².</param>
    /// <param name="from">Its position before, m.</param>
    public static void PayForLift(ref BallState s, scoped Span<Contact> set, BallProperties ball, in Vector3d weight, in Vector3d from)
    {
        // ½ |v|² + ½ α r² |ω|², less g·δ.
        double energy = 0.5 * (s.Velocity.LengthSquared + (ball.InertiaFactor * ball.Radius * ball.Radius * s.SpinAxis.LengthSquared));
        double lift = -Vector3d.Dot(weight, s.Position - from);
        if (lift > ContactTolerances.PieceEnergy * energy && !Drives(set))
        {
            double share = Math.Sqrt(Math.Max(0, 1.0 - (lift / energy)));
            s.Velocity = share * s.Velocity;
            s.SpinAxis = share * s.SpinAxis;
        }
    }

    /// <summary>True if a surface has a velocity, also one that turns in place: it may do work on the ball.</summary>
    private static bool Drives(Span<Contact> set)
    {
        foreach (ref readonly Contact contact in set)
        {
            if (contact.Velocity != Vector3d.Zero)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>True if an object moves, and its surface has a velocity.</summary>
    public static bool Moves(Span<Contact> set)
    {
        foreach (ref readonly Contact contact in set)
        {
            if (contact.Moves && contact.Velocity != Vector3d.Zero)
            {
                return true;
            }
        }

        return false;
    }
}
