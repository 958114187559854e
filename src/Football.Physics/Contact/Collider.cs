namespace Football.Physics;

/// <summary>A thing that can be hit, ready to be asked: the ground is one, and every obstacle, post and body.</summary>
internal sealed class Collider
{
    private readonly IShape _shape;
    private readonly Bounds3d _bounds;
    private readonly ContactMaterial _material;
    private readonly RigidMotion _motion;
    private readonly Body? _body;

    public Collider(string name, IShape shape, in ContactMaterial material)
    {
        Name = name;
        _shape = shape;
        _bounds = shape.Bounds;
        _material = material;
    }

    public Collider(Obstacle obstacle)
        : this(obstacle.Name, obstacle.Shape, new ContactMaterial(obstacle.Surface))
    {
        _motion.Velocity = obstacle.Velocity;
        _motion.Spin = obstacle.Spin;
        _motion.Pivot = obstacle.Pivot;
    }

    public Collider(Body body)
        : this(body.Name, body.Shape, new ContactMaterial(body.Surface)) => _body = body;

    /// <summary>Its name.</summary>
    public string Name { get; }

    /// <summary>What it is made of.</summary>
    public ref readonly ContactMaterial Material => ref _material;

    /// <summary>V, m/s.</summary>
    public Vector3d Velocity => Motion.Velocity;

    /// <summary>Whether the game moves it.</summary>
    public bool IsBody => _body is not null;

    /// <summary>Whether it may be elsewhere at another time.</summary>
    public bool Moves => _body is not null || _motion.Velocity != Vector3d.Zero;

    /// <summary>The strongest curvature of its hollows, 1/m; 0 where it is convex.</summary>
    public double HollowCurvature => _shape.HollowCurvature;

    /// <summary>A box around it in its own frame: for what the game does not move, where it was at time 0.</summary>
    public ref readonly Bounds3d Bounds => ref _bounds;

    private ref readonly RigidMotion Motion
    {
        get
        {
            if (_body is null)
            {
                return ref _motion;
            }

            return ref _body.Motion;
        }
    }

    /// <summary>Distance, normal and curvature, seen from a point at a time.</summary>
    public ShapePoint At(in Vector3d position, double time) => Motion.At(_shape, in position, time);

    /// <summary>The same for a point given in the thing's own frame.</summary>
    public ShapePoint At(in Vector3d position) => _shape.At(in position);

    /// <summary>A path as the thing sees it in its own frame.</summary>
    public PathCubic Seen(in PathCubic path, double time)
    {
        ref readonly RigidMotion motion = ref Motion;
        PathCubic seen = path.SeenFrom(motion.GoneBy(time), motion.Velocity);
        return motion.IsTurned ? seen.InAxes(in motion) : seen;
    }

    /// <summary>A box around it at a time.</summary>
    public Bounds3d BoundsAt(double time) => _body is null ? _bounds.Moved(_motion.GoneBy(time)) : _body.BoundsAt(time);

    /// <summary>The surface's velocity at a point of contact, V + Ω × (c − o), m/s.</summary>
    public Vector3d SurfaceVelocity(in Vector3d contact, double time) => Motion.SurfaceVelocity(in contact, time);
}
