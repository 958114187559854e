using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Steps a pile: balls in sustained contact with each other.</summary>
/// <remarks>The pile takes a few parts, with impulses for all balls at once. A gap that a ball may close within a part counts as a contact. Fast contacts
/// bounce when they touch, and end a part. No ball enters a stationary object.</remarks>
internal sealed partial class BallPile
{
    /// <summary>Length of a part, s. A step takes at most as many parts as that of a single ball.</summary>
    private const double Part = 2e-3;

    /// <summary>The change of a custom force in a part, as a share of it, up to which the force stays the same for the longest part.</summary>
    private const double SoftForce = 0.05;

    /// <summary>Maximum number of parts per step, including those cut short by other balls that hit the pile.</summary>
    private const int MostPlans = 24;

    /// <summary>Solver iterations: for the first part (cold start), for further parts, and for the check of rest.</summary>
    private const int FirstRounds = 48;
    private const int NextRounds = 20;
    private const int RestRounds = 256;

    /// <summary>Maximum number of parts per ball and step that end at a bounce. After that, balls bounce at the start of a part.</summary>
    private const int MostEnds = 16;

    /// <summary>Length of the part that is solved to check for rest, s.</summary>
    private const double RestPart = 1e-3;

    /// <summary>Minimum drilling length b of two balls in sustained contact, m.</summary>
    /// <remarks>2/3 of the radius of a patch that supports the weight of a few balls at 0.8 bar. Without drilling friction, a ball between two others would spin for ever.</remarks>
    private const double LeastDrilling = 4e-3;

    private readonly Simulator[] _simulators;
    private readonly ContactMaterial _material;
    private readonly PileSystem _system = new();
    private readonly PileBounces _bounces;
    private readonly PileOverlaps _overlaps;
    private Contact[] _last = new Contact[32];
    private int _lastCount;
    private double _length;
    private double _longest;
    private double _end;
    private int _plans;
    private int _ends;

    /// <param name="simulators">The scenes of all balls of the group.</param>
    /// <param name="contact">The material of impacts between balls.</param>
    /// <param name="friction">The friction coefficient of sustained contact between balls.</param>
    public BallPile(Simulator[] simulators, in ContactMaterial contact, double friction)
    {
        _simulators = simulators;
        _material = contact with { Resistance = new Resistance(friction, 0, 0, 0, Math.Max(LeastDrilling, contact.Resistance.Patch)) };
        _bounces = new PileBounces(simulators, _system, in contact);
        _overlaps = new PileOverlaps(simulators, _system);
    }

    /// <summary>Number of balls in the pile.</summary>
    public int Count => _system.Count;

    /// <summary>Index of a ball of the pile.</summary>
    public int this[int index] => _system.Members[index].Ball;

    /// <summary>True if the pile has used its parts in this step, so that a ball that hits it joins it at once.</summary>
    public bool IsSpent => _plans >= MostPlans;

    /// <summary>Time up to which its balls have moved, s.</summary>
    public double Time { get; private set; }

    /// <summary>Time up to which its paths are computed, s.</summary>
    public double Until { get; private set; }

    /// <summary>True if the part ends before its length, because a contact bounces there.</summary>
    private bool EndsAtBounce { get; set; }

    /// <summary>Empties the pile for a step of a given length, s.</summary>
    public void Clear(double time, double step)
    {
        _system.Count = 0;
        _system.ContactCount = 0;
        _bounces.Clear();
        _plans = 0;
        _ends = 0;
        _length = 0;
        _longest = Math.Max(Part, step / ContactSetParts.MostParts);
        Time = time;
        Until = time;
    }

    /// <summary>Adds a ball that has reached the pile's time.</summary>
    public void Add(int ball, ref BallState s)
    {
        BallProperties its = _simulators[ball].Scene.Ball;

        // In a pile, as on the ground, the spin is a full vector.
        Vector3d spin = s.Spin;
        s.SetGroundSpin(in spin);
        s.ClearUntil = 0;
        Add(new PileMember { Ball = ball, FreeUntil = double.NegativeInfinity, StartV = s.Velocity, StartW = spin }, new PressedBall(its));
    }

