using FootballPhysics.Contacts;
using FootballPhysics.Numerics;
using FootballPhysics.Scenes;
using FootballPhysics.Simulation;
using FootballPhysics.State;

namespace FootballPhysics;

/// <summary>A scene, validated and compiled for one integrator. Use it to launch, kick and step balls.</summary>
/// <remarks>
/// Any number of balls and threads can share it. If the scene has bodies, obstacles with a mass or engine colliders, only one thread may
/// use it at a time.
/// </remarks>
public sealed partial class Simulator
{
    /// <summary>Maximum number of steps per run. With more steps, the clock could no longer resolve a single step.</summary>
    private const double MostSteps = 1e12;

    private readonly Stepper _stepper;
    private readonly double _contact;
    private readonly World _world;

    /// <summary>True if the scene has custom forces.</summary>

    private readonly bool _isPlain;
    private readonly bool _mayWake;
    private ulong? _sceneHash;

    /// <summary>Validates and compiles a scene.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <param name="settings">The integrator and solver settings; default <see cref="SolverSettings.Default"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is out of range. The message names the field, the value and the
    /// range.</exception>
    public Simulator(Scene? scene = null, SolverSettings? settings = null)
    {
        Scene = scene ?? Scene.Default;
        Settings = settings ?? SolverSettings.Default;
        if (!ReferenceEquals(Scene, Scene.Default))
        {
            // Skip validating the default scene (ProfileTests does), so that the first ball is not delayed.
            Scene.Validate();
        }

        Settings.Validate();
        _stepper = StepperFactory.Create(Scene, Settings);
        LaunchOrientation = Laws.KnuckleForce.Orientation(Scene);
        _contact = Scene.Ground.Height + Scene.Ball.Radius;
        _world = _stepper.World;
        _mayWake = _stepper.MayWake;
        Zones = ZoneWatch.Of(Scene, _world.ThingOfZone(0));
        _isPlain = !Scene.HasOwnForces && Zones is null;
    }

    /// <summary>The scene.</summary>
    public Scene Scene { get; }

    /// <summary>The integrator and solver settings.</summary>
    public SolverSettings Settings { get; }

    /// <summary>The values of the scene that the simulator has replaced, a sentence for each; empty if there are none.</summary>
    /// <remarks>
    /// The only such value is <see cref="IShape.MaximumConcaveCurvature"/> of a custom shape, if samples of its normals show a larger one. Each sentence names
    /// the field, your value and the value used.
    /// </remarks>
    public IReadOnlyList<string> Warnings => HollowSamples.Warnings(Scene);

    /// <summary>The height of the ball's centre on level ground at the origin, in m; −∞ with <see cref="Ground.None"/>.</summary>
    public double ContactHeight => _contact;

    /// <summary>The orientation of a ball that is launched without one: the identity, or random by <see cref="ForceSet.KnuckleSeed"/> if it is set.</summary>
    public Quaterniond LaunchOrientation { get; }

    /// <summary>Launches a ball that has the <see cref="LaunchOrientation"/>.</summary>
    /// <inheritdoc cref="Launch(Vector3d, Vector3d, Vector3d, Quaterniond)"/>
    public BallState Launch(Vector3d position, Vector3d velocity, Vector3d spin) =>
        Launch(position, velocity, spin, LaunchOrientation);

