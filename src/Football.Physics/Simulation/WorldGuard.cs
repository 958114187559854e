namespace FootballPhysics;

/// <summary>Ends a piece of motion at the first thing of the world that it meets, and does what that calls for.</summary>
internal sealed class WorldGuard
{
    /// <summary>Below this, m, a gap needs no correction.</summary>
    private const double Closed = 1e-14;

    /// <summary>A piece that ends where something is grazed is at least this share of what it was.</summary>
    private const double ShortestPiece = 1e-6;

    /// <summary>How often the search is repeated on the piece that it has shortened: its path is then known better.</summary>
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

    /// <summary>An impact with what the ball touches and comes closer to where it is, if anything; what a ball in the air is pressed on takes it even where nothing comes closer.</summary>
    /// <returns>True when there was one, or the ground has taken the ball.</returns>
    public bool HitsAtOnce(ref BallState s, ref StepRun run)
    {
        long carrier = s.Motion == MotionState.Airborne ? -1 : s.Carrier - _world.FirstCollider;
        int first = int.MaxValue;
        bool takesUp = false;
        var near = NearThings.At(_world, s.Position, s.Time);
        while (near.NextCollider(out int i))
        {
            // The first counts, in whatever order the walk comes to them: of the scene, and of bodies that on a certain side.
            bool byside = first != int.MaxValue && _world.IsByside(i, first);
            if (i == carrier || (i > first && !byside))
            {
                continue;
            }

            Separation.OfContact(_world, i).Evaluate(s.Position, s.Velocity, s.Time, out double gap, out double rate);

            // Closing is an impact. Neither closing nor leaving, but pressed there, a ball in the air is taken up.
            bool touches = gap <= ContactSearch.Touching;
            bool hits = touches && ((rate < -ContactSearch.Approaching && !(Flush.Passage(_world, i, s.Position, s.Velocity, s.Time) > 0)) || IsStruck(in s, _world.Colliders[i]));
            bool presses = touches && !hits && rate <= ContactSearch.Leaving && carrier < 0 && _contact.Load.IsPressed(in s, i);
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

    /// <summary>True if a surface that moves while its shape stays closes on a ball that touches it.</summary>
    private bool IsStruck(in BallState s, Collider collider)
    {
        if (collider.Spin == Vector3d.Zero || collider.Rotates)
        {
            return false;
        }

        // (v − V_c)·n with V_c at the point of contact, c = p − r n.
        Vector3d n = collider.At(s.Position, s.Time).Normal;
        Vector3d surface = collider.SurfaceVelocity(s.Position - (_world.Ball.Radius * n), s.Time);
        return Vector3d.Dot(s.Velocity - surface, in n) < -ContactSearch.Approaching;
    }

    /// <summary>Ends a piece at the first thing that it meets.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="s">The ball at its start.</param>
    /// <param name="order">Order of the method.</param>
    /// <param name="met">What it meets.</param>
    /// <returns>True when it meets anything.</returns>
    public bool EndAtFirst<TSweep>(ref TSweep sweep, in BallState s, int order, out Separation met)
        where TSweep : struct, ISweep => EndAtFirst(ref sweep, in s, order, default, out met);

    /// <summary>Ends a piece at the first thing that it meets, but for contacts that the ball keeps.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="s">The ball at its start.</param>
    /// <param name="order">Order of the method.</param>
    /// <param name="held">Contacts that it keeps.</param>
    /// <param name="met">What it meets.</param>
    /// <returns>True when it meets anything.</returns>
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
            // Time of impact on the cubic of the piece, then on the integrator's own step; once more, for the shortened piece has another cubic.
            var path = PathCubic.Of(ref sweep, s.Position, s.Velocity, order);
            var search = new ContactSearch(_world, in path, s.Time);
            double at = search.First(in s, carrier, held, out Separation found);

            // Nothing before what is met already, or the same contact a rounding earlier.
            if (!(at <= path.Length) || (met.What != SeparationKind.None && (at >= path.Length * (1.0 - 1e-9) || IsAgain(ref sweep, in met, in found, s.Time, path.Length - at))))
            {
                break;
            }

            // At a seam another surface carries the ball on: the piece ends where the ball is over that.
            if (found.What == SeparationKind.Seam)
            {
                sweep.Step(at);
                met = found;
                break;
            }

            // It touches and closes at the start: a piece of no length.
            if (at == 0)
            {
                sweep.Step(0);
                met = found;
                break;
            }

            // The thesis' search knows the level ground alone.
            if (_bisects && IsLevelGround(in found) && sweep.Position.Y < _world.LevelContact)
            {
                Bisection.End(ref sweep, _tolerance, _world.LevelContact);
                met = found;
                break;
            }

            if (!Locate(ref sweep, in found, s.Time, at))
            {
                // It only grazes: the piece ends there all the same, for nothing else is met before, and the next one sees what is ahead.
                sweep.Step(Math.Max(at, ShortestPiece * path.Length));
                met = default;
                break;
            }

            // On its cubic a piece may close on the surface that a seam continues, and on the step itself not: it crosses the seam, and ends where it comes to the edge.
            if (found.What == SeparationKind.Contact && !_world.IsPlaneAlone
                && Flush.Passage(_world, found.Index, sweep.Position, sweep.Velocity, s.Time + sweep.Length, carrier, held) > 0)
            {
                met = default;
                break;
            }

            met = found;
            if (!(sweep.Length > 0) || _world.IsPlaneAlone)
            {
                // Nothing else can be met before.
                break;
            }
        }

        return met.What != SeparationKind.None;
    }

