namespace FootballPhysics;

/// <summary>A thing that can be hit, ready to be asked: the ground is one, and every obstacle, post and body.</summary>
internal sealed class Collider
{
    private readonly RigidMotion _motion;
    private readonly ObstacleMotions? _obstacles;
    private readonly KinematicBody? _body;
    private readonly EnginePushes? _enginePushes;
    private IShape _shape;
    private PlaneShape? _plane;
    private Bounds3d _bounds;
    private ContactMaterial _material;
    private Placement? _placement;
    private readonly ISurfacePattern? _pattern;
    private readonly ContactMaterial[] _patches = [];

    /// <summary>The ball's factor on every restitution.</summary>
    private readonly double _bounce = 1;

    public Collider(string name, IShape shape, in ContactMaterial material)
    {
        Name = name;
        _shape = shape;
        _plane = shape as PlaneShape;
        _bounds = shape.Bounds;
        _material = material;
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
        _obstacles = all;
        _placement = placement;
        _motion.Velocity = obstacle.Velocity;
        _motion.Spin = obstacle.Spin;
        _motion.Pivot = obstacle.Pivot;
    }

    public Collider(KinematicBody body, BallProperties ball)
        : this(body.Name, body.Shape, new ContactMaterial(body.Surface, ball.Bounce))
    {
        Surfaces = [body.Surface];
        Mass = body.Mass;
        Layer = body.Layer;
        _body = body;
        _placement = body.Placement;
    }

    /// <summary>A place for one that an engine finds.</summary>
    public Collider(Placement none, EnginePushes pushes, BallProperties ball)
    {
        _bounce = ball.Bounce;
        _enginePushes = pushes;
        Name = "";
        _shape = new TangentShape();
        _bounds = _shape.Bounds;
        _placement = none;
    }

    /// <summary>Its name.</summary>
    public string Name { get; private set; }

    /// <summary>Its layer; −1 for what is in none: the ground, the frames of goals, and places of an engine, whose colliders are sorted out when they are found.</summary>
    public int Layer { get; init; } = -1;

    /// <summary>The engine's collider that it stands for; null where it does for none.</summary>
    public EngineCollider? Engine { get; private set; }

    /// <summary>Nothing that it is made of is narrower, m; infinite where it is the same everywhere.</summary>
    public double LeastWidth => _pattern is null ? double.PositiveInfinity : _pattern.MinimumWidth;

    /// <summary>V, m/s.</summary>
    public Vector3d Velocity => Motion.Velocity;

    /// <summary>Ω of its material, rad/s.</summary>
    public Vector3d Spin => Motion.Spin;

    /// <summary>True when the shape itself rotates within a step: bodies and engine colliders.</summary>
    /// <remarks>
    /// The spin of an obstacle moves only its surface, and so does a spin that leaves the shape as it is.
    /// </remarks>
    public bool Rotates => Motion.Rotates;

    /// <summary>True if it has no velocity and no spin in this step: a ball may rest on it.</summary>
    public bool StandsStill => Velocity == Vector3d.Zero && Spin == Vector3d.Zero;

    /// <summary>Velocity of the shape at a point, m/s: with Ω where the shape itself rotates.</summary>
    /// <remarks>A gap to the ball changes by the ball's velocity relative to this one.</remarks>
    public Vector3d ShapeVelocity(in Vector3d point, double time) => Rotates ? SurfaceVelocity(in point, time) : Velocity;

    /// <summary>V_p, the velocity of its material, continued to a point, m/s.</summary>
    public Vector3d MaterialVelocity(in Vector3d point, double time) => Spin == Vector3d.Zero ? Velocity : SurfaceVelocity(in point, time);

    /// <summary>Where a point that moves along with its material is after a time, m.</summary>
    public Vector3d CarriedTo(in Vector3d point, double time, double after)
    {
        ref readonly RigidMotion motion = ref Motion;
        Vector3d pivot = motion.Pivot + ((time - motion.Time) * motion.Velocity);
        return pivot + (after * motion.Velocity) + Quaterniond.FromRotationVector(after * motion.Spin).Rotate(point - pivot);
    }

