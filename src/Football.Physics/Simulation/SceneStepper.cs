using System.Runtime.CompilerServices;
using TAir = Football.Physics.SceneAir;

namespace Football.Physics;

/// <summary>
/// A step of the ball in one scene with one method, as a loop over pieces, each by the phase that the ball is in. The whole step of flight in which
/// nothing happens, which most steps are, is <see cref="FlightStepper{TAir, TIntegrator}"/>'s.
/// <list type="number">
/// <item><see cref="FlightPhase{TAir, TIntegrator}"/>: to the drag law's jump, the end of the spin, the ground;</item>
/// <item><see cref="SlidePhase{TAir, TIntegrator}"/>: to the jump, the end of the slip;</item>
/// <item><see cref="RollPhase{TAir, TIntegrator}"/>: to the jump, to rest;</item>
/// <item><see cref="ContactPhase{TAir}"/>: an impact, and what becomes of the ball after it;</item>
/// <item><see cref="CarriedPhase{TAir, TIntegrator}"/>: the slide, the roll on any other surface than the thesis' level pitch;</item>
/// <item><see cref="RestPhase{TAir}"/>: at rest among things, to the first that hits;</item>
/// <item><see cref="ImplicitPhase{TAir}"/>: where the air is too strong for explicit pieces.</item>
/// </list>
/// </summary>
/// <typeparam name="TIntegrator">The one-step method.</typeparam>
internal class SceneStepper<TIntegrator> : Stepper, IFlight
    where TIntegrator : struct, IIntegrator
{
    /// <summary>After so many pieces the length of the parts is chosen anew: what asked for short ones may be over.</summary>
    private const int PiecesOfOneLength = 1024;

    /// <summary>After so many pieces in a row in which the clock stands still, the rest of the step is taken by implicit Euler.</summary>
    private const int MostStanding = 256;

    private readonly Vector3d _wind;
    private readonly double _upward;
    private readonly bool _staysDown;
    private TAir _air;
    private TIntegrator _integrator;
    private readonly FlightPhase<TAir, TIntegrator> _flight;
    private readonly SlidePhase<TAir, TIntegrator> _slide;
    private readonly RollPhase<TAir, TIntegrator> _roll;
    private readonly ImplicitPhase<TAir> _implicit;
    private readonly ClearFlight? _clear;
    private readonly ulong _clearKey;
    private readonly CarriedPhase<TAir, TIntegrator>? _carried;
    private readonly FlatSurfaceStep? _flat;
    private readonly RestPhase<TAir>? _rest;
    private readonly WorldContact<TAir>? _worldContact;
    private readonly BodyPush<TAir>? _bodies;

    public SceneStepper(Scene scene, SolverSettings settings, in TAir air)
    {
        var around = new Surroundings<TAir>(scene, in air);
        Around = around;
        _air = around.Air;
        _integrator = default;
        _wind = around.Wind;
        _upward = around.Upward;
        _staysDown = _upward <= 0 && around.World is null;
        Limit = StabilityLimit.Of(scene, in _air, 0, _upward, _integrator.Order);
        var jump = new DragJumpGuard<TAir>(around, settings.LocateJump && _integrator.Order > 1);
        LocatesJump = jump.Acts;
        var contact = new ContactPhase<TAir>(scene, around);
        World? world = around.World;
        _clear = world is null or { IsLevelGroundAlone: true } ? null : new ClearFlight(world, Limit, StabilityLimit.WithFall(_air.OrdinaryBound, _upward), in _wind, _upward, _integrator.ShareInPath);

        // Where there are bodies, no answer is good for longer than a step.
        _clearKey = _clear is { LooksForBodies: false } ? _clear.Key : 0;
        _worldContact = world is null ? null : new WorldContact<TAir>(around, scene.Ground.IsLevel);
        _bodies = world is { Bodies: not null } or { Engine: not null } ? new BodyPush<TAir>(world, _worldContact!) : null;
        WorldGuard<TAir>? guard = world is null ? null : new WorldGuard<TAir>(world, _worldContact!);
        _implicit = new ImplicitPhase<TAir>(around, contact, guard);
        _carried = guard is null ? null : new CarriedPhase<TAir, TIntegrator>(scene, settings, around, Limit, jump, guard, _worldContact!, _implicit);
        _flat = world is null ? null : new FlatSurfaceStep(scene, settings, around, Limit, world.IsBare ? null : _clear, LocatesJump);
        _rest = guard is null ? null : new RestPhase<TAir>(world!, guard);
        _flight = new FlightPhase<TAir, TIntegrator>(settings, around, this, Limit, jump, contact, _implicit, guard);

        // Friction may speed a ball up faster than gravity does.
        StabilityLimit pushed = StabilityLimit.Of(scene, in _air, 0, Math.Max(Math.Abs(_upward), around.Ground.Sliding), _integrator.Order);
        var ground = new GroundLimit<TAir>(around, in pushed);
        _slide = new SlidePhase<TAir, TIntegrator>(settings, around, in ground, jump, contact, _implicit);
        _roll = new RollPhase<TAir, TIntegrator>(scene, around, in ground, jump, contact, _implicit);
    }

    public override World? World => Around.World;

    /// <summary>What acts on a ball wherever it is.</summary>
    protected Surroundings<TAir> Around { get; }

    /// <summary>How long a piece may be.</summary>
    protected StabilityLimit Limit { get; }

    /// <summary>Whether pieces end where the drag law jumps.</summary>
    protected bool LocatesJump { get; }

    public override void Step(ref BallState s, double dt, StepLog log)
    {
        if (s.Motion is MotionState.Rolling or MotionState.Sliding && _flat is not null && _flat.TryWhole(ref s, dt, log))
        {
            return;
        }

        // A ball lighter than the air may leave the ground, and air that varies may do anything.
        bool done = _staysDown && !_air.Varies
            && ((s.Motion == MotionState.Rolling && _roll.TryWhole(ref s, dt, log))
                || (s.Motion == MotionState.Sliding && _slide.TryWhole(ref s, dt, log)));
        if (!done)
        {
            TakePieces(ref s, dt, log);
        }
    }

    public virtual void Fly(in BallState start, ref FlightMotion motion, in Vector3d wind, DragBranch branch, double upward, double h, out FlightStep step) =>
        _integrator.Fly(ref _air, in start, ref motion, in wind, branch, upward, h, out step);

    public override void Settle(ref BallState s)
    {
        World!.Engine?.Forget();
        _worldContact!.Raise(ref s);
        _worldContact.Settle(ref s);
    }

    public override bool FliesClear(in Vector3d from, in Vector3d to, double duration, double airSpeed, double spinRate) =>
        _clear is null || _clear.HasFlown(in from, in to, duration, airSpeed, spinRate);

    public override void AirFactors(double speed, double spinRate, out double drag, out double lift, out double decay)
    {
        double speedSquared = speed * speed;
        DragBranch branch = DragJump.At(speedSquared, Around.RadiusSquared * spinRate * spinRate).Branch;
        _air.Factors(speedSquared, spinRate, speedSquared, branch, out drag, out lift, out decay);
    }

    /// <summary>Whether a step of flight meets nothing but level ground; |u|² may be a bound of it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    protected bool IsClear(ref BallState s, double dt, double airSpeedSquared) =>
        _clear is null || (s.Time + dt <= s.ClearUntil && s.ClearIn == _clearKey) || _clear.Holds(ref s, dt, airSpeedSquared);

    /// <summary>Shows a whole step of flight to the observer: the ball is at its end, the rest is of its start.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    protected void Show(StepLog log, in BallState s, double time, in Vector3d position, in Vector3d velocity, double spin, in FlightStep step)
    {
        BallState before = s;
        before.Time = time;
        before.Position = position;
        before.Velocity = velocity;
        before.SpinRate = spin;
        Vector3d acceleration = default;
        if (log.Observer!.WantsEndAcceleration)
        {
            FlightRates.Of(ref _air, in s, _upward, in step.AirVelocity, step.SpinRate, out acceleration, out _);
            log.Evaluations++;
        }

        log.Show(in before, in s, in step.StartAcceleration, in acceleration, _integrator.Order);
    }

    /// <summary>A step, piece by piece.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    protected void TakePieces(ref BallState s, double dt, StepLog log)
    {
        if (_air.Varies)
        {
            TakePiecesOrNone(ref s, dt, log);
            return;
        }

        var run = new StepRun(dt, s.Time, log);
        TakePieces(ref s, ref run);
    }

    /// <summary>The same with forces of the game's own, which may throw, or take the ball beyond what a number can hold: then nothing has happened.</summary>
    private void TakePiecesOrNone(ref BallState s, double dt, StepLog log)
    {
        BallState before = s;
        StepLogMark mark = log.Mark();
        try
        {
            var run = new StepRun(dt, s.Time, log);
            TakePieces(ref s, ref run);
            OwnForces.CheckOutcome(in s);
        }
        catch
        {
            s = before;
            log.TakeBack(in mark);
            throw;
        }
    }

    /// <summary>The same, where the whole step has been taken as flight already and something was found in it.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    protected void FinishPieces(ref BallState s, double dt, StepLog log, in FlightStep taken)
    {
        if (_air.Varies)
        {
            TakePieces(ref s, dt, log);
            return;
        }

        var run = new StepRun(dt, s.Time, log);
        _flight.Finish(ref s, ref run, in taken, dt);
        if (!log.Halted)
        {
            TakePieces(ref s, ref run);
        }
    }

    private void TakePieces(ref BallState s, ref StepRun run)
    {
        s.ClearUntil = 0;
        _worldContact?.Raise(ref s);
        _bodies?.Apply(ref s, ref run);
        while (run.Left > 0 && !run.IsWedged && (s.Motion != MotionState.Stopped || _rest is not null))
        {
            if (!run.Begin() || run.Standing > MostStanding)
            {
                _implicit.TakeRest(ref s, ref run);
                continue;
            }

            run.Part = run.Pieces % PiecesOfOneLength == 0 ? 0 : run.Part;
            switch (s.Motion)
            {
                case MotionState.Airborne:
                    _flight.Take(ref s, ref run);
                    break;
                case MotionState.Stopped:
                    _rest!.Take(ref s, ref run);
                    break;
                case MotionState.Sliding or MotionState.Rolling when _carried is not null:
                    _carried.Take(ref s, ref run);
                    break;
                case MotionState.Sliding:
                    _slide.Take(ref s, ref run);
                    break;
                default:
                    _roll.Take(ref s, ref run);
                    break;
            }

            if (run.Log.Halted)
            {
                return;
            }
        }

        s.Time = run.End;
    }
}
