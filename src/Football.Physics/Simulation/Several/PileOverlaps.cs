using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Resolves the overlaps of a pile after a part. No ball enters a stationary object.</summary>
/// <param name="simulators">The scenes of all balls of the group.</param>
/// <param name="system">The pile's balls and contacts.</param>
internal sealed class PileOverlaps(Simulator[] simulators, PileSystem system)
{
    /// <summary>Maximum number of iterations for overlaps of balls and objects, and for corners.</summary>
    private const int MostRounds = 128;
    private const int MostCorners = 64;

    /// <summary>Maximum number of projections that move a ball out of stationary surfaces after a part.</summary>
    private const int MostWays = 16;

    /// <summary>Maximum speed at which an overlap with moving objects is resolved, m/s.</summary>
    private const double OutOfTheWay = 5.0;

    /// <summary>Separates overlapping balls by their masses, then pushes them out of moving objects up to a distance, and out of stationary
    /// ones.</summary>
    /// <param name="states">The balls.</param>
    /// <param name="duration">Duration of the part, s.</param>
    public void PutApart(BallState[] states, double duration)
    {
        bool moved = true;
        for (int round = 0; round < MostRounds && moved; round++)
        {
            moved = false;
            for (int i = 0; i < system.ContactCount; i++)
            {
                ref readonly Contact contact = ref system.Contacts[i];
                if (contact.Second >= 0)
                {
                    ref readonly PressedBall a = ref system.Balls[contact.First];
                    ref readonly PressedBall b = ref system.Balls[contact.Second];
                    ref BallState s = ref states[system.Members[contact.First].Ball];
                    ref BallState its = ref states[system.Members[contact.Second].Ball];
                    Vector3d apart = s.Position - its.Position;
                    double most = a.Radius + b.Radius;
                    double square = apart.LengthSquared;
                    if (square < most * most)
                    {
                        double distance = Math.Sqrt(square);
                        double over = most - distance;
                        Vector3d shift = distance > 0 ? over * contact.NormalMass / distance * apart : over * contact.NormalMass * BallContact.Normal(in apart, 0);
                        s.Position += a.PerMass * shift;
                        its.Position -= b.PerMass * shift;
                        moved |= over > ContactTolerances.PileOverlap;
                    }
                }
            }

            for (int i = 0; i < system.Count; i++)
            {
                moved |= KeepOut(i, states, round == 0 ? OutOfTheWay * duration : 0);
            }
        }

        for (int i = 0; i < system.Count; i++)
        {
            StayOut(i, states);
        }
    }

    /// <summary>Returns the maximum overlap of two balls, m; 0 if none overlap.</summary>
    public double Deepest(BallState[] states)
    {
        double deepest = 0;
        for (int i = 0; i < system.ContactCount; i++)
        {
            ref readonly Contact contact = ref system.Contacts[i];
            if (contact.Second >= 0)
            {
                Vector3d apart = states[system.Members[contact.First].Ball].Position - states[system.Members[contact.Second].Ball].Position;
                deepest = Math.Max(deepest, system.Balls[contact.First].Radius + system.Balls[contact.Second].Radius - apart.Length);
            }
        }

        return deepest;
    }

    /// <summary>Pushes a ball out of all stationary objects, or back to its old position: many balls may push it past the known
    /// contacts.</summary>
    private void StayOut(int index, BallState[] states)
    {
        ref readonly PileMember member = ref system.Members[index];
        World world = simulators[member.Ball].World;
        ref BallState s = ref states[member.Ball];
        Span<Contact> room = stackalloc Contact[ContactSet.Room];
        for (int round = 0; round < MostWays; round++)
        {
            // Repeat, because each round of projections gains little between walls at a small angle.
            Span<Contact> near = ContactSet.Near(world, in s, 0, room, world.Room);
            if (!IsInside(near))
            {
                return;
            }

            ContactSet.KeepOut(world, ref s, near);
        }

        if (IsInside(ContactSet.Near(world, in s, 0, room, world.Room)))
        {
            s.Position = member.From.Position;
            s.Velocity = Vector3d.Zero;
        }
    }

    private static bool IsInside(Span<Contact> near)
    {
        foreach (ref readonly Contact contact in near)
        {
            if (!contact.Moves && contact.Gap < -ContactTolerances.Overlap)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Pushes a ball out of stationary objects.</summary>
    public void KeepOut(int member, BallState[] states)
    {
        KeepOut(member, states, 0);
        StayOut(member, states);
    }

    /// <summary>Pushes a ball out of objects that it overlaps; stationary ones last, so that the ball does not enter them.</summary>
    /// <returns>True if it overlapped an object.</returns>
    private bool KeepOut(int index, BallState[] states, double outOfTheWay)
    {
        int ball = system.Members[index].Ball;
        World world = simulators[ball].World;
        ref BallState s = ref states[ball];
        Span<Contact> contacts = system.OwnContactsOf(index);
        bool moved = false;
        bool inside = contacts.Length > 0;
        for (int round = 0; round < MostCorners && inside; round++)
        {
            inside = false;
            for (int pass = 0; pass < 2; pass++)
            {
                Vector3d from = s.Position;
                foreach (ref readonly Contact contact in contacts)
                {
                    if (contact.Moves != (pass == 0))
                    {
                        continue;
                    }

                    Collider collider = world.ByIndex[contact.Collider];
                    ShapePoint at = collider.At(s.Position, s.Time);
                    double over = world.Ball.Radius - at.Distance;
                    if (over > ContactTolerances.PileCorrection && (pass == 1 || round == 0))
                    {
                        s.Position += (pass == 0 ? Math.Min(over, outOfTheWay) : over) * at.Normal;
                        inside |= pass == 1;
                        moved |= over > ContactTolerances.PileOverlap;
                    }

                    s.Position = collider.SnapUp(s.Position);
                }

                // Limit the total displacement by all movers to the limit for a single mover.
                double way = (s.Position - from).Length;
                s.Position = pass == 0 && way > outOfTheWay ? from + (outOfTheWay / way * (s.Position - from)) : s.Position;
            }
        }

        return moved;
    }
}
