using FootballPhysics.Contacts;
using FootballPhysics.Integration;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>Ends a piece of motion at its first contact with the world, and handles that contact.</summary>
internal sealed class WorldGuard
{
    /// <summary>Maximum number of searches per piece. Each shorter piece gives a more accurate path for the next search.</summary>
    private const int MostSearches = 8;

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
        int first = int.MaxValue;
        bool takesUp = false;
        var near = NearThings.At(_world, s.Position, s.Time);
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
            bool hits = touches && rate < -ContactTolerances.Approaching && !(Flush.Passage(_world, i, s.Position, s.Velocity, s.Time) > 0);
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

    private Vector3d NormalOf(int collider, in BallState s) => _world.Colliders[collider].At(s.Position, s.Time).Normal;

    /// <summary>Ends a piece at its first contact, except for the contacts that the ball keeps.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="s">The ball at its start.</param>
    /// <param name="order">Order of the integrator.</param>
    /// <param name="held">The contacts that the ball keeps.</param>
    /// <param name="met">The contact.</param>
    /// <returns>True if there is a contact.</returns>
    public bool EndAtFirst<TSweep>(ref TSweep sweep, in BallState s, int order, scoped Span<Contact> held, out Separation met)
        where TSweep : struct, ISweep
    {
        int carrier = s.Motion == MotionState.Airborne ? -1 : (int)s.Carrier - _world.FirstCollider;
        met = default;
        if (carrier >= 0 && _world.IsPlaneAlone)
        {
            return false;
        }

        for (int i = 0; i < MostSearches; i++)
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

            // The thesis' bisection supports only level ground.
            if (_bisects && found.What == SeparationKind.Contact && _world.Colliders[found.Index].IsLevelGround && sweep.Position.Y < _world.LevelContact)
            {
                Bisection.End(ref sweep, _tolerance, _world.LevelContact);
                met = found;
                break;
            }

            if (!Locate(ref sweep, in found, s.Time, at))
            {
                // The search stopped at a grazing contact: end the piece there. The next piece continues the search.
                sweep.Step(Math.Max(at, ContactTolerances.ShortestPiece * path.Length));
                met = default;
                break;
            }

            // On the cubic, the ball may seem to hit the surface beyond a seam. If the step itself crosses the seam, end the piece at the edge.
            if (found.What == SeparationKind.Contact && !_world.IsPlaneAlone
                && Flush.Passage(_world, found.Index, sweep.Position, sweep.Velocity, s.Time + sweep.Length, carrier, held) > 0)
            {
                met = default;
                break;
            }

            met = found;
            if (!(sweep.Length > 0) || _world.IsPlaneAlone)
            {
                // No other contact can be earlier.
                break;
            }
        }

        return met.What != SeparationKind.None;
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
                break;
        }
    }

    /// <summary>Notes that the ball enters or leaves a net or a goal.</summary>
    private void Pass(ref BallState s, in Separation met, ref StepRun run)
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

/// <summary>Keeps the pieces of a ball in a net short enough for their paths, and ends them at kinks of the net's force.</summary>
/// <remarks>The force has a kink when the net goes slack or taut.</remarks>
internal sealed class NetGuard
{
    /// <summary>Factor by which a piece that bends too much is shortened.</summary>
    private const double Shorter = 0.8;

    /// <summary>Maximum number of times a piece next to a collider is shortened.</summary>
    private const int MostHalved = 4;

    /// <summary>Maximum number of parts per piece: the cost of a step is only checked between pieces.</summary>
    private const int MostParts = 64;

    private readonly World _world;

    public NetGuard(World world) => _world = world;

    /// <summary>Returns the longest piece whose path in the nets follows from its ends, s.</summary>
    public double LongestPiece(in BallState s, double h)
    {
        h = s.Nets == 0 ? h : Math.Min(h, _world.NetForces.Longest(s.Nets, s.NetSides, s.Position, s.Velocity, MostParts));
        for (int i = 0; i < _world.Nets.Length && s.Nets != 0; i++)
        {
            if ((s.Nets >> i & 1) != 0)
            {
                // The deviation of the path scales with the sixth power of the piece's length.
                while (_world.Nets[i].Bends(s.Position, s.Velocity, NetSheet.SideOf(s.NetSides, i), h) > ContactTolerances.NetBend)
                {
                    h *= Shorter;
                }
            }
        }

        return h;
    }

    /// <summary>Returns how fast the nets around the ball change its motion at a position, 1/s.</summary>
    public double FastestRate(in BallState s, in Vector3d position)
    {
        double rate = 0;
        for (int i = 0; i < _world.Nets.Length; i++)
        {
            if ((s.Nets >> i & 1) != 0)
            {
                rate += _world.Nets[i].RateAt(Math.Max(0, _world.Nets[i].Depth(in position, NetSheet.SideOf(s.NetSides, i))));
            }
        }

        return rate;
    }

