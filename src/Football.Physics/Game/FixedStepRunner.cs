using FootballPhysics.Contacts;
using FootballPhysics.Game;
using FootballPhysics.Numerics;

namespace FootballPhysics;

/// <summary>Advances one or more balls in fixed steps under variable frame times, and interpolates their poses.</summary>
/// <remarks>All steps have the same length and kicks belong to ticks, so the trajectory is bit-identical at any frame rate. With bodies, this is true only if
/// <see cref="MoveBodies"/> positions them for every step. If you move them once per frame, the frame rate affects the result. Games with their own fixed
/// update call <see cref="Step"/> there and draw <see cref="PoseAt"/>. Other games call <see cref="Advance"/> once per frame and draw <see cref="Position"/>
/// and <see cref="Orientation"/>. A <see cref="Rollback"/> stores the last states. When an input arrives late, it restores an earlier state and resimulates with
/// the kicks in <see cref="Kicks"/>. Steps and drawing do not allocate; a recording and the two logs grow.</remarks>
public sealed partial class FixedStepRunner
{
    /// <summary>The largest <see cref="QuantizationInterval"/>.</summary>
    internal const int MostWireTicks = 1_000_000;

    /// <summary>The maximum number of steps in a frame.</summary>
    internal const double MostSteps = 1e6;

    private readonly FrameClock _clock;
    private readonly MatchRecorder _recorder = new();
    private readonly StepLog _log = new();
    private readonly BallGroup? _group;
    private readonly BallState[] _states;
    private readonly BallState[] _previous;
    private readonly BallState[] _before;
    private MotionSnapshot _motions;
    private Simulator _simulator;
    private long _claim;
    private long _kickTicks = 36_000;
    private int _wireTicks;

    /// <summary>Creates a runner at tick 0 with a ball at rest on the ground at the origin.</summary>
    /// <remarks>The scene is <see cref="Scene.Default"/> and the settings are <see cref="SolverSettings.Default"/>.</remarks>
    /// <inheritdoc cref="FixedStepRunner(Simulator, double, double)"/>
    public FixedStepRunner(double timeStep = 0.01, double maximumFrameTime = 0.25)
        : this(new Simulator(), timeStep, maximumFrameTime)
    {
    }

    /// <summary>Creates a runner at tick 0 with several balls at rest on the ground.</summary>
    /// <remarks>The balls are side by side along x, from the origin. Without ground they start in the air, at height 0.</remarks>
    /// <param name="group">The balls; used by this runner only.</param>
    /// <param name="timeStep">The length of a step, in s; from a millionth of <paramref name="maximumFrameTime"/> to <paramref name="maximumFrameTime"/>; default 0.01.</param>
    /// <param name="maximumFrameTime">The maximum simulated time per frame, in s; above 0, at most 1e12; default 0.25. Excess time is dropped and reported.</param>
    /// <exception cref="ArgumentNullException"><paramref name="group"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public FixedStepRunner(BallGroup group, double timeStep = 0.01, double maximumFrameTime = 0.25)
        : this(Given(group).SimulatorOf(0), group, timeStep, maximumFrameTime)
    {
    }

    /// <summary>Creates a runner at tick 0 with a ball at rest on the ground at the origin.</summary>
    /// <remarks>Without ground, the ball starts in the air, with its centre at the origin.</remarks>
    /// <param name="simulator">The compiled scene.</param>
    /// <param name="timeStep">The length of a step, in s; from a millionth of <paramref name="maximumFrameTime"/> to <paramref name="maximumFrameTime"/>; default 0.01.</param>
    /// <param name="maximumFrameTime">The maximum simulated time per frame, in s; above 0, at most 1e12; default 0.25. Excess time is dropped and reported.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public FixedStepRunner(Simulator simulator, double timeStep = 0.01, double maximumFrameTime = 0.25)
        : this(simulator ?? throw new ArgumentNullException(nameof(simulator)), null, timeStep, maximumFrameTime)
    {
    }

