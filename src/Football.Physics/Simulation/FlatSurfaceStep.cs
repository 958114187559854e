using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.Integration;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <summary>Whole steps of sliding and rolling on flat ground with no other object near: almost every step of a ball on the ground.</summary>
/// <remarks>
/// The motion has two velocity components along the plane and three of spin, in the plane's axes (<see cref="PlaneLaw{TAir}"/>). The load needs no
/// curvature, and no contact search is needed. If an event is possible, the step changes nothing, and <see cref="SurfacePhase{TIntegrator}"/> takes it in
/// pieces with the same equations on any surface.
/// </remarks>
/// <typeparam name="TAir">The laws of the air. If they vary: <see cref="FieldAir{TLaw}"/>, or <see cref="SceneAir"/>, which supports any mixture.</typeparam>
internal sealed class FlatSurfaceStep<TAir> : FlatSurfaceStep
    where TAir : struct, IFlightAir
{
    /// <summary>If h² |ω(h) × ω(0)| is below this, two terms of the Magnus series suffice: the axis turns little (tested in WholeRun).</summary>
    private const double LittleTurn = 1e-3;

    /// <summary>If a roll needs a larger share of the available friction, or keeps a smaller share of its weight as load, the pieces take the step.</summary>
    private const double Ample = 0.9;
    private const double Slight = 0.05;

    /// <summary>If friction alone would end the slip or the roll within this share of a step, the pieces take the step.</summary>
    private const double SoonOver = 0.5;

    private readonly PlaneLaw<TAir> _law;
    private readonly World _world;
    private readonly ClearFlight? _clear;
    private readonly StabilityLimit _limit;
    private readonly PlaneMaterial[] _materials;
    private readonly bool _acts;
    private readonly bool _slides;
    private readonly bool _jumps;
    private readonly bool _locatesJump;
    private readonly bool _movesWithEnd;
    private readonly int _order;
    private readonly double[] _offsets;
    private readonly double[] _weights;
    private readonly double _radius;
    private readonly double _perRadius;
    private readonly double _radiusSquared;
    private readonly double _halfMass;
    private readonly double _halfInertia;
    private readonly double _restEnergy;
    private readonly double _fastestWind;

    /// <summary>Prepares the steps of a scene.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="settings">The settings of the solver.</param>
    /// <param name="method">The integrator.</param>
    /// <param name="around">The forces on the ball.</param>
    /// <param name="air">The laws of the air.</param>
    /// <param name="limit">The stability limit of a step.</param>
    /// <param name="clear">Checks whether an object is near; null if the scene has only the ground.</param>
    /// <param name="locatesJump">Whether steps end at the jump in the drag law.</param>
    public FlatSurfaceStep(Scene scene, SolverSettings settings, IIntegrator method, Surroundings around, in TAir air, in StabilityLimit limit, ClearFlight? clear, bool locatesJump)
    {
        _law = new PlaneLaw<TAir>(scene, around, in air);
        _world = around.World;
        _clear = clear;
        _limit = limit;
        _jumps = around.Air.Jumps;
        _locatesJump = locatesJump;
        _acts = !scene.Ground.IsNone && scene.Ground.Heights is null;
        _slides = settings.RollingTransition == RollingTransition.Exact;
        Tableau tableau = method.Tableau;
        (_offsets, _weights, _movesWithEnd, _order) = (tableau.Offsets, tableau.Weights, tableau.MovesWithEnd, method.Order);
        BallProperties ball = scene.Ball;
        _radius = ball.Radius;
        _perRadius = 1.0 / ball.Radius;
        _radiusSquared = ball.Radius * ball.Radius;
        _halfMass = 0.5 * ball.Mass;
        _halfInertia = 0.5 * ball.MomentOfInertia;
        _restEnergy = _world.RestEnergy;
        _fastestWind = around.Air.FastestWind;
        ContactMaterial[] materials = _acts ? _world.Ground!.Materials : [];
        _materials = new PlaneMaterial[materials.Length];
        for (int i = 0; i < materials.Length; i++)
        {
            _materials[i] = new PlaneMaterial(in materials[i], ball);
        }
    }

    public override bool TryWhole(ref BallState s, double dt, double end, StepLog log)
    {
        bool touches = s.ClearIn == BallState.TouchesSeveral;
        if (!_acts || s.Carrier != 0 || s.Nets != 0 || touches)
        {
            s.ClearIn = touches ? 0 : s.ClearIn;
            return false;
        }

        return s.Motion == MotionState.Rolling ? TryWhole<PlaneRoll>(ref s, dt, end, log) : _slides && TryWhole<PlaneSlide>(ref s, dt, end, log);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private bool TryWhole<TMotion>(ref BallState s, double dt, double end, StepLog log)
        where TMotion : struct, ISurfaceMotion
    {
        // Keep the motion in the plane's axes in registers: a value that is stored and loaded again is late.
        bool isLevel = _law.Axes.IsLevel;
        double vx = isLevel ? s.Flight.Velocity.X : Vector3d.Dot(in s.Flight.Velocity, in _law.Axes.X);
        double vz = isLevel ? s.Flight.Velocity.Z : Vector3d.Dot(in s.Flight.Velocity, in _law.Axes.Z);
        double wx = isLevel ? s.Flight.Axis.X : Vector3d.Dot(in s.Flight.Axis, in _law.Axes.X);
        double wy = isLevel ? s.Flight.Axis.Y : Vector3d.Dot(in s.Flight.Axis, in _law.Axes.Normal);
        double wz = isLevel ? s.Flight.Axis.Z : Vector3d.Dot(in s.Flight.Axis, in _law.Axes.Z);
        if (!Proposes<TMotion>(ref s, dt, vx, vz, wx, wy, wz, out PlaneStart on, out int patch))
        {
            return false;
        }

        var start = new PlaneMotion { VX = vx, VZ = vz, WX = wx, WY = wy, WZ = wz };

        // Use the first stage to reject a step in which the slip or the roll turns too much.
        bool rolls = default(TMotion).Rolls;
        ref readonly PlaneMaterial material = ref _materials[patch + 1];
        PlaneAcceleration along = _law.RatesOf<TMotion>(in on, in material, vx, vz, wx, wy, wz, 0, 0, 0, out PlaneRates first);
        double rateX = rolls ? along.X : along.X + (_radius * first.BZ);
        double rateZ = rolls ? along.Z : along.Z - (_radius * first.BX);
        double across = Math.Abs((rateX * on.Z) - (rateZ * on.X));
        double turning = Ample * material.SlidingTorque * first.Load;
        if (!TurnLimit.Allows(on.Size, dt * ((rateX * on.X) + (rateZ * on.Z)), dt * across) || !(first.BrakingSquared <= turning * turning))
        {
            return false;
        }

        Integrate<TMotion>(in on, in material, in start, along, ref first, dt, out PlaneMotionStep step);
        if (MayEnd<TMotion>(in on, in material, in start, along, in first, in step, dt))
        {
            return false;
        }

        double wayX = dt * step.Mean.VX;
        double wayZ = dt * step.Mean.VZ;
        Vector3d position = isLevel
            ? new Vector3d(s.Position.X + wayX, s.Position.Y, s.Position.Z + wayZ)
            : s.Position + (wayX * _law.Axes.X) + (wayZ * _law.Axes.Z);
        if (_materials.Length > 1 && _world.Ground!.PatchAt(in position) != patch)
        {
            return false;
        }

        // There is no event: move the ball.
        log.Evaluations += _weights.Length;
        log.Steps++;

        // The axis of the spin ω turns too: ∫ω dt + h²/12 ω(h) × ω(0) over the step h, the fourth-order Magnus series. For a large turn, use the sixth order.
        Vector3d last = step.End.Spin;
        bool turnsLittle = _order < 4 || dt * dt * dt * dt * Vector3d.Cross(in last, start.Spin).LengthSquared <= LittleTurn * LittleTurn;
        Vector3d turned = turnsLittle ? RotationVector.OfMean(step.Mean.Spin, start.Spin, in last, dt)
            : RotationVector.Of(start.Spin, 0.25 * ((6.0 * step.Mean.Spin) - start.Spin - step.Stage.Spin), in last, dt);
        Vector3d turn = _law.Axes.InWorld(turned.X, turned.Y, turned.Z);
        if (log.IsWatched)
        {
            MoveAndShow<TMotion>(log, ref s, in on, in material, in position, in turn, along, in step.End, dt, end, wayX, wayZ);
            return true;
        }

        Move(ref s, in on, in position, in turn, in step.End, end);
        return true;
    }

    /// <summary>Reads the motion, and accepts a step only if the slip or roll has a direction, the step is stable, and no object is near.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool Proposes<TMotion>(ref BallState s, double dt, double vx, double vz, double wx, double wy, double wz, out PlaneStart on, out int patch)
        where TMotion : struct, ISurfaceMotion
    {
        bool rolls = default(TMotion).Rolls;
        double x = rolls ? vx : vx + (_radius * wz);
        double z = rolls ? vz : vz - (_radius * wx);
        double squared = (x * x) + (z * z);
        double size = Math.Sqrt(squared);
        double perSize = size * (1.0 / squared); // the division does not wait for the root
        double airX = vx - _law.WindX;
        double airZ = vz - _law.WindZ;
        double spinSquared = (wx * wx) + (wy * wy) + (wz * wz);
        double airSpeedSquared = (airX * airX) + (_law.WindUp * _law.WindUp) + (airZ * airZ);
        patch = _materials.Length > 1 ? _world.Ground!.PatchAt(s.Position) : -1;
        ref readonly PlaneMaterial material = ref _materials[patch + 1];
        double airSpeed = Math.Abs(airX) + Math.Abs(_law.WindUp) + Math.Abs(airZ) + _fastestWind + (rolls ? 0 : dt * material.Sliding * _law.Weight);
        double spinAtMost = Math.Abs(wx) + Math.Abs(wy) + Math.Abs(wz);
        Unsafe.SkipInit(out on);
        if (!(size >= ContactTolerances.Rolling) || !(dt * (_limit.RateAtMost(airSpeed, spinAtMost) + material.Damping) <= StabilityLimit.LargestChange)
            || size < SoonOver * dt * (rolls ? material.Rolling : material.SlipFriction) * _law.Weight
            || (_materials.Length > 1 && !(_world.Ground!.LeastWidth >= 2.0 * dt * size))
            || (_clear is not null && !_clear.HoldsOnSurface(ref s, dt, Math.Sqrt(airSpeedSquared) + _fastestWind, Math.Sqrt(spinSquared))))
        {
            return false;
        }

        on.Size = size;
        on.X = x * perSize;
        on.Z = z * perSize;
        on.SpinSign = wy > ContactTolerances.Rolling ? 1.0 : wy < -ContactTolerances.Rolling ? -1.0 : 0.0;
        on.Time = s.Time;
        if (_law.HasField)
        {
            on.From = s.Position;
        }

        bool known = _locatesJump && s.Branch is DragBranch.NoSpin or DragBranch.Spinning;
        on.Branch = known ? s.Branch : DragJump.Choose(_jumps, locates: false, s.Branch, airSpeedSquared, _radiusSquared * spinSquared);
        return true;
    }

    /// <summary>Evaluates the integrator's stages; each starts from the initial state, with the rates of the previous stage.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Integrate<TMotion>(
        in PlaneStart on, in PlaneMaterial material, in PlaneMotion start, PlaneAcceleration along, ref PlaneRates first, double dt, out PlaneMotionStep step)
        where TMotion : struct, ISurfaceMotion
    {
        bool rolls = default(TMotion).Rolls;
        double weight = _weights[0];
        double sumVX = weight * start.VX;
        double sumVZ = weight * start.VZ;
        double sumWX = rolls ? 0 : weight * start.WX;
        double sumWY = weight * start.WY;
        double sumWZ = rolls ? 0 : weight * start.WZ;
        double sumAX = weight * along.X;
        double sumAZ = weight * along.Z;
        double sumBX = rolls ? 0 : weight * first.BX;
        double sumBY = weight * first.BY;
        double sumBZ = rolls ? 0 : weight * first.BZ;

        // As above, write each component on its own.
        Unsafe.SkipInit(out step);
        PlaneRates stageRates;
        scoped ref PlaneRates rates = ref first;
        ref PlaneMotion at = ref step.Stage;
        at.VX = start.VX;
        at.VZ = start.VZ;
        at.WX = start.WX;
        at.WY = start.WY;
        at.WZ = start.WZ;
        for (int stage = 1; stage < _weights.Length; stage++)
        {
            double h = _offsets[stage] * dt;
            double wayX = h * at.VX;
            double wayZ = h * at.VZ;
            double vx = start.VX + (h * along.X);
            double vz = start.VZ + (h * along.Z);
            double wx = rolls ? vz * _perRadius : start.WX + (h * rates.BX);
            double wy = start.WY + (h * rates.BY);
            double wz = rolls ? -vx * _perRadius : start.WZ + (h * rates.BZ);
            at.VX = vx;
            at.VZ = vz;
            at.WX = wx;
            at.WY = wy;
            at.WZ = wz;
            along = _law.RatesOf<TMotion>(in on, in material, vx, vz, wx, wy, wz, h, wayX, wayZ, out stageRates);
            rates = ref stageRates;
            weight = _weights[stage];
            sumVX += weight * at.VX;
            sumVZ += weight * at.VZ;
            sumWY += weight * at.WY;
            sumAX += weight * along.X;
            sumAZ += weight * along.Z;
            sumBY += weight * rates.BY;
            if (!rolls)
            {
                sumWX += weight * at.WX;
                sumWZ += weight * at.WZ;
                sumBX += weight * rates.BX;
                sumBZ += weight * rates.BZ;
            }
        }

        // The velocity v of a rolling ball determines its spin along the plane: ω_t = n × v / r.
        ref PlaneMotion end = ref step.End;
        end.VX = start.VX + (dt * sumAX);
        end.VZ = start.VZ + (dt * sumAZ);
        end.WX = rolls ? end.VZ * _perRadius : start.WX + (dt * sumBX);
        end.WY = start.WY + (dt * sumBY);
        end.WZ = rolls ? -end.VX * _perRadius : start.WZ + (dt * sumBZ);
        step.Mean.VX = _movesWithEnd ? end.VX : sumVX;
        step.Mean.VZ = _movesWithEnd ? end.VZ : sumVZ;
        step.Mean.WX = _movesWithEnd ? end.WX : rolls ? sumVZ * _perRadius : sumWX;
        step.Mean.WY = _movesWithEnd ? end.WY : sumWY;
        step.Mean.WZ = _movesWithEnd ? end.WZ : rolls ? -sumVX * _perRadius : sumWZ;
        step.Load = rates.Load;
        step.TractionSquared = rates.TractionSquared;
    }

    /// <summary>True if the slip, roll, load, grip or spin about the normal may end, or the drag law may jump.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool MayEnd<TMotion>(in PlaneStart on, in PlaneMaterial material, in PlaneMotion start, PlaneAcceleration along, in PlaneRates first, in PlaneMotionStep step, double dt)
        where TMotion : struct, ISurfaceMotion
    {
        // Extrapolate the load at the end from the stages.
        bool rolls = default(TMotion).Rolls;
        ref readonly PlaneMotion end = ref step.End;
        double endX = rolls ? end.VX : end.VX + (_radius * end.WZ);
        double endZ = rolls ? end.VZ : end.VZ - (_radius * end.WX);
        double load = step.Load + Math.Min(0, step.Load - first.Load);
        double friction = Ample * material.Sliding * load;

        // The energy of velocity and spin, ½ m v² + ½ I ω².
        double energy = (_halfMass * ((end.VX * end.VX) + (end.VZ * end.VZ))) + (_halfInertia * ((end.WX * end.WX) + (end.WY * end.WY) + (end.WZ * end.WZ)));
        return !((endX * on.X) + (endZ * on.Z) > 0) || !(first.Load > Slight * _law.Weight) || !(load > Slight * _law.Weight)
            || (rolls && (energy <= _restEnergy * 1.001 || !(Math.Max(first.TractionSquared, step.TractionSquared) <= friction * friction)))
            || start.WY * end.WY < 0
            || (_locatesJump && _law.MayCrossJump(in on, in start, along, in first, in end, dt));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Move(ref BallState s, in PlaneStart on, in Vector3d position, in Vector3d turn, in PlaneMotion last, double end)
    {
        s.BaseOrientation = s.BaseOrientation.Turned(in turn);
        s.Position = position;
        s.Flight.Velocity = _law.Axes.InWorld(last.VX, 0, last.VZ);
        s.Flight.Axis = _law.Axes.InWorld(last.WX, last.WY, last.WZ);
        s.Branch = on.Branch;
        s.Time = end;
    }

    /// <summary>Moves the ball, and reports the piece to the observer.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void MoveAndShow<TMotion>(
        StepLog log, ref BallState s, in PlaneStart on, in PlaneMaterial material, in Vector3d position, in Vector3d turn, PlaneAcceleration along,
        in PlaneMotion last, double dt, double end, double wayX, double wayZ)
        where TMotion : struct, ISurfaceMotion
    {
        BallState before = s;
        Move(ref s, in on, in position, in turn, in last, end);
        PlaneAcceleration atEnd = default;
        Vector3d start = _law.Axes.InWorld(along.X, 0, along.Z);
        if (log.WantsEnd(in before, in s, in start))
        {
            atEnd = _law.RatesOf<TMotion>(in on, in material, last.VX, last.VZ, last.WX, last.WY, last.WZ, dt, wayX, wayZ, out _);
            log.Evaluations++;
        }

        log.Show(in before, in s, in start, _law.Axes.InWorld(atEnd.X, 0, atEnd.Z), _order);
    }
}
