namespace FootballPhysics;

/// <summary>Surfaces with the same normal act as one: tiles, a box set into the turf, two boards of one wall.</summary>
/// <remarks>
/// A ball that slides along one of them crosses onto the next without an impact. Only the material and the velocity of the surface change.
/// </remarks>
internal static class Flush
{
    /// <summary>Normals are one where n₁·n₂ is closer to 1 than this.</summary>
    /// <remarks>
    /// The edge of the next tile is first touched, 1e-10 m before the ball is on it, at 4e-5 rad; that of a tile that is 1e-10 m higher at
    /// 6e-5, where n₁·n₂ is 1 − 1.8e-9.
    /// </remarks>
    public const double SameNormal = 4e-9;

    /// <summary>Over the edge of its carrier a ball is handed on to a surface that is no lower than this, m.</summary>
    public const double LowerBy = 3.0 * ContactSearch.Touching;

    /// <summary>Two depths are equal within this, m.</summary>
    private const double SameDepth = 1e-12;

    /// <summary>Two surfaces with one normal part by no more than this, m, until they are compared again.</summary>
    private const double Parted = 1e-8;

    /// <summary>Normals closer than this, as the sine of their angle, are those of one face or of two surfaces that coincide.</summary>
    private const double Coincident = 1e-8;

    /// <summary>The ball is over the face of the next surface after so many times the distance to its edge.</summary>
    private const double OverTheEdge = 2.0;

    /// <summary>How long a ball goes on until the normals are one, s: it comes to the edge of a surface that is flush with one that it touches already.</summary>
    /// <param name="world">The world.</param>
    /// <param name="thing">The collider that it comes to.</param>
    /// <param name="position">Where it touches that, m.</param>
    /// <param name="velocity">Its velocity, m/s.</param>
    /// <param name="time">When, s.</param>
    /// <param name="carrier">The collider that carries the ball; −1 if none does.</param>
    /// <param name="held">Contacts that the ball keeps.</param>
    /// <returns>0 where the contact is an impact.</returns>
    public static double Passage(World world, int thing, in Vector3d position, in Vector3d velocity, double time, int carrier = -1, Span<Contact> held = default)
    {
        Collider next = world.Colliders[thing];
        ShapePoint at = next.At(position, time);
        double r = world.Ball.Radius;
        Vector3d relative = velocity - next.SurfaceVelocity(position - (r * at.Normal), time);
        double closing = -Vector3d.Dot(in relative, at.Normal);
        var near = NearThings.At(world, in position, time);
        while (near.NextCollider(out int i))
        {
            if (i == thing)
            {
                continue;
            }

            // Flush: touched, with the same normal, and the ball closes no faster than the normals differ, |u| |n₁ × n₂|.
            Collider other = world.Colliders[i];
            ShapePoint on = other.At(position, time);
            if (!(on.Distance - r <= 2.0 * ContactSearch.Touching) || !(Vector3d.Dot(on.Normal, at.Normal) > 1.0 - SameNormal))
            {
                continue;
            }

            double sine = Vector3d.Cross(on.Normal, at.Normal).Length;
            double speed = relative.Length;
            Vector3d along = velocity - other.ShapeVelocity(position - (r * on.Normal), time);
            double closingOnOther = -Vector3d.Dot(in along, on.Normal);

            // Between the ends of a piece, the path error makes the ball close on its own contacts. Allow the same speed for a flush
            // surface.
            bool carries = i == carrier || ContactSet.Has(held, i);
            double explained = (speed * sine) + ContactSearch.Approaching + (carries ? Math.Max(0, closingOnOther) : 0);
            if (closing <= explained && (carries || closingOnOther <= ContactSearch.Approaching))
            {
                // Advance past the edge, r sin θ along the surface, and until coinciding convex surfaces can separate: ½ |u|² t²/r.
                double apart = carries && sine <= Coincident ? Math.Sqrt(2.0 * Parted * r) / speed : 0;
                return Math.Max(Math.Max(OverTheEdge * r * sine / speed, apart), double.Epsilon);
            }
        }

        return 0;
    }

