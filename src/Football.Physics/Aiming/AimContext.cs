using FootballPhysics.Contacts;
using FootballPhysics.Numerics;
using FootballPhysics.Scenes;
using FootballPhysics.Simulation;

namespace FootballPhysics.Aiming;

/// <summary>Data shared by the aiming methods: a compiled scene for each purpose, and reusable flights.</summary>
/// <remarks>
/// An aim is a boundary-value problem: both ends of a flight are given, and the kick is unknown. The solvers use the shooting method: they simulate a kick,
/// and then correct it by its miss. The methods differ in the flights that measure the miss.
/// </remarks>
internal sealed class AimContext
{
    /// <summary>The maximum duration of a flight, in s.</summary>
    public const double LongestFlight = 30;

    /// <summary>The miss that a search aims for even if the request allows more, in m; well below any useful tolerance.</summary>
    private const double FineMiss = 1e-3;

    /// <summary>The miss that a search aims for at a target on the ground, in m.</summary>
    private const double GroundMiss = 1e-4;

    /// <summary>The angle by which a kick along sloping ground is steeper than the ground, in rad.</summary>
    /// <remarks>Only level ground supports a ball that moves into it; on any other surface, even a rounding error would be an impact.</remarks>
    private const double OffGround = 1e-6;

    /// <summary>The maximum number of path segments in a search: some hundred simulations of a football, or fewer in very short steps.</summary>
    public const long MostPieces = 200_000;

    /// <summary>The number of simulations in a search over elevations or times that count as one iteration.</summary>
    private const int SimulationsPerIteration = 16;

    /// <summary>The number of simulations that a search already under way may still use.</summary>
    private const int LongestSearch = 64;

    private readonly Simulator _simulator;
    private readonly KickLook _look;
    private readonly TurningLook _turningLook;
    private readonly Collider? _ground;
    private int _spent;
    private int _most;
    private long _pieces;

    public AimContext(Simulator game)
    {
        Scene scene = game.Scene;
        HasThings = scene.HasThings;

        // Measure misses in the full scene. Search without obstacles and, if plane crossings must be smooth, without the ground.
        var real = new Simulator(scene, SolverSettings.Default);
        Scene open = HasThings ? WithoutThings(scene) : scene;
        _simulator = HasThings ? new Simulator(open, SolverSettings.Default) : real;
        Scene = scene;
        Game = game;
        Upward = Weight.UpwardAcceleration(scene);
        Steps = AimSteps.Long;
        var withoutGround = new Simulator(WithoutGround(open), SolverSettings.Default);
        _ground = real.World.Ground;
        IsLevel = _ground is null or { IsLevelGround: true };
        IsEvenAround = scene.Air.IsStill && IsLevel && scene.Ground.Pattern is null && !scene.HasOwnForces && !scene.IsTilted;
        Planes = new PlaneShooter(this, withoutGround);
        Shooting = new ShootingProblem(this, withoutGround, _simulator);
        _look = new KickLook(_simulator);
        _turningLook = new TurningLook(_simulator);
        Miss = new MissMeter(this, real);
    }

    public Scene Scene { get; }

    /// <summary>True if the scene contains more than the ground.</summary>
    /// <remarks>Kicks are searched with the ground only, and then checked in the full scene.</remarks>
    public bool HasThings { get; }

    /// <summary>True if the ground is level or missing, so that its height is the same everywhere.</summary>
    public bool IsLevel { get; }

    /// <summary>True if the scene looks the same in all horizontal directions: still air, and level ground of one material.</summary>
    public bool IsEvenAround { get; }

    /// <summary>True if something other than level ground may end a flight that the solvers took for free.</summary>
    public bool MayBlock => HasThings || !IsLevel;

    /// <summary>The scene with the game's own integrator.</summary>
    public Simulator Game { get; }

    /// <summary>The upward acceleration by gravity and buoyancy, in m/s².</summary>
    public double Upward { get; }

    /// <summary>Flights without ground to a plane.</summary>
    public PlaneShooter Planes { get; }

    /// <summary>Flights to given times; any quantity of the kick may be unknown.</summary>
    public ShootingProblem Shooting { get; }

    /// <summary>Measures the actual miss of a kick.</summary>
    public MissMeter Miss { get; }

    /// <summary>The step lengths of the flights.</summary>
    public AimSteps Steps { get; set; }

    /// <summary>The number of forward simulations since the search began.</summary>
    public int Simulations { get; private set; }

    /// <summary>The number of iterations since the search began.</summary>
    public int Iterations => (_spent + SimulationsPerIteration - 1) / SimulationsPerIteration;

    /// <summary>True if the search has used up its budget.</summary>
    public bool IsSpent => _spent >= _most || IsWorn;

    /// <summary>True if the search has used up its budget of path segments.</summary>
    public bool IsWorn => _pieces >= MostPieces;

    /// <summary>True if the search has used half of its budget; later searches may use the rest.</summary>
    public bool IsHalfSpent => _spent >= _most / 2 || _pieces >= MostPieces / 2;

