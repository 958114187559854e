using System.Runtime.CompilerServices;

namespace FootballPhysics.Contacts;

/// <summary>Determines the modes of a contact set at one instant: which contacts have a load, and which of them stick.</summary>
/// <remarks>
/// It starts with all contacts active. It then opens contacts with a negative load, starts slips outside the friction cone, and closes
/// penetrating contacts, until all of Coulomb's conditions hold.
/// </remarks>
internal static unsafe class ContactModes
{
    /// <summary>Maximum number of mode changes. After these, the search fails.</summary>
    /// <remarks>Above: searches that cycle take half of the evaluations of the slowest steps. In 400 matches, searches that end need at most 2 changes.</remarks>
    private const int MostChanges = 8;

    /// <summary>Maximum number of iterations for the direction of a starting slip.</summary>
    public const int MostStarts = 12;

    /// <summary>Maximum number of iterations to find the bearer.</summary>
    private const int MostBearers = 5;

    /// <summary>Determines the modes.</summary>
    /// <param name="system">The contacts, already updated, that touch the ball without closing.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="at">The ball.</param>
    /// <param name="sticking">A slip below this counts as zero, m/s.</param>
    /// <param name="carrier">The carrier of the ball, which most likely still has the greatest load.</param>
    /// <param name="evaluations">Counts the evaluations.</param>
    /// <returns>False if no consistent modes were found.</returns>
    public static bool Find(ref ContactSystem system, double time, in Motion at, double sticking, int carrier, ref int evaluations)
    {
        for (int i = 0; i < system.Count; i++)
        {
            ref SetContact contact = ref system.Contacts[i];
            contact.Look(system.World, time, in at);
            double slip = contact.Slip.Length;
            contact.Press(sticking);
            contact.Direction = slip > 0 ? contact.Slip / slip : Vector3d.Zero;
        }

        Guess(ref system, time, in at, carrier, ref evaluations);
        for (int change = 0; change < MostChanges; change++)
        {
            Force(ref system, time, in at, ref evaluations, out Vector3d push);
            if (!Change(ref system, sticking, in at, in push) && !Start(ref system, time, in at, ref evaluations))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Guesses the bearer from the loads that frictionless contacts would have.</summary>
    /// <remarks>
    /// If two contacts clamp the ball, or three surround it in one plane, it also opens the contacts that the push does not press against. Examples are
    /// a ball between two spheres, and one between a player and a board on the ground. With all of them active, the loads would not be determined,
    /// however large.
    /// </remarks>
    [SkipLocalsInit]
    private static void Guess(ref ContactSystem system, double time, in Motion at, int carrier, ref int evaluations)
    {
        Forget(ref system);
        Vector3d* normals = stackalloc Vector3d[ContactSystem.Most];
        int sticking = 0;
        int likely = -1;
        for (int i = 0; i < system.Count; i++)
        {
            ref readonly SetContact contact = ref system.Contacts[i];
            normals[i] = contact.Normal;
            sticking += contact.Sticks ? 1 : 0;
            likely = contact.Sticks || (likely < 0 && contact.Collider == carrier) ? i : likely;
        }

        bool idles = PushProjection.Clamp(normals, system.Count) || (system.Count == 3 && PushProjection.Surround(normals));
        if (!idles && sticking == 1 && system.Contacts[likely].RollingVelocity.Length >= ContactTolerances.Rolling)
        {
            // A single sticking contact is the bearer, and the ball rolls: no need to estimate the loads.
            system.Bearer = likely;
            Roll(ref system, in at, default);
            return;
        }

        Vector3d push = system.Free(time, in at).Acceleration;
        evaluations++;
        PushProjection free = PushProjection.Of(normals, system.Count, in push);
        for (int i = 0; i < system.Count; i++)
        {
            ref SetContact contact = ref system.Contacts[i];
            contact.Bears = !idles || free.Bears(i);
            contact.Load = free.LoadOf(i);
        }

        // Three or more loads that take up the entire push are not known yet.
        likely = likely >= 0 && free.TakesAll ? likely : BearerOf(in system);
        Choose(ref system, likely, in at, in push);
    }

    /// <summary>Iterates the direction of a starting slip until friction and the rate of the slip agree.</summary>
    /// <returns>True if the forces have changed so much that the modes must be checked again.</returns>
    private static bool Start(ref ContactSystem system, double time, in Motion at, ref int evaluations)
    {
        bool changed = false;
        for (int round = 0; round < MostStarts; round++)
        {
            bool again = false;
            bool starts = false;
            for (int i = 0; i < system.Count; i++)
            {
                starts |= system.Contacts[i].StartsToSlip;
            }

            if (!starts)
            {
                break;
            }

            MotionRates rates = ContactForces.Solve(ref system, in at.Spin, system.Free(time, in at));
            evaluations++;
            for (int i = 0; i < system.Count; i++)
            {
                ref SetContact contact = ref system.Contacts[i];
                if (contact.StartsToSlip)
                {
                    Vector3d rate = contact.SlipRate(in rates, in at.Spin, system.World.Ball.Radius);
                    again |= contact.TurnSlip(in rate);
                }
            }

            if (!again)
            {
                break;
            }

            changed = true;
        }

        return changed;
    }

    /// <summary>Solves the forces with the current modes; the bearer and the direction of the roll follow from the loads.</summary>
    /// <remarks>
    /// Rolling resistance may reduce the bearer's load so much that the other contact has the greater load, whichever is the bearer.
    /// The two loads are then treated as equal, and the first contact is the bearer.
    /// </remarks>
    private static void Force(ref ContactSystem system, double time, in Motion at, ref int evaluations, out Vector3d push)
    {
        int before = -1;
        push = default;
        system.IsTied = false;
        for (int round = 0; round < MostBearers; round++)
        {
            MotionRates free = system.Free(time, in at);
            evaluations++;
            push = free.Acceleration;
            system.Start = ContactForces.Solve(ref system, in at.Spin, in free);
            int bearer = BearerOf(in system);
            if (bearer == system.Bearer || system.IsTied)
            {
                return;
            }

            system.IsTied = bearer >= 0 && bearer == before;
            if (system.IsTied && system.Bearer < bearer)
            {
                return;
            }

            before = system.Bearer;
            if (bearer < 0)
            {
                Forget(ref system);
                return;
            }

            system.Bearer = bearer;
            Roll(ref system, in at, in push);
        }
    }

    /// <summary>Determines the direction of the roll: the free direction of the velocity, or at a standstill of the push.</summary>
    /// <remarks>At a standstill, rolling resistance may hold the ball instead.</remarks>
    private static void Roll(ref ContactSystem system, in Motion at, in Vector3d free)
    {
        ref readonly SetContact bearer = ref system.Contacts[system.Bearer];
        double about = Vector3d.Dot(in at.Spin, in bearer.Normal) - bearer.CarrierSpin;
        system.SpinSign = about > ContactTolerances.Rolling ? 1.0 : about < -ContactTolerances.Rolling ? -1.0 : 0.0;
        system.HoldsSpin = system.SpinSign == 0 && bearer.Resistance.Drills;
        system.Pinned = false;
        system.Along = DirectionLeft(in system, out bool isLine);
        if (!bearer.Sticks || system.Along == Vector3d.Zero)
        {
            return;
        }

        double along = Vector3d.Dot(in bearer.RollingVelocity, in system.Along);
        if (bearer.RollingVelocity.Length >= ContactTolerances.Rolling)
        {
            system.Along = along < 0 ? -system.Along : system.Along;
            return;
        }

        // At a standstill, the ball is either held, or starts to roll along the push.
        double push = Vector3d.Dot(free - bearer.MaterialRate, in system.Along);
        system.Along = push < 0 ? -system.Along : system.Along;
        system.Pinned = isLine && Math.Abs(push) <= (1.0 + system.World.Ball.InertiaFactor) * bearer.MostRolling;
    }

    /// <summary>Returns the direction that active contacts leave free, normal to both normals; zero if a third contact blocks it.</summary>
    private static Vector3d DirectionLeft(in ContactSystem system, out bool isLine)
    {
        Vector3d first = system.Contacts[system.Bearer].Normal;
        Vector3d along = default;
        isLine = false;
        for (int i = 0; i < system.Count; i++)
        {
            ref readonly SetContact contact = ref system.Contacts[i];
            if (i == system.Bearer || !contact.Bears)
            {
                continue;
            }

            if (!isLine)
            {
                Vector3d across = Vector3d.Cross(in first, in contact.Normal);
                double size = across.Length;
                isLine = size > ContactTolerances.Independent;
                along = isLine ? across / size : along;
            }
            else if (Math.Abs(Vector3d.Dot(in along, in contact.Normal)) > ContactTolerances.Independent)
            {
                isLine = false;
                return Vector3d.Zero;
            }
        }

        if (!isLine)
        {
            // If only one normal remains, the free direction is the direction of the velocity.
            Vector3d rolling = SurfaceSystem.Tangential(system.Contacts[system.Bearer].RollingVelocity, in first);
            double speed = rolling.Length;
            return speed > 0 ? rolling / speed : Vector3d.Zero;
        }

        return along;
    }

    /// <summary>Returns the sticking contact with the greatest load; if none sticks, the one with the greatest load.</summary>
    public static int BearerOf(in ContactSystem system)
    {
        int bearer = -1;
        for (int i = 0; i < system.Count; i++)
        {
            ref readonly SetContact contact = ref system.Contacts[i];
            if (!contact.Bears || !(contact.Load > 0))
            {
                continue;
            }

            bearer = bearer < 0 || contact.Outweighs(in system.Contacts[bearer]) ? i : bearer;
        }

        return bearer;
    }

    /// <summary>Resets the bearer and its hold on the ball: without a bearer, the ball is not pinned.</summary>
    private static void Forget(ref ContactSystem system)
    {
        system.Bearer = -1;
        system.Pinned = false;
        system.HoldsSpin = false;
        system.Along = default;
    }

    /// <summary>Makes a contact the bearer; −1 for none.</summary>
    private static void Choose(ref ContactSystem system, int bearer, in Motion at, in Vector3d push)
    {
        Forget(ref system);
        if (bearer >= 0)
        {
            system.Bearer = bearer;
            Roll(ref system, in at, in push);
        }
    }

    /// <summary>Changes one inconsistent mode.</summary>
    /// <returns>False if all modes are consistent.</returns>
    private static bool Change(ref ContactSystem system, double sticking, in Motion at, in Vector3d push)
    {
        // Open the contact with the most negative load.
        int worst = -1;
        double least = ContactTolerances.LeastLoad;
        for (int i = 0; i < system.Count; i++)
        {
            ref readonly SetContact contact = ref system.Contacts[i];
            if (contact.Bears && contact.Load <= least)
            {
                least = contact.Load;
                worst = i;
            }
        }

        if (worst >= 0)
        {
            system.Contacts[worst].Bears = false;
            Choose(ref system, BearerOf(in system), in at, in push);
            return true;
        }

        // Activate the contact that the ball would penetrate fastest.
        least = -ContactTolerances.LeastLoad;
        for (int i = 0; i < system.Count; i++)
        {
            ref readonly SetContact contact = ref system.Contacts[i];
            if (!contact.Bears && contact.Opening < least)
            {
                least = contact.Opening;
                worst = i;
            }
        }

        if (worst >= 0)
        {
            system.Contacts[worst].Press(sticking);
            Choose(ref system, BearerOf(in system), in at, in push);
            return true;
        }

        // Let the contact that exceeds its friction cone most slip. If its slip is zero, it slips against the friction that it needs.
        double most = 0;
        for (int i = 0; i < system.Count; i++)
        {
            ref readonly SetContact contact = ref system.Contacts[i];
            if (contact.Bears && contact.Sticks)
            {
                worst = contact.Excess > most ? i : worst;
                most = Math.Max(most, contact.Excess);
            }
        }

        if (worst < 0 && system.HoldsSpin && Math.Abs(system.HeldSpin) > system.MostDrilling(in system.Contacts[system.Bearer]) * (1.0 + ContactTolerances.BeyondCone))
        {
            // Drilling friction cannot hold the spin: the spin starts against the holding torque.
            system.HoldsSpin = false;
            system.SpinSign = system.HeldSpin > 0 ? -1.0 : 1.0;
            return true;
        }

        if (worst < 0 && system.Pinned && Math.Abs(system.Held) > system.Contacts[system.Bearer].MostRolling * (1.0 + ContactTolerances.BeyondCone))
        {
            // Rolling resistance cannot hold the ball either: the ball starts to roll against the holding force.
            system.Pinned = false;
            system.Along = system.Held > 0 ? -system.Along : system.Along;
            return true;
        }

        if (worst >= 0)
        {
            system.Contacts[worst].StartSlip();
            Choose(ref system, BearerOf(in system), in at, in push);
            return true;
        }

        return false;
    }
}
