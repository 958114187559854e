using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Contacts;

/// <summary>An object that the ball can hit, prepared for queries: the ground, an obstacle, a post or a body.</summary>
internal sealed class Collider
{
    private readonly RigidMotion _motion;
    private readonly ObstacleMotions? _obstacles;
    private readonly KinematicBody? _body;
    private readonly EnginePushes? _enginePushes;
    private IShape _shape;
    private Bounds3d _bounds;
    private ContactMaterial _material;
    private Placement? _placement;
    private readonly ISurfacePattern? _pattern;
    private readonly ContactMaterial[] _patches = [];

    /// <summary>The factor by which the ball scales every restitution.</summary>
    private readonly double _bounce = 1;

    /// <summary>The radius of the ball, m, for engine colliders.</summary>
    private readonly double _radius;

    private double _hollow;

    public Collider(string name, IShape shape, in ContactMaterial material)
    {
        Name = name;
        _shape = shape;
        _bounds = shape.Bounds;
        _material = material;
        _hollow = shape.MaximumConcaveCurvature;
        Classify();
    }

    public Collider(Ground ground, IShape shape, BallProperties ball)
        : this("ground", shape, new ContactMaterial(ground, ball.Bounce))
    {
        _pattern = ground.Pattern;
        Surfaces = [ground.Material, .. _pattern?.Surfaces ?? []];
        _patches = _pattern is null ? [] : [.. _pattern.Surfaces.Select(surface => new ContactMaterial(surface, ball.Bounce))];
    }

    public Collider(Obstacle obstacle, BallProperties ball, ObstacleMotions? all = null, Placement? placement = null)
        : this(obstacle.Name, obstacle.Shape, new ContactMaterial(obstacle.Surface, ball.Bounce))
    {
        Surfaces = [obstacle.Surface];
        Mass = obstacle.Mass;
        Layer = obstacle.Layer;
        _hollow = HollowSamples.Corrected(_shape, ball.Radius);
        _obstacles = all;
        _placement = placement;
        _motion.Velocity = obstacle.Velocity;
        _motion.Spin = obstacle.Spin;
        _motion.Pivot = obstacle.Pivot;
        Classify();
    }

    public Collider(KinematicBody body, BallProperties ball)
        : this(body.Name, body.Shape, new ContactMaterial(body.Surface, ball.Bounce))
    {
        Surfaces = [body.Surface];
        Mass = body.Mass;
        Layer = body.Layer;
        _hollow = HollowSamples.Corrected(_shape, ball.Radius);
        _body = body;
        _placement = body.Placement;
        Classify();
    }

    /// <summary>Creates an empty slot for an engine collider.</summary>
    public Collider(Placement none, EnginePushes pushes, BallProperties ball)
    {
        _bounce = ball.Bounce;
        _radius = ball.Radius;
        _enginePushes = pushes;
        Name = "";
        _shape = new TangentShape();
        _bounds = _shape.Bounds;
        _placement = none;
        Classify();
    }

    /// <summary>Its name.</summary>
    public string Name { get; private set; }

    /// <summary>True if it is level ground. A ball on level ground has an exact height, because other code compares such heights for equality.</summary>
    public bool IsLevelGround { get; init; }

    /// <summary>The exact height of the centre of a ball on level ground, m; −∞ for other surfaces.</summary>
    public double LevelContact { get; init; } = double.NegativeInfinity;

    /// <summary>Returns the position of a ball on this surface, with the exact height if it is level ground.</summary>
    public Vector3d Snap(in Vector3d position) => IsLevelGround ? new Vector3d(position.X, LevelContact, position.Z) : position;

    /// <summary>Like <see cref="Snap"/>, but never lowers the ball.</summary>
    public Vector3d SnapUp(in Vector3d position) => IsLevelGround ? new Vector3d(position.X, Math.Max(position.Y, LevelContact), position.Z) : position;

    /// <summary>Its layer; −1 for the ground, goal frames and engine slots. Engine colliders are filtered when they are
    /// found.</summary>
    public int Layer { get; init; } = -1;

    /// <summary>True if it is the end of a net, which acts only on a ball in that net, on one side.</summary>
    /// <remarks>The net's force pulls the ball off it, so this force counts in the load.</remarks>
    public bool IsNetEnd { get; init; }

    /// <summary>The engine collider in this slot; null if there is none.</summary>
    public EngineCollider? Engine { get; private set; }

    /// <summary>Width of its narrowest material patch, m; infinite if it has one material.</summary>
    public double LeastWidth => _pattern is null ? double.PositiveInfinity : _pattern.MinimumWidth;

    /// <summary>V, m/s.</summary>
    public Vector3d Velocity => Motion.Velocity;

    /// <summary>Ω of its material, rad/s.</summary>
    public Vector3d Spin => Motion.Spin;

    /// <summary>True if the shape itself rotates within a step: bodies and engine colliders.</summary>
    /// <remarks>The spin of an obstacle moves only its surface, as does any spin that leaves the shape unchanged.</remarks>
    public bool Rotates => Moves && Motion.Rotates;

