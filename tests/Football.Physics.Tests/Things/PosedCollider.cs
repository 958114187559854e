namespace FootballPhysics.Tests.Things;

/// <summary>An object that a game sets before each step: where it is, how it is turned, and how fast it moves and turns. Here as a body, there as a collider of an engine.</summary>
internal sealed class PosedCollider : IEngineColliders
{
    private readonly KinematicBody? _body;
    private readonly EngineCollider? _collider;
    private readonly double _reach;

    private PosedCollider(IShape shape, SurfaceMaterial surface, bool isEngine)
    {
        Bounds3d box = shape.Bounds;
        _reach = Math.Max(box.Min.Length, box.Max.Length);
        if (isEngine)
        {
            _collider = new EngineCollider("object", shape, surface);
        }
        else
        {
            Bodies = new KinematicBodies();
            _body = Bodies.Add("object", shape, surface);
        }
    }

    public double Time { get; private set; }

    public double MaximumSpeed { get; private set; }

    private KinematicBodies? Bodies { get; }

    /// <summary>Makes the object and a scene that has it.</summary>
    public static PosedCollider In(ref Scene scene, IShape shape, SurfaceMaterial surface, bool isEngine)
    {
        var posed = new PosedCollider(shape, surface, isEngine);
        scene = isEngine ? scene with { EngineColliders = posed } : scene with { Bodies = posed.Bodies };
        return posed;
    }

    /// <summary>Sets the object for the step to come.</summary>
    public void MoveTo(in Vector3d position, in Quaterniond orientation, in Vector3d velocity, in Vector3d spin, double time)
    {
        Time = time;
        MaximumSpeed = velocity.Length + (_reach * spin.Length);
        _body?.MoveTo(position, orientation, velocity, spin, time);
        _collider?.MoveTo(position, orientation, velocity, spin);
    }

    public void Cast(in SphereCast cast, EngineHits hits) => hits.Add(_collider!);
}
