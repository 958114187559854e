namespace Football.Physics;

/// <summary>
/// Sliding and rolling on any surface of the world, piece by piece: up to the drag law's jump, the first thing that is met, the end of the slip or of
/// the grip, the place where the load ends, or rest.
/// </summary>
internal sealed class CarriedPhase<TAir, TIntegrator>
    where TAir : struct, IAir
    where TIntegrator : struct, IIntegrator
{
    /// <summary>The last of a slide, this share of a step long, is done in closed form.</summary>
    private const double ClosedForm = 0.0025;

    /// <summary>The normal turns by no more than this in a piece, rad.</summary>
    private const double LargestTurn = 0.05;

    private readonly Surroundings<TAir> _around;
    private readonly World _world;
    private readonly StabilityLimit _limit;
    private readonly DragJumpGuard<TAir> _jump;
    private readonly WorldGuard<TAir> _guard;
    private readonly WorldContact<TAir> _contact;
    private readonly NetGuard _nets;
    private readonly ImplicitPhase<TAir> _implicit;
    private readonly TIntegrator _integrator;
    private readonly double _alpha;
    private readonly double _inertia;

    public CarriedPhase(
        Surroundings<TAir> around, in StabilityLimit limit, DragJumpGuard<TAir> jump, WorldGuard<TAir> guard, WorldContact<TAir> contact, ImplicitPhase<TAir> implicitPhase)
    {
        _around = around;
        _world = around.World!;
        _limit = limit;
        _jump = jump;
        _guard = guard;
        _contact = contact;
        _nets = new NetGuard(_world);
        _implicit = implicitPhase;
        _integrator = default;
        _alpha = _world.Ball.InertiaFactor;
        _inertia = _world.Ball.MomentOfInertia;
    }

    /// <summary>The next piece of a slide or a roll.</summary>
    public void Take(ref BallState s, ref StepRun run)
    {
        if (_guard.HitsAtOnce(ref s, ref run))
        {
            return;
        }

        // What acts here, and what becomes of the ball at once: it leaves, rests, grips, or slips.
        bool rolls = s.Motion == MotionState.Rolling;
        var from = new Motion(s.Position, s.Velocity, s.Spin);
        CarriedSystem<TAir> system = System(in s, in from, rolls);
        CarriedForces on = system.ForcesOn(s.Time, in from);
        run.Log.Evaluations++;
        if (on.FreeLoad <= CarriedForces.Least)
        {
            _contact.Leave(ref s, s.Velocity, s.Spin, ref run);
            return;
        }

        double sliding = system.SlidingFriction(in on);
        Vector3d traction = system.Traction(in on);
        bool grips = system.Grips(in on);
        Vector3d moving = rolls ? on.Velocity : system.SlipOf(in from, in on.Normal);
        double size = moving.Length;
        if (rolls && !grips)
        {
            _contact.StartSliding(ref s, ref run);
            return;
        }

        if (!rolls && size < Slip.Rolling && grips)
        {
            _contact.StartRolling(ref s, ref run);
            return;
        }

        if (rolls)
        {
            Vector3d drive = system.Drive(in on);
            bool held = drive.Length <= system.RollingFriction(in on, 0);
            if (held && _world.Energy(in from, system.Carrier) <= _world.RestEnergy * (1.0 + 1e-12))
            {
                _contact.Rest(ref s, ref run);
                return;
            }

            system.Pinned = size < Slip.Rolling && held;
            if (system.Pinned)
            {
                // What was left of its speed is none: it does not creep.
                s.Velocity = system.Carrier.Velocity;
                from = new Motion(s.Position, s.Velocity, s.Spin);
            }

            moving = size < Slip.Rolling ? drive : moving;
        }
        else
        {
            moving = size < Slip.Rolling ? traction : moving;
        }

        double length = moving.Length;
        system.Direction = length > 0 ? moving / length : Vector3d.Zero;
        double h = LongestPiece(in s, in from, in on, ref run);
        if (h <= 0)
        {
            _implicit.TakeRest(ref s, ref run);
            return;
        }

        if (size >= Slip.Rolling)
        {
            system.Rates(s.Time, in from, out MotionRates rates);
            run.Log.Evaluations++;
            double most = rolls ? system.RollingFriction(in on, size) : (1.0 + (1.0 / _alpha)) * sliding;
            Vector3d rate = rolls ? rates.Acceleration + (on.Centripetal * on.Normal) : SlipRate(in on, in rates);
            if (!rolls && sliding > 0 && system.Guides.Count == 0 && EndSlip(ref s, ref run, ref system, in from, in on, in moving, in rate, most, h))
            {
                return;
            }

            h = most > 0 ? GroundLimit<TAir>.Shorten(h, run.Length, system.Direction, size, in rate) : h;
        }

        TakePiece(ref s, ref run, ref system, in from, h);
    }

    /// <summary>Takes a piece, ends it at the first thing that happens in it, and moves the ball.</summary>
    private void TakePiece(ref BallState s, ref StepRun run, ref CarriedSystem<TAir> system, in Motion from, double h)
    {
        var sweep = new MotionSweep<CarriedSystem<TAir>, TIntegrator>(in system, s.Time, in from, _around.Wind, _around.Radius);
        sweep.Step(h);
        SurfacePath.Shorten(ref sweep, in s, _world, system.Carrier, in system.Guides, _integrator.Order);
        _jump.EndAtCrossingOnGround(ref sweep, ref s.Branch, ref run);
        double crossing = sweep.Length;
        bool overEdge = CarriedMargin<TAir, TIntegrator>.EndPiece(ref sweep, in s, system.Rolls);
        SurfaceBorder.EndBeyond(ref sweep, in s, system.Carrier);
        _nets.EndWhereSlack(ref sweep, in s);
        bool meets = _guard.EndAtFirst(ref sweep, in s, _integrator.Order, out Gap met);
        s.Branch = sweep.Length < crossing ? system.Branch : s.Branch;
        run.Log.Evaluations += sweep.Evaluations;
        BallState before = s;
        before.Branch = system.Branch;
        sweep.MoveTo(ref s);
        run.Advance(ref s, sweep.Length);
        Hold(ref s, in system, meets && met.What == Happening.Contact ? met.Index : -1);
        if (overEdge && run.Log.Observer is not null)
        {
            // What acts beyond the edge is no end of this path.
            Vector3d end = Extrapolate.Rate(before.Velocity, s.Velocity, sweep.StartAcceleration, sweep.Length);
            run.Log.Show(in before, in s, sweep.StartAcceleration, in end, _integrator.Order);
        }
        else
        {
            run.Show(in before, in s, ref sweep, _integrator.Order);
        }

        if (meets && !run.Log.Halted)
        {
            _guard.Meet(ref s, in met, ref run);
        }
    }

    /// <summary>The end of a slide in closed form: near it the push along the surface is all but constant.</summary>
    /// <returns>False where it is not near, or friction cannot hold the ball then.</returns>
    private bool EndSlip(
        ref BallState s,
        ref StepRun run,
        ref CarriedSystem<TAir> system,
        in Motion from,
        in CarriedForces on,
        in Vector3d slip,
        in Vector3d slipRate,
        double friction,
        double longest)
    {
        Vector3d push = slipRate + (friction * system.Direction);
        double size = slip.Length;
        if (!(size < 0.5 * friction * ClosedForm * Math.Min(run.Length, 0.01)) || !(push.LengthSquared < 0.25 * friction * friction))
        {
            return false;
        }

        var decay = new SlipDecay(in slip, in push, friction);
        double t = decay.Time;
        if (!(t > 0 && t <= longest))
        {
            return false;
        }

        // Along the way the ball goes by its own integral of the friction, then onto the surface again.
        double sliding = system.SlidingFriction(in on);
        Vector3d acceleration = on.Body + on.Air - (on.Centripetal * on.Normal);
        Vector3d velocity = from.Velocity + (t * acceleration) - (sliding * decay.Direction);
        Vector3d position = s.Position + (t * from.Velocity) + ((0.5 * t * t) * acceleration) - (sliding * decay.Twice);
        var path = PathCubic.Line(s.Position, (position - s.Position) / t, t);
        if (new ContactSearch(_world, in path, s.Time).First(in s, (int)s.Carrier - _world.FirstCollider, out _) <= t)
        {
            return false;
        }

        double about = Vector3d.Dot(from.Spin, on.Normal);
        system.Rates(s.Time, in from, out MotionRates rates);
        about += t * Vector3d.Dot(rates.SpinAcceleration, on.Normal);
        BallState before = s;
        Vector3d rolling = Slip.RollingSpin(velocity - system.Carrier.Velocity, about, in on.Normal, _around.Radius);
        s.BaseOrientation = s.BaseOrientation.Turned((0.5 * t) * (from.Spin + rolling));
        s.Position = position;
        s.Velocity = velocity;
        s.SpinAxis = rolling;
        run.Advance(ref s, t);
        Hold(ref s, in system, -1);
        if (run.Log.Observer is not null)
        {
            Vector3d end = Extrapolate.Rate(from.Velocity, s.Velocity, rates.Acceleration, t);
            run.Log.Show(in before, in s, rates.Acceleration, in end, _integrator.Order);
        }

        if (!run.Log.Halted)
        {
            CarriedForces there = system.ForcesOn(s.Time, new Motion(s.Position, s.Velocity, s.Spin));
            run.Log.Evaluations++;
            if (system.Grips(in there))
            {
                _contact.StartRolling(ref s, ref run);
            }
        }

        return true;
    }

    /// <summary>ṡ = v̇_t + r n × ω̇.</summary>
    private Vector3d SlipRate(in CarriedForces on, in MotionRates rates) =>
        CarriedSystem<TAir>.Tangential(in rates.Acceleration, on.Normal) + (_around.Radius * Vector3d.Cross(on.Normal, in rates.SpinAcceleration));

    /// <summary>The longest piece that stability, nets and the turning of the normal allow, s; 0 where it would be too short.</summary>
    private double LongestPiece(in BallState s, in Motion from, in CarriedForces on, ref StepRun run)
    {
        double asked = run.Next;
        Collider carrier = _world.CarrierOf(in s);
        double damping = carrier.MaterialAt(s.Position).SpinDamping / _inertia;
        double h = _limit.PartOf(ref _around.Air, asked, (from.Velocity - _around.Wind).Length, from.Spin.Length, s.Branch, damping);
        double turning = on.Turning.Length;
        h = turning * h > LargestTurn ? LargestTurn / turning : h;
        h = Math.Min(h, _nets.LongestPiece(in s, h));
        h = SurfaceBorder.LongestPiece(carrier, on.Velocity.Length, h);
        run.Keep(h, asked);
        return h;
    }

    /// <summary>Puts the ball onto all that it touches: what the integrator left of it is within its own error.</summary>
    private void Hold(ref BallState s, in CarriedSystem<TAir> system, int met)
    {
        Vector3d from = s.Position;
        Vector3d n = system.Carrier.Hold(ref s, _world.Ball.Radius);
        if (met < 0 && Vector3d.Distance(s.Position, from) > ContactSearch.Touching)
        {
            // Back on the surface it may be in what it was just leaving.
            met = NearThings.Deepest(_world, in s, out _);
        }

        if (system.Guides.Count > 0 || met >= 0)
        {
            var end = new Motion(s.Position, s.Velocity, s.Spin);
            CarriedSystem<TAir> bare = system;
            bare.Guides = default;
            bare.Rates(s.Time, in end, out MotionRates pressed);
            system.Rates(s.Time, in end, out MotionRates free);
            system.Guides.Hold(_world, ref s, in pressed.Acceleration, in free.Acceleration, system.Carrier, met);
            n = system.Carrier.At(s.Position, s.Time).Normal;
        }

        Vector3d spin = s.SpinAxis;
        double about = Vector3d.Dot(in spin, in n);

        // Drilling friction ends the spin about the normal, and reverses nothing.
        double kept = system.SpinSign * about < 0 && system.Material.DrillingLength > 0 ? 0 : about;
        s.SpinAxis = system.Rolls ? Slip.RollingSpin(s.Velocity - system.Carrier.Velocity, kept, in n, _around.Radius)
            : kept == about ? spin : spin - (about * n);
    }

    private CarriedSystem<TAir> System(in BallState s, in Motion from, bool rolls)
    {
        Collider carrier = _world.CarrierOf(in s);
        double about = Vector3d.Dot(from.Spin, carrier.At(s.Position, s.Time).Normal);
        return new CarriedSystem<TAir>
        {
            Around = _around,
            World = _world,
            Carrier = carrier,
            Material = carrier.MaterialAt(s.Position),
            Branch = _jump.OnSurface(s.Branch, in from),
            Nets = s.Nets,
            NetSides = s.NetSides,
            Guides = Guides.Of(_world, s.Position, s.Velocity, s.Time, (int)s.Carrier - _world.FirstCollider),
            Rolls = rolls,
            SpinSign = about > Slip.Rolling ? 1.0 : about < -Slip.Rolling ? -1.0 : 0.0,
        };
    }
}
