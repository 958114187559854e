namespace FootballPhysics;

/// <summary>Plays a ball, or several, in fixed steps under a game's irregular frames, and says where to draw it in between.</summary>
/// <remarks>
/// Every step has the same length, so the trajectory is the same bits whatever the frame rate; kicks belong to ticks, not to frames. Bodies do so where
/// <see cref="MoveBodies"/> puts them there for every step: a game that moves them once a frame moves them at other times for another frame rate.
/// Games with a fixed update of their own call <see cref="Step"/> there and draw <see cref="PoseAt"/>; others call
/// <see cref="Advance"/> once a frame and draw <see cref="Position"/> and <see cref="Orientation"/>. A <see cref="Rollback"/> keeps its
/// last states and plays them again where a kick of the past was not known: the kicks in <see cref="Kicks"/> are applied again.
/// Steps and drawing allocate nothing; a recording and the two logs grow.
/// </remarks>
public sealed partial class FixedStepRunner
{
    /// <summary>The largest <see cref="QuantizationInterval"/>.</summary>
    internal const int MostWireTicks = 1_000_000;

    /// <summary>Steps that a frame can have at most.</summary>
    internal const double MostSteps = 1e6;

    private readonly StepLog _log = new();
    private readonly BallGroup? _group;
    private readonly BallState[] _states;
    private readonly BallState[] _previous;
    private readonly BallState[] _before;
    private RigidMotion[] _motions;
    private Simulator _simulator;
    private long _kickTicks = 36_000;
    private int _wireTicks;
    private double _left;

    /// <summary>A ball at rest on the ground at the origin, at tick 0, in <see cref="Scene.Default"/> with <see cref="SolverSettings.Default"/>.</summary>
    /// <inheritdoc cref="FixedStepRunner(Simulator, double, double)"/>
    public FixedStepRunner(double timeStep = 0.01, double maximumFrameTime = 0.25)
        : this(new Simulator(), timeStep, maximumFrameTime)
    {
    }

    /// <summary>Several balls at rest on the ground, side by side from the origin on along x, at tick 0; in the air, at height 0, if there is no ground.</summary>
    /// <param name="group">The balls; for this runner alone.</param>
    /// <param name="timeStep">Length of a step, s; at least a millionth of <paramref name="maximumFrameTime"/>, at most that; default 0.01.</param>
    /// <param name="maximumFrameTime">The longest frame that is made up for, s; above 0, at most 1e12; default 0.25. What a longer one has beyond it is dropped, and reported.</param>
    /// <exception cref="ArgumentNullException"><paramref name="group"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public FixedStepRunner(BallGroup group, double timeStep = 0.01, double maximumFrameTime = 0.25)
        : this(Given(group).SimulatorOf(0), group, timeStep, maximumFrameTime)
    {
    }

    /// <summary>A ball at rest on the ground at the origin, at tick 0; at the origin itself, in the air, if there is no ground.</summary>
    /// <param name="simulator">The compiled scene.</param>
    /// <param name="timeStep">Length of a step, s; at least a millionth of <paramref name="maximumFrameTime"/>, at most that; default 0.01.</param>
    /// <param name="maximumFrameTime">The longest frame that is made up for, s; above 0, at most 1e12; default 0.25. What a longer one has beyond it is dropped, and reported.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public FixedStepRunner(Simulator simulator, double timeStep = 0.01, double maximumFrameTime = 0.25)
        : this(simulator ?? throw new ArgumentNullException(nameof(simulator)), null, timeStep, maximumFrameTime)
    {
    }

    private FixedStepRunner(Simulator simulator, BallGroup? group, double timeStep, double maximumFrameTime)
    {
        Check.Within(nameof(maximumFrameTime), maximumFrameTime, 0, Limits.Time, exclusiveLow: true);
        Check.Within(nameof(timeStep), timeStep, maximumFrameTime / MostSteps, maximumFrameTime);
        TimeStep = timeStep;
        MaximumFrameTime = maximumFrameTime;
        _simulator = simulator;
        _group = group;
        _states = new BallState[group?.Count ?? 1];
        Kicks = new KickLog(64, _states.Length);
        _previous = new BallState[_states.Length];
        _before = new BallState[_states.Length];
        _motions = new RigidMotion[simulator.World.GivesWay ? simulator.World.Movers : 0];
        double x = 0;
        for (int i = 0; i < _states.Length; i++)
        {
            _states[i] = Ball.AtRest(SimulatorOf(i), SimulatorOf(i).OnGround(x, 0));
            x += 2.5 * SimulatorOf(i).Scene.Ball.Radius;
        }

        Array.Copy(_states, _previous, _states.Length);
    }

    private static BallGroup Given(BallGroup group) => group ?? throw new ArgumentNullException(nameof(group));