    /// <summary>Launches a ball at time 0.</summary>
    /// <remarks>
    /// A ball below the surface of the ground is raised vertically until it touches the ground.
    /// On the ground, a vertical speed within ± <see cref="Ground.MinimumBounceSpeed"/> (exclusive) starts a slide or a roll without an
    /// event.
    /// A faster downward speed causes an impact at the start of the first step.
    /// </remarks>
    /// <param name="position">The position of the centre, in m; components within ±1e6.</param>
    /// <param name="velocity">The velocity, in m/s; speed at most 1000.</param>
    /// <param name="spin">The spin, in rad/s; at most 10 000.</param>
    /// <param name="orientation">The orientation; it is normalised.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is out of range. The message names the field, the value and the
    /// range.</exception>
    public BallState Launch(Vector3d position, Vector3d velocity, Vector3d spin, Quaterniond orientation)
    {
        Check.Place("launch.position", position);
        Check.Size("launch.velocity", velocity, Limits.Speed, "m/s");
        Check.Size("launch.spin", spin, Limits.Spin, "rad/s");
        Check.Rotation("launch.orientation", orientation);
        return Start(in position, in velocity, in spin, in orientation, 0);
    }

    /// <summary>Launches a ball at a given time. The values are already validated.</summary>
    internal BallState LaunchAt(in Vector3d position, in Vector3d velocity, in Vector3d spin, double time) =>
        LaunchAt(in position, in velocity, in spin, time, LaunchOrientation);

    /// <summary>Launches a ball at a given time, with an orientation. The values are already validated.</summary>
    internal BallState LaunchAt(in Vector3d position, in Vector3d velocity, in Vector3d spin, double time, in Quaterniond orientation) =>
        Start(in position, in velocity, in spin, in orientation, time);

    /// <summary>Launches a ball that has flown before: it keeps its orientation and the distance flown, as after an impact. The values are already validated.</summary>
    internal BallState LaunchOn(in Vector3d position, in Vector3d velocity, in Vector3d spin, double time, in BallState flown)
    {
        BallState state = Start(in position, in velocity, in spin, flown.Orientation, time);
        state.AirDistance = flown.AirDistance;
        return state;
    }

    /// <summary>Launches a ball. The values are already validated.</summary>
    private BallState Start(in Vector3d position, in Vector3d velocity, in Vector3d spin, in Quaterniond orientation, double time)
    {
        BallState state = Flying(in position, in velocity, in spin, in orientation, time);
        Passages.PutInNets(_world, ref state);

        // A surface supports the ball if the ball touches it at a low enough speed. A ball behind the mouth of a goal is inside that goal.
        _stepper.Settle(ref state);
        state.GoalsEntered = Passages.GoalsEnteredAt(_world, state.Position);
        return state;
    }

    /// <summary>Returns a ball in the air, raised out of the ground. Its nets and goals are not set.</summary>
    private BallState Flying(in Vector3d position, in Vector3d velocity, in Vector3d spin, in Quaterniond orientation, double time)
    {
        BallState state = default;
        state.Time = time;
        state.Position = GroundPlace.Raised(_world, in position);
        state.Velocity = velocity;
        state.BaseOrientation = orientation.Normalized();
        state.SetLaunchSpin(in spin);
        state.Motion = MotionState.Airborne;
        return state;
    }

    /// <summary>Throws if no ball in this scene can have this state.</summary>
    /// <remarks>Use it on states read from a file or passed through the C API. A call takes a few nanoseconds.</remarks>
    /// <param name="state">The state.</param>
    /// <exception cref="ArgumentException"><paramref name="state"/> was never launched.</exception>
    /// <exception cref="ArgumentOutOfRangeException">
    /// A value is not finite or is out of range, or the state does not fit this scene: the surface, net or goal of the state does
    /// not exist, or the ball is not on it. The positions of bodies and engine colliders are not checked.
    /// </exception>
    public void Validate(in BallState state)
    {
        if (!StateCheck.Holds(in state) || SceneCheck.Fault(in state, _world) is not null || !_stepper.MayBeClear(in state))
        {
            RefuseState(in state);
        }
    }