    /// <summary>Handles the meeting with a thing where the ball is.</summary>
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
            case SeparationKind.NetMet:
                s.Nets |= 1UL << met.Index;
                s.NetSides = met.Side > 0 ? s.NetSides | (1UL << met.Index) : s.NetSides & ~(1UL << met.Index);
                Report(in s, BallEventKind.Net, _world.ThingOfNet(met.Index), met.Side * _world.Nets[met.Index].Normal, ref run);
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
                Report(in s, BallEventKind.Goal, _world.ThingOfGoal(met.Index), _world.Goals[met.Index].Out, ref run);
                break;
        }
    }

    /// <summary>The end of a piece that meets level ground is on it to the last bit, and so the path there crosses a plane at that height.</summary>
    public void PutOnto(ref BallState s, in Separation met)
    {
        if (IsLevelGround(in met))
        {
            s.Position = new Vector3d(s.Position.X, _world.LevelContact, s.Position.Z);
        }
    }

    private bool IsLevelGround(in Separation met) => met.What == SeparationKind.Contact && _world.IsLevel && _world.Colliders[met.Index] == _world.Ground;

    private static void Report(in BallState s, BallEventKind kind, int thing, in Vector3d normal, ref StepRun run) =>
        run.Report(new BallEvent(kind, thing, in normal, s.Time, s.Position, s.Velocity, s.Spin, s.Velocity, s.Spin));

    /// <summary>True when what is found is what the piece ends at already, which touches by so much before.</summary>
    private static bool IsAgain<TSweep>(ref TSweep sweep, in Separation met, in Separation found, double time, double before)
        where TSweep : struct, ISweep
    {
        if (found.What != met.What || found.Index != met.Index)
        {
            return false;
        }

        // What closes in the time between is no more than what counts as touching.
        met.Evaluate(sweep.Position, sweep.Velocity, time + sweep.Length, out _, out double rate);
        return before * -rate <= 4.0 * ContactSearch.Touching;
    }

    /// <summary>From the cubic path to the step itself: Newton on the gap, inside its bracket.</summary>
    /// <returns>False where the gap does not close after all.</returns>
    private static bool Locate<TSweep>(ref TSweep sweep, in Separation sought, double time, double tau)
        where TSweep : struct, ISweep
    {
        sought.Evaluate(sweep.Position, sweep.Velocity, time + sweep.Length, out double atEnd, out _);

        // Open at both ends the gap dips: there may be a root, or none.
        bool dips = atEnd > 0;

        // A gap that is zero at the start has a root there, which is not the one sought.
        if (EventLocator.Locate(ref sweep, new Closing<TSweep>(in sought, time, dips), tau) && !dips && sweep.Length >= ShortestPiece * tau)
        {
            return true;
        }

        // Closed all along, by less than what counts as touching: there is no root, and the ball meets it where it begins to come closer.
        if (!dips && sweep.Length < ShortestPiece * tau)
        {
            sweep.Step(tau);
        }

        sought.Evaluate(sweep.Position, sweep.Velocity, time + sweep.Length, out double left, out double coming);

        // A step that ends inside has touched it, even where its own velocity is zero there (a semi-implicit hop).
        return left <= ContactSearch.Touching && (coming < 0 || atEnd < 0);
    }

    /// <summary>A gap that closes.</summary>
    private readonly struct Closing<TSweep> : IEventFunction<TSweep>
        where TSweep : struct, ISweep
    {
        private readonly Separation _gap;
        private readonly double _start;
        private readonly bool _dips;

        /// <param name="gap">The gap.</param>
        /// <param name="start">Time at the start of the piece, s.</param>
        /// <param name="dips">Whether it is open again at the piece's end: then a search that is past its least ends, for it may close nowhere.</param>
        public Closing(in Separation gap, double start, bool dips)
        {
            _gap = gap;
            _start = start;
            _dips = dips;
        }

        public bool Evaluate(ref TSweep sweep, double tau, out double value, out double correction)
        {
            _gap.Evaluate(sweep.Position, sweep.Velocity, _start + tau, out value, out double rate);

            // Newton: −f/f', where the gap falls.
            correction = rate < 0 ? -value / rate : double.NaN;
            if (Math.Abs(value) <= Closed || (_dips && value > 0 && rate >= 0))
            {
                return true;
            }

            // So little is left that the end can be moved along the motion, and the step need not be taken again.
            bool isClose = tau + correction >= 0 && EventLocator.IsLinear(ref sweep, correction);
            if (isClose)
            {
                // Twice: the first correction leaves what the gap bends in it.
                sweep.Nudge(correction);
                _gap.Evaluate(sweep.Position, sweep.Velocity, _start + sweep.Length, out double left, out rate);
                sweep.Nudge(rate < 0 ? Math.Max(-left / rate, -sweep.Length) : 0);
            }

            return isClose;
        }
    }
}

