namespace Football.Physics;

/// <summary>What the aiming methods share: the scene compiled for each purpose, and the memory of their flights.</summary>
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

    private readonly Simulator _simulator;

    public AimContext(Scene scene, SolverSettings settings, double timeStep)
    {
        _simulator = new Simulator(scene, SolverSettings.Default);
        Scene = scene;
        Game = new Simulator(scene, settings);
        Upward = Weight.UpwardAcceleration(scene);
        Steps = AimSteps.Long;
        Planes = new PlaneShooter(this, new Simulator(WithoutGround(scene), SolverSettings.Default));
        Approaches = new ApproachShooter(this, _simulator);
        Frames = new FrameShooter(this, Game, timeStep);
        Miss = new MissMeter(_simulator);
    }

    public Scene Scene { get; }

    /// <summary>The scene with the game's own integrator.</summary>
    public Simulator Game { get; }

    /// <summary>Upward acceleration by gravity and buoyancy, m/s².</summary>
    public double Upward { get; }

    /// <summary>Flights without ground, to a plane.</summary>
    public PlaneShooter Planes { get; }

    /// <summary>Flights with ground, to their closest approach.</summary>
    public ApproachShooter Approaches { get; }

    /// <summary>Flights in the game's own frames.</summary>
    public FrameShooter Frames { get; }

    /// <summary>Measures the true miss of a kick.</summary>
    public MissMeter Miss { get; }

    /// <summary>Steps of the flights.</summary>
    public AimSteps Steps { get; set; }

    /// <summary>Forward simulations since the search began.</summary>
    public int Simulations { get; set; }

    /// <summary>Begins a search.</summary>
    public void Begin()
    {
        Simulations = 0;
        Steps = AimSteps.Long;
    }

    /// <summary>The miss distance within which a search ends, m: inside the tolerance, for the longer steps of the flights are a little off.</summary>
    public static double Sharp(double tolerance, double fine = FineMiss) => 0.8 * Math.Min(tolerance, fine);

    /// <summary>The frame of a request, its ball raised to contact height.</summary>
    public TargetFrame Frame(AimRequest request)
    {
        Vector3d from = request.From;
        return new TargetFrame(from.Y < Game.ContactHeight ? new Vector3d(from.X, Game.ContactHeight, from.Z) : from, request.Target);
    }

    /// <summary>Whether a kick stays on the ground from its start.</summary>
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

    /// <summary>The scene with its ground out of reach.</summary>
    private static Scene WithoutGround(Scene scene) => scene with { Ground = scene.Ground with { Height = -0.5 * Limits.Length } };
}