    /// <summary>Kicks a ball: sets its velocity and spin, and keeps its position, time and orientation.</summary>
    /// <remarks>A ball in a net stays in the net, on the same side.</remarks>
    /// <param name="state">The ball; unchanged if an exception is thrown.</param>
    /// <param name="velocity">The velocity, in m/s; speed at most 1000.</param>
    /// <param name="spin">The spin, in rad/s; at most 10 000.</param>
    /// <exception cref="ArgumentException"><paramref name="state"/> was never launched.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A value is out of range. The message names the field, the value and the
    /// range.</exception>
    public void Kick(ref BallState state, Vector3d velocity, Vector3d spin)
    {
        BallState.Launched(in state);

        // Do not validate the position, because the ball may have left the range of a launch.
        Check.Size("launch.velocity", velocity, Limits.Speed, "m/s");
        Check.Size("launch.spin", spin, Limits.Spin, "rad/s");
        BallState kicked = Flying(state.Position, in velocity, in spin, state.Orientation, state.Time);
        Passages.Keep(_world, in state, ref kicked);
        _stepper.Settle(ref kicked);
        kicked.GoalsEntered |= Passages.GoalsEnteredAt(_world, kicked.Position);
        state = kicked;
    }

    /// <summary>Places a ball at a given time. The values are already validated.</summary>
    internal BallState Placed(in Vector3d position, in Vector3d velocity, in Vector3d spin, in Quaterniond orientation, double time)
    {
        BallState placed = Start(in position, in velocity, in spin, in orientation, time);

        // If rolling friction cannot hold the ball on a slope or against the wind, the ball rolls away.
        if (placed.Motion == MotionState.Rolling && velocity == Vector3d.Zero && spin == Vector3d.Zero && RestsAt(in placed))
        {
            placed.Motion = MotionState.Rest;
        }

        return placed;
    }

    /// <summary>Transfers a ball from another scene to this one. It keeps its position, its motion, and its nets and goals.</summary>
    /// <param name="old">The simulator of the other scene.</param>
    /// <param name="state">The ball in the other scene.</param>
    internal BallState Continue(Simulator old, in BallState state)
    {
        // This scene determines the motion state, and raises the ball if its ground is higher.
        BallState next = Flying(state.Position, state.Velocity, state.Spin, state.Orientation, state.Time);
        Passages.Carry(old._world, _world, in state, ref next);
        next.AirDistance = Scene.Forces.KnuckleSeed is null ? 0 : state.AirDistance;
        _stepper.Settle(ref next);
        return state.Motion == MotionState.Rest ? AtRest(in next, old._world.HangsInNet(in state)) : next;
    }

    /// <summary>Returns a ball that was at rest in another scene.</summary>
    /// <remarks>It stays at rest if rolling friction or its net also holds it here.</remarks>
    private BallState AtRest(in BallState placed, bool hangs)
    {
        BallState still = placed;
        still.Motion = MotionState.Rest;
        if (hangs && placed.Motion == MotionState.Airborne && placed.Nets != 0)
        {
            still.Carrier = _world.ThingOfNet(_world.NetForces.Deepest(in placed));
            still.SetGroundSpin(Vector3d.Zero);
        }
        else if (placed.Motion != MotionState.Rolling)
        {
            return placed;
        }

        return RestsAt(in still) ? still : placed;
    }

