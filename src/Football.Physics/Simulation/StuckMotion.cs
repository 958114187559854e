using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Makes the velocity and the spin of a ball on several surfaces consistent with the modes of its contacts.</summary>
/// <remarks>It removes the remaining slip of sticking contacts, and the remaining normal speed of loaded ones. Both are below the thresholds of the modes.</remarks>
internal static unsafe class StuckMotion
{
    /// <summary>Number of rounds over the contacts.</summary>
    /// <remarks>Further rounds run only if the velocity still changes by <see cref="ContactTolerances.SlipRemoval"/>.</remarks>
    private const int FewRounds = 4;
    private const int MostRounds = 128;

    public static void Project(World world, in ContactSystem system, ref BallState s)
    {
        Vector3d v = s.Velocity;
        Vector3d w = s.SpinAxis;
        double change = double.PositiveInfinity;
        for (int round = 0; round < MostRounds && change > (round < FewRounds ? ContactTolerances.ProjectionError : ContactTolerances.SlipRemoval); round++)
        {
            change = 0;
            for (int i = 0; i < system.Count; i++)
            {
                ref readonly SetContact contact = ref system.Contacts[i];
                change = Math.Max(change, contact.Bears ? Hold(world, in contact, in s, ref v, ref w) : KeepOff(world, in contact, ref v));
            }
        }

        // With moving objects, no velocity may satisfy all contacts. If so, only keep the ball out of stationary objects.
        for (int i = 0; i < system.Count && change > ContactTolerances.SlipRemoval; i++)
        {
            ref readonly SetContact contact = ref system.Contacts[i];
            double off = Vector3d.Dot(in v, contact.Normal);
            off = contact.Bears ? off : Math.Min(0, off);
            v -= world.ByIndex[contact.Collider].Moves ? Vector3d.Zero : off * contact.Normal;
        }

        s.Velocity = v;
        s.SpinAxis = w;
        if (system.HoldsSpin)
        {
            ref readonly SetContact bearer = ref system.Contacts[system.Bearer];
            s.SpinAxis = w - ((Vector3d.Dot(in w, bearer.Normal) - bearer.CarrierSpin) * bearer.Normal);
        }

        if (system.Pinned)
        {
            // Remove the remaining velocity, so that a pinned ball does not creep.
            ref readonly SetContact bearer = ref system.Contacts[system.Bearer];
            Vector3d material = world.ByIndex[bearer.Collider].MaterialVelocity(s.Position, s.Time);
            double about = Vector3d.Dot(s.SpinAxis, bearer.Normal);
            s.Velocity = material;
            s.SpinAxis = Slip.RollingSpin(material - bearer.Surface, about, bearer.Normal, world.Ball.Radius);
        }
    }

    /// <summary>Removes the normal speed at a loaded contact, and the slip if the contact sticks.</summary>
    /// <returns>The larger of the two removed speeds, m/s.</returns>
    private static double Hold(World world, in SetContact contact, in BallState s, ref Vector3d v, ref Vector3d w)
    {
        double r = world.Ball.Radius;
        Vector3d n = contact.Normal;
        double off = Vector3d.Dot(v - world.ByIndex[contact.Collider].ShapeVelocity(s.Position - (r * n), s.Time), in n);
        v -= off * n;
        if (!contact.Sticks)
        {
            return Math.Abs(off);
        }

        // A change F of the velocity along the surface changes the spin by −n × F/(α r), so removing the slip takes α/(1 + α) of it. α is the inertia factor.
        double inertia = world.Ball.InertiaFactor;
        Vector3d slip = Slip.Of(v - contact.Surface, in w, in n, r);
        Vector3d push = -(inertia / (1.0 + inertia)) * slip;
        v += push;
        w -= 1.0 / (inertia * r) * Vector3d.Cross(in n, in push);
        return Math.Max(Math.Abs(off), slip.Length);
    }

    /// <summary>Removes the closing speed at a stationary contact without load: the corrections for the others must not push the ball into it.</summary>
    /// <returns>The removed speed, m/s; 0 if the contact does not close.</returns>
    private static double KeepOff(World world, in SetContact contact, ref Vector3d v)
    {
        double closing = Vector3d.Dot(in v, contact.Normal);
        if (!(closing < -ContactTolerances.Approaching) || world.ByIndex[contact.Collider].Moves)
        {
            return 0;
        }

        v -= closing * contact.Normal;
        return -closing;
    }
}
