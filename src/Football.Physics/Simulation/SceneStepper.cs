using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.Integration;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <summary>
/// Steps the ball in one scene with one integrator: a loop over pieces, each taken by the current phase of the ball.
/// <see cref="FlightStepper{TAir, TIntegrator}"/> takes a whole step of flight without events, the most common case.
/// <list type="number">
/// <item><see cref="FlightPhase{TIntegrator}"/>: flight, up to a jump in the drag law, the end of the spin or a contact;</item>
/// <item><see cref="FlatSurfaceStep{TAir}"/>: a whole step of sliding or rolling on flat ground without events;</item>
/// <item><see cref="SurfacePhase{TIntegrator}"/>: sliding or rolling on any surface, up to a jump, the end of the slip, rest or a
/// contact;</item>
/// <item><see cref="ContactSetPhase{TIntegrator}"/>: the same on several surfaces at once;</item>
/// <item><see cref="ContactSetParts"/>: the fallback if the contact set has no solution, and for a squeezed ball;</item>
/// <item><see cref="WorldContact"/>: an impact and the state of the ball after it;</item>
/// <item><see cref="RestPhase"/>: rest among moving objects, up to the first hit.</item>
/// </list>
/// </summary>
internal class SceneStepper<TIntegrator> : Stepper
    where TIntegrator : struct, IIntegrator
{
    /// <summary>The maximum number of changes of the motion before the first evaluation of a step.</summary>
    private const int MostChanges = 8;

    private readonly Vector3d _wind;
    private readonly double _upward;
    private SceneAir _air;
    private TIntegrator _integrator;
    private readonly FlightPhase<TIntegrator> _flight;
    private readonly ClearFlight? _clear;
    private readonly ulong _clearKey;
    private readonly SurfacePhase<TIntegrator> _surface;
    private readonly StabilityLimit _pulled;
    private FlatSurfaceStep? _flat; // null if forces turn the spin axis
    private readonly ContactSetParts _parts;
    private readonly RestPhase _rest;
    private readonly Rest _holds;
    private readonly KnownRests? _rests; // null if a ball may wake although nothing moves, or if nothing wakes it
    private readonly WorldContact _contact;
    private readonly BodyPush? _bodies;

    public SceneStepper(Scene scene, SolverSettings settings, in SceneAir air)
        : base(new Surroundings(scene, in air))
    {
        Surroundings around = Around;
        _air = around.Air;
        _integrator = default;
        _wind = around.Wind;
        _upward = around.Upward;
        Limit = StabilityLimit.Of(scene, in _air, 0, _upward, _integrator.Order);

        // A step across the jump is of first order, so a first-order integrator gains nothing from locating the jump.
        var jump = new DragJumpGuard(around, settings.LocateJump && _integrator.Order > 1);
        LocatesJump = jump.Acts;
        World world = World;
        double weight = around.Weight.Length;
        _clear = world.IsLevelGroundAlone ? null : new ClearFlight(world, Limit, StabilityLimit.WithFall(_air.OrdinaryBound, weight), in _wind, weight, _integrator.ShareInPath);

        // If there are bodies, a broad-phase result is valid for one step only.
        _clearKey = _clear is { LooksForBodies: false } ? _clear.Key : 0;
        _contact = new WorldContact(around, _integrator.GainsByHops);
        var guard = new WorldGuard(world, _contact, settings);
        _bodies = world is { Bodies: not null } or { Engine: not null } ? new BodyPush(world, guard, _contact) : null;

        // Friction may accelerate the ball more than gravity does.
        double pull = weight * Math.Max(1.0, world.LargestFriction);
        _pulled = StabilityLimit.Of(scene, in _air, 0, pull, _integrator.Order);
        OwnForceGuard? own = _air.HasOwnForces ? new OwnForceGuard(scene) : null;
        _parts = new ContactSetParts(around, guard, _contact);
        var set = new ContactSetPhase<TIntegrator>(around, in _pulled, jump, guard, _contact, _parts, own);
        _surface = new SurfacePhase<TIntegrator>(scene, settings, around, _pulled, jump, guard, _contact, set, own);
        _holds = new Rest(around);
        _rest = new RestPhase(around, guard, _contact);
        _rests = _rest.IsWokenByMotion ? new KnownRests(world) : null;
        Pile = new PilePhase(around, guard, _contact);

        // Custom forces turn the spin axis, so without a step along a constant axis, there are custom forces.
        _flight = new FlightPhase<TIntegrator>(around, this as IFlight, Limit, jump, guard, _contact, own);
    }

    public override bool MayWake => _rest.MayWake;

    public override bool RestsAt(in BallState s)
    {
        BallState entered = s;
        World.Enter(ref entered);
        return _holds.Holds(in entered);
    }

    public override PilePhase Pile { get; }

    public int Order { get; } = default(TIntegrator).Order;

    public int Stages { get; } = default(TIntegrator).Stages;

    /// <summary>The stability limit of a piece.</summary>
    protected StabilityLimit Limit { get; }

    /// <summary>True if pieces end at the jump in the drag law.</summary>
    protected bool LocatesJump { get; }

    public override void Step(ref BallState s, double dt, StepLog log)
    {
        // Try a whole step on flat ground; otherwise take the step in pieces.
        if (!(s.Motion is MotionState.Rolling or MotionState.Sliding && _flat is not null && _flat.TryWhole(ref s, dt, s.Time + dt, log)))
        {
            TakePieces(ref s, dt, log, WholeStep.NotTaken, default);
        }
    }

    /// <summary>Compiles the whole step on flat ground for one air model.</summary>
    protected void TakeWholeSteps<TAir>(Scene scene, SolverSettings settings, in TAir air)
        where TAir : struct, IFlightAir
    {
        _flat = new FlatSurfaceStep<TAir>(scene, settings, _integrator, Around, in air, in _pulled, World.IsBare ? null : _clear, LocatesJump);
    }

    public override void Settle(ref BallState s)
    {
        World.Enter(ref s);
        s.Position = GroundPlace.Raised(World, s.Position);
        _contact.Settle(ref s);
        World.Exit(ref s);
    }

    public override void Struck(ref BallState s, in Vector3d velocity, in Vector3d spin, in Vector3d n, StepLog log)
    {
        int first = log.Events.Count;
        World.Enter(ref s);
        var run = new StepRun(0, s.Time, log);
        _contact.Struck(ref s, in velocity, in spin, in n, ref run);
        Close(ref s, in run, first);
    }

    public override bool FliesClear(in Vector3d from, in Vector3d to, double duration, double airSpeed, double spinRate) =>
        _clear is null || _clear.HasFlown(in from, in to, duration, airSpeed, spinRate);

    public override double SearchMargin(double speed, double spinRate, double dt) =>
        _clear?.MarginAt(speed + _wind.Length + Around.Air.FastestWind, spinRate, dt) ?? World.Ball.Radius;

    public override bool MayBeClear(in BallState s) => !(s.ClearUntil > s.Time) || _clear is null || s.ClearIn != _clear.Key || _clear.MayBeFree(in s);

    public override void AirFactors(double speed, double spinRate, out double drag, out double lift, out double decay)
    {
        double speedSquared = speed * speed;
        DragBranch branch = DragJump.BranchAt(jumps: true, speedSquared, Around.RadiusSquared * spinRate * spinRate);
        _air.Factors(speedSquared, spinRate, speedSquared, branch, out drag, out lift, out decay);
    }

    /// <summary>True if a step of flight reaches no object other than level ground. |u|² may be an upper bound.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    protected bool IsClear(ref BallState s, double dt, double airSpeedSquared) =>
        _clear is null || (s.Time + dt <= s.ClearUntil && s.ClearIn == _clearKey) || _clear.Holds(ref s, dt, airSpeedSquared, s.SpinRate);

    /// <summary>Reports a whole step of flight to the observers.</summary>
    /// <remarks>The ball is at its end; the other arguments describe its start.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    protected void Show(StepLog log, in BallState s, double time, in Vector3d position, in Vector3d velocity, double spin, in FlightStep step)
    {
        if (log.WantsPathOnly)
        {
            // A look-ahead does not need the states: do not copy them.
            log.ShowFlight(this, in s, time, in position, in velocity, spin, in step.StartAcceleration, _integrator.Order);
            return;
        }

        BallState before = s;
        before.Time = time;
        before.Position = position;
        before.Velocity = velocity;
        before.SpinRate = spin;
        Vector3d acceleration = default;
        if (log.WantsEnd(in before, in s, in step.StartAcceleration))
        {
            EndAcceleration(in s, s.Time - time, out acceleration);
            log.Evaluations++;
        }

        log.Show(in before, in s, in step.StartAcceleration, in acceleration, _integrator.Order);
    }

    public override void EndAcceleration(in BallState s, double h, out Vector3d acceleration) =>
        FlightRates.Of(ref _air, in s, _upward, s.Flight.Velocity - _wind, s.Flight.SpinRate, out acceleration, out _);

    public override BallForces? ForcesAt(in BallState state, double dt, Scene scene)
    {
        BallState s = state;
        if (World.Engine is not null)
        {
            World.Enter(ref s);
        }

        // Take the step on a copy, with the same phases, up to the first evaluation. A phase may first change the kind of motion.
        var probe = new ForceProbe(Around, scene);
        var run = new StepRun(dt, s.Time, new StepLog()) { Probe = probe };
        run.Spent.Arrival = s.Velocity.Length;
        if (s.Motion == MotionState.Rest)
        {
            probe.Rest(in s);
            return probe.Found;
        }

        Separate(ref s, ref run);
        for (int i = 0; i < MostChanges && probe.Found is null && !run.HasImpulses && s.Motion != MotionState.Pinned; i++)
        {
            switch (s.Motion)
            {
                case MotionState.Airborne:
                    _flight.Take(ref s, ref run);
                    break;
                case MotionState.Rest:
                    probe.Rest(in s);
                    return probe.Found;
                default:
                    _surface.Take(ref s, ref run);
                    break;
            }
        }

        return run.HasImpulses ? null : probe.Found;
    }

    /// <summary>Tries a whole step of flight, and completes it if it contains no event.</summary>
    /// <param name="s">The ball, in the air.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="end">End time, s.</param>
    /// <param name="log">Receives the counts.</param>
    /// <param name="step">The step taken, if it contains an event.</param>
    protected virtual WholeStep TryWhole(ref BallState s, double dt, double end, StepLog log, out FlightStep step)
    {
        step = default;
        return WholeStep.NotTaken;
    }

    /// <summary>Takes a step piece by piece.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="log">Receives events and counts.</param>
    /// <param name="whole">The result of the whole step that was already tried.</param>
    /// <param name="taken">That step, if it contains an event.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    protected void TakePieces(ref BallState s, double dt, StepLog log, WholeStep whole, in FlightStep taken)
    {
        if (_air.Varies)
        {
            TakeOrRestore(ref s, dt, log);
        }
        else if (s.Motion == MotionState.Rest && _rests is not null)
        {
            TakeRest(ref s, dt, log);
        }
        else
        {
            TakeAll(ref s, dt, log, whole, in taken);
        }
    }

    /// <summary>Steps a ball in air that varies. If a custom force or a wind throws or gives a result out of range, the state and the log are restored.</summary>
    private void TakeOrRestore(ref BallState s, double dt, StepLog log)
    {
        BallState before = s;
        StepLogMark mark = log.Mark();
        try
        {
            TakeAll(ref s, dt, log, WholeStep.NotTaken, default);
            _air.CheckOutcome(in s);
        }
        catch
        {
            s = before;
            log.TakeBack(in mark);
            throw;
        }
    }

    /// <summary>Steps a ball at rest.</summary>
    /// <remarks>
    /// If an earlier step found that nothing changes, and no object has moved since, only the time advances.
    /// </remarks>
    private void TakeRest(ref BallState s, double dt, StepLog log)
    {
        if (_rests!.Has(in s))
        {
            s.Time += dt;
            return;
        }

        BallState before = s;
        long reported = Reported(log);
        TakeAll(ref s, dt, log, WholeStep.NotTaken, default);
        if (dt > 0 && Reported(log) == reported)
        {
            _rests.Learn(in before, in s);
        }
    }

    private static long Reported(StepLog log) => log.Events.Count + log.Events.Dropped + log.UnreportedImpacts + log.StalledSteps;

    private void TakeAll(ref BallState s, double dt, StepLog log, WholeStep whole, in FlightStep taken)
    {
        if (World.Engine is not null)
        {
            World.Enter(ref s);
        }

        World.SearchEvaluations = 0;
        var run = new StepRun(dt, s.Time, log) { Whole = whole };
        Vector3d from = s.Position;
        run.Spent.Arrival = run.Spent.Pieces == 0 ? s.Velocity.Length : run.Spent.Arrival;
        if (!log.Halted)
        {
            Separate(ref s, ref run);
        }

        // A step that was already integrated is the first piece, unless the ball has just been moved.
        if (whole == WholeStep.Ends)
        {
            run.Whole = s.Position == from ? whole : WholeStep.NotTaken;
            run.Taken = taken;
        }

        while (!log.Halted && run.Left > 0 && (s.Motion != MotionState.Rest || _rest.MayWake))
        {
            if (!run.Begin(World))
            {
                // The budget is used up: to end the step, keep the ball at its position for the rest of it.
                log.StalledSteps++;
                break;
            }

            // The earlier result of the broad phase is no longer valid.
            s.ClearUntil = 0;
            switch (s.Motion)
            {
                case MotionState.Airborne:
                    TakeFlight(ref s, ref run);
                    break;
                case MotionState.Rest:
                    _rest.Take(ref s, ref run);
                    break;
                case MotionState.Pinned:
                    _parts.TakeSqueezed(ref s, ref run);
                    break;
                default:
                    TakeSurface(ref s, ref run);
                    break;
            }

            run.Whole = run.Whole == WholeStep.Near ? WholeStep.Near : WholeStep.Untried;
        }

        // Set the exact end time, because the sum of the pieces equals it only to within rounding.
        if (!log.Halted)
        {
            s.Time = run.End;
        }

        // Report a slip that the carrier's velocity jump started and that outlasts the step.
        if (run.Jumped && s.Motion == MotionState.Sliding)
        {
            _contact.StartSliding(ref s, ref run);
        }

        if (log.Continues || World.Engine is not null)
        {
            // If the buffer dropped events, this step's events have moved to other indices.
            Close(ref s, in run, log.Events.Dropped > 0 ? 0 : run.FirstEvent);
        }
    }

    /// <summary>Moves the ball out of the ground, and out of bodies that the game has moved into it.</summary>
    private void Separate(ref BallState s, ref StepRun run)
    {
        s.ClearUntil = 0;
        s.Position = GroundPlace.Raised(World, s.Position);
        _bodies?.Apply(ref s, ref run);
        if (World.Moves)
        {
            _contact.TakeJump(ref s, ref run);
        }

        if (run.Log.IsWatched)
        {
            run.Log.Zones?.Moved(run.Log, in s);
        }
    }

    /// <summary>Ends a call: saves the counters of a step that continues, and identifies an engine collider by its own number.</summary>
    private void Close(ref BallState s, in StepRun run, int firstEvent)
    {
        if (run.Log.Continues)
        {
            run.Close();
        }

        World.Exit(ref s);
        EventBuffer events = run.Log.Events;
        for (int i = firstEvent; World.Engine is not null && i < events.Count; i++)
        {
            int number = World.Engine.NumberOf((long)events[i].ColliderIndex - World.FirstCollider);
            if (number >= 0)
            {
                events.Call(i, number);
            }
        }
    }

    /// <summary>Takes the next piece of a flight. The rest of the step is tried as a whole step first.</summary>
    private void TakeFlight(ref BallState s, ref StepRun run)
    {
        bool isHeld = s.Velocity.Y <= ContactTolerances.Leaving && s.Position.Y <= World.LevelContact + ContactTolerances.Touching;
        if (run.Whole != WholeStep.Near && (run.Part > 0 || isHeld))
        {
            // The step is divided, or the ball touches level ground and does not leave it: the next piece handles this contact first.
            run.Whole = WholeStep.NotTaken;
        }
        else if (run.Whole == WholeStep.Untried)
        {
            run.Whole = TryWhole(ref s, run.Left, run.End, run.Log, out run.Taken);
        }

        if (run.Whole == WholeStep.Done)
        {
            run.Left = 0;
        }
        else
        {
            _flight.Take(ref s, ref run);
        }
    }

    /// <summary>Takes the next piece of a slide or a roll.</summary>
    /// <remarks>On flat ground the rest of the step is tried as a whole step first.</remarks>
    private void TakeSurface(ref BallState s, ref StepRun run)
    {
        if (!(run.Part > 0) && run.Whole is WholeStep.Untried or WholeStep.Near && _flat is not null && _flat.TryWhole(ref s, run.Left, run.End, run.Log))
        {
            run.Left = 0;
        }
        else
        {
            _surface.Take(ref s, ref run);
        }
    }
}
