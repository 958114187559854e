using FootballPhysics.Contacts;
using FootballPhysics.Integration;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>Ends a piece of motion at its first contact with the world, and handles that contact.</summary>
internal sealed class WorldGuard
{
    /// <summary>Maximum number of searches per piece. Each shorter piece gives a more accurate path for the next search.</summary>
    private const int MostSearches = 8;

    /// <summary>Maximum number of nets and goals on one straight line: more than can exist at one position.</summary>
    private const int MostPassages = 32;

    private readonly World _world;
    private readonly WorldContact _contact;
    private readonly bool _bisects;
    private readonly double _tolerance;

    public WorldGuard(World world, WorldContact contact, SolverSettings settings)
    {
        _world = world;
        _bisects = settings.CollisionTiming == CollisionTiming.Bisection;
        _tolerance = settings.CollisionTolerance;
        _contact = contact;
    }

    /// <summary>Handles an immediate hit: a touched surface that the ball closes on, or one that presses against a ball in the
    /// air.</summary>
    /// <returns>True if there was an impact, or a surface now supports the ball.</returns>
    public bool HitsAtOnce(ref BallState s, ref StepRun run)
    {
        long carrier = s.Motion == MotionState.Airborne ? -1 : s.Carrier - _world.FirstCollider;
        double slowest = run.Rattles && carrier >= 0 ? _world.MinimumBounceSpeed : ContactTolerances.Approaching;
        int first = int.MaxValue;
        bool takesUp = false;
        var near = NearThings.At(_world, in s);
        while (near.Next(out int i))
        {
            // Use the first collider in scene order, regardless of the traversal order. Between two bodies, the contact normals decide.
            bool byside = first != int.MaxValue && _world.IsByside(i, first);
            if (i == carrier || (i > first && !byside))
            {
                continue;
            }

            new Separation(_world, SeparationKind.Contact, i).Evaluate(s.Position, s.Velocity, s.Time, out double gap, out double rate);

            // A closing contact is an impact. If a flying ball is pressed onto a surface and neither closes nor leaves, the surface supports it.
            bool touches = gap <= ContactTolerances.Touching;
            bool hits = touches && rate < -slowest && !(Flush.Passage(_world, i, s.Position, s.Velocity, s.Time) > 0);
            bool presses = touches && !hits && rate <= ContactTolerances.Leaving && carrier < 0 && _contact.Load.IsPressed(in s, i);
            if ((hits || presses) && (!byside || NearThings.IsBefore(NormalOf(i, in s), i, NormalOf(first, in s), first)))
            {
                takesUp = presses;
                first = i;
            }
        }

        if (first == int.MaxValue)
        {
            return false;
        }

        if (takesUp)
        {
            _contact.TakeUp(ref s, first, ref run);
        }
        else
        {
            _contact.Impact(ref s, first, ref run);
        }

        return true;
    }

    private Vector3d NormalOf(int collider, in BallState s) => _world.ByIndex[collider].At(s.Position, s.Time).Normal;

    /// <summary>Ends a piece at its first contact, except for the contacts that the ball keeps.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="s">The ball at its start.</param>
    /// <param name="order">Order of the integrator.</param>
    /// <param name="held">The contacts that the ball keeps.</param>
    /// <param name="met">The contact.</param>
    /// <returns>True if there is a contact.</returns>
    public bool EndAtFirst<TSweep>(ref TSweep sweep, in BallState s, int order, scoped Span<Contact> held, out Separation met)
        where TSweep : struct, ISweep =>
        _world.IsPlaneAlone ? EndAtPlane(ref sweep, in s, order, out met) : EndAmong(ref sweep, in s, order, held, out met);

    private bool EndAmong<TSweep>(ref TSweep sweep, in BallState s, int order, scoped Span<Contact> held, out Separation met)
        where TSweep : struct, ISweep
    {
        int carrier = s.Motion == MotionState.Airborne ? -1 : (int)s.Carrier - _world.FirstCollider;
        met = default;
        for (int i = 0; i < MostSearches && (i == 0 || sweep.Length > 0); i++)
        {
            // Find the time of impact on the cubic of the piece, then refine it on the integrator's own step. The shorter piece has a different
            // cubic, so repeat.
            var path = PathCubic.Between(s.Position, s.Velocity, sweep.Position, sweep.Velocity, sweep.Length, isQuadratic: order <= 2);
            double at = new ContactSearch(_world, in path, s.Time).First(in s, carrier, out Separation found, held);

            // No earlier contact was found, or the contact is the same one and earlier only by rounding.
            if (!(at <= path.Length) || (met.What != SeparationKind.None && (at >= path.Length * (1.0 - ContactTolerances.StepRounding) || IsAgain(ref sweep, in met, in found, s.Time, path.Length - at))))
            {
                break;
            }

            // At a seam, another surface becomes the carrier: end the piece when the ball reaches that surface. If the ball touches a surface and closes
            // from the start, the piece has zero length.
            if (found.What == SeparationKind.Seam || at == 0)
            {
                sweep.Step(at);
                met = found;
                break;
            }

            if (!Ends(ref sweep, in found, s.Time, at))
            {
                met = default;
                break;
            }

            // On the cubic, the ball may seem to hit the surface beyond a seam. If the step itself crosses the seam, end the piece at the edge.
            if (found.What == SeparationKind.Contact
                && Flush.Passage(_world, found.Index, sweep.Position, sweep.Velocity, s.Time + sweep.Length, carrier, held) > 0)
            {
                met = default;
                break;
            }

            met = found;
        }

        return met.What != SeparationKind.None;
    }

