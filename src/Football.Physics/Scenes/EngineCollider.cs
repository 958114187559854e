namespace FootballPhysics.Engines;

/// <summary>
/// A collider of a game engine, as the ball sees it: of a known shape, which moves; or, where it has none here (a mesh, a terrain), as the plane or sphere
/// that is like it where it was hit.
/// </summary>
public sealed class EngineCollider
{
    /// <summary>Numbers of engines' colliders begin here, beyond the indices of all things that a scene has itself.</summary>
    internal const int FirstNumber = 1 << 30;

    private readonly bool _hasShape;
    private readonly double _mass = double.PositiveInfinity;
    private int _layer;
    private Vector3d _pushed;
    private Vector3d _gone;
    private double _pushedAt = double.NaN;
    private bool _isAsPlaced = true;

    /// <summary>A collider of a known shape.</summary>
    /// <param name="name">Its name, for events.</param>
    /// <param name="shape">Its shape, in its own frame.</param>
    /// <param name="surface">What it is made of; default <see cref="SurfaceMaterial.GoalFrame"/>.</param>
    /// <exception cref="ArgumentNullException">Name or shape is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number of the surface is out of range.</exception>
    public EngineCollider(string name, IShape shape, SurfaceMaterial? surface = null)
        : this(name, surface)
    {
        Check.Given(nameof(shape), shape);
        _hasShape = true;
        Shape = shape;
        Placement.Reshape(shape.Bounds);
    }

    /// <summary>A collider of which is known where it was hit, and no more.</summary>
    /// <param name="name">Its name, for events.</param>
    /// <param name="surface">What it is made of; default <see cref="SurfaceMaterial.GoalFrame"/>.</param>
    /// <exception cref="ArgumentNullException"><paramref name="name"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number of the surface is out of range.</exception>
    public EngineCollider(string name, SurfaceMaterial? surface = null)
    {
        Check.Given(nameof(name), name);
        Name = name;
        Number = NumberOf(name);
        Surface = surface ?? SurfaceMaterial.GoalFrame;
        Surface.Validate(nameof(surface));
        Shape = new TangentShape();
        Placement = new Placement(Shape.Bounds);
    }

    /// <summary>Its name.</summary>
    public string Name { get; }

    /// <summary>
    /// What states and events call it by: a hash of its name, so that it does not depend on what was found before, and is the same on every machine. Those of one name
    /// have one number; which of them is meant the place tells.
    /// </summary>
    internal int Number { get; }

    /// <summary>The material of its surface.</summary>
    public SurfaceMaterial Surface { get; }

    /// <summary>
    /// Mass behind its surface, kg; above 0. Infinite, the default, where the ball does not move it. Else an impact changes its velocity by the impulse
    /// (<see cref="BallEvent.Impulse"/>) until the engine's time goes on: then it is where, and as fast as, the engine says, who applies the impulse to its body.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The mass is not above 0.</exception>
    public double Mass
    {
        get => _mass;
        init
        {
            Check.Within("engineCollider.mass", value, 0, double.PositiveInfinity, exclusiveLow: true);
            _mass = value;
        }
    }

    /// <summary>Its layer: a ball that ignores it passes through. 0 … 31; default 0. A change counts from the next step on.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The layer is out of range.</exception>
    public int Layer
    {
        get => _layer;
        set
        {
            Layers.Validate("engineCollider.layer", value);
            _layer = value;
        }
    }

    internal IShape Shape { get; }

    internal Placement Placement { get; }

    /// <summary>Says where a collider of a known shape is at <see cref="IEngineColliders.Time"/>, and how it moves.</summary>
    /// <param name="position">Where its shape's origin is, m; components within ±1e6.</param>
    /// <param name="orientation">How it is turned, body to world; normalised.</param>
    /// <param name="velocity">Velocity, m/s; at most 1000.</param>
    /// <param name="spin">Spin about its position, rad/s; at most 10 000. Within a step, the shape rotates with this spin.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">It has no known shape.</exception>
    public void MoveTo(Vector3d position, Quaterniond orientation, Vector3d velocity, Vector3d spin)
    {
        RequireShape(true);
        Check.Place("position", position);
        Check.Rotation("orientation", orientation);
        Check.Size("velocity", velocity, Limits.Speed, "m/s");
        Check.Size("spin", spin, Limits.Spin, "rad/s");

        // Only a new orientation costs a new box.
        if (orientation != Placement.Motion.Orientation)
        {
            Placement.Turn(orientation.Normalized());
        }

        Placement.Motion.Origin = position;
        Placement.Motion.Pivot = position;
        Placement.Motion.Velocity = velocity;
        Placement.Motion.Spin = spin;
        Placement.Motion.Rotate(Shape);
        _isAsPlaced = true;
    }

