namespace FootballPhysics;

/// <summary>A scene, checked and compiled for one integrator. Any number of balls and threads can share it; a scene with bodies, obstacles that have a mass, or an engine's colliders, one thread at a time.</summary>
public sealed class Simulator
{
    /// <summary>Steps that a run may have: with more of them the clock no longer tells one from the next.</summary>
    private const double MostSteps = 1e12;

    private readonly Stepper _stepper;
    private readonly double _contact;
    private readonly World _world;

    /// <summary>How many things may carry a ball; those of an engine come and go.</summary>

    private readonly bool _hasOwnForces;
    private readonly bool _isPlain;
    private readonly bool _mayWake;
    private ulong? _sceneHash;

    /// <summary>Checks a scene and compiles it.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <param name="settings">How to integrate it; default <see cref="SolverSettings.Default"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public Simulator(Scene? scene = null, SolverSettings? settings = null)
    {
        Scene = scene ?? Scene.Default;
        Settings = settings ?? SolverSettings.Default;
        if (!ReferenceEquals(Scene, Scene.Default))
        {
            // The default is in range (ProfileTests), and a game's first ball need not wait for that.
            Scene.Validate();
        }

        Settings.Validate();
        _stepper = StepperFactory.Create(Scene, Settings);
        _contact = Scene.Ground.Height + Scene.Ball.Radius;
        _world = _stepper.World;
        _mayWake = _stepper.MayWake;
        _hasOwnForces = Scene.HasOwnForces;
        Zones = ZoneWatch.Of(Scene, _world.ThingOfZone(0));
        _isPlain = !_hasOwnForces && Zones is null;
    }

    /// <summary>The scene.</summary>
    public Scene Scene { get; }

    /// <summary>How it is integrated.</summary>
    public SolverSettings Settings { get; }

    /// <summary>Height of the centre of a ball on the ground at the origin of a level pitch, m; −∞ if the ground is <see cref="Ground.None"/>.</summary>
    public double ContactHeight => _contact;

    /// <summary>A ball at the start of its way, without rotation.</summary>
    /// <inheritdoc cref="Launch(Vector3d, Vector3d, Vector3d, Quaterniond)"/>
    public BallState Launch(Vector3d position, Vector3d velocity, Vector3d spin) =>
        Launch(position, velocity, spin, Quaterniond.Identity);

    /// <summary>A ball at the start of its way.</summary>
    /// <remarks>
    /// A ball in the ground is raised straight up, to the least height at which it is not in the ground. On the ground a vertical speed within ± <see cref="Ground.MinimumBounceSpeed"/>
    /// (that bound excluded) starts a slide or a roll without an event; faster down is an impact in the first step, at time 0.
    /// </remarks>
    /// <param name="position">Position of the centre, m; components within ±1e6.</param>
    /// <param name="velocity">Velocity, m/s; speed at most 1000.</param>
    /// <param name="spin">Spin, rad/s; at most 10 000.</param>
    /// <param name="orientation">Orientation; normalised.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public BallState Launch(Vector3d position, Vector3d velocity, Vector3d spin, Quaterniond orientation)
    {
        Check.Place("launch.position", position);
        Check.Size("launch.velocity", velocity, Limits.Speed, "m/s");
        Check.Size("launch.spin", spin, Limits.Spin, "rad/s");
        Check.Rotation("launch.orientation", orientation);
        return Start(in position, in velocity, in spin, in orientation, 0);
    }

    /// <summary>Launches at a time a ball whose numbers are known to be in range.</summary>
    internal BallState LaunchAt(in Vector3d position, in Vector3d velocity, in Vector3d spin, double time) =>
        Start(in position, in velocity, in spin, Quaterniond.Identity, time);

