using System.Runtime.CompilerServices;

namespace FootballPhysics.Contacts;

/// <summary>All contacts of a ball at one instant: the ground and a board, two boards, a player and a post.</summary>
/// <remarks>
/// The order in which the contacts arose has no effect. Flat surfaces with the same normal, such as adjacent boards, are merged into one
/// contact.
/// </remarks>
internal static class ContactSet
{
    /// <summary>In a wedge between opposite surfaces with a smaller sin² of the angle between the normals, the ball is projected onto one surface after the other.</summary>
    private const double NarrowWedge = 1e-3;

    /// <summary>Number of contacts that callers reserve on the stack. Larger sets use a <see cref="ContactRoom"/>.</summary>
    public const int Room = 8;

    /// <summary>Maximum size of a set that is solved iteratively.</summary>
    /// <remarks>If a set is larger, moving contacts without load are dropped; stationary ones never are.</remarks>
    public const int Most = 16;

    /// <summary>Maximum number of iterations that project a ball onto its contacts.</summary>
    private const int MostRounds = 64;

    /// <summary>Maximum number of such rounds with the contacts at the new position.</summary>
    private const int MostWays = 16;

    /// <summary>Maximum speed at which an overlap with moving objects is resolved, m/s.</summary>
    public const double OutOfTheWay = 5.0;

    /// <summary>Maximum number of Newton iterations that project a ball onto two contacts.</summary>
    private const int MostNewton = 4;

    /// <summary>Search radius for objects that a ball may be pushed into when it is pushed out of another, m.</summary>
    private const double Beside = 0.01;

    /// <summary>A carrier with at least this share of the greatest load stays the carrier.</summary>
    public const double AboutAsMuch = 0.5;

    /// <summary>Finds the contacts that neither close nor separate; for a ball that rattles, those that close or separate slowly.</summary>
    /// <param name="world">The world.</param>
    /// <param name="s">The ball.</param>
    /// <param name="room">Stack memory for contacts.</param>
    /// <param name="more">Further memory.</param>
    /// <param name="rattles">True if the ball rattles.</param>
    /// <returns>The contacts.</returns>
    public static Span<Contact> Touching(World world, scoped in BallState s, Span<Contact> room, ContactRoom more, bool rattles = false)
    {
        Span<Contact> set = Near(world, in s, rattles ? ContactTolerances.Rattling : ContactTolerances.Touching, room, more);
        double closing = rattles ? world.MinimumBounceSpeed : ContactTolerances.Approaching;
        double leaving = rattles ? world.MinimumBounceSpeed : ContactTolerances.Leaving;
        int kept = 0;
        for (int i = 0; i < set.Length; i++)
        {
            // Keep contacts that neither close nor separate: (v − V)·n ≈ 0, with the object's velocity V.
            double rate = Vector3d.Dot(s.Velocity - set[i].Velocity, in set[i].Normal);
            if (rate >= -closing && rate <= leaving && kept++ < i)
            {
                set[kept - 1] = set[i];
            }
        }

        return set.Slice(0, kept);
    }

    /// <summary>Finds all surfaces that overlap the ball or are within a distance.</summary>
    /// <param name="world">The world.</param>
    /// <param name="s">The ball.</param>
    /// <param name="reach">The distance, m.</param>
    /// <param name="room">Stack memory for contacts.</param>
    /// <param name="more">Further memory.</param>
    /// <returns>The contacts.</returns>
    public static Span<Contact> Near(World world, scoped in BallState s, double reach, Span<Contact> room, ContactRoom more)
    {
        int count = 0;
        int carrier = s.Motion == MotionState.Airborne ? -1 : (int)s.Carrier - world.FirstCollider;

        // Broad phase by bounding boxes, then the exact distance.
        var near = NearThings.At(world, in s, reach);
        while (near.Next(out int i))
        {
            Collider collider = world.ByIndex[i];
            ShapePoint at = collider.At(s.Position, s.Time);
            double gap = at.Distance - world.Ball.Radius;
            if (gap > reach)
            {
                continue;
            }

            var contact = new Contact(i, collider, in at, gap, world.Ball, in s);

            // Merge surfaces with the same normal into one contact.
            int place = PlaceOf(in contact, room.Slice(0, count), world, carrier);
            if (place >= 0)
            {
                room = place < room.Length ? room : more.Grown(room);
                room[place] = contact;
                count = Math.Max(count, place + 1);
            }
        }

        Span<Contact> set = room.Slice(0, count);
        Sort(world, set);
        return set;
    }