    /// <summary>Adds all balls of another pile at the same time, with their computed forces.</summary>
    /// <remarks>The result does not depend on the order of the piles.</remarks>
    public void Absorb(BallPile other)
    {
        for (int m = 0; m < other.Count; m++)
        {
            Add(in other._system.Members[m], in other._system.Balls[m]);
        }

        _plans = Math.Max(_plans, other._plans);
        _ends += other._ends;
        _bounces.Absorb(other._bounces);
    }

    private void Add(in PileMember member, in PressedBall ball)
    {
        _system.Add(in member, in ball);
        _system.ContactCount = 0;
        _length = 0;
        Until = Time;
    }

    /// <summary>Sorts the balls by position, lowest first, so that their indices have no effect.</summary>
    public void Sort(BallState[] states)
    {
        PileMember[] members = _system.Members;
        PressedBall[] balls = _system.Balls;
        for (int i = 1; i < Count; i++)
        {
            PileMember member = members[i];
            PressedBall ball = balls[i];
            int place = i;
            for (; place > 0 && IsBefore(in member, in members[place - 1], states); place--)
            {
                members[place] = members[place - 1];
                balls[place] = balls[place - 1];
            }

            members[place] = member;
            balls[place] = ball;
        }
    }

    private static bool IsBefore(in PileMember a, in PileMember b, BallState[] states)
    {
        Vector3d p = states[a.Ball].Position;
        Vector3d q = states[b.Ball].Position;
        return p.Y != q.Y ? p.Y < q.Y : p.X != q.X ? p.X < q.X : p.Z != q.Z ? p.Z < q.Z : a.Ball < b.Ball;
    }

    /// <summary>Computes the motion of its balls in the next part.</summary>
    /// <param name="states">The balls, at the pile's time.</param>
    /// <param name="end">End time of the step, s.</param>
    /// <param name="logs">Receive the events and counts of each ball.</param>
    /// <returns>True if a ball bounced.</returns>
    public bool Plan(BallState[] states, double end, StepLog[] logs)
    {
        _end = end;
        double left = end - Time;

        // Divide the rest of the step into equal parts.
        double parts = Math.Max(1.0, Math.Ceiling((left / _longest) - ContactTolerances.StepRounding));
        double h = left / parts;
        double top = 0;
        double pull = 0;
        for (int i = 0; i < Count; i++)
        {
            ref PileMember member = ref _system.Members[i];
            ref BallState s = ref states[member.Ball];
            if (!(member.FreeUntil > Time))
            {
                PilePhase pile = _simulators[member.Ball].Pile;

                // The forces of the air hardly change within the longest part. Custom forces may, unless an earlier part of the step has shown that they do not.
                bool looksAhead = pile.HasOwnForces && !member.HasSoftForces;
                Vector3d before = member.Free.Acceleration;
                member.Free = pile.Free(in s, h, looksAhead, out double change);
                member.FreeUntil = looksAhead ? Time : Time + (_longest * (1.0 - ContactTolerances.WithinLongest));
                member.HasSoftForces = looksAhead ? change <= SoftForce : (member.Free.Acceleration - before).Length <= 0.5 * before.Length;
                logs[member.Ball].Evaluations += looksAhead ? 2 : 1;
                logs[member.Ball].StiffSteps += change > 1 && !member.IsStiff ? 1 : 0;
                member.IsStiff |= change > 1;
            }

            pull = Math.Max(pull, h * (member.Free.Acceleration.Length + (_system.Balls[i].Radius * member.Free.SpinAcceleration.Length)));
            top = Math.Max(top, s.Velocity.Length);
        }

        // Balls that touch bounce now. A bounce within the part will end the part, if the pile has not used these ends.
        Find(states, ContactTolerances.PileMargin + (2.0 * h * (top + pull)), h);
        bool mayEnd = _ends < MostEnds * Count;
        bool bounced = _bounces.Bounce(states, mayEnd ? 0 : h, logs);
        if (mayEnd)
        {
            _bounces.Mark(states, h);
        }

        for (int i = 0; i < Count; i++)
        {
            ref PileMember member = ref _system.Members[i];
            ref readonly BallState s = ref states[member.Ball];
            member.StartV = s.Velocity;
            member.StartW = s.Spin;
            _system.Balls[i].V = s.Velocity + (h * member.Free.Acceleration);
            _system.Balls[i].W = member.StartW + (h * member.Free.SpinAcceleration);
        }

        double share = _length > 0 ? h / _length : 0;
        bool warm = Continue(share);
        _system.Solve(h, warm ? NextRounds : FirstRounds, ContactTolerances.PileSettled * pull, share: share);
        _system.LimitWork();
        _system.SetWays();
        _length = h;
        double touch = _bounces.FirstTouch(h);
        EndsAtBounce = touch < h;
        Until = EndsAtBounce ? Time + touch : parts > 1 ? Time + h : end;
        _ends += EndsAtBounce ? 1 : 0;
        _plans += EndsAtBounce ? 0 : 1;
        return bounced;
    }

