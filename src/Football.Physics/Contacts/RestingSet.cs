using FootballPhysics.State;

namespace FootballPhysics.Contacts;

/// <summary>Determines whether several contacts hold a ball at rest.</summary>
internal static unsafe class RestingSet
{
    /// <summary>True if contacts hold a ball at rest (several.md, Rest).</summary>
    /// <remarks>The part of the push that no load can take must be at most (1 + α) c₀ N, with N the greatest load.</remarks>
    /// <param name="system">The contacts, already updated.</param>
    /// <param name="push">The acceleration of the ball at rest, relative to its carrier, m/s².</param>
    public static bool Hold(in ContactSystem system, in Vector3d push)
    {
        // Project the push onto the directions that the contacts leave free. Zero to three contacts have a load; three leave no free direction.
        PushProjection free = Project(in system, in push);
        return free.TakesAll || (free.First < 0 ? push.Length <= ContactTolerances.LeastLoad
            : free.FirstLoad >= free.SecondLoad ? IsHeld(in system, free.Left, free.First, free.FirstLoad) : IsHeld(in system, free.Left, free.Second, free.SecondLoad));
    }

    /// <summary>Returns the part of a push that frictionless contacts do not take up.</summary>
    private static PushProjection Project(in ContactSystem system, in Vector3d push)
    {
        Vector3d* normals = stackalloc Vector3d[ContactSystem.Most];
        for (int i = 0; i < system.Count; i++)
        {
            normals[i] = system.Contacts[i].Normal;
        }

        return PushProjection.Of(normals, system.Count, in push);
    }

    /// <summary>True if friction holds a ball at rest that rolling resistance alone cannot hold (contacts.md, Rest).</summary>
    /// <remarks>With equal velocities of ball and surfaces, the modes at that instant leave the ball at its position.</remarks>
    /// <param name="system">The contacts; their modes do not change.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="still">The ball at the velocity of its carrier, without spin.</param>
    /// <param name="carrier">The carrier.</param>
    /// <param name="evaluations">Counts the evaluations.</param>
    public static bool Grip(in ContactSystem system, double time, in Motion still, int carrier, ref int evaluations)
    {
        SetContact* contacts = stackalloc SetContact[ContactSystem.Most];
        for (int i = 0; i < system.Count; i++)
        {
            contacts[i] = system.Contacts[i];
        }

        ContactSystem at = system;
        at.Contacts = contacts;
        return ContactModes.Find(ref at, time, in still, ContactTolerances.LeastLoad, carrier, ref evaluations)
            && at.Start.Acceleration.Length + (system.World.Ball.Radius * at.Start.SpinAcceleration.Length) <= ContactTolerances.LeastLoad;
    }

    /// <summary>True if contacts hold a ball at its carrier's velocity without spin.</summary>
    /// <remarks>No contact may move relative to the carrier (contacts.md, Rest).</remarks>
    /// <param name="around">The scene.</param>
    /// <param name="set">The contacts.</param>
    /// <param name="s">The ball.</param>
    /// <param name="still">The ball at that velocity.</param>
    /// <param name="branch">The branch of the drag law there.</param>
    /// <param name="gained">The carrier's velocity jump divided by the step, m/s².</param>
    /// <param name="evaluations">Counts the evaluations.</param>
    public static bool HoldAtRest(
        Surroundings around, scoped Span<Contact> set, in BallState s, in Motion still, DragBranch branch, in Vector3d gained, ref int evaluations)
    {
        World world = around.World;
        SetContact* contacts = stackalloc SetContact[ContactSystem.Most];
        for (int i = 0; i < set.Length; i++)
        {
            Collider collider = world.ByIndex[set[i].Collider];
            if (collider.Velocity != still.Velocity || collider.Spin != Vector3d.Zero)
            {
                return false;
            }

            contacts[i].Prepare(in set[i], collider, world.Ball);
            contacts[i].Look(world, s.Time, in still);
        }

        var system = new ContactSystem
        {
            Around = around,
            World = world,
            Contacts = contacts,
            Count = set.Length,
            Bearer = -1,
            Nets = s.Nets,
            NetSides = s.NetSides,
            Branch = branch,
        };
        evaluations++;
        return Hold(in system, system.PushAtRest(s.Time, in still) - gained)
            || (gained == Vector3d.Zero && Grip(in system, s.Time, in still, (int)s.Carrier - world.FirstCollider, ref evaluations));
    }

    private static bool IsHeld(in ContactSystem system, in Vector3d left, int bearer, double load) =>
        left.Length <= ((1.0 + system.World.Ball.InertiaFactor) * system.Contacts[bearer].Rolling * load) + ContactTolerances.LeastLoad;
}
