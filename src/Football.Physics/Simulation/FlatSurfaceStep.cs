using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>
/// Whole steps of sliding and rolling on flat ground with nothing else near: nearly every step that a ball takes on the ground. The motion has two components
/// along the plane and three of spin, in the plane's own axes; the load needs no curvature, and nothing is searched for.
/// <see cref="TryWhole"/> proposes the step, takes it, asks whether anything may have happened in it, and moves the ball. Where something may, nothing is done
/// and <see cref="SurfacePhase{TIntegrator}"/> takes the step in pieces, by the same equations on any surface.
/// </summary>
/// <remarks>
/// With a_b gravity and buoyancy, a_air the air's push, T its torque per moment of inertia and N the load per mass:
/// sliding a = a_b + a_air − μ_s N ŝ, ω̇ = (μ_s N/(α r)) n × ŝ + T; rolling a = (a_b + a_air + α r T × n)/(1 + α) − (c₀ + c₁|v|) N v̂ where the air is shared
/// with the spin, else a_b/(1 + α) + a_air − …; about the normal −(c_ω/I) ω_n − sign(ω_n) b μ_s N m/I.
/// </remarks>
internal sealed class FlatSurfaceStep
{
    /// <summary>Where the axis of the spin turns so little in a step that h² |ω(h) × ω(0)| is below this, two terms of Magnus' series do: they leave out some thousandths of it (WholeRun).</summary>
    private const double LittleTurn = 1e-3;

    /// <summary>A rolling ball that needs more than this share of the friction that it has, or a load that has less than this of the weight left, is looked at closely.</summary>
    private const double Ample = 0.9;
    private const double Slight = 0.05;

    private readonly Surroundings _around;
    private readonly World _world;
    private readonly AirLaws _laws;
    private readonly ClearFlight? _clear;
    private readonly StabilityLimit _limit;
    private readonly Material[] _materials;
    private readonly bool _acts;
    private readonly bool _slides;
    private readonly bool _locatesJump;
    private readonly bool _semiImplicit;
    private readonly bool _varies;
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
    private readonly double _airAlong;
    private readonly double _bodyInRoll;
    private readonly double _airInRoll;
    private readonly double _decayInRoll;
    private readonly double _bodyInTraction;
    private readonly double _airInTraction;
    private readonly double _halfMass;
    private readonly double _halfInertia;
    private readonly double _restEnergy;
    private readonly double _fastestWind;

    /// <summary>Prepares the steps of a scene.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="settings">The method.</param>
    /// <param name="around">What acts on the ball.</param>
    /// <param name="limit">How long a step may be.</param>
    /// <param name="clear">Finds out whether anything is near; null where there is nothing but the ground.</param>
    /// <param name="locatesJump">Whether steps end at the drag law's jump.</param>
    public FlatSurfaceStep(Scene scene, SolverSettings settings, Surroundings around, in StabilityLimit limit, ClearFlight? clear, bool locatesJump)
    {
        _around = around;
        _world = around.World!;
        _laws = around.Air.Laws;
        _clear = clear;
        _limit = limit;
        _locatesJump = locatesJump;
        _varies = around.Air.Varies;
        _acts = !scene.Ground.IsNone && scene.Ground.Heights is null && scene.Forces.Custom.Count == 0;
        _slides = settings.RollingTransition == RollingTransition.Exact;
        (_offsets, _weights, _order) = settings.Integrator switch
        {
            Integrator.Rk4 => (new[] { 0, 0.5, 0.5, 1.0 }, new[] { 1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0 }, 4),
            Integrator.Rk2 => (new[] { 0, 0.5 }, new[] { 0, 1.0 }, 2),
            Integrator.Euler or Integrator.SemiImplicitEuler => (new[] { 0.0 }, new[] { 1.0 }, 1),
            _ => throw Check.Unknown("solver.integrator", settings.Integrator),
        };
        _semiImplicit = settings.Integrator == Integrator.SemiImplicitEuler;

        // The plane's axes: on a level pitch those of the world.
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

        BallProperties ball = scene.Ball;
        double alpha = ball.InertiaFactor;
        _radius = ball.Radius;
        _perRadius = 1.0 / ball.Radius;
        _radiusSquared = ball.Radius * ball.Radius;
        _halfMass = 0.5 * ball.Mass;
        _halfInertia = 0.5 * ball.MomentOfInertia;
        _restEnergy = scene.Ground.RestEnergy;
        _fastestWind = around.Air.FastestWind;
        bool shares = _world.SharesAir;
        _airAlong = _world.AirActs ? 1 : 0;
        _airInLoad = _world.AirLoads ? 1 : 0;
        _bodyInRoll = 1.0 / (1.0 + alpha);
        _airInRoll = shares ? 1.0 / (1.0 + alpha) : 1;
        _decayInRoll = shares ? alpha / (1.0 + alpha) : 0;
        _bodyInTraction = alpha / (1.0 + alpha);
        _airInTraction = _decayInRoll;
        ContactMaterial[] materials = _acts ? _world.Ground!.Materials : [];
        _materials = new Material[materials.Length];
        for (int i = 0; i < materials.Length; i++)
        {
            _materials[i] = new Material(in materials[i], ball);
        }
    }

