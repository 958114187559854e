namespace FootballPhysics.Scenes;

/// <summary>The current motions of the obstacles with a finite mass, which impacts of the ball change.</summary>
internal sealed class ObstacleMotions
{
    private readonly IReadOnlyList<Obstacle> _obstacles;
    private readonly Placement?[] _placements;
    private readonly int[] _movable;
    private readonly RigidMotion[] _start;

    public ObstacleMotions(IReadOnlyList<Obstacle> obstacles)
    {
        _obstacles = obstacles;
        _placements = new Placement?[obstacles.Count];
        var movable = new List<int>();
        for (int i = 0; i < _placements.Length; i++)
        {
            // Impacts move only obstacles with a finite mass; all others keep the position that the scene defines.
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

        // Store the motions at time 0 for a later Reset.
        Read(_start);
    }

    /// <summary>The number of obstacles with a finite mass.</summary>
    public int Count => _movable.Length;

    /// <summary>A counter that changes whenever one of these obstacles is pushed or moved.</summary>
    public long Version { get; private set; }

    /// <summary>Returns the placement of an obstacle; null if its mass is infinite.</summary>
    public Placement? Of(int obstacle) => _placements[obstacle];

    /// <summary>Returns the name of the obstacle with the given movable index.</summary>
    public string NameOf(int movable) => _obstacles[_movable[movable]].Name;

    /// <summary>Changes the velocity of one obstacle in an impact.</summary>
    public void Push(Placement placement, in Vector3d velocity, double time)
    {
        // A new version invalidates cached searches.
        placement.Motion.GoOn(in velocity, time);
        Version++;
    }

    /// <summary>Copies all motions.</summary>
    public void Read(Span<RigidMotion> into)
    {
        for (int i = 0; i < _movable.Length; i++)
        {
            into[i] = _placements[_movable[i]]!.Motion;
        }
    }

    /// <summary>Returns a bounding box of the obstacle with the given movable index at a time.</summary>
    public Bounds3d BoundsAt(int movable, double time) => _placements[_movable[movable]]!.BoundsAt(time);

    /// <summary>Restores all motions.</summary>
    public void Write(Span<RigidMotion> from)
    {
        for (int i = 0; i < _movable.Length; i++)
        {
            _placements[_movable[i]]!.Motion = from[i];
        }

        Version++;
    }

    /// <summary>Copies the motions of those obstacles that another scene shares.</summary>
    public void Follow(ObstacleMotions other)
    {
        for (int i = 0; i < _movable.Length; i++)
        {
            // Both scenes contain the same instance, but possibly at different indices.
            int its = Array.FindIndex(other._movable, movable => ReferenceEquals(other._obstacles[movable], _obstacles[_movable[i]]));
            if (its >= 0)
            {
                _placements[_movable[i]]!.Motion = other._placements[other._movable[its]]!.Motion;
                Version++;
            }
        }
    }

    /// <summary>Restores the motions that the scene defines.</summary>
    public void Reset() => Write(_start);
}