    /// <summary>Begins a search.</summary>
    /// <param name="mostIterations">The maximum number of iterations.</param>
    public void Begin(int mostIterations)
    {
        // The budget is 16 flights per iteration, minus a reserve that lets a search finish after the rest has been spent.
        _most = Math.Min(mostIterations, int.MaxValue / (2 * SimulationsPerIteration)) * SimulationsPerIteration;
        _most -= Math.Min(_most / 2, LongestSearch);
        _spent = 0;
        _pieces = 0;
        Simulations = 0;
        Steps = AimSteps.Long;
        Miss.Forget();
    }

    /// <summary>True if rotating a kick's azimuth rotates its flight: in still air over level ground, with a target at rest.</summary>
    public bool Turns(in Vector3d targetVelocity) => IsEvenAround && targetVelocity == Vector3d.Zero;

    /// <summary>Simulates a kick over the ground to its closest approach.</summary>
    public Approach Look(in TargetFrame frame, in Vector3d targetVelocity, in Kick kick, double speed, double timeStep)
    {
        KickLook look = Turns(in targetVelocity) ? _turningLook : _look;
        Approach approach = look.Fly(in frame, in targetVelocity, in kick, speed, timeStep);
        CountSimulation(look.Pieces);
        return approach;
    }

    /// <summary>Counts the last simulation as a full iteration.</summary>
    public void CountIteration() => _spent += SimulationsPerIteration - 1;

    /// <summary>Counts a simulation; 16 make an iteration.</summary>
    /// <param name="pieces">The number of path segments of the simulation.</param>
    public void CountSimulation(long pieces)
    {
        Simulations++;
        _spent++;
        _pieces += pieces;
    }

    /// <summary>Returns the miss at which a search ends, in m. It is below the tolerance, because the long steps are slightly inaccurate.</summary>
    public static double Sharp(double tolerance, double fine = FineMiss) => 0.8 * Math.Min(tolerance, fine);

    /// <summary>Returns this miss for a target. It is smaller on the ground, where a flat flight that is a little low comes down far too early.</summary>
    public double Sharp(in TargetFrame frame, double tolerance) => Sharp(tolerance, IsOnGround(frame.Target, GroundMiss) ? GroundMiss : FineMiss);

    /// <summary>Returns the frame of a request; a ball or target in the ground is raised out of it.</summary>
    public TargetFrame Frame(AimRequest request) => new(Raised(Game, request.From), Raised(Game, request.Target), OrientationOf(Game, request));

    /// <summary>Returns the orientation of the ball at the kick.</summary>
    public static Quaterniond OrientationOf(Simulator simulator, AimRequest request) => request.Orientation ?? simulator.LaunchOrientation;

    /// <summary>Returns a position of the ball's centre, raised straight up if it is in the ground.</summary>
    public static Vector3d Raised(Simulator simulator, in Vector3d place) => GroundPlace.Raised(simulator.World, in place);

    /// <summary>True if a kick stays on level ground from its start.</summary>
    public bool StaysDown(in Vector3d from, double upwardSpeed) =>
        Upward <= 0 && from.Y <= Game.ContactHeight && Math.Abs(upwardSpeed) < Scene.Ground.MinimumBounceSpeed;

    /// <summary>True if a kick stays on the ground from its start, whatever the slope.</summary>
    public bool StaysDown(in Vector3d from, in Vector3d velocity) =>
        IsLevel ? StaysDown(in from, velocity.Y)
        : IsOnGround(in from, GroundMiss) && _simulator.LaunchAt(in from, in velocity, Vector3d.Zero, 0).Motion != MotionState.Airborne;

    /// <summary>True if a kick at an angle stays on the ground from its start.</summary>
    public bool StaysDown(in TargetFrame frame, in Kick kick, double speed)
    {
        if (!IsLevel)
        {
            kick.Vectors(speed, in frame.Forward, out Vector3d velocity, out _);
            return StaysDown(in frame.From, in velocity);
        }

        Elementary.SinCos(kick.Elevation, out double sine, out _);
        return StaysDown(in frame.From, speed * sine);
    }

    /// <summary>True if a ball at a position touches the ground, within a distance in m.</summary>
    public bool IsOnGround(in Vector3d position, double within) => Math.Abs(Clearance(in position)) < within;

    /// <summary>Returns the height of a ball above the ground, in m: vertical over level ground, otherwise the distance from the surface.</summary>
    public double Clearance(in Vector3d position) =>
        IsLevel ? position.Y - Game.ContactHeight : _ground!.At(in position).Distance - Scene.Ball.Radius;

    /// <summary>Returns the elevation of a kick along the ground, in rad.</summary>
    public double AlongGround(in Vector3d from, in Vector3d direction)
    {
        if (IsLevel)
        {
            return 0;
        }

        Vector3d normal = _ground!.At(in from).Normal;
        return OffGround - Elementary.Atan2(Vector3d.Dot(in normal, in direction), normal.Y);
    }

