namespace FootballPhysics.Contacts;

/// <summary>Enumerates the colliders whose bounds intersect a box, in no defined order: unbounded objects, the tree, and movers.</summary>
/// <remarks>It includes the engine colliders that the last cast found, and the ends of the nets that the ball is in.</remarks>
/// <param name="world">The world.</param>
/// <param name="box">The box.</param>
/// <param name="time">The time, s.</param>
/// <param name="duration">The duration, s.</param>
/// <param name="nets">The nets that the ball is in.</param>
/// <param name="sides">The ball's side of each.</param>
/// <param name="withPassages">Whether to include nets and goals.</param>
internal struct NearThings(World world, in Bounds3d box, double time, double duration, ulong nets = 0, ulong sides = 0, bool withPassages = false)
{
    private readonly World _world = world;
    private readonly BroadPhase _objects = world.BroadPhase;
    private readonly Bounds3d _box = box;
    private readonly double _time = time;
    private readonly double _duration = duration;
    private readonly ulong _nets = nets;
    private readonly ulong _sides = sides;
    private readonly bool _withPassages = withPassages;
    private int _net;
    private int _unbounded;
    private int _node;
    private int _moving;
    private int _engine;

    /// <summary>Enumerates the colliders that may be within a distance of a ball, m; by default, those that may touch it.</summary>
    public static NearThings At(World world, in BallState s, double distance = ContactTolerances.Touching) =>
        At(world, s.Position, s.Time, distance, s.Nets, s.NetSides);

    /// <summary>Enumerates the same colliders for a ball at a position, which is in the given nets.</summary>
    public static NearThings At(World world, in Vector3d position, double time, double distance = ContactTolerances.Touching, ulong nets = 0, ulong sides = 0)
    {
        world.Engine?.LookAt(in position, time, distance);
        return new NearThings(world, new Bounds3d(in position, in position).Expanded(world.Ball.Radius + (2.0 * distance)), time, 0, nets, sides);
    }

    /// <summary>True if the ball may touch a collider other than its carrier.</summary>
    public static bool TouchesOthers(World world, in BallState s)
    {
        long carrier = s.Motion == MotionState.Airborne ? -1 : s.Carrier - world.FirstCollider;
        NearThings near = At(world, in s);
        while (near.Next(out int i))
        {
            if (i != carrier)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Returns the collider with the deepest overlap, except the carrier; −1 if there is none.</summary>
    /// <param name="world">The world.</param>
    /// <param name="s">The ball.</param>
    /// <param name="overlapsBody">Whether the ball overlaps a body.</param>
    public static int Deepest(World world, in BallState s, out bool overlapsBody)
    {
        overlapsBody = false;
        double depth = ContactTolerances.Touching;
        int deepest = -1;
        Vector3d side = default;
        long carrier = s.Motion == MotionState.Airborne ? -1 : s.Carrier - world.FirstCollider;
        NearThings near = At(world, in s);
        while (near.Next(out int i))
        {
            if (i == carrier)
            {
                continue;
            }

            // Use the deepest overlap. Break ties by the normals, because the orders of the traversal and of the scene are arbitrary.
            ShapePoint at = world.ByIndex[i].At(s.Position, s.Time);
            double overlap = world.Ball.Radius - at.Distance;
            overlapsBody |= overlap > ContactTolerances.Touching && world.ByIndex[i].IsBody;
            if (overlap > depth || (overlap == depth && IsBefore(at.Normal, i, side, deepest)))
            {
                depth = overlap;
                deepest = i;
                side = at.Normal;
            }
        }

        return deepest;
    }

    /// <summary>True if the first of two contacts has priority: by normal, and for equal normals by scene order.</summary>
    /// <remarks>
    /// The lower normal comes first, then the smaller |x| and |z|. A mirrored scene thus has the same order, unless the two normals are
    /// mirror images.
    /// </remarks>
    public static bool IsBefore(in Vector3d normal, int collider, in Vector3d other, int otherCollider)
    {
        double x = Math.Abs(normal.X) - Math.Abs(other.X);
        double z = Math.Abs(normal.Z) - Math.Abs(other.Z);
        return normal.Y != other.Y ? normal.Y < other.Y
            : x != 0 ? x < 0
            : z != 0 ? z < 0
            : normal.X != other.X ? normal.X < other.X
            : normal.Z != other.Z ? normal.Z < other.Z
            : collider < otherCollider;
    }

    /// <summary>Advances to the next object.</summary>
    /// <param name="thing">Index of the object: colliders first, then nets, then goals.</param>
    /// <returns>False at the end.</returns>
    public bool Next(out int thing)
    {
        while (_unbounded < _objects.Unbounded.Length)
        {
            thing = _objects.Unbounded[_unbounded++];
            if (_world.ByIndex[thing].Bounds.Intersects(in _box))
            {
                return true;
            }
        }

        while (_nets >> _net != 0 && _net < _world.Nets.Length)
        {
            int net = _net++;
            thing = _world.EndOfNet(net, _sides);
            if ((_nets >> net & 1) != 0 && IsNearPlane(_world.ByIndex[thing].StandingPlane!))
            {
                return true;
            }
        }

        while (_objects.Tree.Next(in _box, ref _node, out int leaf))
        {
            thing = _objects.Leaves[leaf];
            if (_withPassages || thing < _world.FirstPassage)
            {
                return true;
            }
        }

        while (_moving < _objects.Moving.Length)
        {
            thing = _objects.Moving[_moving++];
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

    /// <summary>True if a corner of the box is on a plane or beyond it.</summary>
    private readonly bool IsNearPlane(PlaneShape plane)
    {
        Vector3d n = plane.Normal;
        Vector3d half = 0.5 * (_box.Max - _box.Min);
        return plane.DistanceTo(_box.Min + half) <= (half.X * Math.Abs(n.X)) + (half.Y * Math.Abs(n.Y)) + (half.Z * Math.Abs(n.Z));
    }

    private readonly bool Touches(int moving)
    {
        Collider collider = _world.ByIndex[moving];

        // The box that the collider sweeps during this time, axis by axis.
        Bounds3d bounds = collider.BoundsDuring(_time, _duration);
        Vector3d by = _duration > 0 ? _duration * collider.Velocity : Vector3d.Zero;
        return Meets(bounds.Min.X, bounds.Max.X, by.X, _box.Min.X, _box.Max.X) && Meets(bounds.Min.Y, bounds.Max.Y, by.Y, _box.Min.Y, _box.Max.Y)
            && Meets(bounds.Min.Z, bounds.Max.Z, by.Z, _box.Min.Z, _box.Max.Z);
    }

    private static bool Meets(double min, double max, double by, double otherMin, double otherMax) => Math.Min(min, min + by) <= otherMax && Math.Max(max, max + by) >= otherMin;
}
