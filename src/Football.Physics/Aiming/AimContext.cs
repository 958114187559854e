namespace Football.Physics;

/// <summary>What the aiming methods share: the scene compiled for each purpose, and memory for their flights.</summary>
internal sealed class AimContext
{
    /// <summary>No flight is followed for longer, s.</summary>
    public const double LongestFlight = 30;

    /// <summary>Step of the library's own solver, s: with RK4 and the jump located within 1e-5 m.</summary>
    private const double SolverStep = 0.1;

    /// <summary>Its step for a miss that is not asked for more closely than to <see cref="RoughMiss"/>, s: within 1e-4 m.</summary>
    private const double RoughStep = 0.2;

    /// <summary>Miss from which on the rough step will do, m.</summary>
    private const double RoughMiss = 5e-4;

    /// <summary>Step of the library's own solver, s.</summary>
    public double ShortStep => Fine ? FineStep : SolverStep;

    /// <summary>Step of flights that only look where a kick goes, s: within 1e-4 m.</summary>
    private const double CoarseStep = 0.25;

    /// <summary>Step of both where a kick grazes the drag law's jump, so that the coarser ones were wrong, s.</summary>
    private const double FineStep = 0.02;

    /// <summary>Step of the run that measures a miss, s: its own error is below 1e-6 m.</summary>
    private const double JudgeStep = 0.005;

    /// <summary>Ground of the scene without one, m.</summary>
    private const double NoGround = -0.5 * Limits.Length;

    private readonly StepLog _freeLog = new();
    private readonly StepLog _watchedLog = new();
    private readonly StepLog _closeLog = new();
    private readonly StepLog _gameLog = new();
    private readonly Simulator _free;
    private readonly Simulator _judge;
    private readonly ClosestPass _pass;

    public AimContext(Scene scene, SolverSettings settings, double timeStep)
    {
        Scene = scene;
        Game = new Simulator(scene, settings);
        TimeStep = timeStep;
        _judge = new Simulator(scene, SolverSettings.Default);
        _free = new Simulator(scene with { Ground = scene.Ground with { Height = NoGround } }, SolverSettings.Default);
        _pass = new ClosestPass(scene.Air.Wind == Vector3d.Zero);
        Flight = new KickFlight();
        Passes = new PassFlight(_judge);
        Frames = new FrameFlight();
        ThroughFrames = new FrameFlight();
        _watchedLog.Observer = Flight;
        _closeLog.Observer = _pass;
        Upward = Gravity.Acceleration(scene) + Buoyancy.Acceleration(scene);
    }

    public Scene Scene { get; }

    /// <summary>The scene with the game's own integrator.</summary>
    public Simulator Game { get; }

    /// <summary>The game's own step, s.</summary>
    public double TimeStep { get; }

    /// <summary>Upward acceleration by gravity and buoyancy, m/s².</summary>
    public double Upward { get; }

    /// <summary>The last flight without ground.</summary>
    public KickFlight Flight { get; }

    /// <summary>The last flight in the game's frames.</summary>
    public FrameFlight Frames { get; }

    /// <summary>The last flight in the game's frames past a point on the way.</summary>
    public FrameFlight ThroughFrames { get; }

    /// <summary>Flights with ground for their closest approach.</summary>
    public PassFlight Passes { get; }

    /// <summary>Whether the library's own solver takes fine steps.</summary>
    public bool Fine { get; set; }

    /// <summary>Step of flights that only look where a kick goes, s.</summary>
    public double LongStep => Fine ? FineStep : CoarseStep;

    /// <summary>Forward simulations so far.</summary>
    public int Simulations { get; set; }

    /// <summary>The horizontal unit vector from one point to another, and the distance; a fixed direction where they coincide.</summary>
    public static Vector3d Forward(in Vector3d from, in Vector3d to, out double distance)
    {
        Vector3d flat = (to - from).Horizontal;
        distance = flat.Length;
        return distance > 0 ? flat / distance : new Vector3d(0, 0, -1);
    }

    /// <summary>Where the ball starts: raised to contact height.</summary>
    public Vector3d Start(AimRequest request) => request.From.Y < Game.ContactHeight
        ? new Vector3d(request.From.X, Game.ContactHeight, request.From.Z)
        : request.From;

    /// <summary>Whether a kick stays on the ground from its start.</summary>
    public bool StaysDown(in Vector3d from, double upwardSpeed) =>
        Upward <= 0 && from.Y <= Game.ContactHeight && Math.Abs(upwardSpeed) < Scene.Ground.MinimumBounceSpeed;

