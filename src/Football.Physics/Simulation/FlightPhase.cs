using System.Runtime.CompilerServices;

namespace FootballPhysics;

/// <summary>
/// Flight, piece by piece. A piece is as long as stability allows; it ends early at the drag law's jump, where the spin ends, or where the
/// ball meets something, whichever is first.
/// </summary>
internal sealed class FlightPhase<TIntegrator>
    where TIntegrator : struct, IIntegrator
{
    private readonly Surroundings _around;
    private readonly IFlight _flight;
    private readonly ClassicalFlight _classical;
    private readonly StabilityLimit _limit;
    private readonly DragJumpGuard _jump;
    private readonly FlightSystem _system;
    private readonly TIntegrator _integrator;
    private readonly World _world;
    private readonly WorldGuard _guard;
    private readonly WorldContact _contact;
    private readonly NetGuard _nets;
    private readonly double _fastestWind;

    public FlightPhase(
        Surroundings around,
        IFlight flight,
        in StabilityLimit limit,
        DragJumpGuard jump,
        WorldGuard guard,
        WorldContact contact)
    {
        _world = around.World;
        _guard = guard;
        _contact = contact;
        _nets = new NetGuard(_world);
        _around = around;
        _flight = flight;
        _classical = new ClassicalFlight(around);
        _limit = limit;
        _jump = jump;
        _system = new FlightSystem { Around = around };
        _integrator = default;
        _fastestWind = around.Air.FastestWind;
    }

    /// <summary>The next piece of a flight.</summary>
    public void Take(ref BallState s, ref StepRun run)
    {
        // First what happens where the ball is: it hits what it touches, or hangs in a net with all forces in balance.
        if (_guard.HitsAtOnce(ref s, ref run) || (s.Nets != 0 && RestsInNet(ref s, ref run)))
        {
            return;
        }

        Vector3d u = s.Velocity - _around.Wind;

        // The branch of the drag law that this piece is locked to.
        if (_around.Air.Jumps && (s.Branch == DragBranch.Unknown || !_jump.Acts))
        {
            s.Branch = DragJump.At(u.LengthSquared, _around.RadiusSquared * s.SpinRate * s.SpinRate).Branch;
        }

        // With a constant axis the spin is one number; own forces, a sliding mode of the drag law and nets take the whole vector.
        bool hasAxis = !_around.Air.TurnsAxis && s.Branch < DragBranch.AlongCriticalSpeed && s.Nets == 0;

        // As long as stability allows: a length that is shorter than asked for is kept for the parts to come.
        double asked = run.Next;
        double h = Longest(in s, in u, asked, hasAxis && !_around.Air.Varies, ref run.Spirals);
        run.Keep(h, asked);
        if (s.Nets != 0)
        {
            // A net settles faster than a step is long: RK4 in parts.
            TakeWithoutAxis<Substeps>(ref s, ref run, h);
        }
        else if (run.Spirals)
        {
            // RK4 makes no velocity longer that turns by up to 2.8 rad.
            Take<ClassicalRungeKutta>(ref s, ref run, h, hasAxis ? _classical : null);
        }
        else
        {
            Take<TIntegrator>(ref s, ref run, h, hasAxis ? _flight : null);
        }
    }

    /// <summary>The first piece of a step, already taken as a whole step, which is found to have something in it.</summary>
    public void Finish(ref BallState s, ref StepRun run, in FlightStep taken, double h)
    {
        if (IsHeld(in s))
        {
            // What keeps it there is asked first, by the next piece.
            return;
        }

        var sweep = new FlightSweep<TIntegrator>(_around, _flight, in s);
        sweep.Take(in taken, h);
        Finish(ref s, ref run, ref sweep);
    }

    /// <summary>True when the ball touches level ground, and does not leave it.</summary>
    public bool IsHeld(in BallState s) => s.Velocity.Y <= ContactSearch.Leaving && s.Position.Y <= _world.LevelContact + ContactSearch.Touching;

    /// <summary>A ball in a net with no more energy than one at rest rests, where all that acts on it is in balance.</summary>
    private bool RestsInNet(ref BallState s, ref StepRun run)
    {
        var at = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);

        // ½ m |v|² + ½ I |ω|²
        if (!(0.5 * ((_world.Ball.Mass * s.Velocity.LengthSquared) + (_world.Ball.MomentOfInertia * at.Spin.LengthSquared)) <= _world.RestEnergy))
        {
            return false;
        }

        // Slow alone is not enough, for at a turning point it is slow too: all forces, the nets' among them, must balance.
        bool rests = _contact.Load.HangsStill(in s);
        run.Log.Evaluations++;
        if (rests)
        {
            _contact.RestInNet(ref s, _world.DeepestNet(in s), ref run);
        }

        return rests;
    }

    /// <summary>A piece by a method: along a constant axis of the spin where there is a flight along one, else with the whole spin vector.</summary>
    private void Take<TMethod>(ref BallState s, ref StepRun run, double h, IFlight? flight)
        where TMethod : struct, IIntegrator
    {
        if (flight is null)
        {
            TakeWithoutAxis<TMethod>(ref s, ref run, h);
            return;
        }

        var sweep = new FlightSweep<TMethod>(_around, flight, in s);
        sweep.Step(h);
        Finish(ref s, ref run, ref sweep);
    }

    /// <summary>Ends a piece along a constant axis at the first thing that happens in it, and moves the ball there.</summary>
    private void Finish<TMethod>(ref BallState s, ref StepRun run, ref FlightSweep<TMethod> sweep)
        where TMethod : struct, IIntegrator
    {
        DragBranch next = s.Branch;
        bool goes = !_jump.Acts || _jump.EndAtCrossing(ref sweep, in s, ref run, out next);

        // Spin that ends before the jump ends the piece there, on its own branch.
        if (goes && sweep.Taken.SpinRate < 0 && _around.Air.SpinDecays)
        {
            EndSpin(ref sweep, s.SpinRate);
            next = s.Branch;
        }

        Finish(ref s, ref run, ref sweep, default(TMethod).Order, next, goes);
    }

    /// <summary>A piece with the whole spin vector: with forces of the game's own, along the drag law's jump or in a net.</summary>
    private void TakeWithoutAxis<TMethod>(ref BallState s, ref StepRun run, double h)
        where TMethod : struct, IIntegrator
    {
        int order = default(TMethod).Order;
        var from = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
        FlightSystem system = _system;
        system.Branch = s.Branch;
        system.Nets = s.Nets;
        system.NetSides = s.NetSides;
        system.Rates(s.Time, in from, out MotionRates start);
        run.Log.Evaluations++;
        var sweep = new MotionSweep<FlightSystem, TMethod>(in system, s.Time, in from, in start, _around.Wind, _around.Radius);
        sweep.Step(h);
        DragBranch next = s.Branch;
        bool goes = true;

        // The drag law's jump: along one of its surfaces to where the sliding mode ends, else to the first crossing.
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

        // Then the kink of a net's force, where the integrator would lose its order; before the jump the branch is still the piece's.
        if (goes && s.Nets != 0)
        {
            double length = sweep.Length;
            _nets.EndWhereSlack(ref sweep, in s);
            _nets.EndWhereBent(ref sweep, in s, -1);
            next = sweep.Length < length ? s.Branch : next;
        }

        Finish(ref s, ref run, ref sweep, order, next, goes);
    }

    /// <summary>Ends a piece at the first thing that it meets, and moves the ball to its end.</summary>
    private void Finish<TSweep>(ref BallState s, ref StepRun run, ref TSweep sweep, int order, DragBranch next, bool goes)
        where TSweep : struct, IFlightSweep
    {
        if (!goes)
        {
            // On the jump to rounding: the same piece again, on the branch that leads away from it.
            run.Log.Evaluations += sweep.Evaluations;
            s.Branch = next;
            return;
        }

        // The first thing that is met, if any, shortens the piece once more.
        double length = sweep.Length;
        bool meets = _guard.EndAtFirst(ref sweep, in s, order, out Separation met);
        if (!meets)
        {
            // What was halved for forces that turn the ball round stays so short in this step.
            run.Keep(sweep.Length, length);
        }

        run.Log.Evaluations += sweep.Evaluations;
        Unsafe.SkipInit(out BallState before);
        if (run.Log.IsWatched)
        {
            before = s;
        }

        // The ball goes to the end; if it ends before the jump, on the same branch.
        sweep.MoveTo(ref s);
        s.Branch = sweep.Length < length ? s.Branch : next;
        run.Advance(ref s, sweep.Length);
        if (meets)
        {
            _guard.PutOnto(ref s, in met);
        }
        else
        {
            // What it touched at the start, and was not pressed on, it may be in by now.
            ContactSet.Separate(_world, ref s);
        }

        if (run.Log.IsWatched)
        {
            run.Show(in before, in s, ref sweep, order);
        }

        if (meets && !run.Log.Halted)
        {
            _guard.Meet(ref s, in met, ref run);
        }
    }

    /// <summary>Ends a piece where its spin reaches zero: decay never reverses a spin.</summary>
    private static void EndSpin<TMethod>(ref FlightSweep<TMethod> sweep, double spinRate)
        where TMethod : struct, IIntegrator
    {
        // The secant for a first guess; then the step is taken again until the spin is zero at its end.
        double tau = sweep.Length * spinRate / (spinRate - sweep.Taken.SpinRate);
        EventLocator.Locate(ref sweep, new SpinLeft<TMethod>(spinRate), tau);
        sweep.EndSpin();
    }

    /// <summary>The longest piece that stability allows, s.</summary>
    private double Longest(in BallState s, in Vector3d u, double asked, bool isPlain, ref bool spirals)
    {
        double h = asked;
        double speedSquared = u.LengthSquared;
        if (!isPlain)
        {
            double spin = s.Spin.Length;
            double most = Math.Sqrt(speedSquared) + _fastestWind;

            // The quick bound first; where that is not enough a closer one, in a field by the speed that the ball has in its wind.
            h = asked * _limit.RateAtMost(most, spin) <= StabilityLimit.LargestChange
                ? asked
                : _limit.PartOf(ref _around.Air, asked, _fastestWind > 0 ? AirSpeed(in s, in u) : most, spin, s.Branch, ref spirals);
            h = _nets.LongestPiece(in s, h);
        }
        else if (_around.AirActs && !_limit.AllowsWhole(h, speedSquared, s.SpinRate, false))
        {
            h = _limit.PartOf(ref _around.Air, asked, Math.Sqrt(speedSquared), s.SpinRate, s.Branch, ref spirals);
        }

        // Methods that come down from a hop faster than they went up take it in parts, or bounces would grow.
        return _integrator.GainsByHops ? _limit.WithinHop(h, s.Position.Y - _world.LevelContact, s.Velocity.Y) : h;
    }

    /// <summary>The speed relative to the air in wind by place and time, m/s.</summary>
    private double AirSpeed(in BallState s, in Vector3d u)
    {
        _around.Air.Evaluate(new ForceContext(s.Time, s.Position, s.Velocity, in u, s.Spin, s.Motion, s.AirDistance), s.Branch, out AirFactors air);
        return air.AirVelocity.Length;
    }
}

/// <summary>The spin that is left at the end of a flight along a constant axis.</summary>
internal readonly struct SpinLeft<TIntegrator> : IEventFunction<FlightSweep<TIntegrator>>
    where TIntegrator : struct, IIntegrator
{
    /// <summary>A spin of less than this, rad/s, is none.</summary>
    private const double Vanishing = 1e-300;

    private readonly double _start;

    /// <param name="start">The spin at the start, rad/s.</param>
    public SpinLeft(double start) => _start = start;

    public bool Evaluate(ref FlightSweep<TIntegrator> sweep, double tau, out double value, out double correction)
    {
        value = sweep.Taken.SpinRate;

        // The secant from the step's start: its spin falls about linearly.
        correction = value * tau / (_start - value);
        return Math.Abs(value) <= (1e-14 * _start) + Vanishing || !(tau > 0);
    }
}