    /// <summary>Ends a piece at the only surface of the scene, a plane: the same search without the code for other surfaces, which costs more to enter.</summary>
    private bool EndAtPlane<TSweep>(ref TSweep sweep, in BallState s, int order, out Separation met)
        where TSweep : struct, ISweep
    {
        met = default;
        if (s.Motion != MotionState.Airborne || _world.Ground?.StandingPlane is not { } plane)
        {
            return false;
        }

        double length = sweep.Length;
        var path = PathCubic.Between(s.Position, s.Velocity, sweep.Position, sweep.Velocity, length, isQuadratic: order <= 2);
        var gap = new PlaneGap(in path, plane.Normal, plane.DistanceTo(in path.Start) - _world.Ball.Radius);
        double at = TimeOfImpact.First(ref gap, new SearchSpan(length, double.PositiveInfinity), ref _world.SearchEvaluations);
        if (!(at <= length))
        {
            return false;
        }

        var ground = new Separation(_world, SeparationKind.Contact, 0);
        if (at == 0)
        {
            sweep.Step(0);
        }
        else if (!Ends(ref sweep, in ground, s.Time, at))
        {
            return false;
        }

        met = ground;
        return true;
    }

    /// <summary>Ends a piece at a contact, or where the search for it stopped.</summary>
    /// <returns>False if the search stopped at a grazing contact. The next piece continues the search.</returns>
    private bool Ends<TSweep>(ref TSweep sweep, in Separation found, double time, double at)
        where TSweep : struct, ISweep
    {
        // The thesis' bisection supports only level ground.
        if (_bisects && found.What == SeparationKind.Contact && _world.ByIndex[found.Index].IsLevelGround && sweep.Position.Y < _world.LevelContact)
        {
            Bisection.End(ref sweep, _tolerance, _world.LevelContact);
            return true;
        }

        double length = sweep.Length;
        if (!Locate(ref sweep, in found, time, at))
        {
            sweep.Step(Math.Max(at, ContactTolerances.ShortestPiece * length));
            return false;
        }

        return true;
    }

    /// <summary>Handles a contact at the ball's position.</summary>
    public void Meet(ref BallState s, in Separation met, ref StepRun run)
    {
        switch (met.What)
        {
            case SeparationKind.Contact:
                _contact.Impact(ref s, met.Index, ref run);
                break;
            case SeparationKind.Seam:
                _contact.HandOver(ref s, met.Index, ref run);
                break;
            default:
                Pass(ref s, in met, ref run);
                _contact.LeaveNetEnd(ref s, ref run);
                break;
        }
    }

    /// <summary>Notes that the ball enters or leaves a net or a goal.</summary>
    public void Pass(ref BallState s, in Separation met, ref StepRun run)
    {
        switch (met.What)
        {
            case SeparationKind.NetMet:
                s.Nets |= 1UL << met.Index;
                s.NetSides = met.Side > 0 ? s.NetSides | (1UL << met.Index) : s.NetSides & ~(1UL << met.Index);
                run.Report(BallEventKind.Net, _world.ThingOfNet(met.Index), met.Side * _world.Nets[met.Index].Normal, in s, s.Velocity, s.Spin);
                break;
            case SeparationKind.NetLeft:
                s.Nets &= ~(1UL << met.Index);
                break;
            case SeparationKind.MouthEntered:
                s.GoalsEntered |= 1UL << met.Index;
                break;
            case SeparationKind.MouthLeft:
                s.GoalsEntered &= ~(1UL << met.Index);
                break;
            case SeparationKind.GoalLine:
                s.GoalsEntered &= ~(1UL << met.Index);
                s.GoalsPassed |= 1UL << met.Index;
                run.Report(BallEventKind.Goal, _world.ThingOfGoal(met.Index), _world.Goals[met.Index].Out, in s, s.Velocity, s.Spin);
                break;
        }
    }

    /// <summary>True if the contact found is the one at the end of the piece, detected slightly earlier.</summary>
    private static bool IsAgain<TSweep>(ref TSweep sweep, in Separation met, in Separation found, double time, double before)
        where TSweep : struct, ISweep
    {
        if (found.What != met.What || found.Index != met.Index)
        {
            return false;
        }

        // If the gap closes in between, it stays within the contact tolerance.
        met.Evaluate(sweep.Position, sweep.Velocity, time + sweep.Length, out _, out double rate);
        return before * -rate <= 4.0 * ContactTolerances.Touching;
    }