    /// <summary>Advances a ball by one step. Events and counts are added to the log. Does not allocate.</summary>
    /// <remarks>
    /// If drag would overshoot, a step is divided into nearly equal parts. Explicit Euler overshoots if |u| dt ½ρC_D A/m ≥ 1.
    /// For a beach ball at 200 m/s, a step of 20 ms is divided. The parts are counted in <see cref="StepLog.Steps"/>.
    /// If Euler or RK2 would increase a velocity that the Magnus force only turns, those parts are integrated with RK4 instead.
    /// After 8,192 parts the step ends at the current position and is counted in <see cref="StepLog.StalledSteps"/>. No value is clamped.
    /// After an impact, a ball stays on the surface if it would return to it within a microsecond.
    /// </remarks>
    /// <param name="state">The ball.</param>
    /// <param name="dt">The time to advance, in s; 0 … 1e12. It is one step of the integrator, split only at events.</param>
    /// <param name="log">Receives events and counts.</param>
    /// <exception cref="ArgumentOutOfRangeException">
    /// <paramref name="dt"/> is out of range, or a body was moved for a time more than 0.25 s from the ball's time. The ball is unchanged.
    /// </exception>
    /// <exception cref="ArgumentNullException"><paramref name="log"/> is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="state"/> was never launched.</exception>
    /// <exception cref="InvalidOperationException">A custom force is not finite; the message names it. If a custom force throws, the ball
    /// is unchanged.</exception>
    public void Step(ref BallState state, double dt, StepLog log)
    {
        if (!(dt >= 0 && dt <= Limits.Time) || log is null || !state.IsLaunched)
        {
            RefuseStep(dt, log);
        }

        // Check the times of the bodies first, so that the step throws before anything changes.
        _world.Bodies?.CheckTimes(state.Time);
        log!.Halted = false;
        log.StopAt = StopAt.Time;
        log.Pushes = true;
        Take(ref state, dt, log);
    }

    /// <summary>Takes a step. If a custom force throws, the ball is unchanged.</summary>
    private void Take(ref BallState state, double dt, StepLog log)
    {
        // A resting ball that cannot wake: only advance its time.
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

    /// <summary>Takes a step on a copy, because a custom force may throw, and reports zone events.</summary>
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
        BallState.Launched(in state);
        StateCheck.Validate(in state);
        (string field, string value, string allowed) = SceneCheck.Fault(in state, _world)
            ?? ("state.clearUntil", state.ClearUntil.ToString("R", System.Globalization.CultureInfo.InvariantCulture), "a time until which nothing is in the way");
        throw Check.Refusal(field, value, allowed);
    }

    // The last statement always throws, so that the compiler moves the call out of the way of the step.
    private static void RefuseStep(double dt, StepLog? log)
    {
        Check.Within("dt", dt, 0, Limits.Time);
        Check.Given(nameof(log), log);
        throw BallState.NeverLaunched();
    }

    /// <summary>Advances a ball in equal steps until an event or the end of the duration.</summary>
    /// <param name="state">The ball. If an event ends the run, this is its state just after the event.</param>
    /// <param name="timeStep">
    /// The length of a step, in s; above 0, at most 1e12, at least 1e-12 of the duration, and greater than the rounding of the ball's clock. The
    /// last step is shortened.
    /// </param>
    /// <param name="duration">The maximum time to simulate, in s; above 0, at most 1e12.</param>
    /// <param name="stopAt">The event that ends the run.</param>
    /// <param name="log">Receives events and counts.</param>
    /// <param name="afterStep">Called with the ball after every step; default none.</param>
    /// <returns>True if the event ended the run; false if the time ran out.</returns>
    /// <exception cref="ArgumentOutOfRangeException">
    /// A value is out of range, or a body was moved for a time more than 0.25 s from the ball's time. The message names the field, the
    /// value and the range.
    /// </exception>
    /// <exception cref="ArgumentNullException"><paramref name="log"/> is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="state"/> was never launched.</exception>
    public bool Run(ref BallState state, double timeStep, double duration, StopAt stopAt, StepLog log, Action<BallState>? afterStep = null)
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

    /// <summary>All colliders, nets and goals of the scene.</summary>
    internal World World => _world;

    /// <summary>The zones of the scene; null if there are none.</summary>
    internal ZoneWatch? Zones { get; }

    /// <summary>Returns the centre of a ball on the ground, m, for callers that give no position.</summary>
    /// <remarks>Without ground, the height is 0.</remarks>
    internal Vector3d OnGround(double x, double z) => GroundPlace.At(_world, x, z);

    /// <inheritdoc cref="Stepper.Pile"/>
    internal PilePhase Pile => _stepper.Pile;