    /// <summary>Step of a flight to planes, s, from which a miss is to be known.</summary>
    public double StepFor(double miss) => Fine ? FineStep : miss >= RoughMiss ? RoughStep : SolverStep;

    /// <summary>Flies a kick without ground, watched by <see cref="Flight"/>, until its planes are crossed.</summary>
    public void Fly(in Vector3d from, in Vector3d velocity, in Vector3d spin, double timeStep)
    {
        Simulations++;
        Flight.Reset();
        BallState state = _free.Launch(from, velocity, spin);
        double last = LongestFlight - (1e-9 * timeStep);
        bool ended = false;
        _freeLog.Clear();
        while (!ended && state.Time < last)
        {
            // A step that nobody watches is the fastest; one that crosses a plane and has more than one piece is taken again, watched.
            BallState before = state;
            long pieces = _freeLog.Steps;
            ended = _free.StepToImpact(ref state, timeStep, _freeLog);
            if (!Flight.Crosses(in state))
            {
                ended |= Flight.Pass(in state);
            }
            else if (!ended && _freeLog.Steps == pieces + 1)
            {
                ended = Flight.Add(PathPiece.Cubic(in before, in state));
            }
            else
            {
                state = before;
                _watchedLog.Clear();
                ended = _free.StepToImpact(ref state, timeStep, _watchedLog);
            }
        }
    }

    /// <summary>Measures the true miss of a kick.</summary>
    public ClosestPass Judge(AimRequest request, in Vector3d velocity, in Vector3d spin)
    {
        BallState state = _judge.Launch(request.From, velocity, spin);
        _pass.Begin(state.Position, request.Target, request.TargetVelocity, request.Through);
        _closeLog.Clear();
        _judge.Run(ref state, JudgeStep, LongestFlight, StopAt.Impact, _closeLog, null);
        return _pass;
    }

    /// <summary>Flies a kick in the game's own steps, watched by <see cref="Frames"/>.</summary>
    public void FlyFrames(in Vector3d from, in Vector3d velocity, in Vector3d spin, in Vector3d point)
    {
        Simulations++;
        Frames.Begin(in from, in point);
        RunFrames(in from, in velocity, in spin);
    }

    /// <summary>The same, and on the way watched by <see cref="ThroughFrames"/>.</summary>
    public void FlyFramesThrough(in Vector3d from, in Vector3d velocity, in Vector3d spin, in Vector3d through, in Vector3d point)
    {
        Simulations++;
        Frames.Begin(in from, in point);
        ThroughFrames.Begin(in from, in through);
        BallState state = Game.Launch(from, velocity, spin);
        _gameLog.Clear();
        bool passed = false;
        bool ended = false;
        while (!ended && state.Time < LongestFlight)
        {
            ended = Game.StepToImpact(ref state, TimeStep, _gameLog);
            passed = passed || ThroughFrames.Add(in state);
            ended |= Frames.Add(in state) && passed;
        }
    }

    /// <summary>The same until a plane through the point is crossed.</summary>
    public void FlyFramesToPlane(in Vector3d from, in Vector3d velocity, in Vector3d spin, in Vector3d point, in Vector3d normal)
    {
        Simulations++;
        Frames.Begin(in from, in point);
        Frames.WantCrossing(in normal);
        RunFrames(in from, in velocity, in spin);
    }

    private void RunFrames(in Vector3d from, in Vector3d velocity, in Vector3d spin)
    {
        // Step by step: a step that nobody watches is the fastest.
        BallState state = Game.Launch(from, velocity, spin);
        _gameLog.Clear();
        bool ended = false;
        while (!ended && state.Time < LongestFlight)
        {
            ended = Game.StepToImpact(ref state, TimeStep, _gameLog);
            ended |= Frames.Add(in state);
        }
    }

    /// <summary>The closed-form flight of a kick, its coefficients averaged over a way.</summary>
    public FlatFire Model(double speed, double spinRate, double way)
    {
        // Two points of the way, Gauss' for two, from a first drag at launch.
        _judge.AirFactors(speed, spinRate, out double drag, out double lift);
        double perLength = speed > 0 ? drag / speed : 0;
        double early = speed * Elementary.Exp(-0.2113 * perLength * way);
        double late = speed * Elementary.Exp(-0.7887 * perLength * way);
        _judge.AirFactors(early, spinRate, out double drag1, out double lift1);
        _judge.AirFactors(late, spinRate, out double drag2, out double lift2);
        return new FlatFire
        {
            Drag = 0.5 * ((early > 0 ? drag1 / early : 0) + (late > 0 ? drag2 / late : 0)),
            Lift = 0.5 * (lift1 + lift2),
            Upward = Upward,
        };
    }
}
