namespace Football.Physics;

/// <summary>A walk over the things of a world that a box touches, in no order: what has no bounds, the tree of what stands still, what moves.</summary>
internal struct NearThings
{
    private readonly World _world;
    private readonly Bounds3d _box;
    private readonly double _time;
    private readonly double _duration;
    private int _unbounded;
    private int _node;
    private int _moving;
    private int _engine;

    /// <summary>A walk. What an engine finds is that of its last cast.</summary>
    /// <param name="world">The world.</param>
    /// <param name="box">The box.</param>
    /// <param name="time">When, s.</param>
    /// <param name="duration">How long, s.</param>
    public NearThings(World world, in Bounds3d box, double time, double duration)
    {
        _world = world;
        _box = box;
        _time = time;
        _duration = duration;
        _unbounded = 0;
        _node = 0;
        _moving = 0;
        _engine = 0;
    }

    /// <summary>Things that touch a ball, or nearly, at a place.</summary>
    public static NearThings At(World world, in Vector3d position, double time) => Within(world, in position, time, ContactSearch.Touching);

    /// <summary>Things that may be closer to a ball at a place than a distance, m.</summary>
    public static NearThings Within(World world, in Vector3d position, double time, double distance)
    {
        world.Engine?.LookAt(in position, time, distance);
        return new NearThings(world, new Bounds3d(in position, in position).Grown(world.Ball.Radius + (2.0 * distance)), time, 0);
    }

    /// <summary>The collider that a ball overlaps most, but for what carries it; −1 where it overlaps nothing.</summary>
    /// <param name="world">The world.</param>
    /// <param name="s">The ball.</param>
    /// <param name="overlapsBody">Whether it overlaps any body.</param>
    public static int Deepest(World world, in BallState s, out bool overlapsBody)
    {
        overlapsBody = false;
        double depth = ContactSearch.Touching;
        int deepest = -1;
        long carrier = s.Motion == MotionState.Airborne ? -1 : s.Carrier - world.FirstCollider;
        NearThings near = At(world, s.Position, s.Time);
        while (near.NextCollider(out int i))
        {
            // The deepest; of two as deep the first of the scene, for the walk has no order.
            double overlap = world.Ball.Radius - world.Colliders[i].At(s.Position, s.Time).Distance;
            overlapsBody |= i != carrier && overlap > ContactSearch.Touching && world.Colliders[i].IsBody;
            if (i != carrier && (overlap > depth || (overlap == depth && i < deepest)))
            {
                depth = overlap;
                deepest = i;
            }
        }

        return deepest;
    }

    /// <summary>Goes on to the next collider.</summary>
    /// <param name="collider">Its index.</param>
    /// <returns>False at the end.</returns>
    public bool NextCollider(out int collider)
    {
        while (Next(out collider))
        {
            if (collider < _world.Colliders.Length)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Goes on to the next net or goal.</summary>
    /// <param name="thing">Its number.</param>
    /// <returns>False at the end.</returns>
    public bool NextPassage(out int thing)
    {
        // They stand still, and have bounds.
        while (_world.Tree.Next(in _box, ref _node, out int leaf))
        {
            thing = _world.Leaves[leaf];
            if (thing >= _world.Colliders.Length)
            {
                return true;
            }
        }

        thing = -1;
        return false;
    }

    /// <summary>Goes on to the next thing: colliders are numbered first, then nets, then goals.</summary>
    /// <param name="thing">Its number.</param>
    /// <returns>False at the end.</returns>
    public bool Next(out int thing)
    {
        while (_unbounded < _world.Unbounded.Length)
        {
            thing = _world.Unbounded[_unbounded++];
            if (_world.Colliders[thing].Bounds.Touches(in _box))
            {
                return true;
            }
        }

        if (_world.Tree.Next(in _box, ref _node, out int leaf))
        {
            thing = _world.Leaves[leaf];
            return true;
        }

        while (_moving < _world.Moving.Length)
        {
            thing = _world.Moving[_moving++];
            if (Touches(thing))
            {
                return true;
            }
        }

        while (_world.Engine is { } engine && _engine < engine.Count)
        {
            thing = engine.Found(_engine++);
            if (Touches(thing))
            {
                return true;
            }
        }

        thing = -1;
        return false;
    }

    private readonly bool Touches(int moving)
    {
        Collider collider = _world.Colliders[moving];

        // The box that it sweeps in the time.
        Bounds3d bounds = collider.BoundsAt(_time);
        if (_duration > 0)
        {
            bounds = bounds.With(bounds.Moved(_duration * collider.Velocity));
        }

        return bounds.Touches(in _box);
    }
}
