using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.Integration;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <summary>Whole steps of sliding and rolling on flat ground with no other object near: almost every step of a ball on the ground.</summary>
/// <remarks>
/// The motion has two velocity components along the plane and three of spin, in the plane's axes. The load needs no curvature, and no contact
/// search is needed. <see cref="TryWhole"/> takes the step, checks it for events, and moves the ball. If an event is possible, it changes
/// nothing, and <see cref="SurfacePhase{TIntegrator}"/> takes the step in pieces with the same equations on any surface.
/// Symbols: a_b gravity and buoyancy, a_air the acceleration by the air, T its torque per moment of inertia, N the load per mass.
/// Sliding: a = a_b + a_air − μ_s N ŝ, ω̇ = (μ_s N/(α r)) n × ŝ + T.
/// Rolling: a = (a_b + a_air + α r T × n)/(1 + α) − (c₀ + c₁|v|) N v̂ if the spin shares the air's force; otherwise a_b/(1 + α) + a_air − ….
/// About the normal: −(c_ω/I) ω_n − sign(ω_n) b μ_s N m/I.
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

    private readonly Surroundings _around;
    private readonly World _world;
    private TAir _air;
    private readonly ClearFlight? _clear;
    private readonly StabilityLimit _limit;
    private readonly PlaneMaterial[] _materials;
    private readonly bool _acts;
    private readonly bool _isLevel;
    private readonly bool _slides;
    private readonly bool _locatesJump;
    private readonly bool _movesWithEnd;
    private readonly int _order;
    private readonly double[] _offsets;
    private readonly double[] _weights;
    private readonly Vector3d _axisX;
    private readonly Vector3d _normal;
    private readonly Vector3d _axisZ;
    private readonly double _windX;
    private readonly double _windUp;
    private readonly double _windZ;
    private readonly double _bodyX;
    private readonly double _bodyZ;
    private readonly double _weight;
    private readonly double _radius;
    private readonly double _perRadius;
    private readonly double _radiusSquared;
    private readonly double _airInLoad;
    private readonly double _airInSlide;
    private readonly double _bodyXInRoll;
    private readonly double _bodyZInRoll;
    private readonly double _airInRoll;
    private readonly double _decayInRoll;
    private readonly double _bodyXInTraction;
    private readonly double _bodyZInTraction;
    private readonly double _airInTraction;
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
        _around = around;
        _world = around.World;
        _air = air;
        _clear = clear;
        _limit = limit;
        _locatesJump = locatesJump;
        _acts = !scene.Ground.IsNone && scene.Ground.Heights is null && !scene.HasOwnForces;
        _slides = settings.RollingTransition == RollingTransition.Exact;
        Tableau tableau = method.Tableau;
        (_offsets, _weights, _movesWithEnd, _order) = (tableau.Offsets, tableau.Weights, tableau.MovesWithEnd, method.Order);

        // The axes of the plane; on a level pitch, they are the world axes.
        _isLevel = scene.Ground.IsLevel;
        _normal = scene.Ground.Normal.Normalized();
        Vector3d along = Math.Abs(_normal.X) < 0.9 ? new Vector3d(1, 0, 0) : new Vector3d(0, 1, 0);
        _axisX = (along - (Vector3d.Dot(in along, in _normal) * _normal)).Normalized();
        _axisZ = Vector3d.Cross(in _axisX, in _normal);
        Vector3d wind = around.Wind;
        _windX = Vector3d.Dot(in wind, in _axisX);
        _windUp = Vector3d.Dot(in wind, in _normal);
        _windZ = Vector3d.Dot(in wind, in _axisZ);
        var body = new Vector3d(0, around.Upward, 0);
        _bodyX = Vector3d.Dot(in body, in _axisX);
        _bodyZ = Vector3d.Dot(in body, in _axisZ);
        _weight = -Vector3d.Dot(in body, in _normal);

        // Constants of the equations in the remarks: the shares of weight and air in the load, in a slide, in a roll and in its traction.
        BallProperties ball = scene.Ball;
        double alpha = ball.InertiaFactor;
        _radius = ball.Radius;
        _perRadius = 1.0 / ball.Radius;
        _radiusSquared = ball.Radius * ball.Radius;
        _halfMass = 0.5 * ball.Mass;
        _halfInertia = 0.5 * ball.MomentOfInertia;
        _restEnergy = _world.RestEnergy;
        _fastestWind = around.Air.FastestWind;
        bool shares = _world.SharesAir;
        _airInLoad = _world.AirLoads && _world.AirActs ? 1 : 0;
        _airInSlide = _world.AirActs ? 1 : 0;
        _bodyXInRoll = _bodyX / (1.0 + alpha);
        _bodyZInRoll = _bodyZ / (1.0 + alpha);
        _airInRoll = shares ? 1.0 / (1.0 + alpha) : _airInSlide;
        _decayInRoll = shares ? alpha / (1.0 + alpha) : 0;
        _bodyXInTraction = alpha * _bodyXInRoll;
        _bodyZInTraction = alpha * _bodyZInRoll;
        _airInTraction = _decayInRoll;
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
        bool rolls = default(TMotion).Rolls;

        // Copy the motion to the plane's axes component by component, as the last step wrote it: a wide load would stall. A rolling ball needs only
        // its spin about the normal.
        ref FlightMotion motion = ref s.Flight;
        PlaneMotion start;
        if (_isLevel)
        {
            start.VX = motion.Velocity.X;
            start.VZ = motion.Velocity.Z;
            start.WX = motion.Axis.X;
            start.WY = motion.Axis.Y;
            start.WZ = motion.Axis.Z;
        }
        else
        {
            start = InPlane(in motion);
        }

        // Accept a whole step only if the slip or roll has a direction, the step is stable, and no object is near.
        double x = rolls ? start.VX : start.VX + (_radius * start.WZ);
        double z = rolls ? start.VZ : start.VZ - (_radius * start.WX);
        double size = Math.Sqrt((x * x) + (z * z));
        double perSize = 1.0 / size;
        double airX = start.VX - _windX;
        double airZ = start.VZ - _windZ;
        double spinSquared = (start.WX * start.WX) + (start.WY * start.WY) + (start.WZ * start.WZ);
        double airSpeedSquared = (airX * airX) + (_windUp * _windUp) + (airZ * airZ);
        int patch = _materials.Length > 1 ? _world.Ground!.PatchAt(s.Position) : -1;
        PlaneStart on;
        ref readonly PlaneMaterial material = ref _materials[patch + 1];
        double airSpeed = Math.Abs(airX) + Math.Abs(_windUp) + Math.Abs(airZ) + _fastestWind + (rolls ? 0 : dt * material.Sliding * _weight);
        double spinAtMost = Math.Abs(start.WX) + Math.Abs(start.WY) + Math.Abs(start.WZ);
        if (!(size >= ContactTolerances.Rolling) || !(dt * (_limit.RateAtMost(airSpeed, spinAtMost) + material.Damping) <= StabilityLimit.LargestChange)
            || size < SoonOver * dt * (rolls ? material.Rolling : material.SlipFriction) * _weight
            || (_materials.Length > 1 && !(_world.Ground!.LeastWidth >= 2.0 * dt * size))
            || (_clear is not null && !_clear.HoldsOnSurface(ref s, dt, Math.Sqrt(airSpeedSquared) + _fastestWind, Math.Sqrt(spinSquared))))
        {
            return false;
        }

        on.X = x * perSize;
        on.Z = z * perSize;
        on.SpinSign = start.WY > ContactTolerances.Rolling ? 1.0 : start.WY < -ContactTolerances.Rolling ? -1.0 : 0.0;
        Unsafe.SkipInit(out on.From);
        on.Time = s.Time;
        if (_air.HasField)
        {
            on.From = s.Position;
        }

        bool known = _locatesJump && s.Branch is DragBranch.NoSpin or DragBranch.Spinning;
        on.Branch = known ? s.Branch : DragJump.Choose(_around.Air.Jumps, locates: false, s.Branch, airSpeedSquared, _radiusSquared * spinSquared);

        // Use the first stage to reject a step in which the slip or the roll turns too much.
        RatesOf<TMotion>(in on, in material, in start, 0, 0, 0, out PlaneRates first);
        double rateX = rolls ? first.AX : first.AX + (_radius * first.BZ);
        double rateZ = rolls ? first.AZ : first.AZ - (_radius * first.BX);
        double across = Math.Abs((rateX * on.Z) - (rateZ * on.X));
        double turning = Ample * material.SlidingTorque * first.Load;
        if (!TurnLimit.Allows(size, dt * ((rateX * on.X) + (rateZ * on.Z)), dt * across) || !(first.BrakingSquared <= turning * turning))
        {
            return false;
        }

        // Evaluate the integrator's stages; each starts from the initial state, with the rates of the previous stage.
        double weight = _weights[0];
        double sumVX = weight * start.VX;
        double sumVZ = weight * start.VZ;
        double sumWX = rolls ? 0 : weight * start.WX;
        double sumWY = weight * start.WY;
        double sumWZ = rolls ? 0 : weight * start.WZ;
        double sumAX = weight * first.AX;
        double sumAZ = weight * first.AZ;
        double sumBX = rolls ? 0 : weight * first.BX;
        double sumBY = weight * first.BY;
        double sumBZ = rolls ? 0 : weight * first.BZ;
        PlaneRates stageRates;
        ref PlaneRates rates = ref first;
        PlaneMotion at;
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
            at.VX = start.VX + (h * rates.AX);
            at.VZ = start.VZ + (h * rates.AZ);
            at.WX = rolls ? at.VZ * _perRadius : start.WX + (h * rates.BX);
            at.WY = start.WY + (h * rates.BY);
            at.WZ = rolls ? -at.VX * _perRadius : start.WZ + (h * rates.BZ);
            RatesOf<TMotion>(in on, in material, in at, h, wayX, wayZ, out stageRates);
            rates = ref stageRates;
            weight = _weights[stage];
            sumVX += weight * at.VX;
            sumVZ += weight * at.VZ;
            sumWY += weight * at.WY;
            sumAX += weight * rates.AX;
            sumAZ += weight * rates.AZ;
            sumBY += weight * rates.BY;
            if (!rolls)
            {
                sumWX += weight * at.WX;
                sumWZ += weight * at.WZ;
                sumBX += weight * rates.BX;
                sumBZ += weight * rates.BZ;
            }
        }

        // The velocity of a rolling ball determines its spin: ω_t = n × v / r.
        PlaneMotion last;
        last.VX = start.VX + (dt * sumAX);
        last.VZ = start.VZ + (dt * sumAZ);
        last.WX = rolls ? last.VZ * _perRadius : start.WX + (dt * sumBX);
        last.WY = start.WY + (dt * sumBY);
        last.WZ = rolls ? -last.VX * _perRadius : start.WZ + (dt * sumBZ);

        // Reject the step if the slip, roll, load, grip or spin about the normal may end, the surface changes, or the drag law jumps. Extrapolate the
        // load at the end from the stages.
        double endX = rolls ? last.VX : last.VX + (_radius * last.WZ);
        double endZ = rolls ? last.VZ : last.VZ - (_radius * last.WX);
        double endLoad = rates.Load + Math.Min(0, rates.Load - first.Load);
        double friction = Ample * material.Sliding * endLoad;
        if (!((endX * on.X) + (endZ * on.Z) > 0) || !(first.Load > Slight * _weight) || !(endLoad > Slight * _weight)
            || (rolls && (Energy(in last) <= _restEnergy * 1.001 || !(Math.Max(first.TractionSquared, rates.TractionSquared) <= friction * friction)))
            || start.WY * last.WY < 0
            || (_locatesJump && MayCrossJump(in on, in start, in first, in last, dt)))
        {
            return false;
        }

        double alongX = dt * (_movesWithEnd ? last.VX : sumVX);
        double alongZ = dt * (_movesWithEnd ? last.VZ : sumVZ);
        Vector3d position = _isLevel
            ? new Vector3d(s.Position.X + alongX, s.Position.Y, s.Position.Z + alongZ)
            : s.Position + (alongX * _axisX) + (alongZ * _axisZ);
        if (_materials.Length > 1 && _world.Ground!.PatchAt(in position) != patch)
        {
            return false;
        }

        // There is no event: move the ball.
        log.Evaluations += _weights.Length;
        log.Steps++;

        // The axis turns too: ∫ω dt + h²/12 ω(h) × ω(0), the fourth-order Magnus series. For a large turn, use the sixth order.
        sumWX = rolls ? sumVZ * _perRadius : sumWX;
        sumWZ = rolls ? -sumVX * _perRadius : sumWZ;
        var mean = new Vector3d(_movesWithEnd ? last.WX : sumWX, _movesWithEnd ? last.WY : sumWY, _movesWithEnd ? last.WZ : sumWZ);
        Vector3d commutator = dt * dt * Vector3d.Cross(last.Spin, start.Spin);
        Vector3d turned = commutator.LengthSquared <= LittleTurn * LittleTurn || _order < 4
            ? (dt * mean) + ((1.0 / 12.0) * commutator)
            : RotationVector.Of(start.Spin, 0.25 * ((6.0 * mean) - start.Spin - at.Spin), last.Spin, dt);
        Vector3d turn = InWorld(turned.X, turned.Y, turned.Z);
        if (log.IsWatched)
        {
            MoveAndShow<TMotion>(log, ref s, in on, in material, in position, in turn, in first, in last, dt, end, alongX, alongZ);
            return true;
        }

        Move(ref s, in on, in position, in turn, in last, end);
        return true;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Move(ref BallState s, in PlaneStart on, in Vector3d position, in Vector3d turn, in PlaneMotion last, double end)
    {
        s.BaseOrientation = s.BaseOrientation.Turned(in turn);
        s.Position = position;
        s.Flight.Velocity = InWorld(last.VX, 0, last.VZ);
        s.Flight.Axis = InWorld(last.WX, last.WY, last.WZ);
        s.Branch = on.Branch;
        s.Time = end;
    }

    /// <summary>Moves the ball, and reports the piece to the observer.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void MoveAndShow<TMotion>(
        StepLog log,
        ref BallState s,
        in PlaneStart on,
        in PlaneMaterial material,
        in Vector3d position,
        in Vector3d turn,
        in PlaneRates first,
        in PlaneMotion last,
        double dt,
        double end,
        double alongX,
        double alongZ)
        where TMotion : struct, ISurfaceMotion
    {
        BallState before = s;
        Move(ref s, in on, in position, in turn, in last, end);
        PlaneRates rates = default;
        Vector3d start = InWorld(first.AX, 0, first.AZ);
        if (log.WantsEnd(in before, in s, in start))
        {
            RatesOf<TMotion>(in on, in material, in last, dt, alongX, alongZ, out rates);
            log.Evaluations++;
        }

        log.Show(in before, in s, in start, InWorld(rates.AX, 0, rates.AZ), _order);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector3d InWorld(double x, double y, double z) => _isLevel ? new Vector3d(x, y, z) : (x * _axisX) + (y * _normal) + (z * _axisZ);

    private PlaneMotion InPlane(in FlightMotion motion)
    {
        PlaneMotion at;
        at.VX = Vector3d.Dot(in motion.Velocity, in _axisX);
        at.VZ = Vector3d.Dot(in motion.Velocity, in _axisZ);
        at.WX = Vector3d.Dot(in motion.Axis, in _axisX);
        at.WY = Vector3d.Dot(in motion.Axis, in _normal);
        at.WZ = Vector3d.Dot(in motion.Axis, in _axisZ);
        return at;
    }

    /// <summary>½ m v² + ½ I ω², J.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private double Energy(in PlaneMotion at) => (_halfMass * ((at.VX * at.VX) + (at.VZ * at.VZ))) + (_halfInertia * ((at.WX * at.WX) + (at.WY * at.WY) + (at.WZ * at.WZ)));

    /// <summary>Computes the rates of change at one instant: the laws of the air, then the forces that follow from them.</summary>
    /// <remarks>
    /// The laws of the air have a long latency, so everything else is summed meanwhile: a = A + lift B − drag C − decay D.
    /// B and C contain the air's share in the load, and so in friction.
    /// </remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void RatesOf<TMotion>(in PlaneStart on, in PlaneMaterial material, in PlaneMotion at, double after, double wayX, double wayZ, out PlaneRates rates)
        where TMotion : struct, ISurfaceMotion
    {
        double vx = at.VX;
        double vz = at.VZ;
        double wx = at.WX;
        double wy = at.WY;
        double wz = at.WZ;

        // The velocity relative to the air, u, and ω × u.
        double ux = vx - _windX;
        double uy = -_windUp;
        double uz = vz - _windZ;
        DragBranch branch = on.Branch;
        if (_air.HasField)
        {
            // Only the wind varies here: custom forces are excluded, and the knuckle force acts only in flight.
            Vector3d wind = WindAt(in on, after, wayX, wayZ);
            ux -= wind.X;
            uy -= wind.Y;
            uz -= wind.Z;
            branch = DragJump.Choose(
                _around.Air.Laws.Jumps, locates: false, branch, (ux * ux) + (uy * uy) + (uz * uz), _radiusSquared * ((wx * wx) + (wy * wy) + (wz * wz)));
        }

        double speedSquared = (ux * ux) + (uy * uy) + (uz * uz);
        double spinSquared = (wx * wx) + (wy * wy) + (wz * wz);
        double crossX = (wy * uz) - (wz * uy);
        double crossUp = (wz * ux) - (wx * uz);
        double crossZ = (wx * uy) - (wy * ux);
        bool spins = _air.FactorsPerSpin(
            speedSquared,
            spinSquared,
            (crossX * crossX) + (crossUp * crossUp) + (crossZ * crossZ),
            branch,
            out double drag,
            out double lift,
            out double decay);

        // a_air = L (ω × u) − D u; N/m = −a_b·n, minus a_air·n if the air adds to the load.
        double upByLift = _airInLoad * crossUp;
        double upByDrag = _airInLoad * uy;
        double load = _weight - ((lift * upByLift) - (drag * upByDrag));
        double slowing = spins ? decay : 0;
        rates.Load = load;
        rates.BY = -(((material.Damping + slowing) * wy) + (on.SpinSign * material.Drilling * load));
        if (default(TMotion).Rolls)
        {
            double speed = Math.Sqrt((vx * vx) + (vz * vz));
            bool goesOn = (vx * on.X) + (vz * on.Z) > 0;
            double perSpeed = 1.0 / speed;
            double friction = material.Rolling + (material.RollingBySpeed * speed);
            double fx = friction * (goesOn ? vx * perSpeed : on.X);
            double fz = friction * (goesOn ? vz * perSpeed : on.Z);

            // The air's torque T = −decay ω accelerates a rolling ball by r T × n, which equals −decay v.
            double ax = (_bodyXInRoll - (_weight * fx)) + (lift * ((_airInRoll * crossX) + (upByLift * fx)))
                - ((drag * ((_airInRoll * ux) + (upByDrag * fx))) + (decay * (_decayInRoll * vx)));
            double az = (_bodyZInRoll - (_weight * fz)) + (lift * ((_airInRoll * crossZ) + (upByLift * fz)))
                - ((drag * ((_airInRoll * uz) + (upByDrag * fz))) + (decay * (_decayInRoll * vz)));
            rates.AX = ax;
            rates.AZ = az;
            rates.BX = az * _perRadius;
            rates.BZ = -ax * _perRadius;
            double tractionX = _bodyXInTraction + (_airInTraction * ((lift * crossX) - (drag * ux) + (decay * vx)));
            double tractionZ = _bodyZInTraction + (_airInTraction * ((lift * crossZ) - (drag * uz) + (decay * vz)));
            rates.TractionSquared = (tractionX * tractionX) + (tractionZ * tractionZ);
            rates.BrakingSquared = 0;
        }
        else
        {
            double sx = vx + (_radius * wz);
            double sz = vz - (_radius * wx);
            double size = Math.Sqrt((sx * sx) + (sz * sz));
            bool slips = (sx * on.X) + (sz * on.Z) > 0;
            double perSize = 1.0 / size;
            sx = slips ? perSize * sx : on.X;
            sz = slips ? perSize * sz : on.Z;
            double fx = material.Sliding * sx;
            double fz = material.Sliding * sz;
            rates.AX = (_bodyX - (_weight * fx)) + ((lift * ((_airInSlide * crossX) + (upByLift * fx))) - (drag * ((_airInSlide * ux) + (upByDrag * fx))));
            rates.AZ = (_bodyZ - (_weight * fz)) + ((lift * ((_airInSlide * crossZ) + (upByLift * fz))) - (drag * ((_airInSlide * uz) + (upByDrag * fz))));

            // n × ŝ. If the ball has no spin, the air's torque reduces the torque of friction, but never reverses it.
            double turning = material.SlidingTorque * load;
            turning = spins ? turning : Math.Max(0, turning - decay);
            rates.BX = (turning * sz) - (slowing * wx);
            rates.BZ = -((turning * sx) + (slowing * wz));
            rates.TractionSquared = 0;
            rates.BrakingSquared = spins ? decay * decay * spinSquared : decay * decay;
        }
    }

    /// <summary>Returns the wind at a position and time, in the plane's axes.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private Vector3d WindAt(in PlaneStart on, double after, double wayX, double wayZ)
    {
        Vector3d at = on.From + InWorld(wayX, 0, wayZ);
        Vector3d wind = _air.WindAt(on.Time + after, at.X, at.Y, at.Z);
        return new Vector3d(Vector3d.Dot(in wind, in _axisX), Vector3d.Dot(in wind, in _normal), Vector3d.Dot(in wind, in _axisZ));
    }

    /// <summary>True if the step may have crossed the jump in the drag law (conservative).</summary>
    private bool MayCrossJump(in PlaneStart on, in PlaneMotion start, in PlaneRates rates, in PlaneMotion end, double h)
    {
        DragJump from = JumpAt(in start);
        double ux = start.VX - _windX;
        double uz = start.VZ - _windZ;
        var change = DragJump.Rate(
            2.0 * ((ux * rates.AX) + (uz * rates.AZ)), 2.0 * _radiusSquared * ((start.WX * rates.BX) + (start.WY * rates.BY) + (start.WZ * rates.BZ)));
        DragJump to = JumpAt(in end);
        return DragJump.MayCross(on.Branch, in from, in change, in to, h);
    }

    private DragJump JumpAt(in PlaneMotion at)
    {
        double ux = at.VX - _windX;
        double uz = at.VZ - _windZ;
        return DragJump.At(
            (ux * ux) + (_windUp * _windUp) + (uz * uz), _radiusSquared * ((at.WX * at.WX) + (at.WY * at.WY) + (at.WZ * at.WZ)));
    }
}