    /// <summary>A whole step, done if nothing happens in it.</summary>
    /// <returns>False where something may happen; then nothing is done.</returns>
    public bool TryWhole(ref BallState s, double dt, StepLog log)
    {
        bool rolls = s.Motion == MotionState.Rolling;
        if (!_acts || s.Carrier != 0 || s.Nets != 0 || !(rolls || _slides))
        {
            return false;
        }

        // The motion in the plane's axes. What a roll leaves of the spin is that about the normal.
        Vector3d velocity = s.Velocity;
        Vector3d spin = s.SpinAxis;
        PlaneMotion at;
        at.VX = Vector3d.Dot(in velocity, in _axisX);
        at.VZ = Vector3d.Dot(in velocity, in _axisZ);
        at.WX = Vector3d.Dot(in spin, in _axisX);
        at.WY = Vector3d.Dot(in spin, in _normal);
        at.WZ = Vector3d.Dot(in spin, in _axisZ);
        PlaneMotion start = at;

        // Propose: the whole step, if there is a direction of the roll or the slip, and the air is not too strong.
        double x = rolls ? at.VX : at.VX + (_radius * at.WZ);
        double z = rolls ? at.VZ : at.VZ - (_radius * at.WX);
        double size = Math.Sqrt((x * x) + (z * z));
        double perSize = 1.0 / size;
        double airX = at.VX - _windX;
        double airZ = at.VZ - _windZ;
        double spinSquared = (at.WX * at.WX) + (at.WY * at.WY) + (at.WZ * at.WZ);
        double airSpeedSquared = (airX * airX) + (_windUp * _windUp) + (airZ * airZ);
        int patch = _materials.Length > 1 ? _world.Ground!.PatchAt(s.Position) : -1;
        StepOn on;
        on.Material = _materials[patch + 1];
        double airSpeed = Math.Abs(airX) + Math.Abs(_windUp) + Math.Abs(airZ) + _fastestWind;
        double spinAtMost = Math.Abs(at.WX) + Math.Abs(at.WY) + Math.Abs(at.WZ);
        if (!(size >= Slip.Rolling) || !(dt * (_limit.RateAtMost(airSpeed, spinAtMost) + on.Material.Damping) <= StabilityLimit.LargestChange)
            || (rolls && Energy(in at) <= _restEnergy * 1.001)
            || (_materials.Length > 1 && !(_world.Ground!.LeastWidth >= 2.0 * dt * size))
            || (_clear is not null && !_clear.HoldsOnSurface(ref s, dt, Math.Sqrt(airSpeedSquared) + _fastestWind, Math.Sqrt(spinSquared))))
        {
            return false;
        }

        on.Rolls = rolls;
        on.X = x * perSize;
        on.Z = z * perSize;
        on.SpinSign = at.WY > Slip.Rolling ? 1.0 : at.WY < -Slip.Rolling ? -1.0 : 0.0;
        on.Time = s.Time;
        on.From = s.Position;
        bool known = _locatesJump && s.Branch is DragBranch.NoSpin or DragBranch.Spinning;
        on.Branch = !_around.Air.Jumps || known ? s.Branch : DragJump.At(airSpeedSquared, _radiusSquared * spinSquared).Branch;

        // The first stage tells whether the direction turns too much on the way, by size at the end: then the step is taken in pieces.
        RatesOf(in on, in at, 0, 0, 0, out PlaneRates rates);
        PlaneRates first = rates;
        double rateX = rolls ? rates.AX : rates.AX + (_radius * rates.BZ);
        double rateZ = rolls ? rates.AZ : rates.AZ - (_radius * rates.BX);
        double across = Math.Abs((rateX * on.Z) - (rateZ * on.X));
        if (!TurnLimit.Allows(size, dt * ((rateX * on.X) + (rateZ * on.Z)), dt * across) || !(first.Braking <= Ample * on.Material.SlidingTorque * first.Load))
        {
            return false;
        }

        // Take it: the stages of the method, each from the start and the rates of the one before.
        double weight = _weights[0];
        double sumVX = weight * at.VX;
        double sumVZ = weight * at.VZ;
        double sumWX = weight * at.WX;
        double sumWY = weight * at.WY;
        double sumWZ = weight * at.WZ;
        PlaneRates sum = rates.Scaled(weight);
        for (int stage = 1; stage < _weights.Length; stage++)
        {
            double h = _offsets[stage] * dt;
            double wayX = h * at.VX;
            double wayZ = h * at.VZ;
            start.After(h, in rates, out at);
            Slave(rolls, ref at);
            RatesOf(in on, in at, h, wayX, wayZ, out rates);
            weight = _weights[stage];
            sumVX += weight * at.VX;
            sumVZ += weight * at.VZ;
            sumWX += weight * at.WX;
            sumWY += weight * at.WY;
            sumWZ += weight * at.WZ;
            sum.Add(weight, in rates);
        }

        start.After(dt, in sum, out PlaneMotion end);
        Slave(rolls, ref end);

        // Guards: the slip ends, the roll ends or needs more than friction gives, the load ends, the spin about the normal ends, another surface begins, the drag law jumps.
        // The load and the traction at the end are what the stages lead to.
        double endX = rolls ? end.VX : end.VX + (_radius * end.WZ);
        double endZ = rolls ? end.VZ : end.VZ - (_radius * end.WX);
        double endLoad = rates.Load + Math.Min(0, rates.Load - first.Load);
        double friction = Ample * on.Material.Sliding * endLoad;
        if (!((endX * on.X) + (endZ * on.Z) > 0) || !(first.Load > Slight * _weight) || !(endLoad > Slight * _weight)
            || (rolls && (Energy(in end) <= _restEnergy * 1.001 || !(Math.Max(first.TractionSquared, rates.TractionSquared) <= friction * friction)))
            || start.WY * end.WY < 0
            || (_locatesJump && MayCrossJump(in on, in start, in first, in end, dt)))
        {
            return false;
        }

        double alongX = dt * (_semiImplicit ? end.VX : sumVX);
        double alongZ = dt * (_semiImplicit ? end.VZ : sumVZ);
        Vector3d position = s.Position + (alongX * _axisX) + (alongZ * _axisZ);
        if (_materials.Length > 1 && _world.Ground!.PatchAt(in position) != patch)
        {
            return false;
        }

        // Nothing happened: move the ball.
        log.Evaluations += _weights.Length;
        log.Steps++;

        // The axis turns as well: ∫ω dt + h²/12 ω(h) × ω(0), Magnus' series to the fourth order; where it turns much, to the sixth.
        var mean = new Vector3d(_semiImplicit ? end.WX : sumWX, _semiImplicit ? end.WY : sumWY, _semiImplicit ? end.WZ : sumWZ);
        Vector3d commutator = dt * dt * Vector3d.Cross(end.Spin, start.Spin);
        Vector3d turned = commutator.LengthSquared <= LittleTurn * LittleTurn || _order < 4
            ? (dt * mean) + ((1.0 / 12.0) * commutator)
            : RotationVector.Of(start.Spin, 0.25 * ((6.0 * mean) - start.Spin - at.Spin), end.Spin, dt);
        Vector3d turn = InWorld(turned.X, turned.Y, turned.Z);
        if (log.Observer is not null)
        {
            MoveAndShow(log, ref s, in on, in position, in turn, in first, in end, dt, alongX, alongZ);
            return true;
        }

        Move(ref s, in on, in position, in turn, in end, dt);
        return true;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Move(ref BallState s, in StepOn on, in Vector3d position, in Vector3d turn, in PlaneMotion end, double dt)
    {
        s.BaseOrientation = s.BaseOrientation.Turned(in turn);
        s.Position = position;
        s.Velocity = InWorld(end.VX, 0, end.VZ);
        s.SpinAxis = InWorld(end.WX, end.WY, end.WZ);
        s.Branch = on.Branch;
        s.Time += dt;
    }

    /// <summary>Moves the ball, and shows the piece to the observer.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void MoveAndShow(
        StepLog log,
        ref BallState s,
        in StepOn on,
        in Vector3d position,
        in Vector3d turn,
        in PlaneRates first,
        in PlaneMotion end,
        double dt,
        double alongX,
        double alongZ)
    {
        BallState before = s;
        Move(ref s, in on, in position, in turn, in end, dt);
        PlaneRates last = default;
        if (log.Observer!.WantsEndAcceleration)
        {
            RatesOf(in on, in end, dt, alongX, alongZ, out last);
            log.Evaluations++;
        }

        log.Show(in before, in s, InWorld(first.AX, 0, first.AZ), InWorld(last.AX, 0, last.AZ), _order);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector3d InWorld(double x, double y, double z) => (x * _axisX) + (y * _normal) + (z * _axisZ);

    /// <summary>½ m v² + ½ I ω², J.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private double Energy(in PlaneMotion at) => (_halfMass * ((at.VX * at.VX) + (at.VZ * at.VZ))) + (_halfInertia * ((at.WX * at.WX) + (at.WY * at.WY) + (at.WZ * at.WZ)));

    /// <summary>The spin of a ball that rolls: ω_t = n × v / r.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Slave(bool rolls, ref PlaneMotion at)
    {
        if (rolls)
        {
            at.WX = at.VZ * _perRadius;
            at.WZ = -at.VX * _perRadius;
        }
    }

    /// <summary>The rates of change at one instant: the laws of the air at a point, and what follows from them.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void RatesOf(in StepOn on, in PlaneMotion at, double after, double wayX, double wayZ, out PlaneRates rates)
    {
        if (_varies)
        {
            RatesInVaryingAir(in on, in at, after, wayX, wayZ, out rates);
            return;
        }

        double ux = at.VX - _windX;
        double uy = -_windUp;
        double uz = at.VZ - _windZ;

        // |ω̂ × u|² = |ω × u|²/|ω|², whose division does not wait for the root.
        double spinSquared = (at.WX * at.WX) + (at.WY * at.WY) + (at.WZ * at.WZ);
        bool spins = spinSquared > AirRates.NoSpin;
        double perSquared = spins ? 1.0 / spinSquared : 0;
        double rate = spins ? Math.Sqrt(spinSquared) : 0;
        double crossX = (at.WY * uz) - (at.WZ * uy);
        double crossUp = (at.WZ * ux) - (at.WX * uz);
        double crossZ = (at.WX * uy) - (at.WY * ux);
        double acrossSquared = perSquared * ((crossX * crossX) + (crossUp * crossUp) + (crossZ * crossZ));
        _laws.Factors((ux * ux) + (uy * uy) + (uz * uz), rate, acrossSquared, on.Branch, out double drag, out double lift, out double decay);
        double perRate = spins ? perSquared * rate : 1.0;
        FlowPast flow;
        flow.X = ux;
        flow.Up = uy;
        flow.Z = uz;
        flow.Drag = drag;
        flow.Lift = lift * perRate;
        flow.Decay = decay * perRate;
        flow.Spins = spins;
        flow.Braking = decay;
        RatesUnder(in on, in at, in flow, 0, 0, 0, 0, 0, 0, out rates);
    }

    /// <summary>The same in wind by place and time.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void RatesInVaryingAir(in StepOn on, in PlaneMotion at, double after, double wayX, double wayZ, out PlaneRates rates)
    {
        Vector3d velocity = InWorld(at.VX, 0, at.VZ);
        Vector3d spin = InWorld(at.WX, at.WY, at.WZ);
        Vector3d position = on.From + InWorld(wayX, 0, wayZ);
        Vector3d u = velocity - _around.Wind;
        var ball = new ForceInput(on.Time + after, in position, in velocity, in u, in spin, on.Rolls ? MotionState.Rolling : MotionState.Sliding);
        double rate = _around.Air.Evaluate(in ball, on.Branch, out AirFactors air);
        FlowPast flow;
        flow.X = Vector3d.Dot(in air.AirVelocity, in _axisX);
        flow.Up = Vector3d.Dot(in air.AirVelocity, in _normal);
        flow.Z = Vector3d.Dot(in air.AirVelocity, in _axisZ);
        flow.Drag = air.Drag;
        flow.Lift = air.Lift;
        flow.Decay = air.Decay;
        flow.Spins = rate > 0;
        flow.Braking = rate > 0 ? air.Decay * rate : air.Decay;
        Vector3d a = air.Acceleration;
        Vector3d t = air.SpinAcceleration;
        RatesUnder(
            in on,
            in at,
            in flow,
            Vector3d.Dot(in a, in _axisX),
            Vector3d.Dot(in a, in _normal),
            Vector3d.Dot(in a, in _axisZ),
            Vector3d.Dot(in t, in _axisX),
            Vector3d.Dot(in t, in _normal),
            Vector3d.Dot(in t, in _axisZ),
            out rates);
    }

    /// <summary>The rates of change in a flow, and under pushes and torques that are not along it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void RatesUnder(
        in StepOn on,
        in PlaneMotion at,
        in FlowPast flow,
        double pushX,
        double pushUp,
        double pushZ,
        double torqueX,
        double torqueUp,
        double torqueZ,
        out PlaneRates rates)
    {
        double ux = flow.X;
        double uy = flow.Up;
        double uz = flow.Z;
        double drag = flow.Drag;
        double lift = flow.Lift;
        double decay = flow.Decay;

        // a = L (ω × u) − D u
        double airX = (_airAlong * ((lift * ((at.WY * uz) - (at.WZ * uy))) - (drag * ux))) + pushX;
        double airUp = (lift * ((at.WZ * ux) - (at.WX * uz))) - (drag * uy) + pushUp;
        double airZ = (_airAlong * ((lift * ((at.WX * uy) - (at.WY * ux))) - (drag * uz))) + pushZ;
        double load = _weight - (_airInLoad * airUp);
        rates.Load = load;
        ref readonly Material material = ref on.Material;
        rates.BY = torqueUp - ((material.Damping + (flow.Spins ? decay : 0)) * at.WY) - (on.SpinSign * material.Drilling * load);
        if (on.Rolls)
        {
            double speed = Math.Sqrt((at.VX * at.VX) + (at.VZ * at.VZ));
            bool goesOn = (at.VX * on.X) + (at.VZ * on.Z) > 0;
            double perSpeed = 1.0 / speed;
            double dx = goesOn ? at.VX * perSpeed : on.X;
            double dz = goesOn ? at.VZ * perSpeed : on.Z;

            // The air's torque turns the ball by itself: r T × n, with T = −decay ω that of −decay v.
            double turnedX = (decay * at.VX) + (_radius * torqueZ);
            double turnedZ = (decay * at.VZ) - (_radius * torqueX);
            double friction = (material.Rolling + (material.RollingBySpeed * speed)) * load;
            rates.AX = (_bodyInRoll * _bodyX) + (_airInRoll * airX) - (_decayInRoll * turnedX) - (friction * dx);
            rates.AZ = (_bodyInRoll * _bodyZ) + (_airInRoll * airZ) - (_decayInRoll * turnedZ) - (friction * dz);
            rates.BX = rates.AZ * _perRadius;
            rates.BZ = -rates.AX * _perRadius;
            double tractionX = (_bodyInTraction * _bodyX) + (_airInTraction * (airX + turnedX));
            double tractionZ = (_bodyInTraction * _bodyZ) + (_airInTraction * (airZ + turnedZ));
            rates.TractionSquared = (tractionX * tractionX) + (tractionZ * tractionZ);
            rates.Braking = 0;
        }
        else
        {
            double sx = at.VX + (_radius * at.WZ);
            double sz = at.VZ - (_radius * at.WX);
            double size = Math.Sqrt((sx * sx) + (sz * sz));
            bool slips = (sx * on.X) + (sz * on.Z) > 0;
            double perSize = 1.0 / size;
            sx = slips ? perSize * sx : on.X;
            sz = slips ? perSize * sz : on.Z;
            double friction = material.Sliding * load;

            // n × ŝ; a ball without spin is held by the air as it begins to turn, and no more than that.
            double turning = material.SlidingTorque * load;
            turning = flow.Spins ? turning : Math.Max(0, turning - flow.Braking);
            decay = flow.Spins ? decay : 0;
            rates.AX = _bodyX + airX - (friction * sx);
            rates.AZ = _bodyZ + airZ - (friction * sz);
            rates.BX = torqueX - (decay * at.WX) + (turning * sz);
            rates.BZ = torqueZ - (decay * at.WZ) - (turning * sx);
            rates.TractionSquared = 0;
            rates.Braking = flow.Braking;
        }
    }