    /// <summary>How far a point is inside the border of the flat face that it is over, m; negative beyond it, infinite where the shape has no such border.</summary>
    public double FaceMargin(in Vector3d position, double time) => _shape is BoxShape box ? box.FaceMargin(Motion.ToShape(in position, time)) : double.PositiveInfinity;

    /// <summary>True when it is made of several materials.</summary>
    public bool HasPatches => _patches.Length > 0;

    /// <summary>True when its shape is a plane everywhere, or, where it is flat, like one.</summary>
    public bool IsPlane => _shape is PlaneShape or TangentShape;

    /// <summary>True when its shape has flat faces with borders, as a box does.</summary>
    public bool HasFaces => _shape is BoxShape;

    /// <summary>The greatest speed of any part of it, m/s. For a shape without bounds, only its velocity counts.</summary>
    public double GreatestSpeed => Motion.GreatestSpeed;

    /// <summary>Mass behind its surface, kg; infinite where the ball does not move it.</summary>
    public double Mass { get; private set; } = double.PositiveInfinity;

    /// <summary>True when the ball moves it.</summary>
    public bool GivesWay => Mass < double.PositiveInfinity;

    /// <summary>The motion that the scene gives it; none for what the game, or an engine, moves.</summary>
    public ref readonly RigidMotion Given => ref _motion;

    /// <summary>True when the game, or an engine, moves it.</summary>
    public bool IsBody => _placement is not null && _obstacles is null;

    /// <summary>True when the game has taken it out of play.</summary>
    public bool IsWithdrawn => _body is { IsWithdrawn: true };

    /// <summary>True when it may be elsewhere at another time.</summary>
    public bool Moves => _placement is not null || _motion.Velocity != Vector3d.Zero;

    /// <summary>The plane that it is, where it stands still; else null: a path's distance from it is one cubic.</summary>
    public PlaneShape? StandingPlane => Moves ? null : _plane;

    /// <summary>The strongest curvature of its hollows, 1/m; 0 where it is convex.</summary>
    public double HollowCurvature => _shape.MaximumConcaveCurvature;

    /// <summary>A box around it in its own frame: for what the game does not move, where it was at time 0.</summary>
    public ref readonly Bounds3d Bounds => ref _bounds;

    private ref readonly RigidMotion Motion
    {
        get
        {
            if (_placement is null)
            {
                return ref _motion;
            }

            return ref _placement.Motion;
        }
    }

    /// <summary>Stands for an engine's collider from now on.</summary>
    public void Become(EngineCollider collider)
    {
        Engine = collider;
        Name = collider.Name;
        _shape = collider.Shape;
        _plane = _shape as PlaneShape;
        _bounds = _shape.Bounds;
        _material = new ContactMaterial(collider.Surface, _bounce);
        _placement = collider.Placement;
        Mass = collider.Mass;
    }

    /// <summary>An impact of the ball gives it an impulse, N s: it goes on with V + J/M.</summary>
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

    /// <summary>Which of its materials is under a place; −1 for its own.</summary>
    public int PatchAt(in Vector3d position)
    {
        int patch = _pattern is null ? -1 : _pattern.At(position.X, position.Z);
        return (uint)patch < (uint)_patches.Length ? patch : -1;
    }

    /// <summary>The given materials: its own, then those of its parts. Empty for an engine's.</summary>
    public IReadOnlyList<SurfaceMaterial> Surfaces { get; } = [];

    /// <summary>Materials: its own, then those of its parts.</summary>
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

    /// <summary>Material under a place.</summary>
    public ref readonly ContactMaterial MaterialAt(in Vector3d position)
    {
        int patch = PatchAt(in position);
        if (patch < 0)
        {
            return ref _material;
        }

        return ref _patches[patch];
    }

    /// <summary>Distance, normal and curvature, seen from a point at a time.</summary>
    public ShapePoint At(in Vector3d position, double time) => Motion.At(_shape, in position, time);

    /// <summary>Nearest point of the shape to a point in the thing's own frame.</summary>
    public ShapePoint At(in Vector3d position) => _shape.At(in position);