    /// <summary>Follows a ball that is displaced out of an overlap: on that straight path it may enter nets and pass through goals.</summary>
    /// <param name="s">The ball, at its new position.</param>
    /// <param name="from">Its old position, m.</param>
    /// <param name="run">The step.</param>
    public void Follow(ref BallState s, in Vector3d from, ref StepRun run)
    {
        Vector3d to = s.Position;
        if (_world.Nets.Length + _world.Goals.Length > 0 && to != from)
        {
            // The events contain the positions of the passages, and the time of the displacement.
            s.Position = from;
            MoveAlong(ref s, (to - from) / ContactTolerances.Displacement, ContactTolerances.Displacement, passes: 0, ref run);
            s.Position = to;
            _contact.LeaveNetEnd(ref s, ref run);
        }
    }

    /// <summary>Moves a ball in a straight line, through the nets and goals on it, in order.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="velocity">The velocity of the line, m/s.</param>
    /// <param name="duration">The duration, s.</param>
    /// <param name="passes">The time that passes per duration: 1, or 0 for a displacement.</param>
    /// <param name="run">The step.</param>
    public void MoveAlong(ref BallState s, in Vector3d velocity, double duration, double passes, ref StepRun run)
    {
        for (int i = 0; i < MostPassages && _world.Nets.Length + _world.Goals.Length > 0; i++)
        {
            var path = PathCubic.Line(s.Position, in velocity, duration);
            double at = new ContactSearch(_world, in path, s.Time).FirstPassage(in s, out Separation met);
            if (!(at <= duration))
            {
                break;
            }

            s.Position = path.At(at);
            s.Time += passes * at;
            duration -= at;
            Pass(ref s, in met, ref run);
        }

        s.Position += duration * velocity;
    }

    /// <summary>Refines a contact from the cubic to the integrator's own step: bracketed Newton iteration on the gap.</summary>
    /// <returns>False if the gap does not close after all.</returns>
    private static bool Locate<TSweep>(ref TSweep sweep, in Separation sought, double time, double tau)
        where TSweep : struct, ISweep
    {
        sought.Evaluate(sweep.Position, sweep.Velocity, time + sweep.Length, out double atEnd, out _);

        // The gap is open at both ends: there may be a root in between.
        bool dips = atEnd > 0;

        // If the gap is zero at the start, reject the root there, which belongs to the old contact.
        if (EventLocator.Locate(ref sweep, new Closing<TSweep>(in sought, time, dips), tau) && !dips && sweep.Length >= ContactTolerances.ShortestPiece * tau)
        {
            return true;
        }

        // The gap stays within the contact tolerance, so it has no root. The contact starts when the ball begins to close.
        if (!dips && sweep.Length < ContactTolerances.ShortestPiece * tau)
        {
            sweep.Step(tau);
        }

        sought.Evaluate(sweep.Position, sweep.Velocity, time + sweep.Length, out double left, out double coming);

        // If a step ends inside the surface, the ball has hit it, even with zero end velocity (a semi-implicit hop).
        return left <= ContactTolerances.Touching && (coming < 0 || atEnd < 0);
    }

    /// <summary>A gap that closes, as a function of the step's length.</summary>
    /// <param name="gap">The gap.</param>
    /// <param name="start">Start time of the piece, s.</param>
    /// <param name="dips">Whether the gap is open at the end of the piece too. The search then stops after the minimum, as there may be
    /// no root.</param>
    private readonly struct Closing<TSweep>(in Separation gap, double start, bool dips) : IEventFunction<TSweep>
        where TSweep : struct, ISweep
    {
        private readonly Separation _gap = gap;

        public bool Evaluate(ref TSweep sweep, double tau, out double value, out double correction)
        {
            _gap.Evaluate(sweep.Position, sweep.Velocity, start + tau, out value, out double rate);

            // The Newton step −f/f', valid while the gap closes.
            correction = rate < 0 ? -value / rate : double.NaN;
            if (Math.Abs(value) <= ContactTolerances.LocatedGap || (dips && value > 0 && rate >= 0))
            {
                return true;
            }

            // The remaining correction is small: move the end linearly instead of repeating the step.
            bool isClose = tau + correction >= 0 && Math.Abs(correction) <= EventLocator.Negligible
                && sweep.StartAcceleration.Length * correction * correction <= EventLocator.NegligibleBend;
            if (isClose)
            {
                // Apply the correction twice, because the first one leaves an error due to the curvature of the gap.
                sweep.Nudge(correction);
                _gap.Evaluate(sweep.Position, sweep.Velocity, start + sweep.Length, out double left, out rate);
                sweep.Nudge(rate < 0 ? Math.Max(-left / rate, -sweep.Length) : 0);
            }

            return isClose;
        }
    }
}
