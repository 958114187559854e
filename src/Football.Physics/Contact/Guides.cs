namespace Football.Physics;

/// <summary>
/// The colliders that guide a ball: it touches them without coming closer, and what would push it into them is taken away. Three of them leave a
/// point no freedom, so more need not be remembered; of flat ones side by side, as boards are, one stands for all.
/// </summary>
internal struct Guides
{
    /// <summary>Onto what it touches a ball is put so often at most.</summary>
    private const int MostRounds = 256;

    /// <summary>Below this, m, there is no gap.</summary>
    private const double Closed = 1e-12;

    /// <summary>Normals are one where the cosine of the angle between them is closer to 1 than this.</summary>
    private const double InLine = 1e-14;

    private int _first;
    private int _second;
    private int _third;

    /// <summary>How many there are.</summary>
    public int Count { get; private set; }

    /// <summary>The colliders that a ball touches without coming closer or leaving.</summary>
    /// <param name="world">The world.</param>
    /// <param name="position">Where the ball is, m.</param>
    /// <param name="velocity">Its velocity, m/s.</param>
    /// <param name="time">When, s.</param>
    /// <param name="carrier">The collider that carries it, which is no guide; −1 where none does.</param>
    public static Guides Of(World world, in Vector3d position, in Vector3d velocity, double time, int carrier)
    {
        Guides guides = default;
        var near = NearThings.At(world, in position, time);
        while (near.NextCollider(out int i))
        {
            if (i == carrier)
            {
                continue;
            }

            Separation.OfContact(world, i).Evaluate(in position, in velocity, time, out double gap, out double rate);
            if (gap <= ContactSearch.Touching && rate >= -ContactSearch.Approaching && rate <= ContactSearch.Leaving)
            {
                guides.Add(guides.WithoutLike(world, i, in position, time));
            }
        }

        return guides;
    }

    /// <summary>The acceleration, less what would push the ball into the guides: a·n + (v − V)ᵀH(v − V) is not negative.</summary>
    public readonly Vector3d Free(World world, in Vector3d position, in Vector3d velocity, double time, in Vector3d acceleration)
    {
        Vector3d free = acceleration;
        for (int round = 0; round < Count; round++)
        {
            for (int i = 0; i < Count; i++)
            {
                Collider guide = world.Colliders[At(i)];
                ShapePoint at = guide.At(in position, time);
                Vector3d along = velocity - guide.Velocity;
                Vector3d normal = at.Normal;
                double into = Vector3d.Dot(in free, in normal) + Vector3d.Dot(in along, at.Curvature * along);
                free -= Math.Min(0, into) * normal;
            }
        }

        return free;
    }

    /// <summary>The same for a ball that a surface carries: what is taken away lies along that surface.</summary>
    /// <param name="world">The world.</param>
    /// <param name="position">Where the ball is, m.</param>
    /// <param name="velocity">Its velocity, m/s.</param>
    /// <param name="time">When, s.</param>
    /// <param name="acceleration">What pushes it along the surface, m/s².</param>
    /// <param name="surface">The normal of the surface.</param>
    /// <param name="centripetal">What keeps it on the surface, against that normal, m/s².</param>
    public readonly Vector3d FreeAlong(
        World world, in Vector3d position, in Vector3d velocity, double time, in Vector3d acceleration, in Vector3d surface, double centripetal)
    {
        Vector3d free = acceleration;
        for (int round = 0; round < Count; round++)
        {
            for (int i = 0; i < Count; i++)
            {
                Collider guide = world.Colliders[At(i)];
                ShapePoint at = guide.At(in position, time);
                Vector3d relative = velocity - guide.Velocity;
                Vector3d normal = at.Normal;
                double into = Vector3d.Dot(free - (centripetal * surface), in normal) + Vector3d.Dot(in relative, at.Curvature * relative);
                free -= Way(in normal, in surface, out Vector3d way) ? Math.Min(0, into) * way : Vector3d.Zero;
            }
        }

        return free;
    }

