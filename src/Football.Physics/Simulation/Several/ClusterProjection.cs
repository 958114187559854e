using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Projects the balls of a cluster back onto their loaded contacts, to remove the integrator's error.</summary>
internal static class ClusterProjection
{
    private const int MostRounds = 40;

    /// <summary>Projects the positions at the end: balls by their masses, then onto stationary objects, which they must not
    /// enter.</summary>
    public static void Places(ClusterSystem system)
    {
        bool moved = true;
        for (int round = 0; round < MostRounds && moved; round++)
        {
            moved = false;
            for (int i = 0; i < system.ContactCount; i++)
            {
                ref readonly ClusterContact contact = ref system.Contacts[i];
                if (contact.Second < 0 || !contact.On.Bears)
                {
                    continue;
                }

                ref ClusterBall a = ref system.Balls[contact.First];
                ref ClusterBall b = ref system.Balls[contact.Second];
                Vector3d apart = a.End.Position - b.End.Position;
                double distance = apart.Length;
                double gap = distance - a.Radius - b.Radius;
                Vector3d shift = gap / ((a.PerMass + b.PerMass) * distance) * apart;
                a.End.Position -= a.PerMass * shift;
                b.End.Position += b.PerMass * shift;
                moved |= Math.Abs(gap) > ContactTolerances.ProjectionError;
            }

            for (int i = 0; i < system.ContactCount; i++)
            {
                ref readonly ClusterContact contact = ref system.Contacts[i];
                if (contact.Second < 0 && contact.On.Bears)
                {
                    Put(ref system.Balls[contact.First], contact.On.Collider);
                }
            }
        }
    }

    /// <summary>Projects the velocities by impulses: zero normal speed at loaded contacts, zero slip at sticking ones. Impulses add no
    /// energy.</summary>
    /// <param name="system">The balls and their contacts, updated at the balls' positions.</param>
    /// <param name="atEnd">True for the end of the step, false for the start.</param>
    /// <returns>The largest change, m/s.</returns>
    public static double Velocities(ClusterSystem system, bool atEnd)
    {
        double largest = 0;
        double change = double.PositiveInfinity;
        for (int round = 0; round < MostRounds && change > ContactTolerances.ProjectionError; round++)
        {
            change = 0;
            for (int i = 0; i < system.ContactCount; i++)
            {
                ref readonly ClusterContact contact = ref system.Contacts[i];
                if (contact.On.Bears)
                {
                    ref ClusterBall ball = ref system.Balls[contact.First];
                    ref ClusterBall other = ref system.Balls[Math.Max(0, contact.Second)];
                    change = Math.Max(change, contact.Second < 0
                        ? End(in contact.On, ref ball, ref StateOf(ref ball, atEnd))
                        : End(in contact.On, ref ball, ref StateOf(ref ball, atEnd), ref other, ref StateOf(ref other, atEnd)));
                }
            }

            largest = Math.Max(largest, change);
        }

        for (int i = 0; i < system.Count; i++)
        {
            ref ClusterBall ball = ref system.Balls[i];
            if (ball.HoldsSpin)
            {
                ref BallState s = ref StateOf(ref ball, atEnd);
                ref readonly SetContact on = ref system.Contacts[ball.Bearer].On;
                s.SpinAxis -= (Vector3d.Dot(s.SpinAxis, in on.Normal) - on.CarrierSpin) * on.Normal;
            }
        }

        return largest;
    }

    private static ref BallState StateOf(ref ClusterBall ball, bool atEnd)
    {
        if (atEnd)
        {
            return ref ball.End;
        }

        return ref ball.Start;
    }

    private static void Put(ref ClusterBall ball, int index)
    {
        ref BallState s = ref ball.End;
        Collider collider = ball.World.Colliders[index];
        ShapePoint at = collider.At(s.Position, s.Time);
        s.Position = collider.Snap(s.Position + ((ball.Radius - at.Distance) * at.Normal));
    }

    /// <summary>Projects the velocity of a ball on a stationary object.</summary>
    private static double End(in SetContact on, ref ClusterBall ball, ref BallState s)
    {
        double off = Vector3d.Dot(s.Velocity, in on.Normal);
        s.Velocity -= off * on.Normal;
        if (!on.Sticks)
        {
            return Math.Abs(off);
        }

        Vector3d slip = Slip.Of(s.Velocity - on.Surface, s.SpinAxis, in on.Normal, ball.Radius);
        double turns = ball.Radius * ball.Radius * ball.PerInertia;
        Vector3d impulse = -1.0 / (ball.PerMass + turns) * slip;
        s.Velocity += ball.PerMass * impulse;
        s.SpinAxis -= ball.Radius * ball.PerInertia * Vector3d.Cross(in on.Normal, in impulse);
        return Math.Max(Math.Abs(off), slip.Length);
    }

    /// <summary>Projects the velocities of two balls.</summary>
    private static double End(in SetContact on, ref ClusterBall a, ref BallState first, ref ClusterBall b, ref BallState second)
    {
        Vector3d n = on.Normal;
        Vector3d relative = first.Velocity - second.Velocity;
        double off = Vector3d.Dot(in relative, in n);
        Vector3d impulse = -off / (a.PerMass + b.PerMass) * n;
        double slipped = 0;
        if (on.Sticks)
        {
            Vector3d slip = relative - (off * n) + Vector3d.Cross(in n, (a.Radius * first.SpinAxis) + (b.Radius * second.SpinAxis));
            double turns = (a.Radius * a.Radius * a.PerInertia) + (b.Radius * b.Radius * b.PerInertia);
            Vector3d rub = -1.0 / (a.PerMass + b.PerMass + turns) * slip;
            Vector3d turned = Vector3d.Cross(in n, in rub);
            impulse += rub;
            first.SpinAxis -= a.Radius * a.PerInertia * turned;
            second.SpinAxis -= b.Radius * b.PerInertia * turned;
            slipped = slip.Length;
        }

        first.Velocity += a.PerMass * impulse;
        second.Velocity -= b.PerMass * impulse;
        return Math.Max(Math.Abs(off), slipped);
    }
}