    /// <summary>Returns the closed-form flight of a kick, with coefficients averaged over a path length.</summary>
    public FlatFire Model(double speed, double spinRate, double way)
    {
        // Average over the two Gauss points of the path, with speeds estimated from the drag at launch.
        _simulator.AirFactors(speed, spinRate, out double drag, out double lift);
        double perLength = speed > 0 ? drag / speed : 0;
        double early = speed * Elementary.Exp(-0.2113 * perLength * way);
        double late = speed * Elementary.Exp(-0.7887 * perLength * way);
        _simulator.AirFactors(early, spinRate, out double drag1, out double lift1);
        _simulator.AirFactors(late, spinRate, out double drag2, out double lift2);
        return new FlatFire
        {
            Drag = 0.5 * ((early > 0 ? drag1 / early : 0) + (late > 0 ? drag2 / late : 0)),
            Lift = 0.5 * (lift1 + lift2),
            Upward = Upward,
        };
    }

    /// <inheritdoc cref="Stepper.AirFactors"/>
    public void Factors(double speed, double spinRate, out double drag, out double lift, out double decay) =>
        _simulator.AirFactors(speed, spinRate, out drag, out lift, out decay);

    /// <inheritdoc cref="MeasuringStep.IsRuledByAir"/>
    public bool IsRuledByAir(double speed, double spinRate) => MeasuringStep.IsRuledByAir(_simulator, Upward, speed, spinRate);

    /// <summary>Returns the scene with the ground only.</summary>
    public static Scene WithoutThings(Scene scene) => scene with { Obstacles = [], Nets = [], Goals = [], Bodies = null, EngineColliders = null };

    /// <summary>Returns the scene with its ground replaced by a plane far out of reach.</summary>
    public static Scene WithoutGround(Scene scene) => scene with { Ground = Ground.PublishedTurf with { Height = -0.5 * Limits.Length } };
}

/// <summary>The step lengths of the flights in an aim, in s; each is the longest that is accurate enough.</summary>
internal readonly struct AimSteps
{
    /// <summary>The miss above which the rough step is sufficient, in m.</summary>
    private const double RoughMiss = 5e-4;

    private AimSteps(double search, double hit, double roughHit, double rehearsedHit, bool areShort)
    {
        Search = search;
        Hit = hit;
        RoughHit = roughHit;
        RehearsedHit = rehearsedHit;
        AreShort = areShort;
    }

    /// <summary>The long steps for RK4.</summary>
    /// <remarks>
    /// The errors are 1e-4 m for a search, 1e-5 m for a hit, 1e-4 m for a rough hit and 5e-4 m for a rehearsed hit. The error of a hit requires that
    /// the flight locates the jump in the drag law.
    /// </remarks>
    public static AimSteps Long => new(search: 0.25, hit: 0.1, roughHit: 0.2, rehearsedHit: 0.3, areShort: false);

    /// <summary>Steps for a kick that grazes the jump in the drag law, where longer steps are inaccurate.</summary>
    public static AimSteps Short => new(search: 0.02, hit: 0.02, roughHit: 0.02, rehearsedHit: 0.02, areShort: true);

    /// <summary>The step of search flights.</summary>
    public double Search { get; }

    /// <summary>The step of flights that confirm a hit.</summary>
    public double Hit { get; }

    /// <summary>True for the short steps, used when longer ones were inaccurate.</summary>
    public bool AreShort { get; }

    private double RoughHit { get; }

    private double RehearsedHit { get; }

    /// <summary>Returns the step of flights that must resolve a miss of a given size.</summary>
    public double HitWithin(double miss) => miss >= RoughMiss ? RoughHit : Hit;

    /// <summary>Returns the step of flights that measure the small error of a rehearsed kick, which is then corrected.</summary>
    public double RehearsedWithin(double miss) => miss >= RoughMiss ? RehearsedHit : Hit;
}

/// <summary>The kick that a method found, by its own estimate.</summary>
internal struct AimSolution
{
    public AimReason Reason;
    public Kick Kick;

    /// <summary>The horizontal unit direction to the target, from which the kick's azimuth is measured.</summary>
    public Vector3d Forward;

    /// <summary>The speed of the kick, in m/s.</summary>
    public double Speed;

    /// <summary>The miss at the target, in m.</summary>
    public double Miss;

    /// <summary>The miss at the waypoint, in m.</summary>
    public double ThroughMiss;

    /// <summary>The time to the target, in s.</summary>
    public double Time;

    /// <summary>The number of iterations if the method counts its own; otherwise 0.</summary>
    public int Iterations;

    /// <summary>The arc of the kick; null if it is not known yet.</summary>
    public AimArc? Arc;

    /// <summary>The status, by the method's own estimate.</summary>
    public readonly AimStatus Status => Reason.Status();

    /// <summary>Returns the velocity and spin of the kick.</summary>
    public readonly void Vectors(out Vector3d velocity, out Vector3d spin) => Kick.Vectors(Speed, in Forward, out velocity, out spin);
}
