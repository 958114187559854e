namespace Football.Physics;

/// <summary>Flies kicks in the game's own steps, as the thesis does, and looks at the frames between them.</summary>
internal sealed class FrameShooter
{
    private readonly AimContext _context;
    private readonly Simulator _simulator;
    private readonly double _timeStep;
    private readonly StepLog _log = new();

    /// <param name="context">Where flights are counted.</param>
    /// <param name="simulator">The scene with the game's own integrator.</param>
    /// <param name="timeStep">The game's own step, s.</param>
    public FrameShooter(AimContext context, Simulator simulator, double timeStep)
    {
        _context = context;
        _simulator = simulator;
        _timeStep = timeStep;
    }

    /// <summary>How the last flight came to the point that it was for.</summary>
    public FrameApproach Target { get; } = new();

    /// <summary>How it came to a point on the way.</summary>
    public FrameApproach Through { get; } = new();

    /// <summary>Flies a kick past a point.</summary>
    public void Fly(in Vector3d from, in Vector3d velocity, in Vector3d spin, in Vector3d point)
    {
        Target.Begin(in from, in point);
        Run(in from, in velocity, in spin);
    }

    /// <summary>The same until a plane through the point is crossed.</summary>
    public void FlyToPlane(in Vector3d from, in Vector3d velocity, in Vector3d spin, in Vector3d point, in Vector3d normal)
    {
        Target.Begin(in from, in point);
        Target.WantCrossing(in normal);
        Run(in from, in velocity, in spin);
    }

    /// <summary>Flies a kick past two points.</summary>
    public void FlyThrough(in Vector3d from, in Vector3d velocity, in Vector3d spin, in Vector3d through, in Vector3d point)
    {
        Target.Begin(in from, in point);
        Through.Begin(in from, in through);
        BallState state = _simulator.Launch(from, velocity, spin);
        _log.Clear();
        bool passed = false;
        bool ended = false;
        while (!ended && state.Time < AimContext.LongestFlight && _log.Steps < AimContext.MostPieces)
        {
            ended = _simulator.StepToImpact(ref state, _timeStep, _log);
            passed = passed || Through.Add(in state);
            ended |= Target.Add(in state) && passed;
        }

        _context.CountSimulation(_log.Steps);
    }

    private void Run(in Vector3d from, in Vector3d velocity, in Vector3d spin)
    {
        // Step by step: a step that nobody watches is the fastest.
        BallState state = _simulator.Launch(from, velocity, spin);
        _log.Clear();
        bool ended = false;
        while (!ended && state.Time < AimContext.LongestFlight && _log.Steps < AimContext.MostPieces)
        {
            ended = _simulator.StepToImpact(ref state, _timeStep, _log);
            ended |= Target.Add(in state);
        }

        _context.CountSimulation(_log.Steps);
    }
}