    /// <summary>Launches a ball whose numbers are known to be in range.</summary>
    private BallState Start(in Vector3d position, in Vector3d velocity, in Vector3d spin, in Quaterniond orientation, double time)
    {
        BallState state = Flying(in position, in velocity, in spin, in orientation, time);
        Passages.PutInNets(_world, ref state);

        // Carried, where it touches something slowly enough; and in a goal, where it is behind the mouth of one.
        _stepper.Settle(ref state);
        state.GoalsEntered = Passages.GoalsEnteredAt(_world, state.Position);
        return state;
    }

    /// <summary>A ball in the air, out of the ground, whose nets and goals are not known.</summary>
    private BallState Flying(in Vector3d position, in Vector3d velocity, in Vector3d spin, in Quaterniond orientation, double time)
    {
        BallState state = default;
        state.Time = time;
        state.Position = GroundPlace.Raised(_world, in position);
        state.Velocity = velocity;
        state.BaseOrientation = orientation.Normalized();
        state.SetFlightSpin(spin);
        state.Motion = MotionState.Airborne;
        return state;
    }

    /// <summary>Names of all that an event may tell of, by <see cref="BallEvent.ColliderIndex"/>: the ground first, then obstacles, posts and bars, bodies, nets, goals, zones.</summary>
    public IReadOnlyList<string> Names => _world.Names;

    /// <summary>The name of what an event tells of: an obstacle's, a net's, "ground", "left post", "goal" …; null for none.</summary>
    /// <param name="thing"><see cref="BallEvent.ColliderIndex"/>: an index of this scene; negative for none.</param>
    /// <exception cref="ArgumentOutOfRangeException">The scene has nothing of that index.</exception>
    public string? NameOf(int thing) => thing < 0 ? null : _world.NameOf(thing);

    /// <summary>Refuses a state that no ball of this scene can have: for states that come from elsewhere, from C or from a file. A few nanoseconds.</summary>
    /// <param name="state">The state.</param>
    /// <exception cref="ArgumentOutOfRangeException">
    /// It was never launched, a number of it is not finite or beyond where a ball can get; or it is none of this scene: the ball lies on, or is in, what the scene does not
    /// have, or is not where it says it is. Where bodies and an engine's colliders are is not asked.
    /// </exception>
    public void Validate(in BallState state)
    {
        if (!StateCheck.Holds(in state) || SceneCheck.Fault(in state, _world) is not null || !_stepper.MayBeClear(in state))
        {
            RefuseState(in state);
        }
    }

    /// <summary>Kicks a ball where it is: new velocity and spin, same place, time and orientation. A ball in a net stays in it, on the same side.</summary>
    /// <param name="state">The ball; unchanged when an exception is thrown.</param>
    /// <param name="velocity">Velocity, m/s; speed at most 1000.</param>
    /// <param name="spin">Spin, rad/s; at most 10 000.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public void Kick(ref BallState state, Vector3d velocity, Vector3d spin)
    {
        // The place is the ball's own, wherever it has got to.
        Check.Size("launch.velocity", velocity, Limits.Speed, "m/s");
        Check.Size("launch.spin", spin, Limits.Spin, "rad/s");
        BallState kicked = Flying(state.Position, in velocity, in spin, state.Orientation, state.Time);
        Passages.Keep(_world, in state, ref kicked);
        _stepper.Settle(ref kicked);
        kicked.GoalsEntered |= Passages.GoalsEnteredAt(_world, kicked.Position);
        state = kicked;
    }

    /// <summary>A ball of another scene as it goes on in this one, where it is and as it moves: in the same nets, and as far in the same goals.</summary>
    /// <param name="old">The simulator of the other scene.</param>
    /// <param name="state">The ball there.</param>
    internal BallState Continue(Simulator old, in BallState state)
    {
        // This scene decides what motion that is, and raises the ball where its ground is higher.
        BallState next = Flying(state.Position, state.Velocity, state.Spin, state.Orientation, state.Time);
        Passages.Carry(old._world, _world, in state, ref next);
        next.AirDistance = Scene.Forces.KnuckleSeed is null ? 0 : state.AirDistance;
        next.SqueezeSpeed = state.SqueezeSpeed;
        next.SqueezeUntil = state.SqueezeUntil;
        _stepper.Settle(ref next);
        return state.Motion == MotionState.Rest ? AtRest(in next, old._world.HangsInNet(in state)) : next;
    }