    /// <summary>Returns the nets around the ball that are slack from now on.</summary>
    public ulong? SlackAt(in BallState s, in Vector3d acceleration) =>
        s.Nets == 0 ? null : _world.NetForces.SlackAt(s.Nets, s.NetSides, s.Velocity, in acceleration);

    /// <summary>Ends a piece when a net that was slack from its start becomes taut, or the reverse.</summary>
    public void EndWhereSlack<TSweep>(ref TSweep sweep, in BallState s, ulong? slack)
        where TSweep : struct, ISweep
    {
        for (int i = 0; i < _world.Nets.Length && s.Nets != 0; i++)
        {
            if ((s.Nets >> i & 1) == 0)
            {
                continue;
            }

            // The force has a kink where 1 + b δ̇ changes sign. The piece continues one branch beyond it, so its path is smooth there.
            double sign = (slack >> i & 1) != 0 ? -1.0 : 1.0;
            var tension = new TensionLeft<TSweep>(_world.Nets[i], NetSheet.SideOf(s.NetSides, i), sign);
            if (tension.At(sweep.Velocity) < 0)
            {
                EventLocator.Locate(ref sweep, in tension, tension.FirstGuess(ref sweep, s.Velocity));
            }
        }
    }

    /// <summary>Shortens a piece next to a collider until the cubic that is searched matches the path, which a net bends
    /// strongly.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="s">The ball at its start.</param>
    /// <param name="carrier">The carrier; −1 if there is none.</param>
    public void EndWhereBent<TSweep>(ref TSweep sweep, in BallState s, int carrier)
        where TSweep : struct, ISweep
    {
        for (int i = 0; i < MostHalved && s.Nets != 0 && sweep.Length > 0 && IsNear(ref sweep, in s, carrier); i++)
        {
            // The quintic minus the cubic at the middle: h (v₀ − v₁)/32 + h² (a₀ + a₁)/64, which is of fourth order in the length.
            double h = sweep.Length;
            Vector3d off = (h / 32.0 * (s.Velocity - sweep.Velocity)) + (h * h / 64.0 * (sweep.StartAcceleration + sweep.EndAcceleration()));
            double share = ContactTolerances.NetBend / off.Length;
            if (!(share < 1))
            {
                return;
            }

            sweep.Step(h * Shorter * Math.Sqrt(Math.Sqrt(share)));
        }
    }

    /// <summary>True if a collider other than the carrier is next to a piece.</summary>
    private bool IsNear<TSweep>(ref TSweep sweep, in BallState s, int carrier)
        where TSweep : struct, ISweep
    {
        var path = PathCubic.Between(s.Position, s.Velocity, sweep.Position, sweep.Velocity, sweep.Length);
        double r = _world.Ball.Radius;
        var near = new NearThings(_world, path.Bounds.Expanded(r), s.Time, sweep.Length);
        while (near.Next(out int i))
        {
            // Planes have no bounding box, so check their distance here.
            bool isFar = _world.Colliders[i].StandingPlane is { } plane
                && Math.Min(plane.DistanceTo(s.Position), plane.DistanceTo(sweep.Position)) > r + path.Deviation;
            if (i != carrier && !isFar)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>The remaining tension of a net before its sign change.</summary>
    private readonly struct TensionLeft<TSweep>(NetSheet net, double side, double sign) : IEventFunction<TSweep>
        where TSweep : struct, ISweep
    {
        /// <summary>The number of Newton steps on the cubic.</summary>
        private const int Guesses = 4;

        /// <summary>± (1 + b δ̇), positive until the kink.</summary>
        public double At(in Vector3d velocity) => sign * net.Tension(in velocity, side);

        /// <summary>Returns the zero of the cubic through the values and rates at both ends of a sweep, s.</summary>
        public double FirstGuess(ref TSweep sweep, in Vector3d start)
        {
            double h = sweep.Length;
            double from = At(in start);
            double to = At(sweep.Velocity);
            var cubic = new CubicHermite(from, h * sign * net.TensionRate(sweep.StartAcceleration, side), to, h * sign * net.TensionRate(sweep.EndAcceleration(), side));
            double x = from / (from - to);
            for (int i = 0; i < Guesses; i++)
            {
                x -= cubic.At(x) / cubic.SlopeAt(x);
            }

            return x > 0 && x < 1 ? x * h : 0.5 * h;
        }

        public bool Evaluate(ref TSweep sweep, double tau, out double value, out double correction)
        {
            // A Newton step on ± (1 + b δ̇); its derivative needs the acceleration at the end.
            value = At(sweep.Velocity);
            bool isThere = Math.Abs(value) < ContactTolerances.NetSlack;
            double rate = isThere ? 0 : sign * net.TensionRate(sweep.EndAcceleration(), side);
            correction = rate < 0 ? -value / rate : double.NaN;
            return isThere;
        }
    }
}