/// <summary>Keeps the pieces of a ball in a net short enough for their paths, and ends them where a net becomes slack or tight: there its force has a kink.</summary>
internal sealed class NetGuard
{
    /// <summary>So far, m, the path of a piece may be off the one that its ends tell.</summary>
    private const double LargestBend = 3e-7;

    /// <summary>By what a piece is shortened that bends too much.</summary>
    private const double Shorter = 0.8;

    /// <summary>A piece next to a collider is shortened so often at most.</summary>
    private const int MostHalved = 4;

    /// <summary>A kink is found to this tension; a piece that starts with less than the second starts at one.</summary>
    private const double Kink = 1e-12;
    private const double AtKink = 1e-9;

    /// <summary>So many parts a piece has at most: what a step may cost is counted between its pieces.</summary>
    private const int MostParts = 256;

    private readonly World _world;

    public NetGuard(World world) => _world = world;

    /// <summary>The longest piece whose path between its ends is known from those, in the nets that the ball is in, s.</summary>
    public double LongestPiece(in BallState s, double h)
    {
        h = s.Nets == 0 ? h : Math.Min(h, _world.LongestPieceInNets(in s, MostParts));
        for (int i = 0; i < _world.Nets.Length && s.Nets != 0; i++)
        {
            if ((s.Nets >> i & 1) != 0)
            {
                // How far the path may be off falls with the sixth power of the length.
                while (_world.Nets[i].Bends(s.Position, s.Velocity, World.SideOf(s.NetSides, i), h) > LargestBend)
                {
                    h *= Shorter;
                }
            }
        }

        return h;
    }

    /// <summary>How fast the nets that the ball is in change its motion at a place, 1/s.</summary>
    public double FastestRate(in BallState s, in Vector3d position)
    {
        double rate = 0;
        for (int i = 0; i < _world.Nets.Length; i++)
        {
            if ((s.Nets >> i & 1) != 0)
            {
                rate += _world.Nets[i].RateAt(Math.Max(0, _world.Nets[i].Depth(in position, World.SideOf(s.NetSides, i))));
            }
        }

        return rate;
    }

