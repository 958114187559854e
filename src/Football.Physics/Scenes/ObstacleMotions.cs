namespace FootballPhysics;

/// <summary>Where the obstacles of a scene that have a mass have got to: what an impact pushes does not stay where the scene has it.</summary>
internal sealed class ObstacleMotions
{
    private readonly IReadOnlyList<Obstacle> _obstacles;
    private readonly Placement?[] _placements;
    private readonly int[] _movable;
    private readonly RigidMotion[] _start;
    private readonly RigidMotion[] _kept;

    public ObstacleMotions(IReadOnlyList<Obstacle> obstacles)
    {
        _obstacles = obstacles;
        _placements = new Placement?[obstacles.Count];
        var movable = new List<int>();
        for (int i = 0; i < _placements.Length; i++)
        {
            // Only what has a mass is placed anew by impacts; all else stays where the scene has it.
            Obstacle obstacle = obstacles[i];
            if (obstacle.Mass < double.PositiveInfinity)
            {
                var placement = new Placement(obstacle.Shape.Bounds);
                placement.Motion.Velocity = obstacle.Velocity;
                placement.Motion.Spin = obstacle.Spin;
                placement.Motion.Pivot = obstacle.Pivot;
                _placements[i] = placement;
                movable.Add(i);
            }
        }

        _movable = movable.ToArray();
        _start = new RigidMotion[_movable.Length];
        _kept = new RigidMotion[_movable.Length];

        // Where they are at time 0, to go back to.
        Read(_start);
    }

    /// <summary>How many have a mass.</summary>
    public int Count => _movable.Length;

    /// <summary>Changes whenever one of them is pushed, or put elsewhere.</summary>
    public long Version { get; private set; }

    /// <summary>The place of an obstacle; null where nothing moves that.</summary>
    public Placement? Of(int obstacle) => _placements[obstacle];

    /// <summary>An impact changes the velocity of one.</summary>
    public void Push(Placement placement, in Vector3d velocity, double time)
    {
        // By the version who has looked among them sees that they are no longer there.
        placement.Motion.GoOn(in velocity, time);
        Version++;
    }

    /// <summary>Reads where all are.</summary>
    public void Read(Span<RigidMotion> into)
    {
        for (int i = 0; i < _movable.Length; i++)
        {
            into[i] = _placements[_movable[i]]!.Motion;
        }
    }

    /// <summary>A box around one of those that have a mass, at a time.</summary>
    public Bounds3d BoundsAt(int movable, double time) => _placements[_movable[movable]]!.BoundsAt(time);

    /// <summary>Puts all where they were.</summary>
    public void Write(Span<RigidMotion> from)
    {
        for (int i = 0; i < _movable.Length; i++)
        {
            _placements[_movable[i]]!.Motion = from[i];
        }

        Version++;
    }

    /// <summary>What another scene has of the same obstacles is where it has got to there.</summary>
    public void Follow(ObstacleMotions other)
    {
        for (int i = 0; i < _movable.Length; i++)
        {
            // In both scenes an obstacle is the same one, wherever in the list: a wall may stand before it.
            int its = Array.FindIndex(other._movable, movable => ReferenceEquals(other._obstacles[movable], _obstacles[_movable[i]]));
            if (its >= 0)
            {
                _placements[_movable[i]]!.Motion = other._placements[other._movable[its]]!.Motion;
                Version++;
            }
        }
    }

    /// <summary>Remembers where all are.</summary>
    public void Keep() => Read(_kept);

    /// <summary>Puts all back to where they were when that was remembered.</summary>
    public void PutBack()
    {
        if (Count > 0)
        {
            Write(_kept);
        }
    }

    /// <summary>Puts all back to where the scene has them.</summary>
    public void Reset() => Write(_start);
}
