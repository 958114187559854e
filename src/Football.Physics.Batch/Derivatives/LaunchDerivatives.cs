namespace FootballPhysics.Batch;

/// <summary>
/// How what becomes of a ball changes with its launch: derivatives by one run, along plain flight by the variational equation, through impacts and the drag
/// law's jump by what they do to it, and through slides, rolls, nets and all else by differences of the steps. Its memory is made once and used again.
/// </summary>
/// <remarks>One a thread. The run itself is the simulator's own, step by step.</remarks>
public sealed class LaunchDerivatives
{
    private readonly TangentObserver _observer;
    private readonly StepDifferences _differences;
    private readonly Simulator.StepCallback _onStep;

    /// <summary>Every event of a run counts.</summary>
    private readonly StepLog _log = new(mostEvents: int.MaxValue) { IgnoresZones = true };
    private BallState _start;
    private int _events;
    private long _pieces;
    private double _timeStep;
    private double _end;
    private double _dt;
    private StopAt _stopAt;

    /// <summary>Makes one for balls of a simulator's scene.</summary>
    /// <param name="simulator">The scene, compiled for the integrator to run with.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    public LaunchDerivatives(Simulator simulator)
    {
        Check.Given(nameof(simulator), simulator);
        Simulator = simulator;
        _observer = TangentObserver.Of(simulator.Scene);
        _differences = new StepDifferences(simulator);
        _onStep = End;
    }

    /// <summary>The simulator.</summary>
    public Simulator Simulator { get; }

    /// <summary>The place at the end by the place of the launch.</summary>
    public Matrix3d PositionByPosition => _observer.Tangent.Block(0, 0);

    /// <summary>The place at the end by the velocity of the launch, s.</summary>
    public Matrix3d PositionByVelocity => _observer.Tangent.Block(0, MotionVector.Velocity);

    /// <summary>The place at the end by the spin of the launch, m s/rad. Without spin it says nothing by the published laws, whose lift is not smooth there.</summary>
    public Matrix3d PositionBySpin => _observer.Tangent.Block(0, MotionVector.Spin);

    /// <summary>The velocity at the end, before the event there, by the place of the launch, 1/s.</summary>
    public Matrix3d VelocityByPosition => _observer.Tangent.Block(MotionVector.Velocity, 0);

    /// <summary>The velocity at the end, before the event there, by the velocity of the launch.</summary>
    public Matrix3d VelocityByVelocity => _observer.Tangent.Block(MotionVector.Velocity, MotionVector.Velocity);

    /// <summary>The velocity at the end, before the event there, by the spin of the launch, m/rad.</summary>
    public Matrix3d VelocityBySpin => _observer.Tangent.Block(MotionVector.Velocity, MotionVector.Spin);

    /// <summary>The time of the end by the place of the launch, s/m; zero where no event ended the run.</summary>
    public Vector3d TimeByPosition { get; private set; }

    /// <summary>The time of the end by the velocity of the launch, s²/m.</summary>
    public Vector3d TimeByVelocity { get; private set; }

    /// <summary>The time of the end by the spin of the launch, s²/rad.</summary>
    public Vector3d TimeBySpin { get; private set; }

    /// <summary>The events of the last run, in order.</summary>
    public EventBuffer Events => _log.Events;

    /// <summary>Runs a ball to an event or a time, and finds how its place there changes with the launch. At an event the place is that at the event, whose time moves too.</summary>
    /// <param name="state">The ball; its motion now is the launch. After an early end it is as it was just after the event.</param>
    /// <param name="timeStep">Length of a step, s; above 0, at most 1e12. The last one is shortened.</param>
    /// <param name="duration">How long to go on at most, s; above 0, at most 1e12.</param>
    /// <param name="stopAt">The event that ends the run.</param>
    /// <returns>True when the event ended the run, false when its time did.</returns>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public bool Run(ref BallState state, double timeStep, double duration, StopAt stopAt)
    {
        Simulator.CheckRun(in state, timeStep, duration, stopAt);
        Start(in state);
        bool ended = Go(ref state, timeStep, duration, stopAt);
        _observer.Finish(in state, ended);
        double[] times = _observer.EventTimes;
        double counts = ended ? 1.0 : 0;
        TimeByPosition = counts * new Vector3d(times[0], times[1], times[2]);
        TimeByVelocity = counts * new Vector3d(times[3], times[4], times[5]);
        TimeBySpin = counts * new Vector3d(times[6], times[7], times[8]);
        return ended;
    }

    /// <summary>Starts at a launch; <see cref="Advance"/> goes on.</summary>
    internal void Start(in BallState state)
    {
        _log.Clear();
        _log.Observer = _observer;
        _observer.Begin(in state, _log);
    }

    /// <summary>Goes on for a time; the derivatives are then those there by the launch.</summary>
    internal void Advance(ref BallState state, double timeStep, double duration)
    {
        Go(ref state, timeStep, duration, StopAt.Time);
        _observer.Finish(in state, ended: false);
    }

    /// <summary>The simulator's own run, step by step.</summary>
    private bool Go(ref BallState state, double timeStep, double duration, StopAt stopAt)
    {
        _timeStep = timeStep;
        _stopAt = stopAt;
        _end = state.Time + duration;
        Begin(in state);
        return Simulator.RunChecked(ref state, timeStep, duration, stopAt, _log, _onStep);
    }

    private void Begin(in BallState start)
    {
        _start = start;
        _events = _log.Events.Count;
        _pieces = _log.Steps;
        double left = _end - start.Time;
        _dt = _timeStep < left ? _timeStep : left;
        _observer.BeginStep(in start, _dt);
    }

    private void End(in BallState end)
    {
        if (_observer.EndStep(in end))
        {
            // A ball at rest on what stands has nothing to do.
            if (_start.Motion != MotionState.Rest || Simulator.World.Moves)
            {
                _differences.Take(_observer.Tangent, in _start, in end, _dt, _stopAt, _log.Events.Span.Slice(_events), _log.Steps - _pieces, _observer.EventTimes);
            }

            _observer.GoOn(in end);
        }

        Begin(in end);
    }
}