    /// <inheritdoc cref="Stepper.SearchMargin"/>
    internal double SearchMargin(double speed, double spinRate, double dt) => _stepper.SearchMargin(speed, spinRate, dt);

    /// <inheritdoc cref="Stepper.FliesClear"/>
    internal bool FliesClear(in Vector3d from, in Vector3d to, double duration, double airSpeed, double spinRate) =>
        _stepper.FliesClear(in from, in to, duration, airSpeed, spinRate);

    /// <inheritdoc cref="Stepper.AirFactors"/>
    internal void AirFactors(double speed, double spinRate, out double drag, out double lift) =>
        AirFactors(speed, spinRate, out drag, out lift, out _);

    /// <inheritdoc cref="Stepper.AirFactors"/>
    internal void AirFactors(double speed, double spinRate, out double drag, out double lift, out double decay) =>
        _stepper.AirFactors(speed, spinRate, out drag, out lift, out decay);

    /// <summary>Throws if an argument of a run is out of range.</summary>
    internal static void CheckRun(in BallState state, double timeStep, double duration, StopAt stopAt)
    {
        Check.Within("timeStep", timeStep, 0, Limits.Time, exclusiveLow: true);
        Check.Within("duration", duration, 0, Limits.Time, exclusiveLow: true);
        Check.AtLeast("timeStep", timeStep, duration / MostSteps);
        Check.Defined("stopAt", stopAt, (int)stopAt, 3);
        Check.Advances("timeStep", timeStep, state.Time + duration);
        BallState.Launched(in state);
    }

    /// <summary>Runs with arguments that are already validated.</summary>
    internal bool RunChecked(ref BallState state, double timeStep, double duration, StopAt stopAt, StepLog log, StepCallback? afterStep)
    {
        log.Halted = false;
        log.StopAt = stopAt;
        double end = state.Time + duration;

        // A remainder below a billionth of a step is only rounding error of the clock.
        double last = end - (ContactTolerances.StepRounding * timeStep);
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

    /// <inheritdoc cref="Stepper.RestsAt"/>
    internal bool RestsAt(in BallState state) => _stepper.RestsAt(in state);

    /// <summary>Takes one step, or the part of it up to the first impact.</summary>
    /// <returns>True if an impact ended it.</returns>
    internal bool StepToImpact(ref BallState state, double dt, StepLog log)
    {
        log.Halted = false;
        log.StopAt = StopAt.Impact;
        _stepper.Step(ref state, dt, log);
        return log.Halted;
    }

    /// <summary>Advances a ball by one step, which the log may end early.</summary>
    internal void Advance(ref BallState state, double dt, StepLog log) => Take(ref state, dt, log);

    /// <inheritdoc cref="Stepper.Struck"/>
    internal void Struck(ref BallState s, in Vector3d velocity, in Vector3d spin, in Vector3d n, StepLog log) =>
        _stepper.Struck(ref s, in velocity, in spin, in n, log);

    /// <summary>A hash of everything that determines the ball's path in this scene. Compare the hash between machines.</summary>
    /// <remarks>
    /// The hash covers the scene's values, sampled values of fields defined by code, and the settings. Scenes that differ in any value have different hashes.
    /// Custom forces are included only by their type names.
    /// </remarks>
    /// <exception cref="InvalidOperationException">A custom wind field is not finite.</exception>
    public ulong SceneHash => _sceneHash ??= Simulation.SceneHash.Of(Scene, Settings, _world, this);

    /// <summary>Moves obstacles with a mass (<see cref="Obstacle.Mass"/>) back to their positions at time 0.</summary>
    public void ResetObstacles() => _world.Obstacles.Reset();

    /// <summary>Receives the state after every step of a run.</summary>
    internal delegate void StepCallback(in BallState state);

    // Keep this in its own method: a lambda in Run would allocate a closure even without a callback.
    private static StepCallback Shown(Action<BallState> afterStep) => (in BallState at) => afterStep(at);
}
