namespace Football.Physics;

/// <summary>Plays a ball in fixed steps under a game's irregular frames, and says where to draw it in between.</summary>
/// <remarks>
/// Every step has the same length, so the trajectory is the same bits whatever the frame rate; kicks belong to ticks, not to frames.
/// Games with a fixed update of their own call <see cref="Step"/> there and draw <see cref="PoseAt"/>; others call
/// <see cref="Advance"/> once a frame and draw <see cref="Position"/> and <see cref="Orientation"/>. A <see cref="Rollback"/> keeps its
/// last states and plays them again where a kick of the past was not known: the kicks in <see cref="Kicks"/> are applied again.
/// Steps and drawing allocate nothing; a recording and the two logs grow.
/// </remarks>
public sealed class FixedStepRunner
{
    /// <summary>Steps that a frame can have at most.</summary>
    internal const double MostSteps = 1e6;

    private readonly Ball _ball;
    private BallState _previous;
    private double _left;

    /// <summary>A ball at rest on the ground at the origin, at tick 0, in <see cref="Scene.Default"/> with <see cref="SolverSettings.Default"/>.</summary>
    /// <inheritdoc cref="FixedStepRunner(Simulator, double, double)"/>
    public FixedStepRunner(double timeStep = 0.01, double maximumFrameTime = 0.25)
        : this(new Simulator(), timeStep, maximumFrameTime)
    {
    }

    /// <summary>A ball at rest on the ground at the origin, at tick 0.</summary>
    /// <param name="simulator">The compiled scene.</param>
    /// <param name="timeStep">Length of a step, s; at least a millionth of <paramref name="maximumFrameTime"/>, at most that; default 0.01.</param>
    /// <param name="maximumFrameTime">The longest frame that is made up for, s; above 0, at most 1e12; default 0.25. What a longer one has beyond it is dropped, and reported.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public FixedStepRunner(Simulator simulator, double timeStep = 0.01, double maximumFrameTime = 0.25)
    {
        Check.Within(nameof(maximumFrameTime), maximumFrameTime, 0, Limits.Time, exclusiveLow: true);
        Check.Within(nameof(timeStep), timeStep, maximumFrameTime / MostSteps, maximumFrameTime);
        TimeStep = timeStep;
        MaximumFrameTime = maximumFrameTime;
        _ball = new Ball(simulator);
        _previous = _ball.State;
    }

    /// <summary>The compiled scene. Setting it between steps goes on in another one, as <see cref="Ball.Simulator"/> does; a recording ends, for it is of one scene.</summary>
    /// <exception cref="ArgumentNullException">The simulator that is set is null; nothing has changed.</exception>
    public Simulator Simulator
    {
        get => _ball.Simulator;
        set
        {
            if (ReferenceEquals(value, _ball.Simulator))
            {
                return;
            }

            _ball.Simulator = value;
            StopRecording();
            Restore(Tick, _ball.State);
        }
    }

    /// <summary>Length of a step, s.</summary>
    public double TimeStep { get; }

    /// <summary>The longest frame that is made up for, s.</summary>
    public double MaximumFrameTime { get; }

    /// <summary>How many steps have been made: the state is the one at the start of this tick.</summary>
    public long Tick { get; private set; }

    /// <summary>The ball at the start of this tick. Copying it is the snapshot.</summary>
    public BallState State => _ball.State;

    /// <summary>Velocity at the start of this tick, m/s.</summary>
    public Vector3d Velocity => _ball.State.Velocity;

    /// <summary>Angular velocity at the start of this tick, rad/s, world frame.</summary>
    public Vector3d Spin => _ball.State.Spin;

    /// <summary>The motion of the ball: in the air, sliding, rolling or at rest.</summary>
    public MotionState Motion => _ball.Motion;

    /// <summary>Time since the ball was placed, s.</summary>
    public double Time => _ball.Time;

    /// <summary>The kicks by tick, those to come included. What is added for an earlier tick counts when the game rolls back that far.</summary>
    public KickLog Kicks { get; } = new();

    /// <summary>The events of all steps of the last <see cref="Advance"/>, or in the last <see cref="Step"/>, in order.</summary>
    public EventBuffer Events { get; } = new();

    /// <summary>Time by which the last frame was cut short, s; 0 but after a hitch.</summary>
    public double DroppedTime { get; private set; }