    /// <summary>Mean velocity of a ball in the part, m/s.</summary>
    public Vector3d WayOf(int index) => _system.Members[index].Way;

    /// <summary>Discards the computed motion after a change of a ball's velocity.</summary>
    public void Forget() => Until = Time;

    /// <summary>Moves its balls to a time within the part.</summary>
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
            _system.Members[i].From = states[_system.Members[i].Ball];
        }

        // Within a part, v and ω are linear in time: interpolate a shortened part.
        double share = EndsAtBounce ? duration / _length : time < Until ? duration / h : 1.0;
        for (int i = 0; i < Count; i++)
        {
            ref readonly PileMember member = ref _system.Members[i];
            ref BallState s = ref states[member.Ball];
            ref readonly PressedBall ball = ref _system.Balls[i];
            Vector3d v = share < 1 ? member.StartV + (share * (ball.V - member.StartV)) : ball.V;
            Vector3d w = share < 1 ? member.StartW + (share * (ball.W - member.StartW)) : ball.W;
            _simulators[member.Ball].Pile.Move(ref s, duration, in member.Way, in v, in w, member.Free.AirSpeed, logs[member.Ball]);
            s.Time = time;
        }

        Time = time;
        _overlaps.PutApart(states, duration);

        // Report the path up to the final position, after overlaps are resolved. Only End sets the position at the end of the step.
        for (int i = 0; i < Count; i++)
        {
            ref PileMember member = ref _system.Members[i];
            member.IsUnshown = time == _end;
            if (!member.IsUnshown)
            {
                Show(in member.From, in states[member.Ball], logs[member.Ball]);
            }
        }
    }

    /// <summary>Ends the pile: all balls come to rest, or each continues on its own.</summary>
    public void End(BallState[] states, StepLog[] logs)
    {
        bool rests = Rests(states, logs);
        for (int i = 0; i < Count; i++)
        {
            int ball = _system.Members[i].Ball;
            int bearer = _system.ContactCount > 0 ? _system.BearerOf(i) : -1;
            int collider = bearer < 0 ? -1 : _system.Contacts[bearer].Collider;
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

        if (!rests && _overlaps.Deepest(states) > ContactTolerances.Leaning)
        {
            // Projecting the balls onto their carriers may have pushed them into each other.
            _overlaps.PutApart(states, 0);
        }

        for (int i = 0; i < Count; i++)
        {
            ref PileMember member = ref _system.Members[i];
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

    /// <summary>Reports a piece to the observer, if there is one: a straight line between the two positions.</summary>
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

        // If its path buffer is full, a ball's own step ends early, but the pile's step continues.
        log.Halted = false;
    }
}
