using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.Integration;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <summary>Steps a flying ball piece by piece.</summary>
/// <remarks>
/// A piece has the maximum stable length. It ends early at the first of these events: a jump in the drag law, the end of the spin, or a
/// contact.
/// </remarks>
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

    /// <summary>Takes the next piece of a flight.</summary>
    public void Take(ref BallState s, ref StepRun run)
    {
        // First handle contacts at the current position: an immediate impact, or a ball at rest in a net.
        if (_guard.HitsAtOnce(ref s, ref run) || (s.Nets != 0 && RestsInNet(ref s, ref run)))
        {
            return;
        }

        Vector3d u = s.Velocity - _around.Wind;

        // Lock this piece to one branch of the drag law.
        s.Branch = DragJump.Choose(_around.Air.Jumps, _jump.Acts, s.Branch, u.LengthSquared, _around.RadiusSquared * s.SpinRate * s.SpinRate);

        // If the spin axis is constant, integrate the spin as a scalar. Custom forces, a sliding mode of the drag law and nets need the
        // full vector.
        bool hasAxis = !_around.Air.TurnsAxis && s.Branch < DragBranch.AlongCriticalSpeed && s.Nets == 0;

        // Take the longest stable piece. If it is shorter than requested, use this length for later parts too.
        double asked = run.Next;
        double h = Longest(in s, in u, asked, hasAxis && !_around.Air.Varies, ref run.Spirals);
        run.Keep(h, asked);
        if (s.Nets != 0)
        {
            // A net reacts within less than a step: use RK4 substeps.
            TakeWithoutAxis<Substeps>(ref s, ref run, h);
        }
        else if (run.Spirals)
        {
            // RK4 does not speed up a velocity that turns by up to 2.8 rad.
            Take<ClassicalRungeKutta>(ref s, ref run, h, hasAxis ? _classical : null);
        }
        else
        {
            Take<TIntegrator>(ref s, ref run, h, hasAxis ? _flight : null);
        }
    }

    /// <summary>Finishes the first piece of a step that was already integrated as a whole step and contains an event.</summary>
    public void Finish(ref BallState s, ref StepRun run, in FlightStep taken, double h)
    {
        if (IsHeld(in s))
        {
            // The ball touches the ground: the next piece handles this contact first.
            return;
        }

        var sweep = new FlightSweep<TIntegrator>(_around, _flight, in s);
        sweep.Take(in taken, h);
        Finish(ref s, ref run, ref sweep);
    }

    /// <summary>True if the ball touches level ground and does not leave it.</summary>
    public bool IsHeld(in BallState s) => s.Velocity.Y <= ContactTolerances.Leaving && s.Position.Y <= _world.LevelContact + ContactTolerances.Touching;

    /// <summary>Stops a ball in a net if its energy is below the rest energy and all forces balance.</summary>
    private bool RestsInNet(ref BallState s, ref StepRun run)
    {
        var at = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);

        // ½ m |v|² + ½ I |ω|²
        if (!(0.5 * ((_world.Ball.Mass * s.Velocity.LengthSquared) + (_world.Ball.MomentOfInertia * at.Spin.LengthSquared)) <= _world.RestEnergy))
        {
            return false;
        }

        // A slow ball may only be turning around, so also require that all forces balance, including those of nets.
        bool rests = _contact.Load.HangsStill(in s);
        run.Log.Evaluations++;
        if (rests)
        {
            _contact.RestInNet(ref s, _world.DeepestNet(in s), ref run);
        }

        return rests;
    }

    /// <summary>Takes a piece with one integrator: along a constant spin axis if a flight for that is given, otherwise with the full spin
    /// vector.</summary>
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

    /// <summary>Ends a piece with a constant spin axis at the first event within it, and moves the ball there.</summary>
    private void Finish<TMethod>(ref BallState s, ref StepRun run, ref FlightSweep<TMethod> sweep)
        where TMethod : struct, IIntegrator
    {
        DragBranch next = s.Branch;
        bool goes = !_jump.Acts || _jump.EndAtCrossing(ref sweep, in s, ref run, out next);

        // If the spin ends before the jump, end the piece there and keep the branch.
        if (goes && sweep.Taken.SpinRate < 0 && _around.Air.SpinDecays)
        {
            EndSpin(ref sweep, s.SpinRate);
            next = s.Branch;
        }

        Finish(ref s, ref run, ref sweep, default(TMethod).Order, next, goes);
    }

    /// <summary>Takes a piece with the full spin vector: with custom forces, along the jump in the drag law, or in a net.</summary>
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

        // At the jump in the drag law, slide along its surface until the sliding mode ends, or stop at the first crossing.
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

        // Stop at the kink in a net's force, where the integrator would lose its order. Before the jump, keep the branch.
        if (goes && s.Nets != 0)
        {
            double length = sweep.Length;
            _nets.EndWhereSlack(ref sweep, in s);
            _nets.EndWhereBent(ref sweep, in s, -1);
            next = sweep.Length < length ? s.Branch : next;
        }

        Finish(ref s, ref run, ref sweep, order, next, goes);
    }

    /// <summary>Ends a piece at the first contact, and moves the ball to the end of the piece.</summary>
    private void Finish<TSweep>(ref BallState s, ref StepRun run, ref TSweep sweep, int order, DragBranch next, bool goes)
        where TSweep : struct, IFlightSweep
    {
        if (!goes)
        {
            // To within rounding, the ball is on the jump: repeat the piece on the branch that leads away from it.
            run.Log.Evaluations += sweep.Evaluations;
            s.Branch = next;
            return;
        }

        // If the ball touches an object, end the piece at the first contact.
        double length = sweep.Length;
        bool meets = _guard.EndAtFirst(ref sweep, in s, order, out Separation met);
        if (!meets)
        {
            // Forces turn the ball back, so the search halved the piece: keep this length for the rest of the step.
            run.Keep(sweep.Length, length);
        }

        run.Log.Evaluations += sweep.Evaluations;
        Unsafe.SkipInit(out BallState before);
        if (run.Log.IsWatched)
        {
            before = s;
        }

        // Move the ball to the end. If the piece ends before the jump, keep the branch.
        sweep.MoveTo(ref s);
        s.Branch = sweep.Length < length ? s.Branch : next;
        run.Advance(ref s, sweep.Length);
        if (meets)
        {
            _guard.PutOnto(ref s, in met);
        }
        else
        {
            // The ball may have entered a surface that it touched without load at the start.
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

    /// <summary>Ends a piece at the time when the spin reaches zero: decay never reverses a spin.</summary>
    private static void EndSpin<TMethod>(ref FlightSweep<TMethod> sweep, double spinRate)
        where TMethod : struct, IIntegrator
    {
        // Start with a secant estimate, then repeat the step until the spin at its end is zero.
        double tau = sweep.Length * spinRate / (spinRate - sweep.Taken.SpinRate);
        EventLocator.Locate(ref sweep, new SpinLeft<TMethod>(spinRate), tau);
        sweep.EndSpin();
    }

    /// <summary>Returns the longest piece that stability allows, s.</summary>
    private double Longest(in BallState s, in Vector3d u, double asked, bool isPlain, ref bool spirals)
    {
        double h = asked;
        double speedSquared = u.LengthSquared;
        if (!isPlain)
        {
            double spin = s.Spin.Length;
            double most = Math.Sqrt(speedSquared) + _fastestWind;

            // Try the cheap bound first. If it fails, use a tighter one; in a wind field, use the ball's actual airspeed.
            h = asked * _limit.RateAtMost(most, spin) <= StabilityLimit.LargestChange
                ? asked
                : _limit.PartOf(ref _around.Air, asked, _fastestWind > 0 ? AirSpeed(in s, in u) : most, spin, s.Branch, ref spirals);
            h = _nets.LongestPiece(in s, h);
        }
        else if (_around.AirActs && !_limit.AllowsWhole(h, speedSquared, s.SpinRate, false))
        {
            h = _limit.PartOf(ref _around.Air, asked, Math.Sqrt(speedSquared), s.SpinRate, s.Branch, ref spirals);
        }

        // With some integrators, a ball would return from a hop faster than it left, and its bounces would grow: divide the fall.
        return _integrator.GainsByHops ? _limit.WithinHop(h, s.Position.Y - _world.LevelContact, s.Velocity.Y) : h;
    }

    /// <summary>Returns the speed relative to the air in a wind field, m/s.</summary>
    private double AirSpeed(in BallState s, in Vector3d u)
    {
        _around.Air.Evaluate(new ForceContext(s.Time, s.Position, s.Velocity, in u, s.Spin, s.Motion, s.AirDistance), s.Branch, out AirFactors air);
        return air.AirVelocity.Length;
    }
}

/// <summary>The spin left at the end of a flight with a constant axis.</summary>
internal readonly struct SpinLeft<TIntegrator> : IEventFunction<FlightSweep<TIntegrator>>
    where TIntegrator : struct, IIntegrator
{
    /// <summary>A spin below this counts as zero, rad/s.</summary>
    private const double Vanishing = 1e-300;

    private readonly double _start;

    /// <param name="start">Spin at the start, rad/s.</param>
    public SpinLeft(double start) => _start = start;

    public bool Evaluate(ref FlightSweep<TIntegrator> sweep, double tau, out double value, out double correction)
    {
        value = sweep.Taken.SpinRate;

        // Use the secant from the start of the step, because the spin falls almost linearly.
        correction = value * tau / (_start - value);
        return Math.Abs(value) <= (1e-14 * _start) + Vanishing || !(tau > 0);
    }
}