    /// <summary>Ends a piece where the tension 1 + b δ̇ of a net changes its sign.</summary>
    public void EndWhereSlack<TSweep>(ref TSweep sweep, in BallState s)
        where TSweep : struct, ISweep
    {
        for (int i = 0; i < _world.Nets.Length && s.Nets != 0; i++)
        {
            if ((s.Nets >> i & 1) == 0)
            {
                continue;
            }

            // A change of sign of 1 + b δ̇ is the kink; a piece that begins at one has it behind itself.
            double side = World.SideOf(s.NetSides, i);
            double start = _world.Nets[i].Tension(s.Velocity, side);
            double end = _world.Nets[i].Tension(sweep.Velocity, side);
            if (Math.Abs(start) > AtKink && start < 0 != end < 0)
            {
                // Up to the kink the motion is smooth: its rate at the start leads there sooner than what lies beyond.
                double sign = start < 0 ? -1.0 : 1.0;
                double first = sign * start / Math.Max(0, -sign * _world.Nets[i].TensionRate(sweep.StartAcceleration, side));
                double secant = sweep.Length * start / (start - end);
                EventLocator.Locate(ref sweep, new TensionLeft<TSweep>(_world.Nets[i], side, sign), first < sweep.Length ? first : secant);
            }
        }
    }

    /// <summary>Shortens a piece next to a collider until the cubic that is searched is the path: a net bends it by more than the cubic through the ends of a usual piece.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="s">The ball at its start.</param>
    /// <param name="carrier">The collider that carries it; −1 if none does.</param>
    public void EndWhereBent<TSweep>(ref TSweep sweep, in BallState s, int carrier)
        where TSweep : struct, ISweep
    {
        for (int i = 0; i < MostHalved && s.Nets != 0 && sweep.Length > 0 && IsNear(ref sweep, in s, carrier); i++)
        {
            // The quintic less the cubic in the middle: h (v₀ − v₁)/32 + h² (a₀ + a₁)/64. It falls with the fourth power of the length.
            double h = sweep.Length;
            Vector3d off = (h / 32.0 * (s.Velocity - sweep.Velocity)) + (h * h / 64.0 * (sweep.StartAcceleration + sweep.EndAcceleration()));
            double share = LargestBend / off.Length;
            if (!(share < 1))
            {
                return;
            }

            sweep.Step(h * Shorter * Math.Sqrt(Math.Sqrt(share)));
        }
    }

    /// <summary>True if a collider that does not carry the ball is next to a piece.</summary>
    private bool IsNear<TSweep>(ref TSweep sweep, in BallState s, int carrier)
        where TSweep : struct, ISweep
    {
        var path = PathCubic.Between(s.Position, s.Velocity, sweep.Position, sweep.Velocity, sweep.Length);
        double r = _world.Ball.Radius;
        var near = new NearThings(_world, path.Bounds.Expanded(r), s.Time, sweep.Length);
        while (near.NextCollider(out int i))
        {
            // Planes have no box.
            bool isFar = _world.Colliders[i].StandingPlane is { } plane
                && Math.Min(plane.DistanceTo(s.Position), plane.DistanceTo(sweep.Position)) > r + path.Deviation;
            if (i != carrier && !isFar)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>What is left until the tension of a net changes its sign.</summary>
    private readonly struct TensionLeft<TSweep>(NetSheet net, double side, double sign) : IEventFunction<TSweep>
        where TSweep : struct, ISweep
    {
        public bool Evaluate(ref TSweep sweep, double tau, out double value, out double correction)
        {
            // Newton on ± (1 + b δ̇), whose rate takes the acceleration at the end.
            value = sign * net.Tension(sweep.Velocity, side);
            bool isThere = Math.Abs(value) < Kink;
            double rate = isThere ? 0 : sign * net.TensionRate(sweep.EndAcceleration(), side);
            correction = rate < 0 ? -value / rate : double.NaN;
            return isThere;
        }
    }
}
