using System.Runtime.CompilerServices;

namespace FootballPhysics;

/// <summary>
/// A step of the ball in one scene with one method, as a loop over pieces, each by the phase that the ball is in. The whole step of flight in which
/// nothing happens, which most steps are, is <see cref="FlightStepper{TAir, TIntegrator}"/>'s.
/// <list type="number">
/// <item><see cref="FlightPhase{TIntegrator}"/>: to the drag law's jump, the end of the spin, what is met;</item>
/// <item><see cref="FlatSurfaceStep{TAir}"/>: a whole step of a slide, a roll on flat ground in which nothing happens;</item>
/// <item><see cref="LineStep{TAir}"/>: the same of a roll, or a spin, between stationary surfaces;</item>
/// <item><see cref="SurfacePhase{TIntegrator}"/>: a slide, a roll on any surface, to the jump, the end of the slip, rest, what is met;</item>
/// <item><see cref="ContactSetPhase{TIntegrator}"/>: the same on several surfaces at once;</item>
/// <item><see cref="ContactSetParts"/>: where that has no answer, and between things that squeeze the ball;</item>
/// <item><see cref="WorldContact"/>: an impact, and what becomes of the ball after it;</item>
/// <item><see cref="RestPhase"/>: at rest among what moves, to the first that hits.</item>
/// </list>
/// </summary>
/// <typeparam name="TIntegrator">The one-step method.</typeparam>
internal class SceneStepper<TIntegrator> : Stepper, IFlight
    where TIntegrator : struct, IIntegrator
{
    private readonly Vector3d _wind;
    private readonly double _upward;
    private SceneAir _air;
    private TIntegrator _integrator;
    private readonly FlightPhase<TIntegrator> _flight;
    private readonly ClearFlight? _clear;
    private readonly ulong _clearKey;
    private readonly SurfacePhase<TIntegrator> _surface;
    private readonly StabilityLimit _pulled;
    private LineStep? _line; // null if they do not cover the scene
    private FlatSurfaceStep? _flat; // null where forces turn the axis of the spin: nothing is compiled for those
    private readonly ContactSetParts _parts;
    private readonly RestPhase _rest;
    private readonly KnownRests? _rests; // null if something may wake a ball although nothing moves, or if nothing wakes it
    private readonly WorldContact _contact;
    private readonly BodyPush? _bodies;
    private readonly Displacement _displacement;

    public SceneStepper(Scene scene, SolverSettings settings, in SceneAir air)
    {
        var around = new Surroundings(scene, in air);
        Around = around;
        _air = around.Air;
        _integrator = default;
        _wind = around.Wind;
        _upward = around.Upward;
        Limit = StabilityLimit.Of(scene, in _air, 0, _upward, _integrator.Order);

        // A step across the jump is of first order: a method of that order gains nothing by locating it.
        var jump = new DragJumpGuard(around, settings.LocateJump && _integrator.Order > 1);
        LocatesJump = jump.Acts;
        World world = around.World;
        double weight = around.Weight.Length;
        _clear = world.IsLevelGroundAlone ? null : new ClearFlight(world, Limit, StabilityLimit.WithFall(_air.OrdinaryBound, weight), in _wind, weight, _integrator.ShareInPath);

        // Where there are bodies, no answer is good for longer than a step.
        _clearKey = _clear is { LooksForBodies: false } ? _clear.Key : 0;
        _contact = new WorldContact(around, _integrator.GainsByHops);
        var guard = new WorldGuard(world, _contact, settings);
        _displacement = new Displacement(world, guard);
        _bodies = world is { Bodies: not null } or { Engine: not null } ? new BodyPush(world, _displacement, _contact) : null;

        // Friction may speed a ball up faster than gravity does.
        double pull = weight * Math.Max(1.0, world.LargestFriction);
        _pulled = StabilityLimit.Of(scene, in _air, 0, pull, _integrator.Order);
        _parts = new ContactSetParts(around, jump, guard, _displacement, _contact);
        var set = new ContactSetPhase<TIntegrator>(around, in _pulled, jump, guard, _contact, _parts);
        _surface = new SurfacePhase<TIntegrator>(scene, settings, around, _pulled, jump, guard, _contact, set);
        _rest = new RestPhase(around, guard, _contact, jump);
        _rests = _rest.IsWokenByMotion ? new KnownRests(world) : null;
        Pile = new PilePhase(around, in _pulled, _integrator, guard, _contact);
        _flight = new FlightPhase<TIntegrator>(around, this, Limit, jump, guard, _contact);
    }

    public override World World => Around.World;

    public override bool MayWake => _rest.MayWake;

    public override bool RestsAt(in BallState s)
    {
        BallState entered = s;
        World.Enter(ref entered);
        return _rest.Holds(in entered);
    }

    public override PilePhase Pile { get; }

    /// <summary>Forces on a ball wherever it is.</summary>
    protected Surroundings Around { get; }

    /// <summary>How long a piece may be.</summary>
    protected StabilityLimit Limit { get; }

    /// <summary>True when pieces end where the drag law jumps.</summary>
    protected bool LocatesJump { get; }

    public override void Step(ref BallState s, double dt, StepLog log)
    {
        // A whole step on flat ground, or on several surfaces, if nothing happens in it; otherwise piece by piece. An engine's carrier has a place among the colliders only in a step.
        if (!(s.Motion is MotionState.Rolling or MotionState.Sliding
            && ((_flat is not null && _flat.TryWhole(ref s, dt, s.Time + dt, log)) || (_line is not null && World.Engine is null && _line.TryWhole(ref s, dt, s.Time + dt, log)))))
        {
            TakePieces(ref s, dt, log, WholeFlight.NotTaken, default);
        }
    }

    /// <summary>Compiles the whole steps on flat ground for an air.</summary>
    protected void TakeWholeSteps<TAir>(Scene scene, SolverSettings settings, in TAir air)
        where TAir : struct, IFlightAir
    {
        _flat = new FlatSurfaceStep<TAir>(scene, settings, Around, in air, in _pulled, World.IsBare ? null : _clear, LocatesJump);
        _line = LineStep<TAir>.Covers(Around, _integrator.Order) ? new LineStep<TAir>(Around, in air, in _pulled, _integrator.Order) : null;
    }

    public virtual void Fly(in BallState start, ref FlightMotion motion, in Vector3d wind, DragBranch branch, double upward, double h, out FlightStep step) =>
        _integrator.Fly(ref _air, in start, ref motion, in wind, branch, upward, h, out step);

    public override void Settle(ref BallState s)
    {
        World.Enter(ref s);
        _contact.Raise(ref s);
        _contact.Settle(ref s);
        World.Exit(ref s);
    }

    public override void Struck(ref BallState s, in Vector3d velocity, in Vector3d spin, in Vector3d n, StepLog log)
    {
        int first = log.Events.Count;
        World.Enter(ref s);
        var run = new StepRun(0, s.Time, log);
        _contact.Struck(ref s, in velocity, in spin, in n, ref run);
        run.Close();
        Exit(ref s, log.Events, first);
    }

    public override void Displaced(ref BallState s, in Vector3d from, StepLog log)
    {
        var run = new StepRun(0, s.Time, log);
        _displacement.Follow(ref s, in from, ref run);
        log.Zones?.Moved(log, in s);
    }

    public override bool FliesClear(in Vector3d from, in Vector3d to, double duration, double airSpeed, double spinRate) =>
        _clear is null || _clear.HasFlown(in from, in to, duration, airSpeed, spinRate);

    public override bool MayBeClear(in BallState s) => !(s.ClearUntil > s.Time) || _clear is null || s.ClearIn != _clear.Key || _clear.MayBeFree(in s);

    public override void AirFactors(double speed, double spinRate, out double drag, out double lift, out double decay)
    {
        double speedSquared = speed * speed;
        DragBranch branch = DragJump.At(speedSquared, Around.RadiusSquared * spinRate * spinRate).Branch;
        _air.Factors(speedSquared, spinRate, speedSquared, branch, out drag, out lift, out decay);
    }

    /// <summary>True when a step of flight meets nothing but level ground; |u|² may be a bound of it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    protected bool IsClear(ref BallState s, double dt, double airSpeedSquared) =>
        _clear is null || (s.Time + dt <= s.ClearUntil && s.ClearIn == _clearKey) || _clear.Holds(ref s, dt, airSpeedSquared);

    /// <summary>Shows a whole step of flight to all that watch: the ball is at its end, the rest is of its start.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    protected void Show(StepLog log, in BallState s, double time, in Vector3d position, in Vector3d velocity, double spin, in FlightStep step)
    {
        BallState before = s;
        before.Time = time;
        before.Position = position;
        before.Velocity = velocity;
        before.SpinRate = spin;
        Vector3d acceleration = default;
        if (log.WantsEnd(in before, in s, in step.StartAcceleration))
        {
            FlightRates.Of(ref _air, in s, _upward, in step.AirVelocity, step.SpinRate, out acceleration, out _);
            log.Evaluations++;
        }

        log.Show(in before, in s, in step.StartAcceleration, in acceleration, _integrator.Order);
    }

    /// <summary>A whole step of flight, done if nothing happens in it.</summary>
    /// <param name="s">The ball, in the air.</param>
    /// <param name="dt">Its length, s.</param>
    /// <param name="end">When it ends, s.</param>
    /// <param name="log">Where counts are added.</param>
    /// <param name="step">What was taken, where something happens in it.</param>
    protected virtual WholeFlight TryWhole(ref BallState s, double dt, double end, StepLog log, out FlightStep step)
    {
        step = default;
        return WholeFlight.NotTaken;
    }

    /// <summary>A step, piece by piece. A force of the game's own may throw, or take the ball beyond what a number can hold: then nothing has happened.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="log">Where events and counts are added.</param>
    /// <param name="whole">Whether the whole step has been taken as flight already, and something was found in it.</param>
    /// <param name="taken">Then that.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    protected void TakePieces(ref BallState s, double dt, StepLog log, WholeFlight whole, in FlightStep taken)
    {
        if (!_air.Varies)
        {
            if (s.Motion == MotionState.Rest && _rests is not null)
            {
                TakeRest(ref s, dt, log);
            }
            else
            {
                TakeAll(ref s, dt, log, whole, in taken);
            }

            return;
        }

        BallState before = s;
        StepLogMark mark = log.Mark();
        try
        {
            TakeAll(ref s, dt, log, WholeFlight.NotTaken, in taken);
            OwnForces.CheckOutcome(in s);
        }
        catch
        {
            s = before;
            log.TakeBack(in mark);
            throw;
        }
    }

    /// <summary>A step of a ball at rest: only its time goes on if an earlier step has found that nothing changes it, and nothing has moved since.</summary>
    private void TakeRest(ref BallState s, double dt, StepLog log)
    {
        if (_rests!.Has(in s))
        {
            s.Time += dt;
            return;
        }

        BallState before = s;
        long reported = Reported(log);
        TakeAll(ref s, dt, log, WholeFlight.NotTaken, default);
        if (dt > 0 && Reported(log) == reported)
        {
            _rests.Learn(in before, in s);
        }
    }

    private static long Reported(StepLog log) => log.Events.Count + log.Events.Dropped + log.UnreportedImpacts + log.StalledSteps;

    private void TakeAll(ref BallState s, double dt, StepLog log, WholeFlight whole, in FlightStep taken)
    {
        World.Enter(ref s);
        var run = new StepRun(dt, s.Time, log);

        // What was already taken as flight is cut at what happens in it.
        if (whole == WholeFlight.Ends)
        {
            _flight.Finish(ref s, ref run, in taken, dt);
        }

        // Depenetration: out of the ground, and out of bodies that the game has put over the ball.
        if (!log.Halted)
        {
            s.ClearUntil = 0;
            _contact.Raise(ref s);
            _bodies?.Apply(ref s, ref run);
            if (World.Moves)
            {
                _contact.TakeJump(ref s, ref run);
            }

            log.Zones?.Moved(log, in s);
        }

        // The first piece was tried as a whole step already where it is not one's end.
        bool isTried = whole == WholeFlight.NotTaken;
        while (!log.Halted && run.Left > 0 && (s.Motion != MotionState.Rest || _rest.MayWake))
        {
            if (!run.Begin())
            {
                // So that every step ends: the ball stays where it is for the rest of it.
                log.StalledSteps++;
                break;
            }

            // What was free ahead was so before this.
            s.ClearUntil = 0;
            switch (s.Motion)
            {
                case MotionState.Airborne:
                    TakeFlight(ref s, ref run, isTried);
                    break;
                case MotionState.Rest:
                    _rest.Take(ref s, ref run);
                    break;
                case MotionState.Pinned:
                    _parts.TakeSqueezed(ref s, ref run);
                    break;
                default:
                    TakeSurface(ref s, ref run, isTried);
                    break;
            }

            isTried = false;
        }

        // The clock ends where the step does; the pieces add up to that but for rounding.
        if (!log.Halted)
        {
            s.Time = run.End;
        }

        // A slip that the carrier's jump began, and that lasts.
        if (run.Jumped && s.Motion == MotionState.Sliding)
        {
            _contact.StartSliding(ref s, ref run);
        }

        run.Close();

        // Where events were dropped meanwhile those of the step have moved up.
        Exit(ref s, log.Events, log.Events.Dropped > 0 ? 0 : run.FirstEvent);
    }

    /// <summary>Ends a step: in the state and in its events an engine's collider is called by its number.</summary>
    private void Exit(ref BallState s, EventBuffer events, int firstEvent)
    {
        World.Exit(ref s);
        for (int i = firstEvent; World.Engine is not null && i < events.Count; i++)
        {
            int number = World.Engine.NumberOf((long)events[i].ColliderIndex - World.FirstCollider);
            if (number >= 0)
            {
                events.Call(i, number);
            }
        }
    }

    /// <summary>The next piece of a flight: what is left of the step is a whole step again, if nothing happens in it.</summary>
    private void TakeFlight(ref BallState s, ref StepRun run, bool isTried)
    {
        FlightStep taken = default;

        // Not where the step was divided, nor for a ball that level ground holds.
        WholeFlight whole = isTried || run.Part > 0 || _flight.IsHeld(in s) ? WholeFlight.NotTaken : TryWhole(ref s, run.Left, run.End, run.Log, out taken);
        switch (whole)
        {
            case WholeFlight.Done:
                run.Left = 0;
                break;
            case WholeFlight.Ends:
                _flight.Finish(ref s, ref run, in taken, run.Left);
                break;
            default:
                _flight.Take(ref s, ref run);
                break;
        }
    }

    /// <summary>The next piece of a slide or a roll: on flat ground what is left of the step is a whole step again, if nothing happens in it.</summary>
    private void TakeSurface(ref BallState s, ref StepRun run, bool isTried)
    {
        bool mayBeWhole = !(run.Part > 0);
        if (mayBeWhole && ((!isTried && _flat is not null && _flat.TryWhole(ref s, run.Left, run.End, run.Log))
            || (_line is not null && !run.Jumped && (!isTried || World.Engine is not null) && _line.TryWhole(ref s, run.Left, run.End, run.Log))))
        {
            run.Left = 0;
        }
        else
        {
            _surface.Take(ref s, ref run);
        }
    }
}

/// <summary>Outcomes of a step of flight that was to be taken whole.</summary>
internal enum WholeFlight
{
    /// <summary>It was not taken: it may have to be divided, or something is near.</summary>
    NotTaken,

    /// <summary>It was taken, and something happens in it: the ball is where it was.</summary>
    Ends,

    /// <summary>Nothing happened in it, and the ball has moved.</summary>
    Done,
}
