namespace FootballPhysics.Contacts;

/// <summary>Surfaces with the same normal act as one: tiles, a box set into the turf, two boards of one wall.</summary>
/// <remarks>
/// A ball that slides along one of them crosses onto the next without an impact. Only the material and the velocity of the surface change.
/// </remarks>
internal static class Flush
{
    /// <summary>Beyond the edge of its carrier, a ball is handed over to a surface that is at most this much lower, m.</summary>
    public const double LowerBy = 3.0 * ContactTolerances.Touching;

    /// <summary>The ball is over the face of the next surface after this multiple of the distance to its edge.</summary>
    private const double OverTheEdge = 2.0;

    /// <summary>Returns the time until the normals agree, s, if the ball reaches the edge of a surface that is flush with one it
    /// touches.</summary>
    /// <param name="world">The world.</param>
    /// <param name="thing">The collider that it reaches.</param>
    /// <param name="position">Position of the ball at the contact, m.</param>
    /// <param name="velocity">Its velocity, m/s.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="carrier">The carrier; −1 if there is none.</param>
    /// <param name="held">Contacts that the ball keeps.</param>
    /// <returns>0 if the contact is an impact.</returns>
    public static double Passage(World world, int thing, in Vector3d position, in Vector3d velocity, double time, int carrier = -1, Span<Contact> held = default)
    {
        Collider next = world.ByIndex[thing];
        ShapePoint at = next.At(position, time);
        double r = world.Ball.Radius;
        Vector3d relative = velocity - next.SurfaceVelocity(position - (r * at.Normal), at.Normal, time);
        double closing = -Vector3d.Dot(in relative, at.Normal);
        var near = NearThings.At(world, in position, time);
        while (near.Next(out int i))
        {
            if (i == thing)
            {
                continue;
            }

            // Flush: the ball touches a surface with the same normal, and closes on it no faster than the difference of the normals explains: |u| |n₁ × n₂| at
            // the speed |u|.
            Collider other = world.ByIndex[i];
            ShapePoint on = other.At(position, time);
            if (!(on.Distance - r <= 2.0 * ContactTolerances.Touching) || !(Vector3d.Dot(on.Normal, at.Normal) > 1.0 - ContactTolerances.SameNormal))
            {
                continue;
            }

            double sine = Vector3d.Cross(on.Normal, at.Normal).Length;
            double speed = relative.Length;
            Vector3d along = velocity - other.ShapeVelocity(position - (r * on.Normal), time);
            double closingOnOther = -Vector3d.Dot(in along, on.Normal);

            // Between the ends of a piece, the path error makes the ball close on its own contacts: allow the same speed for a flush surface.
            bool carries = i == carrier || ContactSet.Has(held, i);
            double explained = (speed * sine) + ContactTolerances.Approaching + (carries ? Math.Max(0, closingOnOther) : 0);
            if (closing <= explained && (carries || closingOnOther <= ContactTolerances.Approaching))
            {
                // The longer of two times: until the ball is past the edge, r sin θ at an angle θ of the normals, and until coinciding convex surfaces separate,
                // ½ |u|² t²/r.
                double apart = carries && sine <= ContactTolerances.Coincident ? Math.Sqrt(2.0 * ContactTolerances.PartedSurfaces * r) / speed : 0;
                return Math.Max(Math.Max(OverTheEdge * r * sine / speed, apart), double.Epsilon);
            }
        }

        return 0;
    }

    /// <summary>True if two contacts have the same normal, and neither surface moves relative to the other along it.</summary>
    /// <param name="first">One contact.</param>
    /// <param name="second">The other contact.</param>
    public static bool IsFlush(in Contact first, in Contact second)
    {
        if (!(Vector3d.Dot(in first.Normal, in second.Normal) > 1.0 - ContactTolerances.SameNormal))
        {
            return false;
        }

        return MovesAlong(first.Velocity - second.Velocity, in first.Normal, in second.Normal);
    }