    /// <summary>True if two contacts have the same normal, and neither surface moves against the other along it.</summary>
    /// <param name="first">One contact.</param>
    /// <param name="second">The other contact.</param>
    public static bool IsFlush(in Contact first, in Contact second)
    {
        if (!(Vector3d.Dot(in first.Normal, in second.Normal) > 1.0 - SameNormal))
        {
            return false;
        }

        return MovesAlong(first.Velocity - second.Velocity, in first.Normal, in second.Normal);
    }

    /// <summary>True if neither of two surfaces moves against the other along their normal.</summary>
    private static bool MovesAlong(World world, int first, int second, in Vector3d position, in ShapePoint on, in ShapePoint at, double time)
    {
        Collider one = world.Colliders[first];
        Collider other = world.Colliders[second];
        if (!one.Moves && !other.Moves)
        {
            return true;
        }

        double r = world.Ball.Radius;
        Vector3d difference = one.SurfaceVelocity(position - (r * on.Normal), time) - other.SurfaceVelocity(position - (r * at.Normal), time);
        return MovesAlong(in difference, on.Normal, at.Normal);
    }

    /// <summary>True if the difference of two velocities is along surfaces with these normals: at the edge of a tile those differ a little, and ΔV·n is at most |ΔV| |n₁ × n₂|.</summary>
    private static bool MovesAlong(in Vector3d difference, in Vector3d first, in Vector3d second) =>
        Math.Abs(Vector3d.Dot(in difference, in first)) <= ContactSearch.Approaching + (difference.Length * Vector3d.Cross(in first, in second).Length);

    /// <summary>True if the first of two contacts with the same normal stands for both.</summary>
    /// <param name="world">The world.</param>
    /// <param name="first">One contact.</param>
    /// <param name="second">The other contact.</param>
    /// <param name="carrier">The collider that carries the ball; −1 for none.</param>
    public static bool ComesBefore(World world, in Contact first, in Contact second, int carrier) =>
        ComesBefore(world, first.Collider, first.IsFlat, second.Collider, second.IsFlat, second.Gap - first.Gap, carrier);

    private static bool ComesBefore(World world, int first, bool firstIsFlat, int second, bool secondIsFlat, double deeper, int carrier)
    {
        if (firstIsFlat != secondIsFlat)
        {
            return firstIsFlat;
        }

        if (Math.Abs(deeper) > SameDepth)
        {
            return deeper > 0;
        }

        bool isGround = world.Colliders[first] == world.Ground;
        return isGround || world.Colliders[second] == world.Ground ? !isGround : first == carrier || (second != carrier && first < second);
    }

    /// <summary>The surface that carries a ball if several with the same normal touch it.</summary>
    /// <remarks>
    /// The order: a face under the ball, the deepest, any object before the ground, the carrier so far, the first of the scene.
    /// </remarks>
    /// <param name="world">The world.</param>
    /// <param name="s">The ball, on a surface.</param>
    /// <returns>Index of the collider.</returns>
    public static int CarrierOf(World world, in BallState s)
    {
        return CarrierAt(world, (int)s.Carrier - world.FirstCollider, s.Position, s.Time);
    }

    /// <inheritdoc cref="CarrierOf"/>
    public static int CarrierAt(World world, int carrier, in Vector3d position, double time)
    {
        if (!world.IsCollider(carrier))
        {
            return carrier;
        }

        ShapePoint on = world.Colliders[carrier].At(position, time);
        int best = carrier;
        double depth = -on.Distance;
        bool isFlat = on.IsFlat;
        var near = NearThings.At(world, in position, time);
        while (near.NextCollider(out int i))
        {
            if (i == carrier)
            {
                continue;
            }

            ShapePoint at = world.Colliders[i].At(position, time);
            if (!(at.Distance - world.Ball.Radius <= (isFlat ? ContactSearch.Touching : LowerBy)) || !(Vector3d.Dot(on.Normal, at.Normal) > 1.0 - SameNormal)
                || !MovesAlong(world, carrier, i, in position, in on, in at, time))
            {
                continue;
            }

            // The walk has no defined order, so the rule decides and not the first hit.
            bool wins = ComesBefore(world, i, at.IsFlat, best, isFlat, -at.Distance - depth, carrier);
            if (wins)
            {
                best = i;
                depth = -at.Distance;
                isFlat = at.IsFlat;
            }
        }

        return best;
    }
}
