using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Engines;

/// <summary>A collider of a game engine, with a known shape or with only its surface at the contact.</summary>
/// <remarks>A mesh or terrain has no shape in the library, so a plane or sphere approximates its surface near the contact.</remarks>
public sealed class EngineCollider
{
    /// <summary>The first number of an engine collider, above all indices of the scene's own objects.</summary>
    internal const int FirstNumber = 1 << 30;

    private readonly bool _hasShape;
    private readonly double _mass = double.PositiveInfinity;
    private int _layer;
    private double _hollow;
    private double _hollowRadius = double.NaN;
    private EnginePush _push = new() { At = double.NaN, IsAsPlaced = true };

    /// <summary>Creates a collider of a known shape; place it with <see cref="MoveTo"/>.</summary>
    /// <param name="name">The name used in events.</param>
    /// <param name="shape">The shape, in the collider's frame.</param>
    /// <param name="surface">The material; default <see cref="SurfaceMaterial.GoalFrame"/>.</param>
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

    /// <summary>Creates a collider without a shape; describe each contact with <see cref="TouchAt"/>.</summary>
    /// <param name="name">The name used in events.</param>
    /// <param name="surface">The material; default <see cref="SurfaceMaterial.GoalFrame"/>.</param>
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

    /// <summary>The name used in events.</summary>
    public string Name { get; }

    /// <summary>The number in states and events: a hash of the name.</summary>
    /// <remarks>It is the same on every machine and independent of earlier hits. Colliders with equal names share a number; the position distinguishes them.</remarks>
    internal int Number { get; }

    /// <summary>The material of its surface.</summary>
    public SurfaceMaterial Surface { get; }

    /// <summary>The effective mass at the surface, in kg; above 0. Default infinite: the ball does not move the collider.</summary>
    /// <remarks>
    /// With a finite mass, an impact changes the velocity by the impulse divided by the mass, until <see cref="IEngineColliders.Time"/> advances. From then on
    /// the engine's own position and velocity are used, so apply the opposite of <see cref="Impact.Impulse"/> to the engine's body.
    /// </remarks>
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

    /// <summary>The layer; a ball that ignores this layer passes through. 0 … 31; default 0.</summary>
    /// <remarks>A change takes effect with the next step.</remarks>
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

    /// <summary>Returns the largest concave curvature of the shape for a ball, 1/m.</summary>
    /// <param name="radius">The radius of the ball, m.</param>
    internal double Hollow(double radius)
    {
        if (_hollowRadius != radius)
        {
            _hollow = HollowSamples.Corrected(Shape, radius);
            _hollowRadius = radius;
        }

        return _hollow;
    }

    /// <summary>Sets the position and motion of a collider of a known shape at <see cref="IEngineColliders.Time"/>.</summary>
    /// <param name="position">The position of the shape's origin, in m; components within ±1e6.</param>
    /// <param name="orientation">The orientation, body to world; it is normalized.</param>
    /// <param name="velocity">The velocity, in m/s; at most 1000.</param>
    /// <param name="spin">The spin about the position, in rad/s; at most 10 000. The shape rotates with it within a step.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">The collider has no known shape.</exception>
    public void MoveTo(Vector3d position, Quaterniond orientation, Vector3d velocity, Vector3d spin)
    {
        RequireShape(true);
        Check.Place("position", position);
        Check.Rotation("orientation", orientation);
        Check.Size("velocity", velocity, Limits.Speed, "m/s");
        Check.Size("spin", spin, Limits.Spin, "rad/s");

        // Recompute the bounding box only for a new orientation.
        if (!Placement.Has(in orientation))
        {
            Placement.Turn(orientation.Unit());
        }

        Placement.Motion.Origin = position;
        Placement.Motion.Pivot = position;
        Placement.Motion.Velocity = velocity;
        Placement.Motion.Spin = spin;
        Placement.Motion.Rotate(Shape);
        _push.IsAsPlaced = true;
    }

    /// <summary>Sets the surface of a collider without a known shape, at the expected point of contact.</summary>
    /// <param name="point">A point on the surface at <see cref="IEngineColliders.Time"/>, in m; components within ±1e6.</param>
    /// <param name="normal">The outward normal at the point; any length except 0.</param>
    /// <param name="velocity">The velocity of the surface at the point, in m/s; at most 1000.</param>
    /// <param name="curvature">The curvature at the point, in 1/m: 0 for a plane, 1/R for a sphere of radius R.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">The collider has a known shape.</exception>
    public void TouchAt(Vector3d point, Vector3d normal, Vector3d velocity, double curvature = 0)
    {
        RequireShape(false);
        Check.Place("point", point);
        Vector3d unit = Check.Direction("normal", normal);
        Check.Size("velocity", velocity, Limits.Speed, "m/s");
        Check.Within("curvature", curvature, 0, Limits.Length);
        ((TangentShape)Shape).Set(in unit, curvature);

        // The origin of the tangent shape's frame is the point of contact.
        Placement.Motion.Origin = point;
        Placement.Motion.Pivot = point;
        Placement.Motion.Velocity = velocity;
        _push.IsAsPlaced = true;
    }

    /// <summary>Changes the velocity in an impact.</summary>
    internal void Push(in Vector3d velocity, double time)
    {
        // The engine reports positions at its own time: move the position back as if the new velocity had applied since then.
        ref RigidMotion motion = ref Placement.Motion;
        bool isFirst = _push.At != motion.Time;
        _push.Placed = isFirst ? motion : _push.Placed;
        Vector3d change = velocity - motion.Velocity;
        Vector3d back = (motion.Time - time) * change;
        _push.Pushed = isFirst ? change : _push.Pushed + change;
        _push.Gone = isFirst ? back : _push.Gone + back;
        _push.At = motion.Time;
        motion.Origin += back;
        motion.Pivot += back;
        motion.Velocity = velocity;
    }

    /// <summary>The engine's time of the last push; NaN if there was none.</summary>
    internal double PushedAt => _push.At;

    /// <summary>The motion, and the pushes received so far.</summary>
    internal EnginePush PushSoFar
    {
        get => _push with { Motion = Placement.Motion };
        set
        {
            // The engine may have turned the collider since, so its box is another one.
            bool isTurned = !Placement.Has(value.Motion.Orientation);
            Placement.Motion = value.Motion;
            _push = value;
            if (isTurned)
            {
                Placement.Turn(value.Motion.Orientation);
            }
        }
    }

    /// <summary>Removes the effect of the last push.</summary>
    internal void ForgetPush()
    {
        // Undo the push, unless the engine has placed the collider since: the new position excludes the push.
        if (_push.At == Placement.Motion.Time && !_push.IsAsPlaced)
        {
            Placement.Motion = _push.Placed;
        }

        _push.At = double.NaN;
    }

    /// <summary>Sets the engine's time of the current position, and reapplies pushes received since that time.</summary>
    internal void FoundAt(double time)
    {
        ref RigidMotion motion = ref Placement.Motion;
        motion.Time = time;

        // The engine placed the collider again at the same time, so the position lacks the push: add the push.
        if (_push.IsAsPlaced && _push.At == time)
        {
            _push.Placed = motion;
            motion.Origin += _push.Gone;
            motion.Pivot += _push.Gone;
            motion.Velocity += _push.Pushed;
        }

        _push.IsAsPlaced = false;
    }

    private static int NumberOf(string name)
    {
        // FNV-1a, folded into the bits below FirstNumber.
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
