namespace FootballPhysics;

/// <summary>
/// Balls that lie on each other, in one step: from the time at which they begin to press each other to its end. A few whose contacts keep their modes go by whole steps of the
/// method (<see cref="PileWholes"/>); else in few equal parts, with impulses for all of them at once.
/// What is closer than a ball may come in a part is a contact by its gap; what closes so fast that it bounces does so at the part's start. Nothing that stands still is entered.
/// </summary>
internal sealed partial class BallPile
{
    /// <summary>Length of a part, s; and how many a step may have.</summary>
    private const double Part = 2e-3;
    private const int MostParts = 16;

    /// <summary>So many parts it has at most that others cut short which hit it.</summary>
    private const int MostPlans = 24;

    /// <summary>So many whole steps are tried in a step; what has had a part goes on in parts.</summary>
    private const int MostWholes = 16;

    /// <summary>Contacts are looked for this much farther, m, than the balls get.</summary>
    private const double Near = 1e-5;

    /// <summary>Of two that lie on each other the gap is no more than this, m.</summary>
    public const double Leaning = 1e-6;

    /// <summary>Rounds of the solver: of the first part, which begins from nothing; of the next ones; and where it is asked whether the pile rests.</summary>
    private const int FirstRounds = 48;
    private const int NextRounds = 20;
    private const int RestRounds = 256;

    /// <summary>Impulses that change a ball's speed by less than this share of what its forces do in a part are found.</summary>
    private const double Settled = 1e-5;

    /// <summary>A pile rests where its contacts leave no ball more than this share of the forces on it.</summary>
    private const double Held = 1e-3;

    /// <summary>Where it is asked whether a pile rests, after so long, s.</summary>
    private const double RestPart = 1e-3;

    /// <summary>
    /// b of two balls that lie on each other, m, as long as no more is said: 2/3 of the radius of a patch that bears a few balls' weight at 0.8 bar. Without it a ball
    /// between two others would turn about their contacts for ever.
    /// </summary>
    private const double LeastDrilling = 4e-3;

    private readonly Simulator[] _simulators;
    private readonly ContactMaterial _contact;
    private readonly double _friction;
    private readonly PileSolver _solver = new();
    private readonly PileBounces _bounces;
    private readonly PileOverlaps _overlaps;
    private readonly PileWholes _whole;
    private PileContact[] _last = new PileContact[32];
    private int _lastCount;
    private double _length;
    private double _longest;
    private double _end;
    private int _plans;
    private int _wholes;

    /// <param name="simulators">The scenes of all balls of the group.</param>
    /// <param name="contact">What two balls are to each other where they bounce.</param>
    /// <param name="friction">The friction of that, where they press each other.</param>
    /// <param name="room">Room that all piles of a group share.</param>
    public BallPile(Simulator[] simulators, in ContactMaterial contact, double friction, ClusterRoom room)
    {
        _simulators = simulators;
        _contact = contact;
        _friction = friction;
        _bounces = new PileBounces(simulators, _solver, in contact);
        _overlaps = new PileOverlaps(simulators, _solver);
        _whole = new PileWholes(simulators, _solver, friction, friction * Math.Max(LeastDrilling, contact.DrillingLength), room);
    }

    /// <summary>How many balls are in it.</summary>
    public int Count => _solver.Count;

    /// <summary>A ball of it.</summary>
    public int this[int index] => _solver.Members[index].Ball;

    /// <summary>True when it has been planned so often in the step that a ball which hits it is one of it from then on.</summary>
    public bool IsSpent => _plans >= MostPlans;

    /// <summary>Until when its balls have got, s.</summary>
    public double Time { get; private set; }

    /// <summary>Until when it is known where they go, s.</summary>
    public double Until { get; private set; }

    /// <summary>True when its balls go on by a whole step of the method; else straight on.</summary>
    public bool IsWhole { get; private set; }

    /// <summary>The way of a ball in a whole step.</summary>
    public PathCubic PathOf(int index) => _whole.PathOf(index);

    /// <summary>Empties it, for a step of a length, s.</summary>
    public void Clear(double time, double step)
    {
        _solver.Count = 0;
        _solver.ContactCount = 0;
        _bounces.Clear();
        _plans = 0;
        _wholes = 0;
        IsWhole = false;
        _length = 0;
        _longest = Math.Max(Part, step / MostParts);
        Time = time;
        Until = time;
    }

