using System.Runtime.CompilerServices;

namespace FootballPhysics.Contacts;

/// <summary>Solves the impulses of a contact set over a short time, with Coulomb's law at all contacts: J_n ≥ 0, no closing, |J_t| ≤ μ
/// J_n.</summary>
/// <remarks>
/// Projected Gauss–Seidel solves one contact after the other, until the impulses no longer change.
/// On a sphere a normal impulse does not change the spin, and a tangential one acts on the mass m α/(1 + α) in every direction.
/// Each contact therefore has a closed-form solution per iteration.
/// </remarks>
internal static class ContactSolver
{
    /// <summary>Maximum number of iterations. If they do not suffice, the set is unsolvable, as with two objects that close on a ball.</summary>
    private const int MostRounds = 48;

    /// <summary>Maximum number of iterations for a set that may be unsolvable; the result is then approximate.</summary>
    public const int RoundsInVain = 16;

    /// <summary>Solves the velocity and the spin after a time, given their values without contacts.</summary>
    /// <param name="set">The contacts. They hold the impulses of the previous part, or zero, and receive the new ones.</param>
    /// <param name="ball">The ball.</param>
    /// <param name="duration">The time, s, in which a contact with a gap may close.</param>
    /// <param name="v">Velocity, m/s.</param>
    /// <param name="w">Spin, rad/s.</param>
    /// <param name="settled">Relative change of impulses and speeds below which the solver has converged.</param>
    /// <param name="closing">Maximum closing speed of a contact, m/s.</param>
    /// <param name="rounds">Maximum number of iterations.</param>
    /// <returns>True if a solution was found.</returns>
    public static bool Solve(
        Span<Contact> set, BallProperties ball, double duration, ref Vector3d v, ref Vector3d w,
        double settled = ContactTolerances.Settled, double closing = ContactTolerances.LargestClosing, int rounds = MostRounds)
    {
        Begin(set, ball, ref v, ref w);
        TurningResistance resistance = TurningResistance.None;
        double change = double.PositiveInfinity;
        for (int round = 0; round < rounds && change > settled; round++)
        {
            change = Round(set, ball, duration, ref resistance, ref v, ref w);
        }

        bool found = change <= ContactTolerances.Foreseen;
        foreach (ref readonly Contact contact in set)
        {
            found &= Closing(in contact, duration, in v) >= -closing;
        }

        return found;
    }

    /// <summary>True if a set too large for the force-level solver holds a ball: from a standstill, the forces do not move it.</summary>
    /// <param name="set">The contacts.</param>
    /// <param name="world">The world.</param>
    /// <param name="free">The rates without contacts.</param>
    /// <param name="duration">The time, s.</param>
    /// <param name="still">A ball below this speed is at a standstill, m/s, and rad/s times its radius.</param>
    [SkipLocalsInit]
    public static bool Holds(scoped Span<Contact> set, World world, in MotionRates free, double duration, double still)
    {
        Span<Contact> room = stackalloc Contact[ContactSet.Room];
        Span<Contact> held = world.Room.Of(set.Length, room).Slice(0, set.Length);
        set.CopyTo(held);
        ContactSet.Forget(held);
        Vector3d v = duration * free.Acceleration;
        Vector3d w = duration * free.SpinAcceleration;
        double most = ContactTolerances.StillHeld * (v.Length + (world.Ball.Radius * w.Length));
        Solve(held, world.Ball, duration, ref v, ref w);
        return v.Length + (world.Ball.Radius * w.Length) <= most + still;
    }

    /// <summary>Applies the impulses that the contacts already hold.</summary>
    private static void Begin(Span<Contact> set, BallProperties ball, ref Vector3d v, ref Vector3d w)
    {
        // Warm start: apply the stored impulses to velocity and spin.
        foreach (ref readonly Contact contact in set)
        {
            v += (contact.Load * contact.Normal) + contact.Friction;
            w -= 1.0 / (ball.InertiaFactor * ball.Radius) * Vector3d.Cross(in contact.Normal, in contact.Friction);
        }
    }

    /// <summary>Solves one contact after the other.</summary>
    /// <returns>Relative change of the impulses and the speeds.</returns>
    private static double Round(
        Span<Contact> set, BallProperties ball, double duration, ref TurningResistance resistance, ref Vector3d v, ref Vector3d w)
    {
        double scale = v.Length + (ball.Radius * w.Length);
        double change = 0;
        foreach (ref Contact contact in set)
        {
            change = Math.Max(change, Press(ref contact, ball, duration, ref v, ref w));
            scale += contact.Load;
        }

        change = Math.Max(change, ball.Radius * Resist(set, ball, duration, ref resistance, in v, ref w));
        return change > 0 ? change / scale : 0;
    }

    /// <summary>Applies rolling resistance, drilling friction and damping at the contact with the greatest load.</summary>
    /// <returns>Change of the spin, rad/s.</returns>
    public static double Resist(Span<Contact> set, BallProperties ball, double duration, ref TurningResistance resistance, in Vector3d v, ref Vector3d w)
    {
        int heaviest = ContactSet.Heaviest(set);
        resistance.MoveTo(heaviest, heaviest < 0 ? Vector3d.Zero : set[heaviest].Normal, ref w);
        if (heaviest < 0)
        {
            return 0;
        }

        ref readonly Contact bearer = ref set[heaviest];
        double mostDrilling = TurningResistance.DrillingPerLoad(in bearer, ball) * bearer.Load;
        return resistance.Act(TurningResistance.Damping(in bearer, ball, duration), mostDrilling, TurningResistance.MostRolling(in bearer, ball, in v), ref w);
    }

    /// <summary>Returns the closing speed of a contact, minus the speed that its gap allows, m/s.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Closing(in Contact contact, double duration, in Vector3d v)
    {
        // (v − V)·n + gap/h, because a gap may close within the time h. Over zero time, only touching surfaces count.
        double gap = duration > 0 ? Math.Max(0, contact.Gap) / duration : contact.Gap > ContactTolerances.Touching ? double.MaxValue : 0;
        return Vector3d.Dot(v - contact.Velocity, in contact.Normal) + gap;
    }

    /// <summary>Solves a single contact.</summary>
    /// <returns>Change of its impulses, m/s.</returns>
    private static double Press(ref Contact contact, BallProperties ball, double duration, ref Vector3d v, ref Vector3d w)
    {
        double alpha = ball.InertiaFactor;
        double r = ball.Radius;
        Vector3d n = contact.Normal;

        // J_n: the ball must separate at least as fast as the gap requires.
        double load = Math.Max(0, contact.Load - Closing(in contact, duration, in v));
        double pushed = load - contact.Load;
        v += pushed * n;
        contact.Load = load;

        // J_t: the impulse that stops the slip s = u_t + r n × ω, limited by friction.
        Vector3d relative = v - contact.Velocity;
        Vector3d slip = relative - (Vector3d.Dot(in relative, in n) * n) + (r * Vector3d.Cross(in n, in w));
        Vector3d friction = contact.Friction - (alpha / (1.0 + alpha) * slip);
        double size = friction.Length;
        double most = contact.Material.Resistance.MostFriction(load);
        friction = size > most ? most / size * friction : friction;
        Vector3d rubbed = friction - contact.Friction;
        v += rubbed;
        w -= 1.0 / (alpha * r) * Vector3d.Cross(in n, in rubbed);
        contact.Friction = friction;
        return Math.Max(Math.Abs(pushed), rubbed.Length);
    }
}
