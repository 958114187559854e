namespace Football.Physics;

/// <summary>
/// Flight, piece by piece. A piece is as long as stability allows; it ends early at the drag law's jump, where the spin ends, or where the
/// ball touches the ground, whichever is first.
/// </summary>
internal sealed class FlightPhase<TAir, TIntegrator>
    where TAir : struct, IAir
    where TIntegrator : struct, IIntegrator
{
    /// <summary>A ball that rises at contact by less than this share of its speed before does so by rounding.</summary>
    private const double Rising = 1e-9;

    /// <summary>Pieces shorter than this, s, are not halved.</summary>
    private const double ShortestPiece = 1e-18;

    private readonly SolverSettings _settings;
    private readonly Surroundings<TAir> _around;
    private readonly IFlight _flight;
    private readonly StabilityLimit _limit;
    private readonly DragJumpGuard<TAir> _jump;
    private readonly ContactPhase<TAir> _contact;
    private readonly ImplicitPhase<TAir> _implicit;
    private readonly FlightSystem<TAir> _system;
    private readonly TIntegrator _integrator;
    private readonly WorldGuard<TAir>? _world;
    private readonly NetGuard? _nets;
    private readonly double _fastestWind;

    public FlightPhase(
        SolverSettings settings,
        Surroundings<TAir> around,
        IFlight flight,
        in StabilityLimit limit,
        DragJumpGuard<TAir> jump,
        ContactPhase<TAir> contact,
        ImplicitPhase<TAir> implicitPhase,
        WorldGuard<TAir>? world)
    {
        _world = world;
        _nets = around.World is null ? null : new NetGuard(around.World);
        _settings = settings;
        _around = around;
        _flight = flight;
        _limit = limit;
        _jump = jump;
        _contact = contact;
        _implicit = implicitPhase;
        _system = new FlightSystem<TAir> { Around = around };
        _integrator = default;
        _fastestWind = around.Air.FastestWind;
    }

    /// <summary>The next piece of a flight.</summary>
    public void Take(ref BallState s, ref StepRun run)
    {
        if (s.Position.Y <= _around.ContactHeight && s.Velocity.Y < 0)
        {
            _contact.Impact(ref s, ref run);
            return;
        }

        if (_world is not null && _world.HitsAtOnce(ref s, ref run))
        {
            return;
        }

        Guides guides = _world is null ? default : Guides.Of(_around.World!, s.Position, s.Velocity, s.Time, -1);
        Vector3d u = s.Velocity - _around.Wind;
        if (_around.Air.Jumps && (s.Branch == DragBranch.Unknown || !_jump.Acts))
        {
            s.Branch = DragJump.At(u.LengthSquared, _around.RadiusSquared * s.SpinRate * s.SpinRate).Branch;
        }

        bool hasAxis = !_around.Air.TurnsAxis && s.Branch < DragBranch.AlongCriticalSpeed && (_world is null || s.Nets == 0) && guides.Count == 0;
        double asked = run.Next;
        double h = Longest(in s, in u, asked, hasAxis && !_around.Air.Varies);
        if (h <= 0)
        {
            _implicit.Fly(ref s, ref run);
            return;
        }

        run.Keep(h, asked);
        if (hasAxis)
        {
            if (!_around.AirActs && _world is null && FallsQuietly(ref s, h, ref run))
            {
                return;
            }

            var sweep = new FlightSweep<TAir, TIntegrator>(_around, _flight, in s);
            sweep.Step(h);
            Finish(ref s, ref run, ref sweep);
        }
        else
        {
            TakeWithoutAxis(ref s, ref run, h, in guides);
        }
    }

    /// <summary>The first piece of a step, already taken as a whole step, which is found to have something in it.</summary>
    public void Finish(ref BallState s, ref StepRun run, in FlightStep taken, double h)
    {
        if (_world is not null && s.Velocity.Y <= ContactSearch.Leaving && s.Position.Y <= _around.LevelContact + ContactSearch.Touching)
        {
            // It touches the ground and does not leave it: what keeps it there is asked first, by the next piece.
            return;
        }

        var sweep = new FlightSweep<TAir, TIntegrator>(_around, _flight, in s);
        sweep.Take(in taken, h);
        Finish(ref s, ref run, ref sweep);
    }

    /// <summary>Ends a piece along a constant axis at the first thing that happens in it, and moves the ball there.</summary>
    private void Finish(ref BallState s, ref StepRun run, ref FlightSweep<TAir, TIntegrator> sweep)
    {
        DragBranch next = s.Branch;
        bool goes = !_jump.Acts || _jump.EndAtCrossing(ref sweep, in s, ref run, out next);
        if (goes && sweep.Taken.SpinRate < 0 && _around.Air.SpinDecays)
        {
            EndSpin(ref sweep, s.SpinRate);
            next = s.Branch;
        }

        Finish(ref s, ref run, ref sweep, next, goes, default);
    }

    /// <summary>A piece with the whole spin vector: with forces of the game's own, along the drag law's jump, in a net, or along what guides the ball.</summary>
    private void TakeWithoutAxis(ref BallState s, ref StepRun run, double h, in Guides guides)
    {
        var from = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
        FlightSystem<TAir> system = _system;
        system.Branch = s.Branch;
        system.Nets = _world is null ? 0 : s.Nets;
        system.NetSides = s.NetSides;
        system.Guides = guides;
        var sweep = new MotionSweep<FlightSystem<TAir>, TIntegrator>(in system, s.Time, in from, _around.Wind, _around.Radius);
        sweep.Step(h);
        if (guides.Count > 0)
        {
            SurfacePath.Shorten(ref sweep, in s, _around.World!, null, in guides, _integrator.Order);
        }

        DragBranch next = s.Branch;
        bool goes = true;
        if (_jump.Acts)
        {
            if (s.Branch >= DragBranch.AlongCriticalSpeed)
            {
                next = _jump.EndAlongSurface(ref sweep, s.Time, in from, ref run);
                goes = sweep.Length > 0;
            }
            else
            {
                goes = _jump.EndAtCrossing(ref sweep, in s, ref run, out next);
            }
        }

        if (goes && _world is not null && s.Nets != 0)
        {
            double length = sweep.Length;
            _nets!.EndWhereSlack(ref sweep, in s);
            next = sweep.Length < length ? s.Branch : next;
        }

        Finish(ref s, ref run, ref sweep, next, goes, in guides);
    }

    /// <summary>Puts a ball onto what it slides along: what the integrator left of it is within its own error.</summary>
    private void Hold(ref BallState s, in Guides guides, int met)
    {
        FlightSystem<TAir> system = _system;
        system.Branch = s.Branch;
        system.Nets = s.Nets;
        system.NetSides = s.NetSides;
        var end = new Motion(s.Position, s.Velocity, s.Spin);
        system.Rates(s.Time, in end, out MotionRates pressed);
        Vector3d free = guides.Free(_around.World!, s.Position, s.Velocity, s.Time, in pressed.Acceleration);
        guides.Hold(_around.World!, ref s, in pressed.Acceleration, in free, null, met);
    }

    /// <summary>Ends a piece at the ground, if it is met, and moves the ball to its end.</summary>
    private void Finish<TSweep>(ref BallState s, ref StepRun run, ref TSweep sweep, DragBranch next, bool goes, in Guides guides)
        where TSweep : struct, IFlightSweep
    {
        if (!goes)
        {
            // On the jump to rounding: the same piece again, on the branch that leads away from it.
            run.Log.Evaluations += sweep.Evaluations;
            s.Branch = next;
            return;
        }

        Gap met = default;
        double length = sweep.Length;
        bool meets = _world is not null && _world.EndAtFirst(ref sweep, in s, _integrator.Order, out met);
        bool hit = !meets && EndAtGround(ref sweep, in s);
        if (!meets && !hit)
        {
            // What was halved for forces that turn the ball round stays so short in this step.
            run.Keep(sweep.Length, length);
        }

        run.Log.Evaluations += sweep.Evaluations;
        BallState before = s;
        sweep.MoveTo(ref s);
        if (hit)
        {
            // What rises at contact does so by rounding.
            s.Position = new Vector3d(s.Position.X, _around.ContactHeight, s.Position.Z);
            s.Velocity = new Vector3d(s.Velocity.X, Math.Min(s.Velocity.Y, 0), s.Velocity.Z);
        }

        s.Branch = hit ? DragBranch.Unknown : sweep.Length < length ? before.Branch : next;
        run.Advance(ref s, sweep.Length);
        if (guides.Count > 0)
        {
            Hold(ref s, in guides, meets && met.What == Happening.Contact ? met.Index : -1);
        }

        run.Show(in before, in s, ref sweep, _integrator.Order);
        if (hit && !run.Log.Halted)
        {
            _contact.Impact(ref s, ref run);
        }

        if (meets && !run.Log.Halted)
        {
            _world!.Meet(ref s, in met, ref run);
        }
    }

    /// <summary>Ends a piece where the ball touches the ground.</summary>
    /// <returns>False where it does not.</returns>
    private bool EndAtGround<TSweep>(ref TSweep sweep, in BallState s)
        where TSweep : struct, IFlightSweep
    {
        double contact = _around.ContactHeight;
        double height = sweep.Position.Y;
        double climb = sweep.Velocity.Y;
        bool below = height < contact;
        if (!below && !(s.Velocity.Y < 0 && climb > 0))
        {
            return false;
        }

        double h = sweep.Length;
        bool exact = _settings.CollisionTiming == CollisionTiming.Exact;
        var arc = new HeightArc(s.Position.Y - contact, s.Velocity.Y, sweep.StartAcceleration.Y, height - contact, climb, h);
        if (!below && !(exact && arc.Dips))
        {
            return false;
        }

        TSweep whole = sweep;
        bool touches = !exact || TimeOfImpact.Exact(ref sweep, _integrator, in arc, contact);
        if (!exact)
        {
            TimeOfImpact.Bisection(ref sweep, h, _settings.CollisionTolerance, contact);
        }

        if (touches && (sweep.Velocity.Y <= Rising * Math.Abs(s.Velocity.Y) || sweep.Length <= ShortestPiece))
        {
            return true;
        }

        if (!touches)
        {
            whole.Evaluations = sweep.Evaluations;
            sweep = whole;
            return false;
        }

        // A ball that rises where it comes down: the step is too long for the forces that act, most often a game's own. It has been below before.
        sweep.Step(0.5 * sweep.Length);
        return EndAtGround(ref sweep, in s);
    }

    /// <summary>Ends a piece where its spin reaches zero: decay never reverses a spin.</summary>
    private static void EndSpin(ref FlightSweep<TAir, TIntegrator> sweep, double spinRate)
    {
        double tau = sweep.Length * spinRate / (spinRate - sweep.Taken.SpinRate);
        EventLocator.Locate(ref sweep, new SpinLeft<TAir, TIntegrator>(spinRate), tau);
        sweep.EndSpin();
    }

    /// <summary>The longest piece that stability allows, s; 0 where it would be too short.</summary>
    private double Longest(in BallState s, in Vector3d u, double asked, bool isPlain)
    {
        double h = asked;
        double speedSquared = u.LengthSquared;
        if (!isPlain)
        {
            double spin = s.Spin.Length;
            double most = Math.Sqrt(speedSquared) + _fastestWind;
            h = asked * _limit.RateAtMost(most, spin) <= StabilityLimit.LargestChange
                ? asked
                : _limit.PartOf(ref _around.Air, asked, _fastestWind > 0 ? AirSpeed(in s, in u) : most, spin, s.Branch);
            h = h > 0 && _nets is not null ? _nets.LongestPiece(in s, h) : h;
        }
        else if (_around.AirActs && !_limit.AllowsWhole(h, speedSquared, s.SpinRate, false))
        {
            h = _limit.PartOf(ref _around.Air, asked, Math.Sqrt(speedSquared), s.SpinRate, s.Branch);
        }

        return h > 0 && _integrator.GainsByHops ? _limit.WithinHop(h, s.Position.Y - _around.LevelContact, s.Velocity.Y) : h;
    }

    /// <summary>The speed relative to the air in wind by place and time, m/s.</summary>
    private double AirSpeed(in BallState s, in Vector3d u)
    {
        _around.Air.Evaluate(new ForceInput(s.Time, s.Position, s.Velocity, in u, s.Spin, s.Motion, s.AirDistance), s.Branch, out AirFactors air);
        return air.AirVelocity.Length;
    }

    /// <summary>A piece in vacuum, done if nothing happens in it: what the method makes of a constant acceleration, p + h (v + c h g), v + h g.</summary>
    private bool FallsQuietly(ref BallState s, double h, ref StepRun run)
    {
        double vy = s.Velocity.Y;
        double gained = h * _around.Upward;
        double climb = vy + gained;
        double height = s.Position.Y + (h * (vy + (_integrator.ShareInPath * gained)));
        if (height < _around.ContactHeight || (vy < 0 && climb > 0))
        {
            return false;
        }

        BallState before = s;
        s.Position = new Vector3d(s.Position.X + (h * s.Velocity.X), height, s.Position.Z + (h * s.Velocity.Z));
        s.Velocity = new Vector3d(s.Velocity.X, climb, s.Velocity.Z);
        s.Angle += h * s.SpinRate;
        run.Advance(ref s, h);
        run.Log.Evaluations += _integrator.Stages;
        if (run.Log.Observer is not null)
        {
            var gravity = new Vector3d(0, _around.Upward, 0);
            run.Log.Show(in before, in s, in gravity, in gravity, _integrator.Order);
        }

        return true;
    }
}