    /// <summary>Takes a ball in, that has got to the pile's time.</summary>
    public void Add(int ball, ref BallState s)
    {
        BallProperties its = _simulators[ball].Scene.Ball;

        // In a pile the spin is a full vector, as on the ground.
        Vector3d spin = s.Spin;
        s.SetGroundSpin(in spin);
        s.ClearUntil = 0;
        Add(new PileMember
        {
            Ball = ball,
            PerMass = 1.0 / its.Mass,
            PerInertia = 1.0 / its.MomentOfInertia,
            InertiaFactor = its.InertiaFactor,
            Radius = its.Radius,
            FreeUntil = double.NegativeInfinity,
            StartV = s.Velocity,
            StartW = spin,
        });
    }

    /// <summary>Takes in all balls of another pile of its time, with what is known of them: of the two none is the first.</summary>
    public void Absorb(BallPile other)
    {
        for (int m = 0; m < other.Count; m++)
        {
            Add(in other._solver.Members[m]);
        }

        _plans = Math.Max(_plans, other._plans);
        _wholes = Math.Max(_wholes, other._wholes);
        _bounces.Absorb(other._bounces);
    }

    private void Add(in PileMember member)
    {
        if (Count == _solver.Members.Length)
        {
            Array.Resize(ref _solver.Members, 2 * Count);
        }

        _solver.Members[_solver.Count++] = member;
        _solver.ContactCount = 0;
        _length = 0;
        IsWhole = false;
        Until = Time;
    }

    /// <summary>Puts its balls into an order that their places decide, the lowest first: so their numbers decide nothing.</summary>
    public void Sort(BallState[] states)
    {
        PileMember[] members = _solver.Members;
        for (int i = 1; i < Count; i++)
        {
            PileMember member = members[i];
            int place = i;
            for (; place > 0 && IsBefore(in member, in members[place - 1], states); place--)
            {
                members[place] = members[place - 1];
            }

            members[place] = member;
        }
    }

    private static bool IsBefore(in PileMember a, in PileMember b, BallState[] states)
    {
        Vector3d p = states[a.Ball].Position;
        Vector3d q = states[b.Ball].Position;
        return p.Y != q.Y ? p.Y < q.Y : p.X != q.X ? p.X < q.X : p.Z != q.Z ? p.Z < q.Z : a.Ball < b.Ball;
    }

    /// <summary>Finds where its balls go in the next part.</summary>
    /// <param name="states">The balls, at the pile's time.</param>
    /// <param name="end">When the step ends, s.</param>
    /// <param name="logs">Where events and counts of each go.</param>
    /// <returns>Whether something bounced.</returns>
    public bool Plan(BallState[] states, double end, StepLog[] logs)
    {
        _plans++;
        _end = end;
        double left = end - Time;
        bool mayBeWhole = (IsWhole || !(_length > 0)) && _wholes++ < MostWholes;
        IsWhole = mayBeWhole && _whole.Try(states, Time, left, Part, logs);
        if (IsWhole)
        {
            _length = _whole.Length;
            Until = _length < left ? Time + _length : end;
            return false;
        }

        // The forces at the start are already computed.
        for (int i = 0; i < Count && mayBeWhole && _whole.HasLooked; i++)
        {
            _solver.Members[i].FreeUntil = Time + (_longest * (1.0 - 1e-6));
        }

        // Divide the rest of the step into equal parts.
        double parts = Math.Max(1.0, Math.Ceiling((left / _longest) - 1e-9));
        double h = left / parts;
        double top = 0;
        double pull = 0;
        for (int i = 0; i < Count; i++)
        {
            ref PileMember member = ref _solver.Members[i];
            ref BallState s = ref states[member.Ball];
            if (!(member.FreeUntil > Time))
            {
                member.Free = _simulators[member.Ball].Pile.Free(in s, h, atRest: false);
                member.FreeUntil = Time + (_longest * (1.0 - 1e-6));
                logs[member.Ball].Evaluations++;
            }

            pull = Math.Max(pull, h * (member.Free.Acceleration.Length + (member.Radius * member.Free.SpinAcceleration.Length)));
            top = Math.Max(top, s.Velocity.Length);
        }

        Find(states, Near + (2.0 * h * (top + pull)), h);
        bool bounced = _bounces.Bounce(states, h, logs);
        for (int i = 0; i < Count; i++)
        {
            ref PileMember member = ref _solver.Members[i];
            ref readonly BallState s = ref states[member.Ball];
            member.StartV = s.Velocity;
            member.StartW = s.Spin;
            member.V = s.Velocity + (h * member.Free.Acceleration);
            member.W = member.StartW + (h * member.Free.SpinAcceleration);
        }

        bool warm = Continue(_length > 0 ? h / _length : 0);
        _solver.Solve(h, warm ? NextRounds : FirstRounds, Settled * pull);

        // A ball with a load moves at its new velocity; a ball in flight moves at the mean of both.
        for (int i = 0; i < Count; i++)
        {
            ref PileMember member = ref _solver.Members[i];
            member.Way = 0.5 * (member.StartV + member.V);
        }

        for (int i = 0; i < _solver.ContactCount; i++)
        {
            ref readonly PileContact contact = ref _solver.Contacts[i];
            if (contact.Load > 0)
            {
                ref PileMember first = ref _solver.Members[contact.First];
                first.Way = first.V;
                if (contact.Second >= 0)
                {
                    ref PileMember second = ref _solver.Members[contact.Second];
                    second.Way = second.V;
                }
            }
        }

        _length = h;
        Until = parts > 1 ? Time + h : end;
        return bounced;
    }