    /// <summary>The compiled scene. Setting it between steps goes on in another one, as <see cref="Ball.Simulator"/> does; a recording ends, for it is of one scene.</summary>
    /// <exception cref="ArgumentNullException">The simulator that is set is null; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">It is set where there are several balls; nothing has changed.</exception>
    public Simulator Simulator
    {
        get => _simulator;
        set
        {
            if (ReferenceEquals(value ?? throw new ArgumentNullException(nameof(value)), _simulator))
            {
                return;
            }

            if (_group is not null)
            {
                throw new InvalidOperationException("A runner of several balls cannot change its simulator. Create a new runner instead.");
            }

            if (value.World.Movers != _simulator.World.Movers && History is not null)
            {
                throw new InvalidOperationException("The new scene has another number of bodies and movable obstacles, and a Rollback is attached to this runner. Use a scene with as many of them as the old one.");
            }

            // How a ball goes on in another scene is told by one place alone, Ball.Simulator.
            var ball = new Ball(_simulator) { State = _states[0] };
            ball.Simulator = value;
            _simulator = value;
            _motions = new RigidMotion[value.World.GivesWay ? value.World.Movers : 0];
            StopRecording();
            Restore(Tick, ball.State);
        }
    }

    /// <summary>Several balls; null where there is one.</summary>
    public BallGroup? Group => _group;

    /// <summary>How many balls there are.</summary>
    public int Balls => _states.Length;

    /// <summary>
    /// Puts the game's bodies (<see cref="Scene.Bodies"/>), and its engine's colliders, to where they are at a time of the ball's clock, s: asked once a step, at its start, also
    /// where steps are played again. Default none: bodies stay where the game has put them last, going on as they go; then a <see cref="Rollback"/> keeps where they were.
    /// </summary>
    public Action<double>? MoveBodies { get; set; }

    /// <summary>Kicks of so many ticks ago are forgotten; those that a rollback or a recording may need are kept. 1 … 1e15; default 36 000.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The number that is set is out of range; nothing has changed.</exception>
    public long KickTicks
    {
        get => _kickTicks;
        set
        {
            Check.Within(nameof(KickTicks), value, 1, Limits.Tick);
            _kickTicks = value;
        }
    }

    /// <summary>
    /// Every so many ticks the ball is rounded to what <see cref="Snapshot.QuantizedSize"/> bytes hold, on every machine that plays the match, where it is rolled back and where it is played again: what
    /// <see cref="TryWriteQuantized"/> writes then is the state itself. 0 … 1e6; default 0: never.
    /// </summary>
    /// <remarks>
    /// Then place and velocity change by 0.5 mm (just above the ground by 1 mm, upwards) and 1 mm/s at most in each direction, the spin by less than 0.125 rad/s, up or down by lot so that a slow decay is not lost, and the rotation
    /// by 2.5° at most. A ball that the form does not hold stays as it is: one in a net, on anything but level ground, among things that have just pressed it, with a knuckle force, beyond
    /// ±128 m, 64 m/s or 512 rad/s; of several balls all are rounded, or none. A look-ahead does not round. Setting another number ends a recording.
    /// </remarks>
    /// <exception cref="ArgumentOutOfRangeException">The number that is set is out of range; nothing has changed.</exception>
    public int QuantizationInterval
    {
        get => _wireTicks;
        set
        {
            Check.Within(nameof(QuantizationInterval), value, 0, MostWireTicks);
            if (value != _wireTicks)
            {
                StopRecording();
            }

            _wireTicks = value;
        }
    }

    /// <summary>
    /// Hash of all that two machines must have in common before a match: scene and settings of every ball, step, <see cref="QuantizationInterval"/>, and the version of the library. Send it with the
    /// first message, and refuse who has another.
    /// </summary>
    public ulong SessionHash => Recording.MatchHash(this);

    /// <summary>Length of a step, s.</summary>
    public double TimeStep { get; }

    /// <summary>The longest frame that is made up for, s.</summary>
    public double MaximumFrameTime { get; }

    /// <summary>How many steps have been made: the state is the one at the start of this tick.</summary>
    public long Tick { get; private set; }

    /// <summary>The ball at the start of this tick, the first of several. Copying it is the snapshot.</summary>
    public BallState State => _states[0];

    /// <summary>Velocity at the start of this tick, m/s.</summary>
    public Vector3d Velocity => _states[0].Velocity;

    /// <summary>Angular velocity at the start of this tick, rad/s, world frame.</summary>
    public Vector3d Spin => _states[0].Spin;

    /// <summary>The motion of the ball: in the air, sliding, rolling or at rest.</summary>
    public MotionState Motion => _states[0].Motion;

    /// <summary>Time since the ball was placed, s.</summary>
    public double Time => _states[0].Time;

    /// <summary>The kicks by tick, those to come included. What is added for an earlier tick counts when the game rolls back that far.</summary>
    public KickLog Kicks { get; }

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
    public Recording? Recording { get; private set; }