    private FixedStepRunner(Simulator simulator, BallGroup? group, double timeStep, double maximumFrameTime)
    {
        Check.Within(nameof(maximumFrameTime), maximumFrameTime, 0, Limits.Time, exclusiveLow: true);
        Check.Within(nameof(timeStep), timeStep, maximumFrameTime / MostSteps, maximumFrameTime);
        _clock = new FrameClock(timeStep, maximumFrameTime);
        _simulator = simulator;
        _group = group;
        _states = new BallState[group?.Count ?? 1];
        Kicks = new KickLog(64, _states.Length);
        _previous = new BallState[_states.Length];
        _before = new BallState[_states.Length];
        _motions = MotionSnapshot.OfPushed(simulator.World);
        simulator.World.Bodies?.BeginMoves();
        _claim = simulator.World.Bodies?.Claim() ?? 0;
        double x = 0;
        for (int i = 0; i < _states.Length; i++)
        {
            _states[i] = Ball.AtRest(SimulatorOf(i), SimulatorOf(i).OnGround(x, 0));
            x += 2.5 * SimulatorOf(i).Scene.Ball.Radius;
        }

        Array.Copy(_states, _previous, _states.Length);
    }

    private static BallGroup Given(BallGroup group) => group ?? throw new ArgumentNullException(nameof(group));

    /// <summary>Gets or sets the compiled scene; setting it continues the motion in the new scene.</summary>
    /// <remarks>Set it between steps; <see cref="Ball.Simulator"/> describes the effect on the ball. Setting it ends the recording, because a recording has one scene.</remarks>
    /// <exception cref="ArgumentNullException">The value is null; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">It is set while there are several balls; nothing has changed.</exception>
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

            if (value.World.Movers != _simulator.World.Movers && Rollback is not null)
            {
                throw new InvalidOperationException("The new scene has another number of bodies and movable obstacles, and a Rollback is attached to this runner. Use a scene with as many of them as the old one.");
            }