    /// <summary>Mean velocity of a ball in the part, m/s.</summary>
    public Vector3d WayOf(int index) => _solver.Members[index].Way;

    /// <summary>Something has changed a ball's velocity: where they go is not known any more.</summary>
    public void Forget() => Until = Time;

    /// <summary>Moves its balls on to a time within the part.</summary>
    public void MoveTo(BallState[] states, double time, StepLog[] logs)
    {
        double h = Until - Time;
        double duration = time - Time;
        if (!(duration > 0))
        {
            return;
        }

        for (int i = 0; i < Count; i++)
        {
            _solver.Members[i].From = states[_solver.Members[i].Ball];
        }

        if (IsWhole)
        {
            _whole.Move(states, duration, time < Until, time, logs);
            Time = time;

            // Find the contacts and their loads for later queries.
            Find(states, Leaning, 0);
            _whole.Load(duration);
            _overlaps.PutApart(states, duration);
            return;
        }

        // v and ω are linear in time within a part, so a shortened part is interpolated.
        double share = time < Until ? duration / h : 1.0;
        for (int i = 0; i < Count; i++)
        {
            ref readonly PileMember member = ref _solver.Members[i];
            ref BallState s = ref states[member.Ball];
            Vector3d v = share < 1 ? member.StartV + (share * (member.V - member.StartV)) : member.V;
            Vector3d w = share < 1 ? member.StartW + (share * (member.W - member.StartW)) : member.W;
            _simulators[member.Ball].Pile.Move(ref s, duration, in member.Way, in v, in w, member.Free.AirSpeed, logs[member.Ball]);
            s.Time = time;
        }

        Time = time;
        _overlaps.PutApart(states, duration);

        // Report the path to the final position, after overlaps are resolved. Only End determines the position at the end of the step.
        for (int i = 0; i < Count; i++)
        {
            ref PileMember member = ref _solver.Members[i];
            member.IsUnshown = time == _end;
            if (!member.IsUnshown)
            {
                Show(in member.From, in states[member.Ball], logs[member.Ball]);
            }
        }
    }

    /// <summary>Every ball goes on by itself; or all of them rest.</summary>
    public void End(BallState[] states, StepLog[] logs)
    {
        bool rests = Rests(states, logs);
        for (int i = 0; i < Count; i++)
        {
            int ball = _solver.Members[i].Ball;
            int bearer = _solver.ContactCount > 0 ? _solver.BearerOf(i) : -1;
            int collider = bearer < 0 ? -1 : _solver.Contacts[bearer].Collider;
            HoldOnto(i, states);
            if (rests)
            {
                _simulators[ball].Pile.Rest(ref states[ball], collider, logs[ball]);
            }
            else
            {
                _simulators[ball].Pile.Release(ref states[ball], collider, logs[ball]);
            }

            // Projecting the ball onto one surface may have pushed it into another.
            _overlaps.KeepOut(i, states);
        }

        if (!rests && _overlaps.Deepest(states) > Leaning)
        {
            // Projecting the balls onto their carriers may have pushed them into each other.
            _overlaps.PutApart(states, 0);
        }

        for (int i = 0; i < Count; i++)
        {
            ref PileMember member = ref _solver.Members[i];
            if (member.IsUnshown)
            {
                member.IsUnshown = false;
                Show(in member.From, in states[member.Ball], logs[member.Ball]);
            }

            if (rests)
            {
                SetKey(i, states);
            }
        }
    }

    /// <summary>Shows a piece to the observer, if there is one: straight from place to place.</summary>
    private static void Show(in BallState before, in BallState after, StepLog log)
    {
        double h = after.Time - before.Time;
        if (!log.IsWatched || !(h > 0))
        {
            return;
        }

        BallState start = before;
        BallState end = after;
        start.Velocity = (after.Position - before.Position) / h;
        end.Velocity = start.Velocity;
        Vector3d none = Vector3d.Zero;
        log.Show(in start, in end, in none, in none, 4);

        // A path with a full buffer ends its own step early, but not the pile's.
        log.Halted = false;
    }
}
