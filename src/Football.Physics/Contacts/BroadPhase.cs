using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Contacts;

/// <summary>The objects of a world by their bounds: moving objects, objects without bounds, and a tree of the others.</summary>
/// <remarks>Searches never find a collider that the ball ignores.</remarks>
internal sealed class BroadPhase
{
    private readonly World _world;

    /// <summary>Bounding spheres of the moving obstacles, which come first in <see cref="Moving"/>; bodies come last.</summary>
    private readonly MovingSpheres _movers = new();
    private readonly MovingLane[] _lanes;
    private long _known = -1;

    public BroadPhase(World world)
    {
        _world = world;
        var moving = new List<int>();
        var unbounded = new List<int>();
        var leaves = new List<int>();
        var lanes = new List<MovingLane>();
        for (int i = 0; i < world.Colliders.Length; i++)
        {
            Collider collider = world.ByIndex[i];
            if (world.Ignores(collider))
            {
                continue;
            }

            if (!collider.Moves)
            {
                (collider.Bounds.IsFinite ? leaves : unbounded).Add(i);
            }
            else if (world.Engine is null || !world.Engine.Has(i))
            {
                moving.Add(i);
                if (!collider.IsBody)
                {
                    lanes.Add(_movers.Add());
                }
            }
        }

        // Nets and goals are stationary, so they are also in the tree.
        for (int i = 0; i < world.Nets.Length + world.Goals.Length; i++)
        {
            leaves.Add(world.FirstPassage + i);
        }

        Moving = moving.ToArray();
        _lanes = lanes.ToArray();
        Unbounded = unbounded.ToArray();
        Leaves = leaves.ToArray();
        var boxes = new Bounds3d[Leaves.Length];
        for (int i = 0; i < boxes.Length; i++)
        {
            boxes[i] = BoundsOf(Leaves[i]);
        }

        Tree = new BoundsTree(boxes);
    }

    /// <summary>The colliders that move.</summary>
    public int[] Moving { get; }

    /// <summary>The stationary colliders without bounds.</summary>
    public int[] Unbounded { get; }

    /// <summary>Bounding boxes of all other stationary objects.</summary>
    public BoundsTree Tree { get; }

    /// <summary>Objects in the boxes of the tree, by index: colliders, then nets, then goals.</summary>
    public int[] Leaves { get; }

    /// <summary>Returns the time for which a straight path is clear of all objects except level ground and bodies, s; at most its duration.</summary>
    public double FreeFor(in StraightWay way)
    {
        // Most paths reach no box at all, so test this first.
        Bounds3d box = way.Box;
        int node = 0;
        double free = Tree.Next(in box, ref node, out _) ? Tree.FirstMet(in way, way.Duration) : way.Duration;

        // For shapes without a bounding box, compare their distance from the midpoint of the path.
        Vector3d middle = way.Middle;
        double half = 0.5 * way.Duration;
        double reach = (half * way.Velocity.Length) + way.Around;
        for (int i = 0; i < Unbounded.Length; i++)
        {
            Collider collider = _world.ByIndex[Unbounded[i]];
            if (!collider.IsLevelGround && !(collider.At(in middle).Distance > reach))
            {
                // If this distance is too small, use the distance from the start: the ball must cover it before it can reach the shape.
                double distance = collider.At(way.From).Distance - way.Around;
                free = Math.Min(free, Math.Max(0, distance / way.Velocity.Length));
            }
        }

        if (Moving.Length == 0)
        {
            return free;
        }

        KnowObstacles();
        for (int i = 0; _movers.Next(in middle, reach, way.Time + half, half, ref i); i++)
        {
            Collider collider = _world.ByIndex[Moving[i]];
            free = Math.Min(free, way.SeenFrom(collider.Velocity).Meets(collider.BoundsAt(way.Time)));
        }

        return free;
    }

    /// <summary>Prepares the fast query for pushed obstacles.</summary>
    private void KnowObstacles()
    {
        if (_known == _world.Obstacles.Version)
        {
            return;
        }

        _known = _world.Obstacles.Version;
        for (int i = 0; i < _lanes.Length; i++)
        {
            // A box at time 0, relative to the world's origin.
            Collider collider = _world.ByIndex[Moving[i]];
            _lanes[i].Move(Vector3d.Zero, collider.Velocity, 0);
            _lanes[i].Bound(collider.BoundsAt(0));
        }
    }

    /// <summary>Hashes all objects that are stationary or move on their own.</summary>
    public void AddTo(ref ClearKey key)
    {
        key.Add(_world.Ball.Radius);
        for (int i = 0; i < Leaves.Length; i++)
        {
            key.Add(BoundsOf(Leaves[i]));
        }

        foreach (Collider collider in _world.Colliders.Where(collider => !collider.IsBody && !_world.Ignores(collider)))
        {
            // Hash an unbounded shape by sampling it at two points.
            ShapePoint low = collider.At(Vector3d.Zero);
            ShapePoint high = collider.At(new Vector3d(11, 7, 5));
            key.Add(low.Distance);
            key.Add(low.Normal);
            key.Add(high.Distance);
            key.Add(high.Normal);
            key.Add(in collider.Bounds);
            key.Add(collider.Given.Velocity);
        }
    }

    private Bounds3d BoundsOf(int thing) =>
        thing < _world.FirstPassage ? _world.ByIndex[thing].Bounds
        : thing < _world.FirstPassage + _world.Nets.Length ? _world.Nets[thing - _world.FirstPassage].Bounds
        : _world.Goals[thing - _world.FirstPassage - _world.Nets.Length].Bounds;
}