            // Ball.Simulator alone defines how a ball continues in another scene: use it here too.
            var ball = new Ball(_simulator) { State = _states[0] };
            ball.Simulator = value;
            _simulator = value;
            _claim = value.World.Bodies?.Claim() ?? 0;
            _motions = MotionSnapshot.OfPushed(value.World);
            StopRecording();
            Restore(Tick, ball.State);
        }
    }

    /// <summary>The group of several balls; null if there is only one ball.</summary>
    public BallGroup? Group => _group;

    /// <summary>The number of balls.</summary>
    internal int Balls => _states.Length;

    /// <summary>Gets or sets the callback that positions the bodies and engine colliders for a given time.</summary>
    /// <remarks>The callback is called at the start of every step, including resimulated steps, with the ball's clock time in s. It moves the bodies
    /// (<see cref="Scene.Bodies"/>) and engine colliders. Move every body that depends on the ball here, such as a keeper. In the callback, <see cref="Tick"/>
    /// is the tick of the step, and <see cref="State"/> is the ball after the restarts of this tick and before its kicks. Default null: bodies keep moving as last set, and a <see cref="Rollback"/> stores their positions.</remarks>
    public Action<double>? MoveBodies { get; set; }

    /// <summary>Gets or sets the age, in ticks, at which past kicks and restarts are discarded. 1 … 1e15; default 36 000.</summary>
    /// <remarks>Inputs that a rollback or a recording may still need are kept.</remarks>
    /// <exception cref="ArgumentOutOfRangeException">The value is out of range; nothing has changed.</exception>
    public long KickTicks
    {
        get => _kickTicks;
        set
        {
            Check.Within(nameof(KickTicks), value, 1, Limits.Tick);
            _kickTicks = value;
        }
    }

    /// <summary>Gets or sets the interval, in ticks, at which the state is quantised. 0 … 1e6; default 0: never.</summary>
    /// <remarks>The state is rounded to a value that <see cref="Snapshot.QuantizedSize"/> bytes represent exactly, so <see cref="Snapshot.TryWriteQuantized"/> is
    /// lossless at these ticks. Every machine in the match rounds in the same way, even in rollbacks and replays. Position changes by at most 0.5 mm
    /// per component (just above the ground by 1 mm, upwards), velocity by 1 mm/s. Spin changes by less than 0.125 rad/s and rotation by at most
    /// 2.5°. Spin is rounded up or down at random, so that a slow decay is not lost. A ball that the format cannot represent is not rounded: a ball
    /// in a net, on ground that is not level, squeezed between objects, with a knuckle force, or beyond ±128 m, 64 m/s or 512 rad/s.
    /// With several balls, either all are rounded or none. A look-ahead does not round. Set it before you attach a <see cref="Rollback"/> or start a
    /// recording, because both repeat past steps.</remarks>
    /// <exception cref="ArgumentOutOfRangeException">The value is out of range; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">A different value is set while a rollback is attached or a recording runs; nothing has changed.</exception>
    public int QuantizationInterval
    {
        get => _wireTicks;
        set
        {
            Check.Within(nameof(QuantizationInterval), value, 0, MostWireTicks);
            if (value != _wireTicks && Rollback is not null)
            {
                throw new InvalidOperationException("QuantizationInterval cannot change while a Rollback is attached, because resimulated ticks would be rounded differently. Set it before you create the Rollback.");
            }

            if (value != _wireTicks && Recording is not null)
            {
                throw new InvalidOperationException("QuantizationInterval cannot change during a recording, because a replay would round its ticks differently. Call StopRecording first.");
            }

            _wireTicks = value;
        }
    }

    /// <summary>A hash of all settings that must be equal on all machines in a match.</summary>
    /// <remarks>The hash covers the scene and settings of every ball, the step, <see cref="QuantizationInterval"/> and the library version. Send it with the
    /// first message, and reject a peer with a different hash.</remarks>
    public ulong SessionHash => Recording.MatchHash(this);

    /// <summary>The length of a step, in s.</summary>
    public double TimeStep => _clock.TimeStep;

    /// <summary>The number of completed steps; the current state is the state at the start of this tick.</summary>
    public long Tick { get; private set; }

    /// <summary>The state of the first ball at the start of this tick; copy it to take a snapshot.</summary>
    public BallState State => _states[0];

    /// <summary>The velocity of the first ball at the start of this tick, in m/s.</summary>
    public Vector3d Velocity => _states[0].Velocity;

    /// <summary>The angular velocity of the first ball at the start of this tick, in rad/s, world frame.</summary>
    public Vector3d Spin => _states[0].Spin;

    /// <summary>The motion state: airborne, sliding, rolling or at rest.</summary>
    public MotionState Motion => _states[0].Motion;

    /// <summary>The time since <see cref="Place"/> placed the ball, in s; a <see cref="PlaceInput"/> does not restart it.</summary>
    public double Time => _states[0].Time;

    /// <summary>The past and future kicks and restarts, sorted by tick.</summary>
    /// <remarks>An input added for an earlier tick takes effect when the game rolls back to that tick.</remarks>
    public KickLog Kicks { get; }

    /// <summary>The events of the last <see cref="Advance"/> or <see cref="Step"/>, in order.</summary>
    public EventBuffer Events { get; } = new();

    /// <summary>Returns the name of the object that an event reports, such as "ground" or "left post".</summary>
    /// <param name="happened">One of <see cref="Events"/>.</param>
    /// <returns>The name; null if the event has no object of the scene, as when a ball comes to rest or hits another ball.</returns>
    public string? NameOf(in BallEvent happened) => Simulator.NameOf(in happened);

    /// <summary>The time dropped from the last frame, in s; 0 unless the frame was too long.</summary>
    public double DroppedTime => _clock.DroppedTime;

    /// <summary>The total time dropped from all frames so far, in s.</summary>
    public double TotalDroppedTime => _clock.TotalDroppedTime;

    /// <summary>The interpolation fraction between the start of the last step and its end, 0 … 1.</summary>
    public double Fraction => _clock.Fraction;

    /// <summary>The pose in which to draw the ball after <see cref="Advance"/>; at most one step behind the state.</summary>
    public BallPose Pose => PoseAt(Fraction);

    /// <summary>The position at which to draw the ball after <see cref="Advance"/>, in m.</summary>
    public Vector3d Position => Pose.Position;

    /// <summary>The orientation in which to draw the ball after <see cref="Advance"/>.</summary>
    public Quaterniond Orientation => Pose.Orientation;

    /// <summary>The current recording; null if nothing is recorded.</summary>
    public Recording? Recording => _recorder.Recording;

    /// <summary>The rollback that stores the last states; null if there is none.</summary>
    public Rollback? Rollback { get; internal set; }

    /// <summary>The body positions of a recording that is replayed; null if the game positions the bodies.</summary>
    internal PlacementLog? Script { get; set; }

    /// <summary>The last tick in which an engine's colliders moved; −1 if none have moved.</summary>
    internal long EngineMoved => _recorder.EngineMoved;

    /// <summary>The states of all balls at the start of this tick.</summary>
    internal BallState[] States => _states;

    /// <summary>Returns the compiled scene of a ball.</summary>
    internal Simulator SimulatorOf(int ball) => _group is null ? _simulator : _group.SimulatorOf(ball);

    /// <summary>Returns the state of a ball at the start of this tick.</summary>
    /// <param name="ball">The index of the ball, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such ball.</exception>
    public BallState StateOf(int ball)
    {
        Check.Index(nameof(ball), ball, _states.Length);
        return _states[ball];
    }

    /// <summary>Takes as many steps as fit in the frame time; the remainder is carried over to the next frame.</summary>
    /// <param name="frameTime">The time since the last frame, in s; finite, not negative.</param>
    /// <returns>The number of steps taken.</returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="frameTime"/> is negative or not finite; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">A later runner uses the bodies of this scene; nothing has changed.</exception>
    /// <remarks>An exception from a custom force propagates. The runner then stays before the failed step, and the remaining whole steps of the frame are dropped.</remarks>
    public int Advance(double frameTime)
    {
        Check.NotNegative(nameof(frameTime), frameTime);
        _clock.Add(frameTime);
        Events.Clear();
        int steps = 0;
        try
        {
            // Subtract the time only after the step, so that the time of a failed step can still be dropped.
            for (; _clock.HasStep; _clock.Subtract())
            {
                StepOnce();
                steps++;
            }
        }
        catch
        {
            // Drop the remaining steps: otherwise, the next frame would repeat the failed step and the steps after it.
            _clock.DropSteps();
            throw;
        }

        return steps;
    }

    /// <summary>Takes one step, independent of the frame time.</summary>
    /// <remarks>An exception from a custom force propagates; the runner then stays before the step, without events.</remarks>
    /// <exception cref="InvalidOperationException">A later runner uses the bodies of this scene; nothing has changed.</exception>
    public void Step()
    {
        Events.Clear();
        StepOnce();
    }

    /// <summary>Sets the tick and the state, to roll back, join a running match, or move the ball.</summary>
    /// <remarks>All <see cref="Kicks"/> are kept, including those for this tick, so that the following steps can be resimulated. An attached
    /// <see cref="Rollback"/> restarts its history here. To move the ball and discard its kicks, use <see cref="Place"/>. The time carried over to the next
    /// frame is kept too. Interpolation restarts from this state.</remarks>
    /// <param name="tick">The tick; 0 … 1e15.</param>
    /// <param name="state">The state at its start: a copy of <see cref="State"/>, or one from <see cref="Simulator.Launch(Vector3d, Vector3d, Vector3d)"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="tick"/> is out of range, the state's clock is so large that a step would not advance it, or no ball of this scene can have the
    /// state (<see cref="Simulator.Validate"/>). Nothing has changed.</exception>
    /// <exception cref="ArgumentException"><paramref name="state"/> was never launched; nothing has changed.</exception>
    public void Restore(long tick, in BallState state)
    {
        _before[0] = state;
        RestoreAll(tick, _states.Length == 1 ? _before : throw new ArgumentException($"state is of one ball, but the runner has {_states.Length} balls. Call RestoreAll with a state for each.", nameof(state)));
    }

    /// <summary>Sets the tick and the states of all balls.</summary>
    /// <inheritdoc cref="Restore(long, in BallState)"/>
    /// <param name="tick">The tick; 0 … 1e15.</param>
    /// <param name="states">The states at the start of the tick, one per ball, all at the same time.</param>
    /// <exception cref="ArgumentNullException"><paramref name="states"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="tick"/> is out of range, the clock is so large that a step would not advance it, or no ball of this scene can have one of the
    /// states (<see cref="Simulator.Validate"/>). Nothing has changed.</exception>
    /// <exception cref="ArgumentException">The number of states differs from the number of balls, their times differ, or one was never launched. Nothing has changed.</exception>
    public void RestoreAll(long tick, BallState[] states)
    {
        Check.Within(nameof(tick), tick, 0, Limits.Tick);
        Check.Given(nameof(states), states);
        if (states.Length != _states.Length)
        {
            throw new ArgumentException($"states.Length is {states.Length}; allowed: {_states.Length}, one state for each ball.", nameof(states));
        }

        for (int i = 0; i < states.Length; i++)
        {
            ref readonly BallState state = ref states[i];
            Check.Advances(nameof(TimeStep), TimeStep, state.Time);
            BallGroup.CheckState(in state, i, states[0].Time);
            SimulatorOf(i).Validate(in state);
        }

        _simulator.World.Bodies?.MoveClock(Time, states[0].Time, isNew: false);
        GoTo(tick, states);
    }

    /// <summary>Sets the tick and the states; the runner has produced or validated these states itself.</summary>
    internal void GoTo(long tick, BallState[] states)
    {
        // Interpolation must not start at the old position: draw the ball at the new position until the next step.
        Array.Copy(states, _states, _states.Length);
        Array.Copy(states, _previous, _states.Length);
        Tick = tick;
        Kicks.Played = tick;
        _log.Clear();
        Events.Clear();
        Rollback?.Begin(tick);
        _recorder.GoTo(tick, _states);
    }

    /// <summary>Starts a recording at this tick.</summary>
    /// <remarks>Each step adds a state hash; the kicks are in <see cref="Kicks"/>. A rollback rewinds the recording; setting an unrecorded state ends it.</remarks>
    public Recording Record() => _recorder.Start(this);

    /// <summary>Ends the recording, if there is one.</summary>
    public void StopRecording() => _recorder.Stop();

    /// <summary>Makes one step: places the balls, positions the bodies, applies the kicks, and steps; a failed step changes nothing.</summary>
    private void StepOnce()
    {
        // Save everything that a step changes, including its kicks: a failed step must change nothing.
        Array.Copy(_states, _before, _states.Length);
        World world = _simulator.World;
        world.Bodies?.CheckClaim(_claim);
        _motions.Save();
        try
        {
            // 1. Place the balls of this tick's restarts. 2. Position the bodies, which may follow the ball. 3. Apply the kicks. 4. Step.
            for (int i = Kicks.FirstPlaceAt(Tick); i < Kicks.PlaceCount && Kicks.PlaceAt(i).Tick == Tick; i++)
            {
                ref readonly PlaceInput place = ref Kicks.PlaceAt(i);
                place.Apply(SimulatorOf(place.Ball), ref _states[place.Ball]);
            }

            _recorder.MoveBodies(this, world);
            for (int i = Kicks.FirstAt(Tick); i < Kicks.Count && Kicks[i].Tick == Tick; i++)
            {
                ref readonly KickInput kick = ref Kicks[i];
                SimulatorOf(kick.Ball).Kick(ref _states[kick.Ball], kick.Velocity, kick.Spin);
            }

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
            _motions.PutBack();
            throw;
        }

        // The moves of this step are recorded. Later ones are for the next step.
        world.Bodies?.BeginMoves();

        // Quantise within the step, so that hashing, recording and rollback all see the quantised state.
        Tick++;
        Kicks.Played = Tick;
        if (_wireTicks > 0 && Tick % _wireTicks == 0)
        {
            WireForm.Round(this);
        }

        Events.Add(_log.Events);
        Recording?.Add(_states, world);
        Rollback?.Keep(Tick);
        ForgetKicks();
    }

    /// <summary>Removes inputs that can no longer be resimulated.</summary>
    private void ForgetKicks()
    {
        if (Kicks.FirstTick < Tick - _kickTicks)
        {
            // Keep all inputs since the oldest tick to which a rollback or a replay can return.
            long oldest = Tick - _kickTicks;
            oldest = Math.Min(oldest, Rollback?.OldestTick ?? oldest);
            Kicks.RemoveBefore(Math.Min(oldest, Recording?.StartTick ?? oldest));
        }
    }
}