    /// <summary>Keeper of its last states; null where there is none.</summary>
    internal Rollback? History { get; set; }

    /// <summary>Where the bodies are to be put, of a segment that is played again; null where the game puts them.</summary>
    internal PlacementLog? Script { get; set; }

    /// <summary>The last tick in which an engine's colliders moved; −1 for none.</summary>
    internal long EngineMoved { get; private set; } = -1;

    /// <summary>All balls at the start of this tick.</summary>
    internal BallState[] States => _states;

    /// <summary>The compiled scene of a ball.</summary>
    internal Simulator SimulatorOf(int ball) => _group is null ? _simulator : _group.SimulatorOf(ball);

    /// <summary>One of several balls at the start of this tick.</summary>
    /// <param name="ball">Which, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such ball.</exception>
    public BallState StateOf(int ball)
    {
        Check.Index(nameof(ball), ball, _states.Length);
        return _states[ball];
    }

    /// <summary>Where to draw one of several balls after <see cref="Advance"/>.</summary>
    /// <param name="ball">Which, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such ball.</exception>
    public BallPose PoseOf(int ball) => PoseAt(Fraction, ball);

    /// <summary>Puts the ball down without motion at this tick, at time 0; one of several goes on at the time of all. Above the ground it will fall.</summary>
    /// <remarks>Kicks that wait for this tick or later ones were for the ball where it was: they are forgotten.</remarks>
    /// <param name="position">Position of the centre, m; components within ±1e6. A ball in the ground is raised straight up until it is not.</param>
    /// <param name="ball">Which of several balls; default the first.</param>
    /// <exception cref="ArgumentOutOfRangeException">A component, or the ball, is out of range; nothing has changed.</exception>
    public void Place(Vector3d position, int ball = 0)
    {
        Check.Index(nameof(ball), ball, _states.Length);
        Check.Place("launch.position", position);

        // The balls of a group have one clock; that of a ball alone begins anew, and bodies go on from where they are.
        double time = _group is null ? 0 : Time;
        _simulator.World.Bodies?.MoveClock(Time, time, isNew: true);
        BallState placed = Ball.AtRest(SimulatorOf(ball), in position, time);

        // Kicks of this ball that wait are taken back; those of the other balls stay.
        for (int i = Kicks.FirstAt(Tick); i < Kicks.Count;)
        {
            KickInput kick = Kicks[i];
            i += kick.Ball == ball && Kicks.Remove(kick.Tick, kick.Player, ball) ? 0 : 1;
        }

        Array.Copy(_states, _before, _states.Length);
        _before[ball] = placed;
        GoTo(Tick, _before);
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
            // Time is taken off after the step: where one throws, what it did not get is still there to be dropped.
            for (; _left >= TimeStep; _left -= TimeStep)
            {
                StepOnce();
                steps++;
            }
        }
        catch
        {
            // Else the next frame would try the step that throws, and those behind it, once more.
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

    /// <summary>Goes to a tick with a state: rolls back, joins a match under way, or puts the ball somewhere.</summary>
    /// <remarks>Nothing else changes: <see cref="Kicks"/> stay, those for this tick included, so that what follows is played again; to put the ball elsewhere, <see cref="Place"/> it. The time kept for the next frame stays too. Drawing starts anew from the state.</remarks>
    /// <param name="tick">The tick; 0 … 1e15.</param>
    /// <param name="state">The state at its start: a copy of <see cref="State"/>, or one from <see cref="Simulator.Launch(Vector3d, Vector3d, Vector3d)"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">
    /// <paramref name="tick"/> is out of range, the state's clock stands so high that a step would not move it, or no ball of this scene can have the state (<see cref="Simulator.Validate"/>); nothing has changed.
    /// </exception>
    /// <exception cref="ArgumentException"><paramref name="state"/> was never launched; nothing has changed.</exception>
    public void Restore(long tick, in BallState state)
    {
        _before[0] = state;
        RestoreAll(tick, _states.Length == 1 ? _before : throw new ArgumentException($"state is of one ball, but the runner has {_states.Length} balls. Call RestoreAll with a state for each.", nameof(state)));
    }

    /// <summary>Goes to a tick with the states of all balls.</summary>
    /// <inheritdoc cref="Restore(long, in BallState)"/>
    /// <param name="tick">The tick; 0 … 1e15.</param>
    /// <param name="states">The states at its start, one each, of one time.</param>
    /// <exception cref="ArgumentNullException"><paramref name="states"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">
    /// <paramref name="tick"/> is out of range, the clock stands so high that a step would not move it, or no ball of this scene can have one of the states (<see cref="Simulator.Validate"/>); nothing has changed.
    /// </exception>
    /// <exception cref="ArgumentException">The states are not as many as the balls, or not of one time, or one was never launched; nothing has changed.</exception>
    public void RestoreAll(long tick, BallState[] states)
    {
        Check.Within(nameof(tick), tick, 0, Limits.Tick);
        Check.Given(nameof(states), states);
        if (states.Length != _states.Length)
        {
            throw new ArgumentException($"states.Length is {states.Length}; allowed: {_states.Length}, one state for each ball.", nameof(states));
        }

        // All are looked at before any is set.
        for (int i = 0; i < states.Length; i++)
        {
            ref readonly BallState state = ref states[i];
            Check.Advances(nameof(TimeStep), TimeStep, state.Time);
            BallState.Launched(in state);
            Check.Within("states' time", state.Time, states[0].Time, states[0].Time);
            SimulatorOf(i).Validate(in state);
        }

        _simulator.World.Bodies?.MoveClock(Time, states[0].Time, isNew: false);
        GoTo(tick, states);
    }

    /// <summary>Goes to a tick with states that were the runner's own, or have been looked at.</summary>
    internal void GoTo(long tick, BallState[] states)
    {
        // Where it was before is of no use: until the next step it is drawn where it is put.
        Array.Copy(states, _states, _states.Length);
        Array.Copy(states, _previous, _states.Length);
        Tick = tick;
        _log.Clear();
        Events.Clear();
        History?.Begin(tick);
        if (Recording is { } recording && !recording.TryRewind(tick, Snapshot.Hash(_states)))
        {
            Recording = null;
        }
    }

    /// <summary>Starts a recording at this tick: every step adds a hash to it, and the kicks are those of <see cref="Kicks"/>.</summary>
    /// <remarks>A rollback within it rewinds it too; going to a state that is not its own ends it.</remarks>
    public Recording Record()
    {
        Recording = new Recording(this);
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
        // What a step changes, its kicks included, is kept: one that throws has changed nothing.
        Array.Copy(_states, _before, _states.Length);
        World world = _simulator.World;
        if (_motions.Length > 0)
        {
            world.ReadMotions(_motions);
        }

        try
        {
            // 1. The bodies are where they are at this tick. 2. Its kicks. 3. The step.
            MoveBodiesTo(world);
            for (int i = Kicks.FirstAt(Tick); i < Kicks.Count && Kicks[i].Tick == Tick; i++)
            {
                ref readonly KickInput kick = ref Kicks[i];
                SimulatorOf(kick.Ball).Kick(ref _states[kick.Ball], kick.Velocity, kick.Spin);
            }

            // Drawn from after the kicks on: what they do to the ball belongs to the start of the step.
            Array.Copy(_states, _previous, _states.Length);
            _log.Clear();
            if (_group is null)
            {
                _simulator.Step(ref _states[0], TimeStep, _log);
            }
            else
            {
                _group.Step(_states, TimeStep, _log);
            }
        }
        catch
        {
            Array.Copy(_before, _states, _states.Length);
            if (_motions.Length > 0)
            {
                world.WriteMotions(_motions);
            }

            throw;
        }

        // Rounded as a part of the step: hashes, recording and rollback see what the wire form holds.
        Tick++;
        if (_wireTicks > 0 && Tick % _wireTicks == 0)
        {
            WireForm.Round(this);
        }

        Events.Add(_log.Events);
        if (Recording is not null || History is not null)
        {
            Recording?.Add(_states, world);
            History?.Keep(Tick);
        }

        ForgetKicks();
    }

    /// <summary>The bodies are put where they are at this tick, and who plays it again is told.</summary>
    private void MoveBodiesTo(World world)
    {
        // The game itself comes first: it also says where bodies were at ticks that are played again.
        if (MoveBodies is { } move)
        {
            move(Time);
            world.Engine?.ForgetPushes();
        }
        else if (world.Bodies is { } bodies)
        {
            Script?.Apply(Tick, bodies);
            History?.PutBodies(Tick, bodies);
        }

        // Now they are where this step finds them: only that is of use to who plays it again.
        if (world.Bodies is { } moved)
        {
            History?.KeepBodies(Tick, moved);
            Recording?.Bodies.Record(Tick, moved);
        }

        if (world.Engine is { GreatestSpeed: > 0 })
        {
            EngineMoved = Tick;
            Recording?.MovesEngine();
        }
    }

    /// <summary>Kicks that nobody can play again are forgotten.</summary>
    private void ForgetKicks()
    {
        if (Kicks.Count > 0 && Kicks[0].Tick < Tick - _kickTicks)
        {
            // The oldest tick that a rollback or the recording may still go back to keeps its kicks.
            long oldest = Tick - _kickTicks;
            oldest = Math.Min(oldest, History?.OldestTick ?? oldest);
            Kicks.RemoveBefore(Math.Min(oldest, Recording?.StartTick ?? oldest));
        }
    }
}
