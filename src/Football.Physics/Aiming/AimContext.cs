namespace FootballPhysics.Aiming;

/// <summary>Shared by the aiming methods: the scene compiled for each purpose, and the memory of their flights.</summary>
/// <remarks>
/// An aim is a boundary-value problem: a flight is given at both ends, and the kick is sought. It is solved by shooting: kicks are flown, and
/// corrected by what they miss by. Which flights tell the miss is what the methods differ in.
/// </remarks>
internal sealed class AimContext
{
    /// <summary>No flight is followed for longer, s.</summary>
    public const double LongestFlight = 30;

    /// <summary>A miss distance well below any tolerance worth having, m: a hit is within it even where a request is content with less.</summary>
    private const double FineMiss = 1e-3;

    /// <summary>Pieces of motion that one search may have: for a football some hundred simulations, for what needs very short steps a few.</summary>
    public const long MostPieces = 200_000;

    /// <summary>Simulations of a search over elevations or times that count as one iteration.</summary>
    private const int SimulationsPerIteration = 16;

    /// <summary>Simulations that a search that has begun may still take.</summary>
    private const int LongestSearch = 64;

    private readonly Simulator _simulator;
    private readonly KickLook _look;
    private readonly TurningLook _turningLook;
    private int _spent;
    private int _most;
    private long _pieces;

    public AimContext(Simulator game)
    {
        Scene scene = game.Scene;
        HasThings = scene.HasThings;

        // Misses are measured in the whole scene; searched is without its things, and for smooth crossings without its ground too.
        var real = new Simulator(scene, SolverSettings.Default);
        Scene open = HasThings ? WithoutThings(scene) : scene;
        _simulator = HasThings ? new Simulator(open, SolverSettings.Default) : real;
        Scene = scene;
        Game = game;
        Upward = Weight.UpwardAcceleration(scene);
        Steps = AimSteps.Long;
        var withoutGround = new Simulator(WithoutGround(open), SolverSettings.Default);
        Planes = new PlaneShooter(this, withoutGround);
        Shooting = new ShootingProblem(this, withoutGround, _simulator);
        _look = new KickLook(_simulator);
        _turningLook = new TurningLook(_simulator);
        Miss = new MissMeter(this, real);
    }

    public Scene Scene { get; }

    /// <summary>True when there is anything in the scene but the ground. Kicks are sought as if there were not, and then looked at where there is.</summary>
    public bool HasThings { get; }

    /// <summary>The scene with the game's own integrator.</summary>
    public Simulator Game { get; }

    /// <summary>Upward acceleration by gravity and buoyancy, m/s².</summary>
    public double Upward { get; }

    /// <summary>Flights without ground, to a plane.</summary>
    public PlaneShooter Planes { get; }

    /// <summary>Flights to given times, any of whose numbers may be unknown.</summary>
    public ShootingProblem Shooting { get; }

    /// <summary>Measures the true miss of a kick.</summary>
    public MissMeter Miss { get; }

    /// <summary>Steps of the flights.</summary>
    public AimSteps Steps { get; set; }

    /// <summary>Forward simulations since the search began.</summary>
    public int Simulations { get; private set; }

    /// <summary>Iterations since the search began.</summary>
    public int Iterations => (_spent + SimulationsPerIteration - 1) / SimulationsPerIteration;

    /// <summary>True when the search has had all that it may have.</summary>
    public bool IsSpent => _spent >= _most || IsWorn;

    /// <summary>True when it has had all the pieces of motion that it may have.</summary>
    public bool IsWorn => _pieces >= MostPieces;

    /// <summary>True when it has had half of that: a search that others come after leaves them the rest.</summary>
    public bool IsHalfSpent => _spent >= _most / 2 || _pieces >= MostPieces / 2;

    /// <summary>Begins a search.</summary>
    /// <param name="mostIterations">Iterations that it may have.</param>
    public void Begin(int mostIterations)
    {
        // Flights that may be spent, sixteen an iteration; less those that a search which has begun may still take.
        _most = Math.Min(mostIterations, int.MaxValue / (2 * SimulationsPerIteration)) * SimulationsPerIteration;
        _most -= Math.Min(_most / 2, LongestSearch);
        _spent = 0;
        _pieces = 0;
        Simulations = 0;
        Steps = AimSteps.Long;
        Miss.Forget();
    }

    /// <summary>True when flights for a target with a velocity turn with their azimuth.</summary>
    public bool Turns(in Vector3d targetVelocity) => Scene.Air.IsStill && targetVelocity == Vector3d.Zero;

    /// <summary>Flies a kick with ground, to its closest approach.</summary>
    public Approach Look(in TargetFrame frame, in Vector3d targetVelocity, in Kick kick, double speed, double timeStep)
    {
        KickLook look = Turns(in targetVelocity) ? _turningLook : _look;
        Approach approach = look.Fly(in frame, in targetVelocity, in kick, speed, timeStep);
        CountSimulation(look.Pieces);
        return approach;
    }