    /// <summary>Time by which all frames so far were cut short, s.</summary>
    public double TotalDroppedTime { get; private set; }

    /// <summary>How far the frame has got from the last step's start to its end, 0 … 1.</summary>
    public double Fraction => _left / TimeStep;

    /// <summary>Where to draw the ball after <see cref="Advance"/>: one step behind the state at most, in double precision.</summary>
    public BallPose Pose => PoseAt(Fraction);

    /// <summary>Position to draw the ball at after <see cref="Advance"/>, m.</summary>
    public Vector3d Position => Pose.Position;

    /// <summary>Orientation to draw the ball with after <see cref="Advance"/>.</summary>
    public Quaterniond Orientation => Pose.Orientation;

    /// <summary>Where the start, the hashes and the kicks of a match segment go; null when nothing is recorded.</summary>
    public MatchSegment? Recording { get; private set; }

    /// <summary>What keeps its last states; null where nothing does.</summary>
    internal Rollback? History { get; set; }

    /// <summary>Has the ball kicked when this tick's step begins, as player 0. <see cref="Ball.Kick(Vector3d, Vector3d)"/> kicks at once; this waits for the step.</summary>
    /// <param name="velocity">Velocity, m/s; speed at most 1000.</param>
    /// <param name="spin">Spin, rad/s, world frame; at most 10 000.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; nothing has changed.</exception>
    public void QueueKick(Vector3d velocity, Vector3d spin) => Kicks.Add(new KickInput(Tick, velocity, spin));

    /// <summary>Has the ball kicked when this tick's step begins: speed, direction, and spin relative to the direction.</summary>
    /// <param name="speed">Speed, m/s; 0 … 1000.</param>
    /// <param name="direction">Direction of the kick; any length but zero.</param>
    /// <param name="topSpin">Spin about the horizontal axis across the kick, rad/s: positive dips, negative (backspin) lifts.</param>
    /// <param name="sideSpin">Spin about the vertical, rad/s: positive is counter-clockwise seen from above, and bends to the left.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, or <paramref name="topSpin"/> is given to a vertical kick; nothing has changed.</exception>
    public void QueueKick(double speed, Vector3d direction, double topSpin = 0, double sideSpin = 0)
    {
        Check.Within(nameof(speed), speed, 0, Limits.Speed);
        Vector3d unit = KickVectors.Unit(direction);
        QueueKick(speed * unit, KickVectors.Spin(unit, topSpin, sideSpin));
    }

    /// <summary>Has the ball kicked when this tick's step begins, with a kick that was found for it.</summary>
    /// <param name="kick">The kick.</param>
    public void QueueKick(in AimResult kick) => QueueKick(kick.Velocity, kick.Spin);

    /// <summary>Puts the ball down without motion at this tick, at time 0. Above the ground it will fall.</summary>
    /// <remarks>Kicks that wait for this tick or later ones were for the ball where it was: they are forgotten.</remarks>
    /// <param name="position">Position of the centre, m; components within ±1e6. Below contact height it is raised to it.</param>
    /// <exception cref="ArgumentOutOfRangeException">A component is out of range; nothing has changed.</exception>
    public void Place(Vector3d position)
    {
        BallState placed = Ball.AtRest(Simulator, in position);
        Kicks.RemoveFrom(Tick);
        Restore(Tick, in placed);
    }

    /// <summary>Makes as many steps as a frame's time asks for; the rest is kept for the next frame.</summary>
    /// <param name="frameTime">Time since the last frame, s: finite, not negative.</param>
    /// <returns>How many steps were made.</returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="frameTime"/> is negative or not finite; nothing has changed.</exception>
    /// <remarks>What a force of the game's own throws comes through: the runner is then before the step in which it did, and the whole steps that were left of the frame are dropped.</remarks>
    public int Advance(double frameTime)
    {
        Check.NotNegative(nameof(frameTime), frameTime);
        double counted = frameTime < MaximumFrameTime ? frameTime : MaximumFrameTime;
        DroppedTime = frameTime - counted;
        TotalDroppedTime += DroppedTime;
        Events.Clear();
        int steps = 0;
        _left += counted;
        try
        {
            for (; _left >= TimeStep; _left -= TimeStep)
            {
                StepOnce();
                steps++;
            }
        }
        catch
        {
            DropWholeSteps();
            throw;
        }

        return steps;
    }