    /// <summary>True if two surfaces do not move relative to each other along their normal.</summary>
    private static bool MovesAlong(World world, int first, int second, in Vector3d position, in ShapePoint on, in ShapePoint at, double time)
    {
        Collider one = world.ByIndex[first];
        Collider other = world.ByIndex[second];
        if (!one.Moves && !other.Moves)
        {
            return true;
        }

        double r = world.Ball.Radius;
        Vector3d difference = one.SurfaceVelocity(position - (r * on.Normal), on.Normal, time) - other.SurfaceVelocity(position - (r * at.Normal), at.Normal, time);
        return MovesAlong(in difference, on.Normal, at.Normal);
    }

    /// <summary>True if the difference of two velocities has no normal component.</summary>
    /// <remarks>At an edge the normals differ slightly, so ΔV·n may be up to |ΔV| |n₁ × n₂|.</remarks>
    private static bool MovesAlong(in Vector3d difference, in Vector3d first, in Vector3d second) =>
        Math.Abs(Vector3d.Dot(in difference, in first)) <= ContactTolerances.Approaching + (difference.Length * Vector3d.Cross(in first, in second).Length);

    /// <summary>True if the first of two contacts with the same normal represents both.</summary>
    /// <param name="world">The world.</param>
    /// <param name="first">One contact.</param>
    /// <param name="second">The other contact.</param>
    /// <param name="carrier">The carrier; −1 if there is none.</param>
    public static bool ComesBefore(World world, in Contact first, in Contact second, int carrier) =>
        ComesBefore(world, first.Collider, in first.Bend, second.Collider, in second.Bend, second.Gap - first.Gap, carrier);

    private static bool ComesBefore(World world, int first, in Bend bend, int second, in Bend other, double deeper, int carrier)
    {
        double rises = bend.CompareTo(in other);
        if (rises != 0)
        {
            return rises < 0;
        }

        if (Math.Abs(deeper) > ContactTolerances.ClosedGap)
        {
            return deeper > 0;
        }

        bool isGround = world.ByIndex[first] == world.Ground;
        return isGround || world.ByIndex[second] == world.Ground ? !isGround : first == carrier || (second != carrier && first < second);
    }

    /// <summary>Returns the carrier if several surfaces with the same normal touch the ball.</summary>
    /// <remarks>
    /// Priority: the surface that curves least (<see cref="Bend"/>), the deepest, any object before the ground, the current carrier, scene order. A surface
    /// ends at its bounds.
    /// </remarks>
    /// <param name="world">The world.</param>
    /// <param name="s">The ball, on a surface.</param>
    /// <returns>Index of the collider.</returns>
    public static int CarrierOf(World world, in BallState s)
    {
        return CarrierAt(world, (int)s.Carrier - world.FirstCollider, s.Position, s.Velocity, s.Time);
    }

    /// <inheritdoc cref="CarrierOf"/>
    public static int CarrierAt(World world, int carrier, in Vector3d position, in Vector3d velocity, double time)
    {
        if (!world.IsCollider(carrier))
        {
            return carrier;
        }

        ShapePoint on = world.ByIndex[carrier].At(position, time);
        int best = carrier;
        double depth = -on.Distance;
        bool isFlat = on.IsFlat;
        Bend bend = world.ByIndex[carrier].BendAt(in on, in position, in velocity, time);
        bool ends = !world.ByIndex[carrier].Reaches(position - (on.Distance * on.Normal), time);
        var near = NearThings.At(world, in position, time);
        while (near.Next(out int i))
        {
            if (i == carrier)
            {
                continue;
            }

            ShapePoint at = world.ByIndex[i].At(position, time);
            if (!(at.Distance - world.Ball.Radius <= (isFlat ? ContactTolerances.Touching : LowerBy)) || !(Vector3d.Dot(on.Normal, at.Normal) > 1.0 - ContactTolerances.SameNormal)
                || !MovesAlong(world, carrier, i, in position, in on, in at, time) || !world.ByIndex[i].Reaches(position - (at.Distance * at.Normal), time))
            {
                continue;
            }

            // The traversal order is undefined: choose by this rule instead of by the first contact found.
            Bend other = world.ByIndex[i].BendAt(in at, in position, in velocity, time);
            bool wins = (ends && best == carrier) || ComesBefore(world, i, in other, best, in bend, -at.Distance - depth, carrier);
            if (wins)
            {
                best = i;
                depth = -at.Distance;
                isFlat = at.IsFlat;
                bend = other;
            }
        }

        return best;
    }
}
