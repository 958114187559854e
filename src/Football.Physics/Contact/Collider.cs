namespace Football.Physics;

/// <summary>A thing that can be hit, ready to be asked: the ground is one, and every obstacle and post.</summary>
internal sealed class Collider
{
    private readonly IShape _shape;
    private readonly Bounds3d _bounds;
    private readonly ContactMaterial _material;
    private readonly Vector3d _spin;
    private readonly Vector3d _pivot;

    public Collider(string name, IShape shape, in ContactMaterial material, in Vector3d velocity, in Vector3d spin, in Vector3d pivot)
    {
        Name = name;
        _shape = shape;
        _bounds = shape.Bounds;
        _material = material;
        Velocity = velocity;
        _spin = spin;
        _pivot = pivot;
    }

    public Collider(Obstacle obstacle)
        : this(obstacle.Name, obstacle.Shape, new ContactMaterial(obstacle.Surface), obstacle.Velocity, obstacle.Spin, obstacle.Pivot)
    {
    }

    /// <summary>Its name.</summary>
    public string Name { get; }

    /// <summary>What it is made of.</summary>
    public ref readonly ContactMaterial Material => ref _material;

    /// <summary>V, m/s.</summary>
    public Vector3d Velocity { get; }

    /// <summary>The strongest curvature of its hollows, 1/m; 0 where it is convex.</summary>
    public double HollowCurvature => _shape.HollowCurvature;

    /// <summary>A box around it where it was at time 0.</summary>
    public ref readonly Bounds3d Bounds => ref _bounds;

    /// <summary>Distance, normal and curvature, seen from a point at a time.</summary>
    public ShapePoint At(in Vector3d position, double time) => _shape.At(position - (time * Velocity));

    /// <summary>The same for a point given in the thing's own frame, in which it stands where it was at time 0.</summary>
    public ShapePoint At(in Vector3d position) => _shape.At(in position);

    /// <summary>The surface's velocity at a point of contact, V + Ω × (c − o), m/s.</summary>
    public Vector3d SurfaceVelocity(in Vector3d contact, double time) =>
        Velocity + Vector3d.Cross(in _spin, contact - _pivot - (time * Velocity));
}
