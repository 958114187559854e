namespace FootballPhysics.Labs.Scenes;

/// <summary>The part of the library that holds the shapes of a scene.</summary>
internal enum PieceKind
{
    Obstacles,
    Bodies,
    Colliders,
}

/// <summary>Shapes that share one rigid motion about the origin of their frame: as obstacles, as bodies that the game moves, or as colliders of an engine.</summary>
/// <param name="kind">The kind of the pieces.</param>
internal sealed class ScenePieces(PieceKind kind) : IEngineColliders
{
    private readonly List<(IShape Shape, SurfaceMaterial Surface)> _pieces = [];
    private readonly List<EngineCollider> _colliders = [];
    private readonly KinematicBodies _bodies = new();
    private double _reach;

    public PieceKind Kind { get; } = kind;

    /// <summary>The log of the last step.</summary>
    public StepLog Log { get; } = new();

    public double Time { get; private set; }

    public double MaximumSpeed { get; private set; }

    /// <summary>Adds a shape in the common frame.</summary>
    public void Add(IShape shape, SurfaceMaterial surface)
    {
        string name = FormattableString.Invariant($"piece {_pieces.Count}");
        _pieces.Add((shape, surface));
        Bounds3d box = shape.Bounds;
        _reach = Math.Max(_reach, Math.Max(box.Min.Length, box.Max.Length));
        if (Kind == PieceKind.Bodies)
        {
            _bodies.Add(name, shape, surface);
        }
        else if (Kind == PieceKind.Colliders)
        {
            _colliders.Add(new EngineCollider(name, shape, surface));
        }
    }

    /// <summary>Returns the scene with all shapes in it. Obstacles begin at the origin and keep this motion; their spin moves the surface only.</summary>
    public Scene In(Scene scene, Vector3d velocity = default, Vector3d spin = default) => Kind switch
    {
        PieceKind.Obstacles => scene with
        {
            Obstacles = [.. scene.Obstacles, .. _pieces.Select((piece, i) => new Obstacle
            {
                Name = FormattableString.Invariant($"piece {i}"), Shape = piece.Shape, Surface = piece.Surface, Velocity = velocity, Spin = spin,
            })],
        },
        PieceKind.Bodies => scene with { Bodies = _bodies },
        PieceKind.Colliders => scene with { EngineColliders = this },
        _ => throw new InvalidOperationException($"{Kind} is no kind of piece"),
    };

    /// <summary>Sets bodies and colliders for the next step; obstacles move by themselves.</summary>
    public void MoveTo(in Vector3d position, in Quaterniond orientation, in Vector3d velocity, in Vector3d spin, double time)
    {
        Time = time;
        MaximumSpeed = velocity.Length + (_reach * spin.Length);
        foreach (KinematicBody body in _bodies)
        {
            body.MoveTo(position, orientation, velocity, spin, time);
        }

        foreach (EngineCollider collider in _colliders)
        {
            collider.MoveTo(position, orientation, velocity, spin);
        }
    }

    /// <summary>Sets bodies and colliders, and steps a ball.</summary>
    public void Step(Simulator simulator, ref BallState ball, double duration, in Vector3d position, in Quaterniond orientation, in Vector3d velocity, in Vector3d spin)
    {
        MoveTo(position, orientation, velocity, spin, ball.Time);
        Log.Clear();
        simulator.Step(ref ball, duration, Log);
    }

    public void Cast(in SphereCast cast, EngineHits hits)
    {
        // Reporting more colliders than the sphere touches is harmless.
        foreach (EngineCollider collider in _colliders)
        {
            hits.Add(collider);
        }
    }
}