    /// <summary>True if it has no velocity and no spin in this step, so that a ball may rest on it.</summary>
    public bool StandsStill => Velocity == Vector3d.Zero && Spin == Vector3d.Zero;

    /// <summary>Returns the velocity of the shape at a point, m/s, including Ω if the shape itself rotates.</summary>
    /// <remarks>The rate of the gap follows from the ball's velocity relative to the shape.</remarks>
    public Vector3d ShapeVelocity(in Vector3d point, double time) => Moves ? Motion.ShapeVelocity(in point, time) : _motion.Velocity;

    /// <summary>Returns V_p, the velocity of its material extrapolated to the ball's centre, m/s.</summary>
    /// <remarks>If the shape does not rotate, the part along the shape, along which a ball moves with the material.</remarks>
    public Vector3d MaterialVelocity(in Vector3d center, double time)
    {
        if (Spin == Vector3d.Zero)
        {
            return Velocity;
        }

        return Rotates ? Motion.SurfaceVelocity(in center, time) : SurfaceVelocity(in center, At(in center, time).Normal, time);
    }

    /// <summary>Returns the position of a ball's centre that moves along with its material, after a time, m.</summary>
    /// <remarks>If the shape does not rotate, the ball keeps its distance from it.</remarks>
    public Vector3d CarriedTo(in Vector3d center, double time, double after)
    {
        ref readonly RigidMotion motion = ref Motion;
        Vector3d pivot = motion.Pivot + ((time - motion.Time) * motion.Velocity);
        Vector3d end = pivot + (after * motion.Velocity) + Quaterniond.FromRotationVector(after * motion.Spin).Rotate(center - pivot);
        if (Rotates)
        {
            return end;
        }

        ShapePoint there = At(in end, time + after);
        return end + ((At(in center, time).Distance - there.Distance) * there.Normal);
    }

    /// <summary>Returns the distance of a point inside the border of the flat face below it, m; negative beyond it, infinite without a
    /// border.</summary>
    public double FaceMargin(in Vector3d position, double time) => _shape is BoxShape box ? box.FaceMargin(Motion.ToShape(in position, time)) : double.PositiveInfinity;

    /// <summary>True if it has several materials.</summary>
    public bool HasPatches => _patches.Length > 0;

    /// <summary>True if its shape is a plane, or a local approximation of a surface, which may be flat.</summary>
    public bool IsPlane => _shape is PlaneShape or TangentShape;

    /// <summary>True if its shape has flat faces with borders, such as a box.</summary>
    public bool HasFaces => _shape is BoxShape;

    /// <summary>The greatest speed of any part of it, m/s. For an unbounded shape, this is the speed of V alone.</summary>
    public double GreatestSpeed => Motion.GreatestSpeed;

    /// <summary>Effective mass at its surface, kg; infinite if the ball cannot move it.</summary>
    public double Mass { get; private set; } = double.PositiveInfinity;

    /// <summary>True if the ball can move it.</summary>
    public bool GivesWay { get; private set; }

    /// <summary>The motion that the scene defines for it; default for objects that the game or an engine moves.</summary>
    public ref readonly RigidMotion Given => ref _motion;

    /// <summary>True if the game or an engine moves it.</summary>
    public bool IsBody => _placement is not null && _obstacles is null;

    /// <summary>True if the game has withdrawn it.</summary>
    public bool IsWithdrawn => _body is { IsWithdrawn: true };

    /// <summary>True if its position may change.</summary>
    public bool Moves { get; private set; }

    /// <summary>Its plane if it is a stationary plane; otherwise null.</summary>
    /// <remarks>The distance of a path from the plane is a single cubic.</remarks>
    public PlaneShape? StandingPlane { get; private set; }

    /// <summary>Its largest concave curvature, 1/m; 0 if it is convex. A stated value that samples contradict is replaced.</summary>
    public double HollowCurvature => _hollow;

    /// <summary>Its bounding box in its own frame; for objects that the game does not move, at time 0.</summary>
    public ref readonly Bounds3d Bounds => ref _bounds;

    private ref readonly RigidMotion Motion => ref _placement is null ? ref _motion : ref _placement.Motion;

    /// <summary>Assigns an engine collider to this slot.</summary>
    public void Become(EngineCollider collider)
    {
        Engine = collider;
        Name = collider.Name;
        _shape = collider.Shape;
        _hollow = collider.Hollow(_radius);
        _bounds = _shape.Bounds;
        _material = new ContactMaterial(collider.Surface, _bounce);
        _placement = collider.Placement;
        Mass = collider.Mass;
        Classify();
    }

    /// <summary>Sets the properties that follow from its shape, its mass and its motion.</summary>
    private void Classify()
    {
        GivesWay = Mass < double.PositiveInfinity;
        Moves = _placement is not null || _motion.Velocity != Vector3d.Zero;
        StandingPlane = Moves ? null : _shape as PlaneShape;
    }

