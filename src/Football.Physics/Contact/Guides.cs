namespace Football.Physics;

/// <summary>
/// The colliders that guide a ball: it touches them without coming closer, and what would push it into them is taken away. Three of them leave a
/// point no freedom, so more need not be remembered.
/// </summary>
internal struct Guides
{
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

            Gap.OfContact(world, i).Evaluate(in position, in velocity, time, out double gap, out double rate);
            if (gap <= ContactSearch.Touching && Math.Abs(rate) <= ContactSearch.Approaching)
            {
                guides.Add(i);
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
    public readonly Vector3d FreeAlong(
        World world, in Vector3d position, in Vector3d velocity, double time, in Vector3d acceleration, in Vector3d surface)
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
                Vector3d along = normal - (Vector3d.Dot(in normal, in surface) * surface);
                double share = along.LengthSquared;
                double into = Vector3d.Dot(in free, in normal) + Vector3d.Dot(in relative, at.Curvature * relative);
                free -= share > 1e-12 ? Math.Min(0, into) / share * along : Vector3d.Zero;
            }
        }

        return free;
    }

    /// <summary>Puts a carried ball that its guides still press onto them, along the surface that carries it.</summary>
    public readonly void HoldAlong(World world, ref BallState s, in Vector3d surface)
    {
        for (int i = 0; i < Count; i++)
        {
            Collider guide = world.Colliders[At(i)];
            ShapePoint at = guide.At(s.Position, s.Time);
            Vector3d normal = at.Normal;
            Vector3d along = normal - (Vector3d.Dot(in normal, in surface) * surface);
            double share = along.LengthSquared;
            double gap = at.Distance - world.Ball.Radius;
            double closing = Vector3d.Dot(s.Velocity - guide.Velocity, in normal);
            if (share > 1e-12 && (gap < 0 || closing < 0))
            {
                s.Position -= Math.Min(0, gap) / share * along;
                s.Velocity -= Math.Min(0, closing) / share * along;
            }
        }
    }

    /// <summary>Puts a ball that is still pressed against its guides onto them, and one that leaves them out of where the method's own error took it.</summary>
    public readonly void Hold(World world, ref BallState s, in Vector3d pressed, in Vector3d free)
    {
        for (int i = 0; i < Count; i++)
        {
            Collider guide = world.Colliders[At(i)];
            ShapePoint at = guide.At(s.Position, s.Time);
            Vector3d normal = at.Normal;
            double closing = Vector3d.Dot(s.Velocity - guide.Velocity, in normal);
            if (Vector3d.Dot(free - pressed, in normal) > 0)
            {
                s.Position += (world.Ball.Radius - at.Distance) * normal;
                s.Velocity -= closing * normal;
            }
            else if (world.Ball.Radius - at.Distance > ContactSearch.Touching)
            {
                s.Position += (world.Ball.Radius - at.Distance) * normal;
                s.Velocity -= Math.Min(0, closing) * normal;
            }
        }
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
