using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>Computes the derivatives of a ball's motion with respect to its launch, in a single run.</summary>
/// <remarks>
/// In free flight, it integrates the variational equation. Impacts and the jump in the drag law contribute their own derivatives. All other motion, such as
/// slides, rolls and nets, is differentiated by finite differences of the steps.
/// <para>The run takes the simulator's own steps. Create one per thread and reuse it: runs do not allocate.</para>
/// </remarks>
public sealed class LaunchDerivatives
{
    private readonly SceneTangent _observer;
    private readonly StepDifferences _differences;
    private readonly Simulator.StepCallback _onStep;

    /// <summary>The log of the run, unbounded because every event counts.</summary>
    private readonly StepLog _log = new(mostEvents: int.MaxValue) { IgnoresZones = true };
    private BallState _start;
    private int _events;
    private long _pieces;
    private double _timeStep;
    private double _end;
    private double _dt;
    private StopAt _stopAt;

    /// <summary>Creates an instance for the balls of a simulator's scene.</summary>
    /// <param name="simulator">The compiled scene; its integrator is used.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    public LaunchDerivatives(Simulator simulator)
    {
        Check.Given(nameof(simulator), simulator);
        Simulator = simulator;
        _observer = new SceneTangent(simulator.Scene);
        _differences = new StepDifferences(simulator);
        _onStep = End;
    }

    /// <summary>The simulator.</summary>
    public Simulator Simulator { get; }

    /// <summary>The derivative of the final position with respect to the launch position.</summary>
    public Matrix3d PositionByPosition => _observer.Tangent.Block(0, 0);

    /// <summary>The derivative of the final position with respect to the launch velocity, in s.</summary>
    public Matrix3d PositionByVelocity => _observer.Tangent.Block(0, MotionVector.Velocity);

    /// <summary>The derivative of the final position with respect to the launch spin, in m s/rad.</summary>
    /// <remarks>Under the published laws it is meaningless without spin, because their lift is not smooth there.</remarks>
    public Matrix3d PositionBySpin => _observer.Tangent.Block(0, MotionVector.Spin);

    /// <summary>The derivative of the final velocity with respect to the launch position, in 1/s.</summary>
    /// <remarks>If an event ends the run, the final velocity is that just before the event.</remarks>
    public Matrix3d VelocityByPosition => _observer.Tangent.Block(MotionVector.Velocity, 0);

    /// <summary>The derivative of the final velocity with respect to the launch velocity.</summary>
    /// <remarks>If an event ends the run, the final velocity is that just before the event.</remarks>
    public Matrix3d VelocityByVelocity => _observer.Tangent.Block(MotionVector.Velocity, MotionVector.Velocity);

    /// <summary>The derivative of the final velocity with respect to the launch spin, in m/rad.</summary>
    /// <remarks>If an event ends the run, the final velocity is that just before the event.</remarks>
    public Matrix3d VelocityBySpin => _observer.Tangent.Block(MotionVector.Velocity, MotionVector.Spin);

    /// <summary>The derivative of the end time with respect to the launch position, in s/m; zero if no event ended the run.</summary>
    public Vector3d TimeByPosition { get; private set; }

    /// <summary>The derivative of the end time with respect to the launch velocity, in s²/m.</summary>
    public Vector3d TimeByVelocity { get; private set; }

    /// <summary>The derivative of the end time with respect to the launch spin, in s²/rad.</summary>
    public Vector3d TimeBySpin { get; private set; }

    /// <summary>The events of the last run, in order of time.</summary>
    public EventBuffer Events => _log.Events;

    /// <summary>Runs a ball to an event or a time, and computes the derivatives with respect to its launch.</summary>
    /// <remarks>If an event ends the run, the derivatives are those at the event, and include the change in its time.</remarks>
    /// <param name="state">The ball, whose current motion is the launch. If an event ends the run, this is the state just after the event.</param>
    /// <param name="timeStep">The length of a step, in s; above 0, at most 1e12. The last step is shortened.</param>
    /// <param name="duration">The longest run, in s; above 0, at most 1e12.</param>
    /// <param name="stopAt">The event that ends the run.</param>
    /// <returns>True if the event ended the run; false if the time ran out.</returns>
    /// <exception cref="ArgumentException"><paramref name="state"/> was never launched.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public bool Run(ref BallState state, double timeStep, double duration, StopAt stopAt)
    {
        Simulator.CheckRun(in state, timeStep, duration, stopAt);
        _log.Clear();
        _log.Observer = _observer;
        _observer.Begin(in state, _log);
        _timeStep = timeStep;
        _stopAt = stopAt;
        _end = state.Time + duration;
        Begin(in state);
        bool ended = Simulator.RunChecked(ref state, timeStep, duration, stopAt, _log, _onStep);
        _observer.Finish(in state, ended);
        double[] times = _observer.EventTimes;
        double counts = ended ? 1.0 : 0;
        TimeByPosition = counts * new Vector3d(times[0], times[1], times[2]);
        TimeByVelocity = counts * new Vector3d(times[3], times[4], times[5]);
        TimeBySpin = counts * new Vector3d(times[6], times[7], times[8]);
        return ended;
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
            // Skip a ball at rest if nothing moves.
            if (_start.Motion != MotionState.Rest || Simulator.World.Moves)
            {
                _differences.Take(_observer.Tangent, in _start, in end, _dt, _stopAt, _log.Events.Span.Slice(_events), _log.Steps - _pieces, _observer.EventTimes);
            }

            _observer.GoOn(in end);
        }

        Begin(in end);
    }
}
