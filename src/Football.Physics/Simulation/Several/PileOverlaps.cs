using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Resolves the overlaps of a pile after a part. No ball enters a stationary object.</summary>
/// <param name="simulators">The scenes of all balls of the group.</param>
/// <param name="solver">The pile's balls and contacts.</param>
internal sealed class PileOverlaps(Simulator[] simulators, PileSolver solver)
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
            for (int i = 0; i < solver.ContactCount; i++)
            {
                ref readonly PileContact contact = ref solver.Contacts[i];
                if (contact.Second >= 0)
                {
                    ref readonly PileMember a = ref solver.Members[contact.First];
                    ref readonly PileMember b = ref solver.Members[contact.Second];
                    Vector3d apart = states[a.Ball].Position - states[b.Ball].Position;
                    double most = a.Radius + b.Radius;
                    double square = apart.LengthSquared;
                    if (square < most * most)
                    {
                        double distance = Math.Sqrt(square);
                        double over = most - distance;
                        Vector3d shift = distance > 0 ? over * contact.NormalMass / distance * apart : over * contact.NormalMass * BallContact.Normal(in apart, 0);
                        states[a.Ball].Position += a.PerMass * shift;
                        states[b.Ball].Position -= b.PerMass * shift;
                        moved |= over > ContactTolerances.PileOverlap;
                    }
                }
            }

            for (int i = 0; i < solver.Count; i++)
            {
                moved |= KeepOut(in solver.Members[i], states, round == 0 ? OutOfTheWay * duration : 0);
            }
        }

        for (int i = 0; i < solver.Count; i++)
        {
            StayOut(in solver.Members[i], states);
        }
    }

    /// <summary>Returns the maximum overlap of two balls, m; 0 if none overlap.</summary>
    public double Deepest(BallState[] states)
    {
        double deepest = 0;
        for (int i = 0; i < solver.ContactCount; i++)
        {
            ref readonly PileContact contact = ref solver.Contacts[i];
            if (contact.Second >= 0)
            {
                ref readonly PileMember a = ref solver.Members[contact.First];
                ref readonly PileMember b = ref solver.Members[contact.Second];
                deepest = Math.Max(deepest, a.Radius + b.Radius - (states[a.Ball].Position - states[b.Ball].Position).Length);
            }
        }

        return deepest;
    }

    /// <summary>Pushes a ball out of all stationary objects, or back to its old position: many balls may push it past the known
    /// contacts.</summary>
    private void StayOut(in PileMember member, BallState[] states)
    {
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
        KeepOut(in solver.Members[member], states, 0);
        StayOut(in solver.Members[member], states);
    }

    /// <summary>Pushes a ball out of objects that it overlaps; stationary ones last, so that the ball does not enter them.</summary>
    /// <returns>True if it overlapped an object.</returns>
    private bool KeepOut(in PileMember member, BallState[] states, double outOfTheWay)
    {
        World world = simulators[member.Ball].World;
        ref BallState s = ref states[member.Ball];
        bool moved = false;
        bool inside = member.OwnContacts > 0;
        for (int round = 0; round < MostCorners && inside; round++)
        {
            inside = false;
            for (int pass = 0; pass < 2; pass++)
            {
                Vector3d from = s.Position;
                for (int i = member.FirstContact; i < member.FirstContact + member.OwnContacts; i++)
                {
                    if (solver.Contacts[i].Moves != (pass == 0))
                    {
                        continue;
                    }

                    Collider collider = world.ByIndex[solver.Contacts[i].Collider];
                    ShapePoint at = collider.At(s.Position, s.Time);
                    double over = member.Radius - at.Distance;
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
