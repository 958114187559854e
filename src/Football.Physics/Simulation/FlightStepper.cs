using System.Runtime.CompilerServices;
using FootballPhysics.Integration;
using FootballPhysics.Numerics;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <summary>The hot path of flight, compiled for one air model and one integrator.</summary>
/// <remarks>
/// It takes a whole step, checks it for events, and moves the ball. If an event may be within the step, <see cref="SceneStepper{TIntegrator}"/> takes it piece by piece.
/// </remarks>
/// <typeparam name="TAir">The air model, without custom forces.</typeparam>
/// <typeparam name="TIntegrator">The integrator.</typeparam>
internal sealed class FlightStepper<TAir, TIntegrator> : SceneStepper<TIntegrator>, IFlight
    where TAir : struct, IFlightAir
    where TIntegrator : struct, IIntegrator
{
    private readonly Vector3d _wind;
    private readonly double _upward;
    private readonly double _contactHeight;
    private readonly double _radiusSquared;
    private readonly bool _locatesJump;
    private readonly double _fastestWind;
    private readonly StabilityLimit _limit;
    private TAir _air;
    private TIntegrator _integrator;

    public FlightStepper(Scene scene, SolverSettings settings, in SceneAir air, in TAir laws)
        : base(scene, settings, in air)
    {
        _air = laws;
        _integrator = default;
        _wind = Around.Wind;
        _upward = Around.Upward;
        _contactHeight = Around.World.LevelContact;
        _radiusSquared = Around.RadiusSquared;
        _locatesJump = LocatesJump;
        TakeWholeSteps(scene, settings, in laws);
        _fastestWind = Around.Air.FastestWind;
        _limit = StabilityLimit.Of(scene, in air, _air.WholeUpTo(Limit.Bound), _upward, _integrator.Order);
    }

    [MethodImpl(Hot.Path)]
    public override void Step(ref BallState s, double dt, StepLog log)
    {
        if (s.Motion != MotionState.Airborne)
        {
            base.Step(ref s, dt, log);
            return;
        }

        WholeStep whole = TryWhole(ref s, dt, s.Time + dt, log, out FlightStep step);
        if (whole != WholeStep.Done)
        {
            TakePieces(ref s, dt, log, whole, in step);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    protected override WholeStep TryWhole(ref BallState s, double dt, double end, StepLog log, out FlightStep step)
    {
        Unsafe.SkipInit(out step);
        double vx = s.Flight.Velocity.X;
        double vy = s.Flight.Velocity.Y;
        double vz = s.Flight.Velocity.Z;
        double spin = s.Flight.SpinRate;
        double y = s.Position.Y;
        DragBranch branch = s.Branch;

        // Leave a slide along the jump, and a descent at contact height, to the piecewise method.
        if (branch >= DragBranch.AlongCriticalSpeed || (y <= _contactHeight && vy < 0))
        {
            return WholeStep.NotTaken;
        }

        // Choose the branch of the drag law, and check that the step is short enough for these forces.
        double ux = vx - _wind.X;
        double uy = vy - _wind.Y;
        double uz = vz - _wind.Z;
        double speedSquared = (ux * ux) + (uy * uy) + (uz * uz);

        bool hasField = _air.HasField;
        double mostSquared = hasField ? MostSquared(speedSquared) : speedSquared;

        if (_air.Jumps)
        {
            branch = DragJump.Choose(jumps: true, _locatesJump, branch, speedSquared, _radiusSquared * spin * spin);
            s.Branch = branch;
        }

        // Use pieces if the hop limit, stability or the broad phase requires them.
        bool covered = _air.Covers(speedSquared, spin, dt);
        bool acts = _air.Acts;
        if ((_integrator.GainsByHops && _limit.WithinHop(dt, y - _contactHeight, vy) < dt)
            || (acts && !_limit.AllowsWhole(dt, mostSquared, spin, covered)))
        {
            return WholeStep.NotTaken;
        }

        if (!IsClear(ref s, dt, mostSquared))
        {
            return WholeStep.Near;
        }

        if (!acts)
        {
            return Fall(ref s, dt, end, log);
        }

        FlyWhole(covered, ref s, branch, dt, out step);
        log.Evaluations += _integrator.Stages;

        // Conservative checks for an event: ground contact, a dip below the ground, the end of the spin, the jump in the drag law.
        double height = y + (step.Path.Y + (dt * _wind.Y));
        if (height < _contactHeight || (vy < 0 && step.AirVelocity.Y + _wind.Y > 0) || step.SpinRate < 0
            || (_air.Jumps && _locatesJump && MayCrossJump(branch, ux, uy, uz, speedSquared, spin, in step, dt)))
        {
            s.Flight.Velocity = new Vector3d(vx, vy, vz);
            s.Flight.SpinRate = spin;
            return WholeStep.Ends;
        }

        // There is no event: move the ball.
        Vector3d position = s.Position;
        double time = s.Time;
        s.Position = new Vector3d(position.X + (step.Path.X + (dt * _wind.X)), height, position.Z + (step.Path.Z + (dt * _wind.Z)));
        Turn(ref s, in step);
        s.Time = end;
        log.Steps++;
        if (log.IsWatched)
        {
            Show(log, in s, time, in position, new Vector3d(vx, vy, vz), spin, in step);
        }

        return WholeStep.Done;
    }

    public void Fly(in BallState start, ref FlightMotion motion, in Vector3d wind, DragBranch branch, double upward, double h, out FlightStep step) =>
        Fly(_air.Covers((motion.Velocity - wind).LengthSquared, motion.SpinRate, h), in start, ref motion, in wind, branch, upward, h, out step);

    /// <summary>Integrates a whole step. With a side force, it begins with an angle of 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void FlyWhole(bool covered, ref BallState s, DragBranch branch, double h, out FlightStep step)
    {
        if (_air.HasSide && s.Angle != 0)
        {
            s.FoldRotation();
        }

        Fly(covered, in s, ref s.Flight, in _wind, branch, _upward, h, out step);
    }

    /// <summary>Turns the ball to the end of a whole step.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Turn(ref BallState s, in FlightStep step)
    {
        if (_air.HasSide)
        {
            s.BaseOrientation = step.Orientation;
            s.AirDistance += step.AirDistance;
        }
        else
        {
            s.Angle += step.Turn;
        }
    }

    /// <summary>Integrates a step with the fast form of the laws if it covers this range, otherwise with the full form.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Fly(
        bool covered, in BallState start, ref FlightMotion motion, in Vector3d wind, DragBranch branch, double upward, double h, out FlightStep step)
    {
        if (covered)
        {
            _integrator.Fly(ref _air, in start, ref motion, in wind, branch, upward, h, out step);
        }
        else
        {
            _integrator.Fly(ref Around.Air, in start, ref motion, in wind, branch, upward, h, out step);
        }
    }

    public override void EndAcceleration(in BallState s, double h, out Vector3d acceleration)
    {
        // Use the same form of the laws as the start of the next step, so that results are bit-identical.
        Vector3d u = s.Flight.Velocity - _wind;
        if (_air.Covers(u.LengthSquared, s.Flight.SpinRate, h))
        {
            FlightRates.Of(ref _air, in s, _upward, in u, s.Flight.SpinRate, out acceleration, out _);
        }
        else
        {
            base.EndAcceleration(in s, h, out acceleration);
        }
    }

    /// <summary>Returns a bound on |u|² in a wind field: the maximum wind speed adds to the airspeed.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private double MostSquared(double speedSquared)
    {
        double most = Math.Sqrt(speedSquared) + _fastestWind;
        return most * most;
    }

    /// <summary>True if a step may have crossed the jump in the drag law.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool MayCrossJump(DragBranch branch, double ux, double uy, double uz, double speedSquared, double spin, in FlightStep step, double h)
    {
        // The squares of the airspeed u and of the rim speed r |ω| at both ends, and their rates at the start: 2 u·a and 2 r² |ω| d|ω|/dt.
        var start = DragJump.At(speedSquared, _radiusSquared * spin * spin);
        var rate = DragJump.Rate(
            2.0 * ((ux * step.StartAcceleration.X) + (uy * step.StartAcceleration.Y) + (uz * step.StartAcceleration.Z)),
            2.0 * _radiusSquared * spin * step.StartSpinAcceleration);
        double wx = step.AirVelocity.X;
        double wy = step.AirVelocity.Y;
        double wz = step.AirVelocity.Z;
        var end = DragJump.At((wx * wx) + (wy * wy) + (wz * wz), _radiusSquared * step.SpinRate * step.SpinRate);
        return DragJump.MayCross(branch, in start, in rate, in end, h);
    }

    /// <summary>Takes a step in a vacuum: the integrator's result for a constant acceleration, p + h (v + c h g), v + h g.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private WholeStep Fall(ref BallState s, double h, double end, StepLog log)
    {
        double vy = s.Velocity.Y;
        double gained = h * _upward;
        double climb = vy + gained;
        double height = s.Position.Y + (h * (vy + (_integrator.ShareInPath * gained)));

        // The same conservative checks as with air.
        if (height < _contactHeight || (vy < 0 && climb > 0))
        {
            return WholeStep.NotTaken;
        }

        if (log.IsWatched)
        {
            ShowFall(log, ref s, h, end, climb, height);
            return WholeStep.Done;
        }

        s.Position = new Vector3d(s.Position.X + (h * s.Velocity.X), height, s.Position.Z + (h * s.Velocity.Z));
        s.Velocity = new Vector3d(s.Velocity.X, climb, s.Velocity.Z);
        s.Angle += h * s.SpinRate;
        s.Time = end;
        log.Steps++;
        log.Evaluations += _integrator.Stages;
        return WholeStep.Done;
    }

    /// <summary>Takes the same step in a vacuum, and reports it to the observers.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void ShowFall(StepLog log, ref BallState s, double h, double end, double climb, double height)
    {
        // A look-ahead does not need the states: do not copy them.
        bool isPath = log.WantsPathOnly;
        Unsafe.SkipInit(out BallState before);
        if (isPath)
        {
            log.ShowFall(in s, h, end, climb, height, _upward, _integrator.Order);
        }
        else
        {
            before = s;
        }

        s.Position = new Vector3d(s.Position.X + (h * s.Velocity.X), height, s.Position.Z + (h * s.Velocity.Z));
        s.Velocity = new Vector3d(s.Velocity.X, climb, s.Velocity.Z);
        s.Angle += h * s.SpinRate;
        s.Time = end;
        log.Steps++;
        log.Evaluations += _integrator.Stages;
        if (!isPath)
        {
            var acceleration = new Vector3d(0, _upward, 0);
            log.Show(in before, in s, in acceleration, in acceleration, _integrator.Order);
        }
    }
}