    /// <summary>Whether the step may have crossed the drag law's jump: errs towards yes.</summary>
    private bool MayCrossJump(in StepOn on, in PlaneMotion start, in PlaneRates rates, in PlaneMotion end, double h)
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

    /// <summary>The numbers of a surface, per mass and per moment of inertia where that is so.</summary>
    private readonly struct Material(in ContactMaterial of, BallProperties ball)
    {
        /// <summary>μ_s.</summary>
        public readonly double Sliding = of.SlidingFriction;

        /// <summary>μ_s/(α r), 1/m: the angular acceleration for a load per mass.</summary>
        public readonly double SlidingTorque = of.SlidingFriction / (ball.InertiaFactor * ball.Radius);

        /// <summary>c₀.</summary>
        public readonly double Rolling = of.RollingFriction;

        /// <summary>c₁, s/m.</summary>
        public readonly double RollingBySpeed = of.RollingFrictionBySpeed;

        /// <summary>b μ_s m/I, 1/m.</summary>
        public readonly double Drilling = of.DrillingLength * of.SlidingFriction * ball.Mass / ball.MomentOfInertia;

        /// <summary>c_ω/I, 1/s.</summary>
        public readonly double Damping = of.SpinDamping / ball.MomentOfInertia;
    }

    /// <summary>What stays the same in a step.</summary>
    private struct StepOn
    {
        public Material Material;
        public Vector3d From;
        public double Time;