    /// <summary>Makes one step, whatever the frame's time.</summary>
    /// <remarks>What a force of the game's own throws comes through: the runner is then before the step, without events.</remarks>
    public void Step()
    {
        Events.Clear();
        StepOnce();
    }

    /// <summary>Where to draw the ball at a fraction of the last step.</summary>
    /// <remarks>
    /// The position runs straight from the step's start to its end, through the exact points of the events between, so a bouncing
    /// ball is seen to touch the ground; the orientation turns the shorter way at constant speed, which is right below half a turn a step.
    /// </remarks>
    /// <param name="fraction">0 is the last step's start, 1 its end; what is beyond is limited to it.</param>
    public BallPose PoseAt(double fraction)
    {
        BallState state = _ball.State;
        double span = state.Time - _previous.Time;
        if (!(fraction < 1) || !(span > 0))
        {
            return new BallPose(state.Position, state.Orientation);
        }

        fraction = fraction > 0 ? fraction : 0;
        double time = _previous.Time + (fraction * span);
        double t0 = _previous.Time;
        double t1 = state.Time;
        Vector3d p0 = _previous.Position;
        Vector3d p1 = state.Position;
        for (int i = 0; i < _ball.Events.Count; i++)
        {
            ref readonly BallEvent happened = ref _ball.Events[i];
            if (happened.Time > time)
            {
                t1 = happened.Time;
                p1 = happened.Position;
                break;
            }

            t0 = happened.Time;
            p0 = happened.Position;
        }

        double part = t1 > t0 ? (time - t0) / (t1 - t0) : 1;
        Quaterniond orientation = Slerp.Between(_previous.Orientation, state.Orientation, fraction);
        return new BallPose(p0 + (part * (p1 - p0)), in orientation);
    }

    /// <summary>Goes to a tick with a state: rolls back, joins a match under way, or puts the ball somewhere.</summary>
    /// <remarks>Nothing else changes: <see cref="Kicks"/> stay, those for this tick included, so that what follows is played again; to put the ball elsewhere, <see cref="Place"/> it. The time kept for the next frame stays too. Drawing starts anew from the state.</remarks>
    /// <param name="tick">The tick; 0 … 1e15.</param>
    /// <param name="state">The state at its start: a copy of <see cref="State"/>, or one from <see cref="Simulator.Launch(Vector3d, Vector3d, Vector3d)"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="tick"/> is out of range, or the state's clock stands so high that a step would not move it; nothing has changed.</exception>
    /// <exception cref="ArgumentException"><paramref name="state"/> was never launched; nothing has changed.</exception>
    public void Restore(long tick, in BallState state)
    {
        Check.Within(nameof(tick), tick, 0, Limits.Tick);
        Check.Advances(nameof(TimeStep), TimeStep, state.Time);
        _ball.State = state;
        Tick = tick;
        _previous = state;
        Events.Clear();
        History?.Begin(tick, in state);
        if (Recording is { } recording && !recording.TryRewind(tick, in state))
        {
            Recording = null;
        }
    }

    /// <summary>Starts a recording at this tick: every step adds a hash to it, and the kicks are those of <see cref="Kicks"/>.</summary>
    /// <remarks>A rollback within it rewinds it too; going to a state that is not its own ends it.</remarks>
    public MatchSegment Record()
    {
        Recording = new MatchSegment(TimeStep, Tick, _ball.State, Kicks);
        return Recording;
    }

    /// <summary>Ends the recording, if there is one.</summary>
    public void StopRecording() => Recording = null;

    /// <summary>Drops the whole steps of the time that is left.</summary>
    private void DropWholeSteps()
    {
        double dropped = Math.Floor(_left / TimeStep) * TimeStep;
        _left = Math.Max(0, _left - dropped);
        DroppedTime += dropped;
        TotalDroppedTime += dropped;
    }

    private void StepOnce()
    {
        BallState before = _ball.State;
        try
        {
            for (int i = Kicks.FirstAt(Tick); i < Kicks.Count && Kicks[i].Tick == Tick; i++)
            {
                _ball.Kick(Kicks[i].Velocity, Kicks[i].Spin);
            }

            BallState start = _ball.State;
            _ball.Step(TimeStep);
            _previous = start;
        }
        catch
        {
            _ball.State = before;
            throw;
        }

        Tick++;
        Events.Add(_ball.Events);
        Recording?.Add(Snapshot.Hash(_ball.State));
        History?.Keep(Tick, _ball.State);
    }
}