    /// <summary>Makes the last simulation an iteration of its own.</summary>
    public void CountIteration() => _spent += SimulationsPerIteration - 1;

    /// <summary>Counts a simulation; several of them make an iteration.</summary>
    /// <param name="pieces">Its pieces of motion.</param>
    public void CountSimulation(long pieces)
    {
        Simulations++;
        _spent++;
        _pieces += pieces;
    }

    /// <summary>The miss distance within which a search ends, m: inside the tolerance, for the longer steps of the flights are a little off.</summary>
    public static double Sharp(double tolerance, double fine = FineMiss) => 0.8 * Math.Min(tolerance, fine);

    /// <summary>The frame of a request, ball and target raised out of the ground.</summary>
    public TargetFrame Frame(AimRequest request) => new(Raised(Game, request.From), Raised(Game, request.Target));

    /// <summary>A place of the ball's centre; one in the ground is raised straight up, as a launch is.</summary>
    public static Vector3d Raised(Simulator simulator, in Vector3d place) => GroundPlace.Raised(simulator.World, in place);

    /// <summary>True when a kick stays on the ground from its start.</summary>
    public bool StaysDown(in Vector3d from, double upwardSpeed) =>
        Upward <= 0 && from.Y <= Game.ContactHeight && Math.Abs(upwardSpeed) < Scene.Ground.MinimumBounceSpeed;

    /// <summary>The closed-form flight of a kick, its coefficients averaged over a way.</summary>
    public FlatFire Model(double speed, double spinRate, double way)
    {
        // Two points of the way, Gauss' for two, from a first drag at launch.
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

    /// <summary>The scene with nothing in it but the ground.</summary>
    public static Scene WithoutThings(Scene scene) => scene with { Obstacles = [], Nets = [], Goals = [], Bodies = null, EngineColliders = null };

    /// <summary>The scene with a plain ground out of reach.</summary>
    public static Scene WithoutGround(Scene scene) => scene with { Ground = Ground.PublishedTurf with { Height = -0.5 * Limits.Length } };
}

/// <summary>How long the steps are in which an aim flies its kicks, s: each as long as its question allows.</summary>
internal readonly struct AimSteps
{
    /// <summary>Miss distance from which on the rough step will do, m.</summary>
    private const double RoughMiss = 5e-4;

    private AimSteps(double search, double hit, double roughHit, double rehearsedHit, bool areShort)
    {
        Search = search;
        Hit = hit;
        RoughHit = roughHit;
        RehearsedHit = rehearsedHit;
        AreShort = areShort;
    }

    /// <summary>With RK4: a search within 1e-4 m, a hit with the drag law's jump located within 1e-5 m, a rough one within 1e-4 m, a rehearsed one within 5e-4 m.</summary>
    public static AimSteps Long => new(search: 0.25, hit: 0.1, roughHit: 0.2, rehearsedHit: 0.3, areShort: false);

    /// <summary>For a kick that grazes the drag law's jump, so that longer steps were wrong about it.</summary>
    public static AimSteps Short => new(search: 0.02, hit: 0.02, roughHit: 0.02, rehearsedHit: 0.02, areShort: true);

    /// <summary>Of flights that only look where a kick goes.</summary>
    public double Search { get; }

    /// <summary>Of flights from which a hit is said.</summary>
    public double Hit { get; }

    /// <summary>True when they are the short ones: longer steps were wrong then.</summary>
    public bool AreShort { get; }

    private double RoughHit { get; }

    private double RehearsedHit { get; }

    /// <summary>Of flights from which a miss distance of a size is to be known.</summary>
    public double HitWithin(double miss) => miss >= RoughMiss ? RoughHit : Hit;

    /// <summary>Of flights that show by how little a rehearsed kick misses, which is then corrected.</summary>
    public double RehearsedWithin(double miss) => miss >= RoughMiss ? RehearsedHit : Hit;
}

/// <summary>The kick that a method found, in its own estimate.</summary>
internal struct AimSolution
{
    public AimStatus Status;
    public Kick Kick;

    /// <summary>Horizontal unit direction of the target, from which the kick's azimuth counts.</summary>
    public Vector3d Forward;

    /// <summary>Speed of the kick, m/s.</summary>
    public double Speed;

    /// <summary>Miss distance at the target, m.</summary>
    public double Miss;

    /// <summary>Miss distance at the point on the way, m.</summary>
    public double ThroughMiss;

    /// <summary>Time to the target, s.</summary>
    public double Time;

    /// <summary>Iterations, where the method counts its own; else 0.</summary>
    public int Iterations;

    /// <summary>Which of the two kicks of its speed it is; null where that is not known yet.</summary>
    public AimArc? Arc;

    /// <summary>Velocity and spin of the kick.</summary>
    public readonly void Vectors(out Vector3d velocity, out Vector3d spin) => Kick.Vectors(Speed, in Forward, out velocity, out spin);
}