    /// <summary>A ball that was at rest in another scene: at rest where rolling friction, or the net that it hangs in, holds it here too.</summary>
    private BallState AtRest(in BallState placed, bool hangs)
    {
        BallState still = placed;
        still.Motion = MotionState.Rest;
        if (hangs && placed.Motion == MotionState.Airborne && placed.Nets != 0)
        {
            still.Carrier = _world.ThingOfNet(_world.DeepestNet(in placed));
            still.SetGroundSpin(Vector3d.Zero);
        }
        else if (placed.Motion != MotionState.Rolling)
        {
            return placed;
        }

        return RestsAt(in still) ? still : placed;
    }

    /// <summary>Advances a ball. Events and counts are added to the log; nothing is allocated.</summary>
    /// <remarks>
    /// A step in which drag would overshoot, |u| dt ½ρC_D A/m ≥ 1 (for explicit Euler; 20 ms for a beach ball at 200 m/s), is divided into
    /// parts as equal as the changing motion allows, counted in <see cref="StepLog.Steps"/>; where Euler or RK2 would make a velocity longer
    /// that the Magnus force turns, those parts are taken by RK4. A step that has had 8 192 parts ends where the ball is, and is counted in
    /// <see cref="StepLog.StalledSteps"/>. Nothing is ever clamped. A ball that leaves an impact to be back within a microsecond stays down.
    /// </remarks>
    /// <param name="state">The ball.</param>
    /// <param name="dt">Time to advance by, s: 0 … 1e12. All of it is one step of the integrator, split only at events.</param>
    /// <param name="log">Where events and counts are added.</param>
    /// <exception cref="ArgumentOutOfRangeException">
    /// <paramref name="dt"/> is out of range, or a body was moved since the last step for a time more than 0.25 s from the ball's; nothing has changed.
    /// </exception>
    /// <exception cref="ArgumentNullException"><paramref name="log"/> is null.</exception>
    /// <exception cref="InvalidOperationException">A force of the game's own is not finite; the message names it. Whatever such a force throws, nothing has changed.</exception>
    public void Step(ref BallState state, double dt, StepLog log)
    {
        if (!(dt >= 0 && dt <= Limits.Time) || log is null)
        {
            RefuseStep(dt, log);
        }

        // Bodies that were moved for another time refuse the step before anything changes.
        _world.Bodies?.CheckTimes(state.Time);
        log!.Halted = false;
        log.StopAt = StopAt.Time;
        log.Pushes = true;
        Take(ref state, dt, log);
    }

    /// <summary>Takes a step. A force of the game's own may refuse it, and the ball is where it was then.</summary>
    private void Take(ref BallState state, double dt, StepLog log)
    {
        // At rest where nothing can change a step is its time alone.
        if (state.Motion == MotionState.Rest && !_mayWake)
        {
            state.Time += dt;
            return;
        }

        if (_isPlain)
        {
            _stepper.Step(ref state, dt, log);
        }
        else
        {
            TakeCopy(ref state, dt, log);
        }
    }

    /// <summary>Takes a step on a copy, for a custom force may throw within it; and watched by zones.</summary>
    private void TakeCopy(ref BallState state, double dt, StepLog log)
    {
        ZoneWatch? outer = log.Zones;
        ZoneWatch? zones = log.IgnoresZones ? null : Zones;
        BallState next = state;
        try
        {
            zones?.Begin(log, in state);
            _stepper.Step(ref next, dt, log);
            zones?.Moved(log, in next);
        }
        finally
        {
            log.Zones = outer;
        }

        state = next;
    }