        /// <summary>Direction of the roll or the slip at the start: what friction keeps to where a stage passes zero.</summary>
        public double X;
        public double Z;

        /// <summary>Which way it spins about the normal: drilling friction keeps to it.</summary>
        public double SpinSign;
        public DragBranch Branch;
        public bool Rolls;
    }

    /// <summary>The flow past the ball, and the factors of a = L (ω × u) − D u, ω̇ = −decay ω; without spin that is the angular deceleration itself.</summary>
    private struct FlowPast
    {
        public double X;
        public double Up;
        public double Z;
        public double Drag;
        public double Lift;
        public double Decay;

        /// <summary>By how much the air slows the spin, rad/s²; of a ball without spin, by how much it holds one that begins to turn.</summary>
        public double Braking;
        public bool Spins;
    }

    /// <summary>Velocity along the plane and spin, in the plane's axes: x and z along it, y its normal.</summary>
    private struct PlaneMotion
    {
        public double VX;
        public double VZ;
        public double WX;
        public double WY;
        public double WZ;

        public readonly Vector3d Spin => new(WX, WY, WZ);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public readonly void After(double h, in PlaneRates rates, out PlaneMotion after)
        {
            after.VX = VX + (h * rates.AX);
            after.VZ = VZ + (h * rates.AZ);
            after.WX = WX + (h * rates.BX);
            after.WY = WY + (h * rates.BY);
            after.WZ = WZ + (h * rates.BZ);
        }
    }

    /// <summary>Their rates of change, the load per mass, the square of what a roll asks of friction, per mass, and how much the air slows the spin of a slide.</summary>
    private struct PlaneRates
    {
        public double AX;
        public double AZ;
        public double BX;
        public double BY;
        public double BZ;
        public double Load;
        public double TractionSquared;
        public double Braking;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public readonly PlaneRates Scaled(double weight)
        {
            PlaneRates scaled = default;
            scaled.AX = weight * AX;
            scaled.AZ = weight * AZ;
            scaled.BX = weight * BX;
            scaled.BY = weight * BY;
            scaled.BZ = weight * BZ;
            return scaled;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Add(double weight, in PlaneRates rates)
        {
            AX += weight * rates.AX;
            AZ += weight * rates.AZ;
            BX += weight * rates.BX;
            BY += weight * rates.BY;
            BZ += weight * rates.BZ;
        }
    }
}
