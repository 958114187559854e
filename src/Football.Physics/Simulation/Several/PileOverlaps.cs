namespace FootballPhysics;

/// <summary>Puts the balls of a pile where there is room for them after a part: what stands still is never entered.</summary>
/// <param name="simulators">The scenes of all balls of the group.</param>
/// <param name="solver">The pile's balls and contacts.</param>
internal sealed class PileOverlaps(Simulator[] simulators, PileSolver solver)
{
    /// <summary>Balls are put apart, and out of things, in so many rounds at most; out of corners in so many.</summary>
    private const int MostRounds = 128;
    private const int MostCorners = 64;

    /// <summary>Less than this, m, is no overlap: of balls, and with what stands still.</summary>
    private const double Overlap = 1e-7;
    private const double Closed = 1e-13;

    /// <summary>The greatest depth of a ball in stationary surfaces at the end of a part, m; and the most rounds of projections that ensure it.</summary>
    private const double Inside = 5e-10;
    private const int MostWays = 16;

    /// <summary>Out of what moves a ball is put by no more than this, m/s.</summary>
    private const double OutOfTheWay = 5.0;

    /// <summary>Puts balls apart that overlap, each by its share, and then out of what moves, by no more than a distance, and out of what stands still.</summary>
    /// <param name="states">The balls.</param>
    /// <param name="duration">How long the part took, s.</param>
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
                    if (square < most * most && square > 0)
                    {
                        double distance = Math.Sqrt(square);
                        double over = most - distance;
                        Vector3d shift = over * contact.NormalMass / distance * apart;
                        states[a.Ball].Position += a.PerMass * shift;
                        states[b.Ball].Position -= b.PerMass * shift;
                        moved |= over > Overlap;
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

    /// <summary>How much two balls overlap at most, m; 0 if none do.</summary>
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

    /// <summary>Pressed by many, a ball may get beyond the contacts that were looked for, or have no room between them: out of all that stands still, or back.</summary>
    private void StayOut(in PileMember member, BallState[] states)
    {
        World world = simulators[member.Ball].World;
        ref BallState s = ref states[member.Ball];
        Span<Contact> room = stackalloc Contact[ContactSet.Room];
        for (int round = 0; round < MostWays; round++)
        {
            // Repeat: between walls at a small angle, each round of projections gains little.
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
            if (!contact.Moves && contact.Gap < -Inside)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Puts a ball out of what stands still.</summary>
    public void KeepOut(int member, BallState[] states)
    {
        KeepOut(in solver.Members[member], states, 0);
        StayOut(in solver.Members[member], states);
    }

    /// <summary>Puts a ball out of what it overlaps; what stands still comes last, so that it is never entered.</summary>
    /// <returns>Whether it was in something.</returns>
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

                    Collider collider = world.Colliders[solver.Contacts[i].Collider];
                    ShapePoint at = collider.At(s.Position, s.Time);
                    double over = member.Radius - at.Distance;
                    if (over > Closed && (pass == 1 || round == 0))
                    {
                        s.Position += (pass == 0 ? Math.Min(over, outOfTheWay) : over) * at.Normal;
                        inside |= pass == 1;
                        moved |= over > Overlap;
                    }

                    if (world.IsLevel && collider == world.Ground)
                    {
                        // Set the exact height of a ball on level ground.
                        s.Position = new Vector3d(s.Position.X, Math.Max(s.Position.Y, world.LevelContact), s.Position.Z);
                    }
                }

                // Limit the total displacement by all movers to that of a single one.
                double way = (s.Position - from).Length;
                s.Position = pass == 0 && way > outOfTheWay ? from + (outOfTheWay / way * (s.Position - from)) : s.Position;
            }
        }

        return moved;
    }
}