    private void RefuseState(in BallState state)
    {
        StateCheck.Validate(in state);
        (string field, string value, string allowed) = SceneCheck.Fault(in state, _world)
            ?? ("state.clearUntil", state.ClearUntil.ToString("R", System.Globalization.CultureInfo.InvariantCulture), "a time until which nothing is in the way");
        throw Check.Refusal(field, value, allowed);
    }

    private static void RefuseStep(double dt, StepLog? log)
    {
        Check.Within("dt", dt, 0, Limits.Time);
        throw new ArgumentNullException(nameof(log));
    }

    /// <summary>Advances a ball in equal steps until an event or a time.</summary>
    /// <param name="state">The ball. After an early end it is as it was just after the event.</param>
    /// <param name="timeStep">
    /// Length of a step, s; above 0, at most 1e12, at least 1e-12 of the duration, and more than the rounding of the ball's clock. The last one is shortened.
    /// </param>
    /// <param name="duration">How long to go on at most, s; above 0, at most 1e12.</param>
    /// <param name="stopAt">The event that ends the run.</param>
    /// <param name="log">Where events and counts are added.</param>
    /// <returns>True when the event ended the run, false when its time did.</returns>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, or a body was moved since the last step for a time more than 0.25 s from the ball's; the message names field, value and range.</exception>
    /// <exception cref="ArgumentNullException"><paramref name="log"/> is null.</exception>
    public bool Run(ref BallState state, double timeStep, double duration, StopAt stopAt, StepLog log) =>
        Run(ref state, timeStep, duration, stopAt, log, null);

    /// <summary>Steps until an event or a time, and shows the ball after every step.</summary>
    /// <param name="state">The ball, as in the other overload.</param>
    /// <param name="timeStep">Length of a step, s, as in the other overload.</param>
    /// <param name="duration">How long to go on at most, s; above 0, at most 1e12.</param>
    /// <param name="stopAt">The event that ends the run.</param>
    /// <param name="log">Where events and counts are added.</param>
    /// <param name="afterStep">Called with the ball after every step; null: nobody is.</param>
    /// <returns>True when the event ended the run, false when its time did.</returns>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, or a body was moved since the last step for a time more than 0.25 s from the ball's; the message names field, value and range.</exception>
    /// <exception cref="ArgumentNullException"><paramref name="log"/> is null.</exception>
    public bool Run(ref BallState state, double timeStep, double duration, StopAt stopAt, StepLog log, Action<BallState>? afterStep)
    {
        CheckRun(in state, timeStep, duration, stopAt);
        if (log is null)
        {
            throw new ArgumentNullException(nameof(log));
        }

        _world.Bodies?.CheckTimes(state.Time);
        log.Pushes = true;
        return RunChecked(ref state, timeStep, duration, stopAt, log, afterStep is null ? null : Shown(afterStep));
    }

    /// <summary>All that can be met.</summary>
    internal World World => _world;

    /// <summary>The zones that watch the ball; null if there are none.</summary>
    internal ZoneWatch? Zones { get; }

    /// <summary>The centre of a ball that lies on the ground, m: where a ball is put if nobody names a place. At height 0 if there is no ground.</summary>
    internal Vector3d OnGround(double x, double z) => GroundPlace.At(_world, x, z);

    /// <inheritdoc cref="Stepper.Pile"/>
    internal PilePhase Pile => _stepper.Pile;

    /// <inheritdoc cref="Stepper.FliesClear"/>
    internal bool FliesClear(in Vector3d from, in Vector3d to, double duration, double airSpeed, double spinRate) =>
        _stepper.FliesClear(in from, in to, duration, airSpeed, spinRate);

    /// <inheritdoc cref="Stepper.AirFactors"/>
    internal void AirFactors(double speed, double spinRate, out double drag, out double lift) =>
        AirFactors(speed, spinRate, out drag, out lift, out _);