    /// <summary>
    /// Puts a ball that is still pressed against its guides onto them, and one that leaves them out of where the method's own error took it; then
    /// again onto its carrier, and so on, where one is off another.
    /// </summary>
    /// <param name="world">The world.</param>
    /// <param name="s">The ball.</param>
    /// <param name="pressed">Its acceleration, were there no guides, m/s².</param>
    /// <param name="free">Its acceleration, m/s².</param>
    /// <param name="carrier">What carries it; null where nothing does.</param>
    /// <param name="met">The collider that it meets there, which it touches as well; −1 where it meets none.</param>
    public readonly void Hold(World world, ref BallState s, in Vector3d pressed, in Vector3d free, Collider? carrier, int met)
    {
        bool moved = true;
        int touched = met;
        for (int round = 0; round < MostRounds && moved; round++)
        {
            Vector3d surface = carrier is null ? Vector3d.Zero : world.Hold(ref s, carrier);
            moved = false;
            for (int i = 0; i < Count; i++)
            {
                Collider guide = world.Colliders[At(i)];
                ShapePoint at = guide.At(s.Position, s.Time);
                double gap = at.Distance - world.Ball.Radius;
                bool presses = Vector3d.Dot(free - pressed, at.Normal) > 0;
                if (!presses && gap > ContactSearch.Touching)
                {
                    continue;
                }

                if (Way(at.Normal, in surface, out Vector3d way))
                {
                    double closing = Vector3d.Dot(s.Velocity - guide.Velocity, at.Normal);
                    s.Velocity -= (presses ? closing : Math.Min(0, closing)) * way;
                    gap = presses ? gap : Math.Min(0, gap);
                    s.Position -= gap * way;
                    moved |= Math.Abs(gap) > Closed;
                }
            }

            // Put onto its guides the ball may be in what it had all but touched.
            touched = touched < 0 && moved ? NearThings.Deepest(world, in s, out _) : touched;
            if (touched >= 0)
            {
                ShapePoint at = world.Colliders[touched].At(s.Position, s.Time);
                double gap = at.Distance - world.Ball.Radius;
                if (Math.Abs(gap) > Closed && Way(at.Normal, in surface, out Vector3d way))
                {
                    s.Position -= gap * way;
                    moved = true;
                }
            }
        }
    }

    /// <summary>The way along a surface on which a distance in a direction grows by one.</summary>
    /// <returns>False where there is none.</returns>
    private static bool Way(in Vector3d normal, in Vector3d surface, out Vector3d way)
    {
        Vector3d along = normal - (Vector3d.Dot(in normal, in surface) * surface);
        double share = along.LengthSquared;
        way = along / share;
        return share > 1e-12;
    }

    /// <summary>How far a place is off the guides, on either side, m.</summary>
    public readonly double Off(World world, in Vector3d position, double time)
    {
        double off = 0;
        for (int i = 0; i < Count; i++)
        {
            off = Math.Max(off, Math.Abs(world.Colliders[At(i)].At(in position, time).Distance - world.Ball.Radius));
        }

        return off;
    }

    /// <summary>Takes out a flat guide with which another flat one is in line.</summary>
    /// <returns>Which of the two comes first in the scene.</returns>
    private int WithoutLike(World world, int collider, in Vector3d position, double time)
    {
        ShapePoint at = world.Colliders[collider].At(in position, time);
        for (int i = 0; i < Count && at.IsFlat; i++)
        {
            int kept = At(i);
            ShapePoint other = world.Colliders[kept].At(in position, time);
            if (other.IsFlat && Vector3d.Dot(at.Normal, other.Normal) > 1.0 - InLine)
            {
                _first = i == 0 ? _second : _first;
                _second = i <= 1 ? _third : _second;
                Count--;
                return Math.Min(kept, collider);
            }
        }

        return collider;
    }

    /// <summary>Keeps the first three of the scene, in its order.</summary>
    private void Add(int collider)
    {
        if (Count > 0 && collider < _first)
        {
            (collider, _first) = (_first, collider);
        }

        if (Count > 1 && collider < _second)
        {
            (collider, _second) = (_second, collider);
        }

        _third = Count == 2 ? collider : Count > 2 ? Math.Min(_third, collider) : _third;
        _second = Count == 1 ? collider : _second;
        _first = Count == 0 ? collider : _first;
        Count = Math.Min(Count + 1, 3);
    }

    private readonly int At(int i) => i == 0 ? _first : i == 1 ? _second : _third;
}