    /// <summary>Applies the impulse of an impact, N s: its velocity becomes V + J/M.</summary>
    public void Push(in Vector3d impulse, double time)
    {
        Vector3d velocity = Velocity + (impulse / Mass);
        if (_body is not null)
        {
            _body.Push(in velocity, time);
        }
        else if (Engine is not null)
        {
            _enginePushes!.Note(Engine);
            Engine.Push(in velocity, time);
        }
        else
        {
            _obstacles?.Push(_placement!, in velocity, time);
        }
    }

    /// <summary>Returns the index of the material patch at a position; −1 for its main material.</summary>
    public int PatchAt(in Vector3d position)
    {
        int patch = _pattern is null ? -1 : _pattern.At(position.X, position.Z);
        return (uint)patch < (uint)_patches.Length ? patch : -1;
    }

    /// <summary>The given materials: the main one, then those of its patches. Empty for an engine collider.</summary>
    public IReadOnlyList<SurfaceMaterial> Surfaces { get; } = [];

    /// <summary>Contact materials: the main one, then those of its patches.</summary>
    public ContactMaterial[] Materials
    {
        get
        {
            var materials = new ContactMaterial[1 + _patches.Length];
            materials[0] = _material;
            _patches.CopyTo(materials, 1);
            return materials;
        }
    }

    /// <summary>Returns the material at a position.</summary>
    public ref readonly ContactMaterial MaterialAt(in Vector3d position) => ref _pattern is not null && PatchAt(in position) is >= 0 and int patch ? ref _patches[patch] : ref _material;

    /// <summary>Returns distance, normal and curvature at a point and a time.</summary>
    public ShapePoint At(in Vector3d position, double time) => Moves ? Motion.At(_shape, in position, time) : _shape.At(in position);

    /// <summary>Returns distance, normal and curvature at a point in the object's own frame.</summary>
    public ShapePoint At(in Vector3d position) => _shape.At(in position);

    /// <summary>Returns the curvature of the surface as a ball meets it.</summary>
    /// <param name="at">The surface at the ball.</param>
    /// <param name="position">Position of the ball, m.</param>
    /// <param name="velocity">Its velocity, m/s.</param>
    /// <param name="time">The time, s.</param>
    public Bend BendAt(in ShapePoint at, in Vector3d position, in Vector3d velocity, double time) => new(in at, velocity - ShapeVelocity(in position, time));

    /// <summary>True if a contact lies within the bounds of the shape: beyond them, a distance function may go on without a surface.</summary>
    public bool Reaches(in Vector3d contact, double time) =>
        BoundsAt(time).Expanded(ContactTolerances.ClosedGap + (ContactTolerances.ClockRounding * contact.Length)).Intersects(new Bounds3d(in contact, in contact));

    /// <summary>True if the curvature of its shape may jump along a path, as between the parts of a shape of the game's own.</summary>
    public bool MayBend => _shape is not (PlaneShape or SphereShape or HeightField or TangentShape);

    /// <summary>Returns the shape and its motion from a given time on, for repeated queries within a piece.</summary>
    public MovingShape From(double time) => new(_shape, in Motion, time);

    /// <summary>Transforms a path to the object's own frame.</summary>
    public PathCubic Seen(in PathCubic path, double time)
    {
        // Transform the path to the frame of the moving shape, in which the shape is stationary.
        ref readonly RigidMotion motion = ref Motion;
        PathCubic seen = path.SeenFrom(motion.GoneBy(time), motion.Velocity);
        return motion.IsTurned ? seen.Rotated(motion.ToOwnAxes) : seen;
    }

    /// <summary>Returns its bounding box at a time.</summary>
    public Bounds3d BoundsAt(double time) => BoundsDuring(time, 0);

    /// <summary>Returns a box around it, valid for a duration if the box moves at its velocity.</summary>
    public Bounds3d BoundsDuring(double time, double duration) =>
        _placement is null ? _bounds.Translated(_motion.GoneBy(time)) : _placement.BoundsDuring(time, duration);

    /// <summary>Returns the surface velocity at a contact that lasts, V + Ω × (c − o), m/s.</summary>
    /// <remarks>Along the normal of a shape that does not rotate, the shape alone counts: the gap changes at its velocity.</remarks>
    public Vector3d SurfaceVelocity(in Vector3d contact, in Vector3d normal, double time)
    {
        if (Spin == Vector3d.Zero)
        {
            return Velocity;
        }

        Vector3d velocity = Motion.SurfaceVelocity(in contact, time);
        return velocity - (OffShape(in velocity, in normal) * normal);
    }

    /// <summary>Returns V + Ω × (p − o), m/s, the velocity of the material, with which an impact is computed.</summary>
    public Vector3d SpinVelocity(in Vector3d point, double time) => Motion.SurfaceVelocity(in point, time);

    /// <summary>Returns the speed at which a spin that does not rotate the shape moves the material out of the shape, m/s.</summary>
    public double OffShape(in Vector3d velocity, in Vector3d normal) => Rotates ? 0 : Vector3d.Dot(velocity - Velocity, in normal);
}
