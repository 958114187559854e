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
    private readonly IFlight? _flight; // null if forces turn the spin axis
    private readonly ClassicalFlight _classical;
    private readonly StabilityLimit _limit;
    private readonly DragJumpGuard _jump;
    private readonly FlightSystem _system;
    private readonly bool _gainsByHops;
    private readonly World _world;
    private readonly WorldGuard _guard;
    private readonly WorldContact _contact;
    private readonly NetGuard _nets;
    private readonly OwnForceGuard? _own;
    private readonly double _fastestWind;

    public FlightPhase(
        Surroundings around,
        IFlight? flight,
        in StabilityLimit limit,
        DragJumpGuard jump,
        WorldGuard guard,
        WorldContact contact,
        OwnForceGuard? own)
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
        _gainsByHops = default(TIntegrator).GainsByHops;
        _fastestWind = around.Air.FastestWind;
        _own = own;
    }

    /// <summary>Takes the next piece of a flight.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)] // its locals would be cleared in every step that has pieces
    public void Take(ref BallState s, ref StepRun run)
    {
        if (!Propose(ref s, ref run, out double h, out bool hasAxis))
        {
            return;
        }

        if (run.Probe is not null)
        {
            run.Probe.Fly(in s);
            return;
        }

        // RK4 does not speed up a velocity that turns by up to 2.8 rad. A net reacts within less than a step: use RK4 substeps.
        bool spirals = run.Spirals && run.Whole != WholeStep.Ends;
        _own?.Shorten(ref h, s.Nets != 0 ? _world.NetForces.Longest(s.Nets, s.NetSides, s.Position, s.Velocity) : double.PositiveInfinity, ref run);
        if (s.Nets != 0 && _own is null)
        {
            TakeFreely<Substeps>(ref s, ref run, h);
        }
        else if (hasAxis)
        {
            TakeAlongAxis(ref s, ref run, h, spirals ? _classical : _flight!);
        }
        else if (run.Followed > 0 || !(spirals ? TakeFreely<ClassicalRungeKutta>(ref s, ref run, h) : TakeFreely<TIntegrator>(ref s, ref run, h)))
        {
            TakeFreely<EighthOrder>(ref s, ref run, h);
        }
    }

    /// <summary>Takes a piece with a constant spin axis.</summary>
    private void TakeAlongAxis(ref BallState s, ref StepRun run, double h, IFlight flight)
    {
        Integrate(in s, ref run, h, flight, out FlightSweep sweep);
        if (Shorten(ref sweep, ref s, ref run, flight.Order, out FlightEnd end))
        {
            Move(ref s, ref run, ref sweep, flight.Order, in end);
            Respond(ref s, ref run, in end);
        }
    }

    /// <summary>Takes a piece with the full spin vector: with custom forces, along the jump in the drag law, or in a net.</summary>
    /// <returns>False if the method does not follow the custom forces. The ball has not moved then.</returns>
    [MethodImpl(MethodImplOptions.NoInlining)] // its locals would be cleared in every piece
    [SkipLocalsInit]
    private unsafe bool TakeFreely<TMethod>(ref BallState s, ref StepRun run, double h)
        where TMethod : struct, IMotionMethod
    {
        ForceTrace trace;
        if (!Integrate(in s, ref run, h, &trace, out MotionSweep<FlightSystem, TMethod> sweep))
        {
            return false;
        }

        int order = default(TMethod).Order;
        if (Shorten(ref sweep, ref s, ref run, order, out FlightEnd end))
        {
            Move(ref s, ref run, ref sweep, order, in end);
            Respond(ref s, ref run, in end);
        }

        return true;
    }

    /// <summary>Chooses the branch of the drag law, and the longest piece that stability allows.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="run">The step.</param>
    /// <param name="h">The length of the piece, s.</param>
    /// <param name="hasAxis">Whether the spin axis is constant.</param>
    /// <returns>False if there was an event at the current position.</returns>
    private bool Propose(ref BallState s, ref StepRun run, out double h, out bool hasAxis)
    {
        // The rest of the step was already integrated, and contains an event.
        h = run.Left;
        hasAxis = true;
        if (run.Whole == WholeStep.Ends)
        {
            return true;
        }

        // First handle contacts at the current position: an immediate impact, or a ball at rest in a net.
        if (_guard.HitsAtOnce(ref s, ref run) || (s.Nets != 0 && _contact.RestsInNet(ref s, ref run)))
        {
            return false;
        }

        Vector3d u = s.Velocity - _around.Wind;

        // Lock this piece to one branch of a drag law that jumps.
        if (_around.Air.Jumps)
        {
            s.Branch = DragJump.Choose(jumps: true, _jump.Acts, s.Branch, u.LengthSquared, _around.RadiusSquared * s.SpinRate * s.SpinRate);
        }

        // If the spin axis is constant, integrate the spin as a scalar. Custom forces, a sliding mode of the drag law and nets need the
        // full vector.
        hasAxis = !_around.Air.HasOwnForces && s.Branch < DragBranch.AlongCriticalSpeed && s.Nets == 0;

        // Take the longest stable piece. If it is shorter than requested, use this length for later parts too.
        double requested = run.Next;
        h = Longest(in s, in u, requested, hasAxis && !_around.Air.Varies, ref run.Spirals);
        run.Keep(h, requested);
        return true;
    }

    /// <summary>Integrates a piece with a constant spin axis, unless the step already holds it.</summary>
    private void Integrate(in BallState s, ref StepRun run, double h, IFlight flight, out FlightSweep sweep)
    {
        sweep = new FlightSweep(_around, flight, in s);
        if (run.Whole == WholeStep.Ends)
        {
            sweep.Taken = run.Taken;
            sweep.Length = h;
        }
        else
        {
            sweep.Step(h);
        }
    }

    /// <summary>Integrates a piece with the full spin vector.</summary>
    /// <returns>False if the method does not follow the custom forces.</returns>
    private unsafe bool Integrate<TMethod>(in BallState s, ref StepRun run, double h, ForceTrace* trace, out MotionSweep<FlightSystem, TMethod> sweep)
        where TMethod : struct, IMotionMethod
    {
        var from = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
        FlightSystem system = _system;
        system.Branch = s.Branch;
        system.Nets = s.Nets;
        system.NetSides = s.NetSides;
        system.Orientation = _around.Air.HasSide ? s.Orientation : default;
        if (_own is not null)
        {
            trace->Begin(_around.Radius);
            system.Trace = trace;
        }

        system.Rates(s.Time, in from, out MotionRates start);
        system.NetsSlack = _nets.SlackAt(in s, start.Acceleration);
        run.Log.Evaluations++;
        sweep = new MotionSweep<FlightSystem, TMethod>(in system, s.Time, in from, in start, _around.Wind, _around.Radius);
        if (_own is not null)
        {
            return _own.Take(ref sweep, h, trace, ref run);
        }

        sweep.Step(h);
        NetGuard.KeepFinite(ref sweep, in s);
        return true;
    }

    /// <summary>Ends a piece with a constant spin axis at the first event within it.</summary>
    /// <returns>False if the piece must be repeated on another branch of the drag law.</returns>
    private bool Shorten(ref FlightSweep sweep, ref BallState s, ref StepRun run, int order, out FlightEnd end)
    {
        end = new FlightEnd { Branch = s.Branch };
        bool goes = !_jump.Acts || _jump.EndAtCrossing(ref sweep, in s, ref run, out end.Branch);

        // If the spin ends before the jump, end the piece there and keep the branch.
        if (goes && sweep.Taken.SpinRate < 0 && _around.Air.SpinDecays)
        {
            EndSpin(ref sweep, s.SpinRate);
            end.Branch = s.Branch;
        }

        return ShortenToContact(ref sweep, ref s, ref run, order, goes, ref end);
    }

    /// <summary>Ends a piece with the full spin vector at the first event within it.</summary>
    /// <returns>False if the piece must be repeated on another branch of the drag law.</returns>
    private bool Shorten<TMethod>(ref MotionSweep<FlightSystem, TMethod> sweep, ref BallState s, ref StepRun run, int order, out FlightEnd end)
        where TMethod : struct, IMotionMethod
    {
        end = new FlightEnd { Branch = s.Branch };
        bool goes = true;

        // At the jump in the drag law, slide along its surface until the sliding mode ends, or stop at the first crossing.
        if (_jump.Acts && s.Branch >= DragBranch.AlongCriticalSpeed)
        {
            end.Branch = _jump.EndAlongSurface(ref sweep, s.Time, new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance), ref run);
            goes = sweep.Length > 0;
        }
        else if (_jump.Acts)
        {
            goes = _jump.EndAtCrossing(ref sweep, in s, ref run, out end.Branch);
        }

        // Stop at the kink in a net's force, where the integrator would lose its order. Before the jump, keep the branch.
        if (goes && (s.Nets != 0 || run.Followed > 0))
        {
            double length = sweep.Length;
            _nets.EndWhereSlack(ref sweep, in s, sweep.System.NetsSlack);
            _nets.EndWhereBent(ref sweep, in s, in run, -1);
            end.Branch = sweep.Length < length ? s.Branch : end.Branch;
        }

        return ShortenToContact(ref sweep, ref s, ref run, order, goes, ref end);
    }

    /// <summary>Ends a piece at the first contact.</summary>
    private bool ShortenToContact<TSweep>(ref TSweep sweep, ref BallState s, ref StepRun run, int order, bool goes, ref FlightEnd end)
        where TSweep : struct, IFlightSweep
    {
        if (!goes)
        {
            // To within rounding, the ball is on the jump: repeat the piece on the branch that leads away from it.
            run.Log.Evaluations += sweep.Evaluations;
            s.Branch = end.Branch;
            return false;
        }

        double length = sweep.Length;
        if (!_guard.EndAtFirst(ref sweep, in s, order, default, out end.Met))
        {
            // Forces turn the ball back, so the search halved the piece: keep this length for the rest of the step.
            run.Keep(sweep.Length, length);
        }

        // If the piece ends before the jump, keep the branch.
        end.Branch = sweep.Length < length ? s.Branch : end.Branch;
        run.Log.Evaluations += sweep.Evaluations;
        return true;
    }

    /// <summary>Moves the ball to the end of a piece, and reports the piece.</summary>
    private void Move<TSweep>(ref BallState s, ref StepRun run, ref TSweep sweep, int order, in FlightEnd end)
        where TSweep : struct, IFlightSweep
    {
        Unsafe.SkipInit(out BallState before);
        if (run.Log.IsWatched)
        {
            before = s;
        }

        sweep.MoveTo(ref s);
        s.Branch = end.Branch;
        run.Advance(ref s, sweep.Length);
        if (end.Met.What == SeparationKind.Contact)
        {
            // Set the exact contact height on level ground, so that the path crosses a plane at that height.
            s.Position = _world.ByIndex[end.Met.Index].Snap(s.Position);
        }
        else if (end.Met.What == SeparationKind.None)
        {
            // The ball may have entered a surface that it touched without load at the start.
            ContactSet.Separate(_world, ref s);
        }

        if (run.Log.IsWatched)
        {
            run.Show(in before, in s, ref sweep, order);
        }
    }

    /// <summary>Handles the contact at the end of a piece.</summary>
    private void Respond(ref BallState s, ref StepRun run, in FlightEnd end)
    {
        if (end.Met.What != SeparationKind.None && !run.Log.Halted)
        {
            _guard.Meet(ref s, in end.Met, ref run);
        }
    }

    /// <summary>Ends a piece at the time when the spin reaches zero: decay never reverses a spin.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void EndSpin(ref FlightSweep sweep, double spinRate)
    {
        // Start with a secant estimate, then repeat the step until the spin at its end is zero.
        double tau = sweep.Length * spinRate / (spinRate - sweep.Taken.SpinRate);
        EventLocator.Locate(ref sweep, new SpinLeft(spinRate), tau);
        sweep.Taken.SpinRate = 0;
    }

    /// <summary>Returns the longest piece that stability allows, s.</summary>
    private double Longest(in BallState s, in Vector3d u, double requested, bool isPlain, ref bool spirals)
    {
        double h = requested;
        double speedSquared = u.LengthSquared;
        if (!isPlain)
        {
            double spin = s.Spin.Length;
            double most = Math.Sqrt(speedSquared) + _fastestWind;

            // Try the cheap bound first. If it fails, use a tighter one; in a wind field, use the ball's actual airspeed.
            h = requested * _limit.RateAtMost(most, spin) <= StabilityLimit.LargestChange
                ? requested
                : _limit.PartOf(ref _around.Air, requested, _fastestWind > 0 ? AirSpeed(in s, in u) : most, spin, s.Branch, ref spirals);
            h = _nets.LongestPiece(in s, h);
        }
        else if (_around.AirActs && !_limit.AllowsWhole(h, speedSquared, s.SpinRate, false))
        {
            h = _limit.PartOf(ref _around.Air, requested, Math.Sqrt(speedSquared), s.SpinRate, s.Branch, ref spirals);
        }

        // With some integrators, a ball would return from a hop faster than it left, and its bounces would grow: divide the fall.
        return _gainsByHops ? _limit.WithinHop(h, s.Position.Y - _world.LevelContact, s.Velocity.Y) : h;
    }

    /// <summary>Returns the speed relative to the air in a wind field, m/s.</summary>
    private double AirSpeed(in BallState s, in Vector3d u)
    {
        _around.Air.Evaluate(new ForceContext(s.Time, s.Position, s.Velocity, in u, s.Spin, s.Motion, s.AirDistance), s.Branch, out AirFactors air);
        return air.AirVelocity.Length;
    }
}

/// <summary>The end of a piece of flight: the branch of the drag law from there, and the contact.</summary>
internal struct FlightEnd
{
    /// <summary>The branch of the drag law from the end on.</summary>
    public DragBranch Branch;

    /// <summary>The contact at the end.</summary>
    public Separation Met;
}

/// <summary>The spin left at the end of a flight with a constant axis.</summary>
/// <param name="start">Spin at the start, rad/s.</param>
internal readonly struct SpinLeft(double start) : IEventFunction<FlightSweep>
{
    /// <summary>A spin below this counts as zero, rad/s.</summary>
    private const double Vanishing = 1e-300;

    public bool Evaluate(ref FlightSweep sweep, double tau, out double value, out double correction)
    {
        value = sweep.Taken.SpinRate;

        // Use the secant from the start of the step, because the spin falls almost linearly.
        correction = value * tau / (start - value);
        return Math.Abs(value) <= (1e-14 * start) + Vanishing || !(tau > 0);
    }
}