    /// <summary>The shape and its motion, described from a time on: for many looks within a piece.</summary>
    public MovingShape From(double time) => new(_shape, in Motion, time);

    /// <summary>A path as the thing sees it in its own frame.</summary>
    public PathCubic Seen(in PathCubic path, double time)
    {
        // Transform the path to the frame of the moving shape, where the shape is stationary.
        ref readonly RigidMotion motion = ref Motion;
        PathCubic seen = path.SeenFrom(motion.GoneBy(time), motion.Velocity);
        return motion.IsTurned ? seen.InAxes(in motion) : seen;
    }

    /// <summary>A box around it at a time.</summary>
    public Bounds3d BoundsAt(double time) => BoundsDuring(time, 0);

    /// <summary>A box that is around it at a time, and stays around it for a duration if the box moves along with its velocity.</summary>
    public Bounds3d BoundsDuring(double time, double duration) =>
        _placement is null ? _bounds.Translated(_motion.GoneBy(time)) : _placement.BoundsDuring(time, duration);

    /// <summary>The surface's velocity at a point of contact, V + Ω × (c − o), m/s.</summary>
    public Vector3d SurfaceVelocity(in Vector3d contact, double time) => Motion.SurfaceVelocity(in contact, time);
}

/// <summary>The numbers of a surface, as contact needs them: the pitch's and every other thing's alike.</summary>
internal readonly struct ContactMaterial
{
    /// <summary>Approach speed at which the restitution of a surface is given where it falls with speed, m/s: what the rigs measure at.</summary>
    private const double RigSpeed = 6.0;

    /// <summary>C: at a speed along the surface of so many times the approach, half of the rise is there (measured on the impacts of one match: 2.5 … 3.5).</summary>
    private const double HalfRise = 2.8;

    /// <summary>e₀ = e₆ √(1 + (6/V_e)²).</summary>
    public double SlowRestitution { get; init; }

    /// <summary>1/V_e, s/m.</summary>
    public readonly double PerRestitutionSpeed;

    /// <summary>η.</summary>
    public double RestitutionRise { get; init; }

    /// <summary>The most that e is at any speed: 1, or more of a bumper.</summary>
    private readonly double _most;

    /// <summary>The least speed off the surface after an impact, m/s.</summary>
    public double MinimumExitSpeed { get; init; }

    /// <summary>e_t along x, and along every direction but z.</summary>
    public readonly double TangentialX;

    /// <summary>e_t along z.</summary>
    public readonly double TangentialZ;

    /// <summary>e_ω.</summary>
    public readonly double Spin;

    /// <summary>μ of an impact.</summary>
    public readonly double ImpactFriction;

    /// <summary>μ_s.</summary>
    public readonly double SlidingFriction;

    /// <summary>μ_r or c₀.</summary>
    public readonly double RollingFriction;

    /// <summary>c₁, s/m.</summary>
    public readonly double RollingFrictionBySpeed;

    /// <summary>c_ω, N m s.</summary>
    public readonly double SpinDamping;

    /// <summary>b, m.</summary>
    public readonly double DrillingLength;

    public ContactMaterial(Ground ground, double bounce = 1)
        : this(ground.Material, bounce) => TangentialZ = ground.TangentialRestitutionZ ?? TangentialX;

    /// <param name="surface">The surface.</param>
    /// <param name="bounce">The ball's factor on its restitution.</param>
    public ContactMaterial(SurfaceMaterial surface, double bounce = 1)
    {
        PerRestitutionSpeed = 1.0 / surface.RestitutionSpeedScale;
        SlowRestitution = bounce * AtRest(surface.NormalRestitution, PerRestitutionSpeed);
        _most = surface.NormalRestitution > 1 ? Math.Max(1.0, bounce * surface.NormalRestitution) : 1.0;
        MinimumExitSpeed = surface.MinimumExitSpeed;
        RestitutionRise = surface.GrazingRestitutionGain;
        TangentialX = surface.TangentialRestitution;
        TangentialZ = surface.TangentialRestitution;
        Spin = surface.SpinRestitution;
        ImpactFriction = surface.ImpactFriction;
        SlidingFriction = surface.SlidingFriction;
        RollingFriction = surface.RollingResistance;
        RollingFrictionBySpeed = surface.RollingResistancePerSpeed;
        SpinDamping = surface.SpinDamping;
        DrillingLength = surface.TorsionalPatchRadius;
    }

    /// <summary>A surface by the three numbers of an impact alone, the same at every speed.</summary>
    public ContactMaterial(double restitution, double tangentialRestitution, double friction)
    {
        this = default;
        SlowRestitution = restitution;
        _most = 1;
        TangentialX = tangentialRestitution;
        TangentialZ = tangentialRestitution;
        Spin = 1;
        ImpactFriction = friction;
    }

    /// <summary>The same surface without restitution.</summary>
    public ContactMaterial WithoutRestitution() => this with { SlowRestitution = 0, RestitutionRise = 0, MinimumExitSpeed = 0 };

    /// <summary>True if an impact may add energy.</summary>
    public bool IsBumper => _most > 1 || MinimumExitSpeed > 0;

    /// <summary>e = e_n + η (1 − e_n) v_t⁴/(v_t⁴ + (C v_n)⁴), e_n = e₀/√(1 + (v_n/V_e)²): a ball that grazes ploughs less.</summary>
    /// <remarks>At most 1, except of a bumper, whose e does not rise.</remarks>
    /// <param name="approach">v_n, m/s.</param>
    /// <param name="along">v_t, the ball's velocity along the surface, m/s.</param>
    public double RestitutionAt(double approach, in Vector3d along)
    {
        double e = RestitutionHeadOn(approach);
        if (!(RestitutionRise > 0))
        {
            return e;
        }

        // Use the ratio of squares, so that it cannot overflow.
        double steep = HalfRise * approach;
        double square = along.LengthSquared / (steep * steep);
        double grazing = square < 1e150 ? square * square / (1.0 + (square * square)) : 1;
        return e + (RestitutionRise * Math.Max(0, 1.0 - e) * grazing);
    }

    /// <summary>The most that e may be at any obliqueness.</summary>
    public double LargestRestitutionAt(double approach)
    {
        double e = RestitutionHeadOn(approach);
        return e + (RestitutionRise * Math.Max(0, 1.0 - e));
    }

    /// <summary>The largest restitution anywhere on a ground: that of the slowest and most oblique impacts.</summary>
    public static double LargestOn(Ground ground, BallProperties ball)
    {
        double largest = new ContactMaterial(ground.Material, ball.Bounce).LargestRestitutionAt(0);
        for (int i = 0; i < (ground.Pattern?.Surfaces.Count ?? 0); i++)
        {
            largest = Math.Max(largest, new ContactMaterial(ground.Pattern!.Surfaces[i], ball.Bounce).LargestRestitutionAt(0));
        }

        return largest;
    }

    /// <summary>The speed off a bumper after an impact, m/s: e v_n or more.</summary>
    /// <remarks>It is never faster than 1000 m/s, unless it came so fast.</remarks>
    /// <param name="approach">v_n, m/s.</param>
    /// <param name="restitution">e.</param>
    /// <param name="share">How much of it counts.</param>
    public double Bumped(double approach, double restitution, double share) =>
        Math.Min(share * Math.Max(restitution * approach, MinimumExitSpeed), Math.Max(approach, Limits.Speed));

    /// <summary>e_n = e₀/√(1 + (v_n/V_e)²), at most 1, or at most that of a bumper.</summary>
    private double RestitutionHeadOn(double approach)
    {
        double x = approach * PerRestitutionSpeed;
        return Math.Min(_most, x > 0 ? SlowRestitution / Math.Sqrt(1.0 + (x * x)) : SlowRestitution);
    }

    private static double AtRest(double atRigSpeed, double perSpeed)
    {
        // e₀ = e₆ √(1 + (6/V_e)²).
        double x = RigSpeed * perSpeed;
        return x > 0 ? atRigSpeed * Math.Sqrt(1.0 + (x * x)) : atRigSpeed;
    }
}
