using FootballPhysics.Numerics;

namespace FootballPhysics.Contacts;

/// <summary>The broad phase: a tree of bounding boxes of stationary objects, built once.</summary>
/// <remarks>
/// It tests only boxes; the caller tests the objects inside. Nodes are in depth-first order; each stores the index of the node after its
/// branch,
/// so a walk needs no stack.
/// </remarks>
internal sealed class BoundsTree
{
    private const int NoItem = -1;

    private readonly Bounds3d[] _bounds;
    private readonly int[] _after;
    private readonly int[] _item;

    /// <summary>Builds a tree.</summary>
    /// <param name="boxes">The boxes.</param>
    public BoundsTree(Bounds3d[] boxes)
    {
        int count = boxes.Length == 0 ? 0 : (2 * boxes.Length) - 1;
        _bounds = new Bounds3d[count];
        _after = new int[count];
        _item = new int[count];
        int[] items = new int[boxes.Length];
        for (int i = 0; i < items.Length; i++)
        {
            items[i] = i;
        }

        if (count > 0)
        {
            Build(boxes, items, 0, items.Length, 0);
        }
    }

    /// <summary>Advances to the next box that intersects the given box.</summary>
    /// <param name="box">The given box.</param>
    /// <param name="node">Position of the walk; 0 at the start.</param>
    /// <param name="item">Index of the box found.</param>
    /// <returns>False at the end.</returns>
    public bool Next(in Bounds3d box, ref int node, out int item)
    {
        while (node < _bounds.Length)
        {
            int here = node;

            // A box that misses this node misses its entire branch.
            if (!_bounds[here].Intersects(in box))
            {
                node = _after[here];
                continue;
            }

            node++;
            item = _item[here];
            if (item != NoItem)
            {
                return true;
            }
        }

        item = NoItem;
        return false;
    }

    /// <summary>Returns the time at which a straight path reaches the first box, s; the given limit if it reaches none before.</summary>
    public double FirstMet(in StraightWay way, double until)
    {
        int node = 0;
        while (node < _bounds.Length)
        {
            double met = way.Meets(in _bounds[node]);

            // The path reaches this node, and thus its entire branch, too late or not at all.
            if (!(met < until))
            {
                node = _after[node];
                continue;
            }

            until = _item[node] != NoItem ? met : until;
            node++;
        }

        return until;
    }

    /// <summary>Builds the branch for a range of items, which it splits at the median along the axis with the widest spread of centres.</summary>
    /// <returns>The node after the branch.</returns>
    private int Build(Bounds3d[] boxes, int[] items, int from, int to, int node)
    {
        // The bounds of all items, and the bounds of their centres, which determine the split axis.
        Bounds3d all = boxes[items[from]];
        Bounds3d centers = boxes[items[from]].AtCenter;
        for (int i = from + 1; i < to; i++)
        {
            all = all.Union(in boxes[items[i]]);
            centers = centers.Union(boxes[items[i]].AtCenter);
        }

        _bounds[node] = all;
        _item[node] = to - from == 1 ? items[from] : NoItem;
        int next = node + 1;
        if (to - from > 1)
        {
            Vector3d spread = centers.Max - centers.Min;
            int axis = spread.X >= spread.Y && spread.X >= spread.Z ? 0 : spread.Y >= spread.Z ? 1 : 2;
            Array.Sort(items, from, to - from, Comparer<int>.Create((a, b) => Compare(boxes, axis, a, b)));
            int middle = (from + to) / 2;
            next = Build(boxes, items, from, middle, next);
            next = Build(boxes, items, middle, to, next);
        }

        _after[node] = next;
        return next;
    }

    private static int Compare(Bounds3d[] boxes, int axis, int a, int b)
    {
        Vector3d first = boxes[a].AtCenter.Min;
        Vector3d second = boxes[b].AtCenter.Min;
        int order = axis == 0 ? first.X.CompareTo(second.X) : axis == 1 ? first.Y.CompareTo(second.Y) : first.Z.CompareTo(second.Z);
        return order != 0 ? order : a.CompareTo(b);
    }
}

/// <summary>Enumerates the objects whose bounds intersect a box, in no defined order: unbounded objects, the tree, and movers.</summary>
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

    /// <summary>Starts an enumeration, with the engine colliders that the last cast found.</summary>
    /// <param name="world">The world.</param>
    /// <param name="box">The box.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="duration">The duration, s.</param>
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

    /// <summary>Enumerates the objects that may touch a ball at a position.</summary>
    public static NearThings At(World world, in Vector3d position, double time) => Within(world, in position, time, ContactTolerances.Touching);

    /// <summary>Enumerates the objects that may be within a distance of a ball at a position, m.</summary>
    public static NearThings Within(World world, in Vector3d position, double time, double distance)
    {
        world.Engine?.LookAt(in position, time, distance);
        return new NearThings(world, new Bounds3d(in position, in position).Expanded(world.Ball.Radius + (2.0 * distance)), time, 0);
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
        NearThings near = At(world, s.Position, s.Time);
        while (near.NextCollider(out int i))
        {
            if (i == carrier)
            {
                continue;
            }

            // Use the deepest overlap. Break ties by the normals, because the orders of the traversal and of the scene are arbitrary.
            ShapePoint at = world.Colliders[i].At(s.Position, s.Time);
            double overlap = world.Ball.Radius - at.Distance;
            overlapsBody |= overlap > ContactTolerances.Touching && world.Colliders[i].IsBody;
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

    /// <summary>Advances to the next collider.</summary>
    /// <param name="collider">Index of the collider.</param>
    /// <returns>False at the end.</returns>
    public bool NextCollider(out int collider)
    {
        while (Next(out collider))
        {
            if (!_world.IsPassage(collider))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Advances to the next net or goal.</summary>
    /// <param name="thing">Index of the net or goal.</param>
    /// <returns>False at the end.</returns>
    public bool NextPassage(out int thing)
    {
        // Nets and goals are stationary and bounded, so they are in the tree.
        while (_world.Tree.Next(in _box, ref _node, out int leaf))
        {
            thing = _world.Leaves[leaf];
            if (_world.IsPassage(thing))
            {
                return true;
            }
        }

        thing = -1;
        return false;
    }

    /// <summary>Advances to the next object.</summary>
    /// <param name="thing">Index of the object: colliders first, then nets, then goals.</param>
    /// <returns>False at the end.</returns>
    public bool Next(out int thing)
    {
        while (_unbounded < _world.Unbounded.Length)
        {
            thing = _world.Unbounded[_unbounded++];
            if (_world.Colliders[thing].Bounds.Intersects(in _box))
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

        // The box that the collider sweeps during this time.
        Bounds3d bounds = collider.BoundsDuring(_time, _duration);
        if (_duration > 0)
        {
            bounds = bounds.Union(bounds.Translated(_duration * collider.Velocity));
        }

        return bounds.Intersects(in _box);
    }
}