    /// <inheritdoc cref="Stepper.AirFactors"/>
    internal void AirFactors(double speed, double spinRate, out double drag, out double lift, out double decay) =>
        _stepper.AirFactors(speed, spinRate, out drag, out lift, out decay);

    /// <summary>Refuses a run whose numbers are out of range.</summary>
    internal static void CheckRun(in BallState state, double timeStep, double duration, StopAt stopAt)
    {
        Check.Within("timeStep", timeStep, 0, Limits.Time, exclusiveLow: true);
        Check.Within("duration", duration, 0, Limits.Time, exclusiveLow: true);
        Check.AtLeast("timeStep", timeStep, duration / MostSteps);
        Check.Defined("stopAt", stopAt, (int)stopAt, 3);
        Check.Advances("timeStep", timeStep, state.Time + duration);
    }

    /// <summary>A run whose numbers have been checked.</summary>
    internal bool RunChecked(ref BallState state, double timeStep, double duration, StopAt stopAt, StepLog log, StepCallback? afterStep)
    {
        log.Halted = false;
        log.StopAt = stopAt;
        double end = state.Time + duration;

        // A remainder of less than a billionth of a step is the clock's rounding.
        double last = end - (1e-9 * timeStep);
        while (state.Time < last)
        {
            double left = end - state.Time;
            Take(ref state, timeStep < left ? timeStep : left, log);
            afterStep?.Invoke(in state);
            if (log.Halted)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>True when a ball is at rest and nothing that is known now will wake it: no force that changes, and nothing that moves.</summary>
    internal bool StaysAtRest(in BallState state) =>
        state.Motion == MotionState.Rest && !(_mayWake && (_world.FastestMover > 0 || _hasOwnForces || Scene.Air.WindField is not null));

    /// <inheritdoc cref="Stepper.RestsAt"/>
    internal bool RestsAt(in BallState state) => _stepper.RestsAt(in state);

    /// <summary>Takes one step, or part of it up to the first impact.</summary>
    /// <returns>True when an impact ended it.</returns>
    internal bool StepToImpact(ref BallState state, double dt, StepLog log)
    {
        log.Halted = false;
        log.StopAt = StopAt.Impact;
        _stepper.Step(ref state, dt, log);
        return log.Halted;
    }

    /// <summary>Advances a ball by one step that its log may end early.</summary>
    internal void Advance(ref BallState state, double dt, StepLog log) => Take(ref state, dt, log);

    /// <inheritdoc cref="Stepper.Struck"/>
    internal void Struck(ref BallState s, in Vector3d velocity, in Vector3d spin, in Vector3d n, StepLog log) =>
        _stepper.Struck(ref s, in velocity, in spin, in n, log);

    /// <inheritdoc cref="Stepper.Displaced"/>
    internal void Displaced(ref BallState s, in Vector3d from, StepLog log) => _stepper.Displaced(ref s, in from, log);

    /// <summary>
    /// A hash of what decides a ball's way: the scene's numbers, the answers of what is code at some places, and the settings. Two machines with the same have the same
    /// scene; of two scenes that differ in a number it differs. Forces of a game's own count by the names of their types alone.
    /// </summary>
    /// <exception cref="InvalidOperationException">A wind of the game's own is not finite.</exception>
    public ulong SceneHash
    {
        get
        {
            _sceneHash ??= FootballPhysics.SceneHash.Of(Scene, Settings, _world, this);
            return _sceneHash.Value;
        }
    }

    /// <summary>Puts obstacles that have a mass (<see cref="Obstacle.Mass"/>), and that the ball has moved, back to where the scene has them at time 0.</summary>
    public void ResetObstacles() => _world.Obstacles.Reset();

    /// <summary>Sees the state after every step of a run.</summary>
    internal delegate void StepCallback(in BallState state);

    // A method of its own: a lambda here would allocate its closure in runs that show nothing too.
    private static StepCallback Shown(Action<BallState> afterStep) => (in BallState at) => afterStep(at);
}