    /// <summary>Drops moving contacts without load from a solved set that is too large, the farthest first.</summary>
    /// <param name="set">The contacts, with their loads.</param>
    /// <returns>The contacts that remain.</returns>
    public static Span<Contact> LeaveOut(Span<Contact> set)
    {
        while (set.Length > Most)
        {
            int farthest = -1;
            for (int i = 0; i < set.Length; i++)
            {
                bool idles = set[i].Moves && set[i].Load == 0;
                farthest = idles && (farthest < 0 || set[i].Gap > set[farthest].Gap) ? i : farthest;
            }

            if (farthest < 0)
            {
                return set;
            }

            set.Slice(farthest + 1).CopyTo(set.Slice(farthest));
            set = set.Slice(0, set.Length - 1);
        }

        return set;
    }

    /// <summary>True if the set contains a moving object.</summary>
    public static bool HasMover(Span<Contact> set)
    {
        foreach (ref readonly Contact contact in set)
        {
            if (contact.Moves)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>True if a ball touches an object other than its carrier, without closing or separating.</summary>
    [SkipLocalsInit]
    public static bool TouchesMore(World world, in BallState s, int carrier)
    {
        Span<Contact> room = stackalloc Contact[Room];
        Span<Contact> set = Touching(world, in s, room, world.Room);
        return set.Length > 1 || (set.Length == 1 && set[0].Collider != carrier);
    }

    /// <summary>Copies the impulses of the previous part of a step as a warm start.</summary>
    public static void Continue(Span<Contact> set, Span<Contact> last)
    {
        foreach (ref Contact contact in set)
        {
            foreach (ref readonly Contact before in last)
            {
                if (before.Collider == contact.Collider)
                {
                    contact.Load = before.Load;
                    contact.Rub = before.Rub;
                }
            }
        }
    }

    /// <summary>True if the set contains a collider.</summary>
    public static bool Has(Span<Contact> set, int collider)
    {
        foreach (ref readonly Contact contact in set)
        {
            if (contact.Collider == collider)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Resets the impulses.</summary>
    public static void Forget(Span<Contact> set)
    {
        foreach (ref Contact contact in set)
        {
            contact.Load = 0;
            contact.Rub = default;
        }
    }

    /// <summary>Returns the index of the contact with the greatest load; −1 if none has a load.</summary>
    public static int Heaviest(Span<Contact> set)
    {
        int heaviest = -1;
        for (int i = 0; i < set.Length; i++)
        {
            // If two loads are equal to within rounding, take the first contact.
            heaviest = set[i].Load > (heaviest < 0 ? 0 : set[heaviest].Load * (1.0 + ContactTolerances.SameLoad)) ? i : heaviest;
        }

        return heaviest;
    }

    /// <summary>Returns the contact that becomes the carrier: the one with the greatest load, or the old carrier.</summary>
    /// <remarks>The old carrier stays while it has at least half of the greatest load, so that two equal contacts do not
    /// alternate.</remarks>
    /// <param name="set">The contacts, with their loads.</param>
    /// <param name="carrier">The old carrier.</param>
    /// <returns>The index of the contact; −1 if no contact has a load.</returns>
    public static int Named(Span<Contact> set, int carrier)
    {
        int named = Heaviest(set);
        double most = named < 0 ? 0 : set[named].Load;
        for (int i = 0; i < set.Length && named >= 0; i++)
        {
            named = set[i].Collider == carrier && set[i].Load > AboutAsMuch * most ? i : named;
        }

        return named;
    }

    /// <summary>Projects a ball onto its loaded contacts and out of all others: moving ones first, then stationary ones, which it never
    /// enters.</summary>
    public static void Hold(World world, ref BallState s, Span<Contact> set)
    {
        PutOntoTwo(world, ref s, set);
        bool moved = true;

        // Repeat the projections until the ball no longer moves. Project stationary surfaces last, so that the ball does not enter them.
        for (int round = 0; round < MostRounds && moved; round++)
        {
            moved = false;
            for (int pass = 0; pass < 2; pass++)
            {
                foreach (ref readonly Contact contact in set)
                {
                    if (contact.Moves == (pass == 0))
                    {
                        moved |= Put(world, ref s, in contact, closes: round == 0);
                    }
                }
            }
        }
    }

    /// <summary>Projects a ball onto the two contacts with the greatest loads.</summary>
    private static void PutOntoTwo(World world, ref BallState s, Span<Contact> set)
    {
        int first = Heaviest(set);
        int second = -1;
        for (int i = 0; i < set.Length; i++)
        {
            second = i != first && set[i].Load > 0 && (second < 0 || set[i].Load > set[second].Load) ? i : second;
        }

        if (second >= 0)
        {
            PutOntoTwo(world, ref s, world.ByIndex[set[first].Collider], world.ByIndex[set[second].Collider]);
        }
    }

    /// <summary>Newton's method on the gaps of two surfaces, until the ball touches both.</summary>
    /// <remarks>At a small angle, or on curved surfaces, alternating projections would converge slowly. In a narrow wedge, a small gap would move
    /// the ball far along the wedge, and lift it. Flush surfaces count as one.</remarks>
    public static void PutOntoTwo(World world, ref BallState s, Collider first, Collider second)
    {
        ShapePoint one = first.At(s.Position, s.Time);
        ShapePoint two = second.At(s.Position, s.Time);
        (bool isFlat, bool isOtherFlat) = (one.IsFlat, two.IsFlat);
        for (int round = 0; round < MostNewton; round++)
        {
            double gap = one.Distance - world.Ball.Radius;
            double other = two.Distance - world.Ball.Radius;
            double cosine = Vector3d.Dot(one.Normal, two.Normal);
            double square = 1.0 - (cosine * cosine);
            if (!(square > (cosine < 0 ? NarrowWedge : ContactTolerances.SameNormal * 4.0)) || (Math.Abs(gap) <= ContactTolerances.ClosedGap && Math.Abs(other) <= ContactTolerances.ClosedGap) || one.IsFlat != isFlat || two.IsFlat != isOtherFlat)
            {
                return;
            }

            // The shortest displacement that closes both gaps: δ = λ₁ n₁ + λ₂ n₂ with δ·nᵢ = −gapᵢ, solved for the lengths λ along the normals.
            s.Position += (((cosine * other) - gap) / square * one.Normal) + (((cosine * gap) - other) / square * two.Normal);
            one = first.At(s.Position, s.Time);
            two = second.At(s.Position, s.Time);
        }
    }

    /// <summary>Pushes a ball out of all objects that it overlaps, and removes its velocity into them.</summary>
    [SkipLocalsInit]
    public static void Separate(World world, ref BallState s)
    {
        Span<Contact> room = stackalloc Contact[Room];

        // Include nearby surfaces, because a ball pushed out of one object must not enter another.
        Span<Contact> set = Near(world, in s, Beside, room, world.Room);
        foreach (ref readonly Contact contact in set)
        {
            if (contact.Gap < 0)
            {
                Hold(world, ref s, set);
                return;
            }
        }
    }

    /// <summary>Pushes a ball out of stationary objects only.</summary>
    /// <returns>True if a free position was found.</returns>
    public static bool KeepOut(World world, ref BallState s, Span<Contact> set)
    {
        bool inside = true;
        for (int round = 0; round < MostRounds && inside; round++)
        {
            inside = false;
            foreach (ref readonly Contact contact in set)
            {
                ShapePoint at = world.ByIndex[contact.Collider].At(s.Position, s.Time);
                double gap = at.Distance - world.Ball.Radius;
                if (!contact.Moves && gap < -ContactTolerances.ClosedGap)
                {
                    s.Position = world.ByIndex[contact.Collider].SnapUp(s.Position - (gap * at.Normal));
                    inside = true;
                }
            }
        }

        return !inside;
    }

    /// <summary>Pushes a ball out of moving objects by at most a distance in all, then out of stationary ones, which it never enters.</summary>
    /// <param name="world">The world.</param>
    /// <param name="s">The ball.</param>
    /// <param name="set">The contacts.</param>
    /// <param name="most">The distance, m: stationary surfaces beyond it may be missing from the set.</param>
    public static void PushOut(World world, ref BallState s, Span<Contact> set, double most)
    {
        Vector3d from = s.Position;
        foreach (ref readonly Contact contact in set)
        {
            ShapePoint at = world.ByIndex[contact.Collider].At(s.Position, s.Time);
            double over = world.Ball.Radius - at.Distance;
            s.Position += contact.Moves && over > 0 ? Math.Min(most, over) * at.Normal : Vector3d.Zero;
        }

        Vector3d pushed = s.Position - from;
        double length = pushed.Length;
        s.Position = length > most ? from + (most / length * pushed) : s.Position;
        KeepOut(world, ref s, set);
    }

    /// <summary>Pushes a ball out of all stationary objects. If that fails, the ball returns to its old position, with zero velocity.</summary>
    /// <param name="world">The world.</param>
    /// <param name="s">The ball, which may have been pushed past its known contacts.</param>
    /// <param name="back">The old position, m.</param>
    [SkipLocalsInit]
    public static void StayOut(World world, ref BallState s, in Vector3d back)
    {
        Span<Contact> room = stackalloc Contact[Room];
        for (int round = 0; round < MostWays; round++)
        {
            // Repeat, because each round of projections gains little between walls at a small angle.
            Span<Contact> near = Near(world, in s, 0, room, world.Room);
            bool isInside = false;
            foreach (ref readonly Contact contact in near)
            {
                isInside |= !contact.Moves && contact.Gap < -ContactTolerances.Overlap;
            }

            if (!isInside)
            {
                return;
            }

            KeepOut(world, ref s, near);
        }

        s.Position = back;
        s.Velocity = Vector3d.Zero;
    }

    private static bool Put(World world, ref BallState s, in Contact contact, bool closes)
    {
        Collider collider = world.ByIndex[contact.Collider];
        ShapePoint at = collider.At(s.Position, s.Time);
        if (contact.IsFlat && collider.HasFaces && !at.IsFlat)
        {
            // Just beyond the edge of a flat face, the ball is still on the plane of that face.
            return false;
        }

        double gap = at.Distance - world.Ball.Radius;
        double off = Vector3d.Dot(s.Velocity - collider.ShapeVelocity(s.Position - (world.Ball.Radius * at.Normal), s.Time), at.Normal);
        bool bears = contact.Load > 0;

        // A loaded contact keeps the ball on its surface, at zero normal speed; other contacts only keep the ball out. Close remaining gaps if
        // possible.
        s.Velocity -= (bears ? off : gap <= ContactTolerances.Touching ? Math.Min(0, off) : 0) * at.Normal;
        gap = bears && (contact.Touches || closes) ? gap : Math.Min(0, gap);
        s.Position -= gap * at.Normal;
        s.Position = bears ? collider.Snap(s.Position) : collider.SnapUp(s.Position);
        return Math.Abs(gap) > ContactTolerances.ClosedGap;
    }

    /// <summary>Returns the index for a contact in the set: a new index, the one of a contact to replace, or −1 to drop it.</summary>
    private static int PlaceOf(in Contact contact, Span<Contact> set, World world, int carrier)
    {
        for (int i = 0; i < set.Length; i++)
        {
            ref readonly Contact other = ref set[i];
            if (Flush.IsFlush(in contact, in other))
            {
                return Flush.ComesBefore(world, in contact, in other, carrier) ? i : -1;
            }
        }

        return set.Length;
    }

    /// <summary>Sorts contacts in scene order, and bodies by their normals, because the order in which they were added or found must not
    /// matter.</summary>
    private static void Sort(World world, Span<Contact> set)
    {
        for (int i = 1; i < set.Length; i++)
        {
            for (int place = i; place > 0 && world.ComesFirst(set[place].Collider, in set[place].Normal, set[place - 1].Collider, in set[place - 1].Normal); place--)
            {
                (set[place], set[place - 1]) = (set[place - 1], set[place]);
            }
        }
    }
}