    /// <summary>Says what a collider without a known shape is like where the ball would touch it.</summary>
    /// <param name="point">A point of its surface at <see cref="IEngineColliders.Time"/>, m; components within ±1e6.</param>
    /// <param name="normal">Its outward normal there; any length but 0.</param>
    /// <param name="velocity">Velocity of its surface there, m/s; at most 1000.</param>
    /// <param name="curvature">How round it is there, 1/m: 0 for a plane, 1/R for a ball of radius R.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">It has a shape.</exception>
    public void TouchAt(Vector3d point, Vector3d normal, Vector3d velocity, double curvature = 0)
    {
        RequireShape(false);
        Check.Place("point", point);
        Vector3d unit = Check.Direction("normal", normal);
        Check.Size("velocity", velocity, Limits.Speed, "m/s");
        Check.Within("curvature", curvature, 0, Limits.Length);
        ((TangentShape)Shape).Set(in unit, curvature);

        // The tangent shape is at the origin of its own frame: the point of contact.
        Placement.Motion.Origin = point;
        Placement.Motion.Pivot = point;
        Placement.Motion.Velocity = velocity;
        _isAsPlaced = true;
    }

    /// <summary>An impact changes its velocity.</summary>
    internal void Push(in Vector3d velocity, double time)
    {
        // Told of the engine's own time, at which it is placed anew whenever it is found again: as if it had always gone so.
        ref RigidMotion motion = ref Placement.Motion;
        bool isFirst = _pushedAt != motion.Time;
        Vector3d change = velocity - motion.Velocity;
        Vector3d back = (motion.Time - time) * change;
        _pushed = isFirst ? change : _pushed + change;
        _gone = isFirst ? back : _gone + back;
        _pushedAt = motion.Time;
        motion.Origin += back;
        motion.Pivot += back;
        motion.Velocity = velocity;
    }

    /// <summary>The engine's time at which it was pushed; NaN where it was not.</summary>
    internal double PushedAt => _pushedAt;

    /// <summary>How it is, and what has pushed it.</summary>
    internal EnginePush PushSoFar
    {
        get => new() { Motion = Placement.Motion, Pushed = _pushed, Gone = _gone, At = _pushedAt, IsAsPlaced = _isAsPlaced };
        set
        {
            Placement.Motion = value.Motion;
            _pushed = value.Pushed;
            _gone = value.Gone;
            _pushedAt = value.At;
            _isAsPlaced = value.IsAsPlaced;
        }
    }

    /// <summary>Forgets its last push.</summary>
    internal void ForgetPush()
    {
        // Taken back, unless the engine has placed it anew since: then the push is no part of where it is.
        if (_pushedAt == Placement.Motion.Time && !_isAsPlaced)
        {
            Placement.Motion.Origin -= _gone;
            Placement.Motion.Pivot -= _gone;
            Placement.Motion.Velocity -= _pushed;
        }

        _pushedAt = double.NaN;
    }

    /// <summary>It was found at the engine's time: what pushed it since that was reached counts again.</summary>
    internal void FoundAt(double time)
    {
        ref RigidMotion motion = ref Placement.Motion;
        motion.Time = time;

        // Placed anew at the same time of the engine, which knows nothing of the push yet.
        if (_isAsPlaced && _pushedAt == time)
        {
            motion.Origin += _gone;
            motion.Pivot += _gone;
            motion.Velocity += _pushed;
        }

        _isAsPlaced = false;
    }

    private static int NumberOf(string name)
    {
        // FNV-1a, folded to the bits below the first number.
        uint hash = 2166136261;
        foreach (char character in name)
        {
            hash = (hash ^ character) * 16777619;
        }

        return FirstNumber | (int)((hash ^ (hash >> 30)) & (FirstNumber - 1));
    }

    private void RequireShape(bool required)
    {
        if (required != _hasShape)
        {
            throw new InvalidOperationException(_hasShape
                ? $"The engine collider \"{Name}\" has a shape. Position it with MoveTo."
                : $"The engine collider \"{Name}\" has no shape. Report its contacts with TouchAt.");
        }
    }
}
