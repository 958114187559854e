namespace Football.Physics;

/// <summary>
/// Balls that lie on each other, in one step: from the time at which they begin to press each other to its end, in few equal parts, with impulses for all of them at once.
/// What is closer than a ball may come in a part is a contact by its gap; what closes so fast that it bounces does so at the part's start. Nothing that stands still is entered.
/// </summary>
internal sealed class BallPile
{
    /// <summary>Length of a part, s; and how many a step may have.</summary>
    private const double Part = 2e-3;
    private const int MostParts = 16;

    /// <summary>So many parts it has at most that others cut short which hit it.</summary>
    private const int MostPlans = 24;

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

    /// <summary>Balls are put apart, and out of things, in so many rounds at most; out of corners in so many.</summary>
    private const int MostRounds = 32;
    private const int MostCorners = 16;

    /// <summary>Less than this, m, is no overlap: of balls, and with what stands still.</summary>
    private const double Overlap = 1e-7;
    private const double Closed = 1e-13;

    /// <summary>
    /// b of two balls that lie on each other, m, as long as no more is said: 2/3 of the radius of a patch that bears a few balls' weight at 0.8 bar. Without it a ball
    /// between two others would turn about their contacts for ever.
    /// </summary>
    private const double LeastDrilling = 4e-3;

    /// <summary>Out of what moves a ball is put by no more than this, m/s.</summary>
    private const double OutOfTheWay = 5.0;

    /// <summary>In a pile nothing bounces that would leave slower than this, m/s, even where the ground lets it.</summary>
    private const double LeastBounce = 0.05;

    private readonly Simulator[] _simulators;
    private readonly ContactMaterial _contact;
    private readonly double _friction;
    private readonly PileSolver _solver = new();
    private PileContact[] _last = new PileContact[32];
    private int _lastCount;
    private double _length;
    private double _longest;
    private int _bounces;
    private int _plans;

    /// <param name="simulators">The scenes of all balls of the group.</param>
    /// <param name="contact">What two balls are to each other where they bounce.</param>
    /// <param name="friction">The friction of that, where they press each other.</param>
    public BallPile(Simulator[] simulators, in ContactMaterial contact, double friction)
    {
        _simulators = simulators;
        _contact = contact;
        _friction = friction;
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

    /// <summary>Empties it, for a step of a length, s.</summary>
    public void Clear(double time, double step)
    {
        _solver.Count = 0;
        _solver.ContactCount = 0;
        _bounces = 0;
        _plans = 0;
        _length = 0;
        _longest = Math.Max(Part, step / MostParts);
        Time = time;
        Until = time;
    }

    /// <summary>Takes a ball in, that has got to the pile's time.</summary>
    public void Add(int ball, ref BallState s)
    {
        BallProperties its = _simulators[ball].Scene.Ball;
        if (Count == _solver.Members.Length)
        {
            Array.Resize(ref _solver.Members, 2 * Count);
        }

        // In the pile its spin is a vector, as on the ground.
        Vector3d spin = s.Spin;
        s.SetGroundSpin(in spin);
        s.ClearUntil = 0;
        _solver.Members[_solver.Count++] = new PileMember
        {
            Ball = ball,
            PerMass = 1.0 / its.Mass,
            PerInertia = 1.0 / its.MomentOfInertia,
            InertiaFactor = its.InertiaFactor,
            Radius = its.Radius,
            FreeUntil = double.NegativeInfinity,
            StartV = s.Velocity,
            StartW = spin,
        };
        _solver.ContactCount = 0;
        _length = 0;
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
        // What is left in equal parts.
        double left = end - Time;
        _plans++;
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
        bool bounced = Bounce(states, h, logs);
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

        // Straight on by the new velocity where something bears a ball; else by the mean, as it flies.
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

        // v and ω are linear in a part, so also where it is cut short.
        double share = time < Until ? duration / h : 1.0;
        for (int i = 0; i < Count; i++)
        {
            ref readonly PileMember member = ref _solver.Members[i];
            ref BallState s = ref states[member.Ball];
            StepLog log = logs[member.Ball];
            BallState before = s;
            Vector3d v = share < 1 ? member.StartV + (share * (member.V - member.StartV)) : member.V;
            Vector3d w = share < 1 ? member.StartW + (share * (member.W - member.StartW)) : member.W;
            _simulators[member.Ball].Pile.Move(ref s, duration, in member.Way, in v, in w, member.Free.AirSpeed, log);
            s.Time = time;
            Show(in before, in s, log);
        }

        Time = time;
        PutApart(states, duration);
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
        }

        for (int i = 0; rests && i < Count; i++)
        {
            SetKey(i, states);
        }
    }

    /// <summary>Puts a ball onto what stands still and bears it: the gap that the part left would be another impact.</summary>
    private void HoldOnto(int index, BallState[] states)
    {
        ref readonly PileMember member = ref _solver.Members[index];
        World world = _simulators[member.Ball].World;
        for (int i = member.FirstContact; i < member.FirstContact + member.OwnContacts; i++)
        {
            ref readonly PileContact contact = ref _solver.Contacts[i];
            if (contact.Load > 0 && !contact.Moves)
            {
                world.Hold(ref states[member.Ball], world.Colliders[contact.Collider]);
            }
        }
    }

    /// <summary>A ball at rest keeps a key of those that it touches.</summary>
    private void SetKey(int index, BallState[] states)
    {
        ref readonly PileMember member = ref _solver.Members[index];
        ref BallState s = ref states[member.Ball];
        ulong key = BallRests.FirstKey;
        for (int j = 0; j < Count; j++)
        {
            ref readonly PileMember other = ref _solver.Members[j];
            ref readonly BallState its = ref states[other.Ball];
            key += j != index && BallRests.Touches(in s, member.Radius, in its, other.Radius) ? BallRests.KeyOf(its.Position) : 0;
        }

        s.ClearIn = key;
    }

    /// <summary>True when the contacts hold the balls as they lie, without speed; on what moves nothing rests.</summary>
    private bool Holds(BallState[] states)
    {
        double pull = 0;
        for (int i = 0; i < Count; i++)
        {
            ref PileMember member = ref _solver.Members[i];
            member.Free = _simulators[member.Ball].Pile.Free(in states[member.Ball], RestPart, atRest: true);
            member.V = RestPart * member.Free.Acceleration;
            member.W = RestPart * member.Free.SpinAcceleration;
            pull = Math.Max(pull, member.V.Length + (member.Radius * member.W.Length));
        }

        // What bore the balls in the last part does so about as much.
        double last = _length > 0 ? RestPart / _length : 0;
        Find(states, Leaning, 0);
        Continue(last);
        for (int i = 0; i < _solver.ContactCount; i++)
        {
            _solver.Contacts[i].Gap = 0;
            if (_solver.Contacts[i].Moves)
            {
                return false;
            }
        }

        _solver.Solve(RestPart, RestRounds, 1e-3 * Held * pull, Held * pull);
        return _solver.Fastest() <= Held * pull;
    }

    /// <summary>True when every ball is slow enough to rest, and the contacts hold all of them, one at least on what stands still.</summary>
    private bool Rests(BallState[] states, StepLog[] logs)
    {
        for (int i = 0; i < Count; i++)
        {
            ref readonly PileMember member = ref _solver.Members[i];
            ref readonly BallState s = ref states[member.Ball];
            double energy = 0.5 * ((s.Velocity.LengthSquared / member.PerMass) + (s.Spin.LengthSquared / member.PerInertia));
            if (!(energy <= _simulators[member.Ball].World.RestEnergy))
            {
                return false;
            }
        }

        bool borne = false;
        for (int i = 0; i < _solver.ContactCount; i++)
        {
            borne |= _solver.Contacts[i].Second < 0 && !_solver.Contacts[i].Moves && _solver.Contacts[i].Load > 0;
        }

        if (!borne)
        {
            return false;
        }

        for (int i = 0; i < Count; i++)
        {
            logs[_solver.Members[i].Ball].Evaluations++;
        }

        return Holds(states);
    }

    /// <summary>Finds all contacts within reach.</summary>
    private void Find(BallState[] states, double reach, double h)
    {
        // What the last part found is where the next one begins.
        (_last, _solver.Contacts) = (_solver.Contacts, _last);
        _lastCount = _solver.ContactCount;
        _solver.ContactCount = 0;
        Span<Contact> room = stackalloc Contact[ContactSet.Most];
        for (int i = 0; i < Count; i++)
        {
            ref PileMember member = ref _solver.Members[i];
            ref readonly BallState s = ref states[member.Ball];
            World world = _simulators[member.Ball].World;

            // What moves comes to the ball as well.
            double far = reach + (world.Moves ? h * world.FastestMover : 0);
            int near = ContactSet.Near(world, in s, far, room);
            member.FirstContact = _solver.ContactCount;
            member.OwnContacts = near;
            for (int k = 0; k < near; k++)
            {
                _solver.Add(With(in room[k], i, in member, in s));
            }

            for (int j = i + 1; j < Count; j++)
            {
                ref readonly PileMember other = ref _solver.Members[j];
                Vector3d apart = s.Position - states[other.Ball].Position;
                double most = member.Radius + other.Radius + reach;
                if (Math.Abs(apart.Y) <= most && Math.Abs(apart.X) <= most && apart.LengthSquared <= most * most)
                {
                    _solver.Add(Between(i, j, in apart));
                }
            }
        }
    }

    private PileContact With(in Contact near, int index, in PileMember member, in BallState s)
    {
        Collider collider = _simulators[member.Ball].World.Colliders[near.Collider];
        ref readonly ContactMaterial material = ref near.Material;
        return new PileContact
        {
            First = index,
            Second = -1,
            Collider = near.Collider,
            Moves = near.Moves,
            Normal = near.Normal,
            Velocity = collider.SurfaceVelocity(s.Position - (member.Radius * near.Normal), s.Time),
            Gap = Math.Max(0, near.Gap),
            NormalMass = 1.0 / member.PerMass,
            SlipMass = 1.0 / (member.PerMass + (member.Radius * member.Radius * member.PerInertia)),
            Friction = material.SlidingFriction,
            RollingFriction = material.RollingFriction,
            RollingFrictionBySpeed = material.RollingFrictionBySpeed,
            SpinDamping = material.SpinDamping,
            DrillingLength = material.DrillingLength,
        };
    }

    private PileContact Between(int first, int second, in Vector3d apart)
    {
        ref readonly PileMember a = ref _solver.Members[first];
        ref readonly PileMember b = ref _solver.Members[second];
        double distance = apart.Length;
        double perMass = a.PerMass + b.PerMass;
        return new PileContact
        {
            First = first,
            Second = second,
            Collider = -1,
            Normal = distance > 0 ? apart / distance : Vector3d.Up,
            Gap = Math.Max(0, distance - a.Radius - b.Radius),
            NormalMass = 1.0 / perMass,
            SlipMass = 1.0 / (perMass + (a.Radius * a.Radius * a.PerInertia) + (b.Radius * b.Radius * b.PerInertia)),
            TwistMass = 1.0 / (a.PerInertia + b.PerInertia),
            Friction = _friction,
            DrillingLength = Math.Max(LeastDrilling, _contact.DrillingLength),
        };
    }

    /// <summary>A contact that was there in the part before begins with its impulses.</summary>
    /// <param name="share">How much of them.</param>
    private bool Continue(double share)
    {
        int k = 0;
        for (int i = 0; i < _solver.ContactCount && _lastCount > 0; i++)
        {
            // Both are in one order: by the first ball, then things, then the other ball.
            ref PileContact contact = ref _solver.Contacts[i];
            while (k < _lastCount && Order(in _last[k], in contact) < 0)
            {
                k++;
            }

            if (k < _lastCount && Order(in _last[k], in contact) == 0)
            {
                ref readonly PileContact last = ref _last[k];
                contact.Load = share * last.Load;
                contact.Twist = share * last.Twist;
                contact.Rub = share * (last.Rub - (Vector3d.Dot(in last.Rub, in contact.Normal) * contact.Normal));
            }
        }

        return _lastCount > 0;
    }

    private static int Order(in PileContact a, in PileContact b) =>
        a.First != b.First ? a.First - b.First
        : a.Second < 0 != b.Second < 0 ? (a.Second < 0 ? -1 : 1)
        : a.Second < 0 ? a.Collider - b.Collider : a.Second - b.Second;

    /// <summary>What closes within the part so fast that it bounces does so now: the first first, one after the other, so that no energy comes from it.</summary>
    private bool Bounce(BallState[] states, double h, StepLog[] logs)
    {
        // As many as there are contacts, and eight, at an instant; and in a step so many for each ball.
        int most = Math.Min(_solver.ContactCount + 8, (8 * Count) - _bounces);
        bool bounced = false;
        for (int done = 0; done < most; done++)
        {
            int next = -1;
            double first = h;
            for (int i = 0; i < _solver.ContactCount; i++)
            {
                double time = BounceTime(in _solver.Contacts[i], states);
                next = time < first ? i : next;
                first = Math.Min(first, time);
            }

            if (next < 0)
            {
                break;
            }

            Bounce(in _solver.Contacts[next], states, logs);
            _bounces++;
            bounced = true;
        }

        return bounced;
    }

    /// <summary>When a contact closes that bounces, s; infinite where it does not.</summary>
    private double BounceTime(in PileContact contact, BallState[] states)
    {
        ref readonly PileMember a = ref _solver.Members[contact.First];
        Vector3d other = contact.Second < 0 ? contact.Velocity : states[_solver.Members[contact.Second].Ball].Velocity;
        double closing = -Vector3d.Dot(states[a.Ball].Velocity - other, in contact.Normal);
        World world = _simulators[a.Ball].World;
        double least = Math.Max(LeastBounce, world.MinimumBounceSpeed);
        if (!(closing > least))
        {
            return double.PositiveInfinity;
        }

        // e u_n, what it would leave with.
        double e = contact.Second < 0
            ? world.Colliders[contact.Collider].MaterialAt(states[a.Ball].Position).LargestRestitutionAt(closing)
            : _contact.LargestRestitutionAt(closing);
        return e * closing >= least ? contact.Gap / closing : double.PositiveInfinity;
    }

    private void Bounce(in PileContact contact, BallState[] states, StepLog[] logs)
    {
        int ball = _solver.Members[contact.First].Ball;
        ref BallState s = ref states[ball];
        Simulator simulator = _simulators[ball];
        if (contact.Second >= 0)
        {
            int other = _solver.Members[contact.Second].Ball;
            ref BallState its = ref states[other];
            BallContact.Impact(
                simulator.Scene.Ball, _simulators[other].Scene.Ball, in _contact, in contact.Normal, in s, in its, out Motion first, out Motion second);
            logs[ball].Events.Add(new BallEvent(other, in contact.Normal, s.Time, in s, in first.Velocity, in first.Spin));
            logs[other].Events.Add(new BallEvent(ball, -contact.Normal, s.Time, in its, in second.Velocity, in second.Spin));
            Set(ref s, in first.Velocity, in first.Spin);
            Set(ref its, in second.Velocity, in second.Spin);
            return;
        }

        // Against what is pushed too: in a pile it stands as firm as the pile.
        Vector3d v = s.Velocity;
        Vector3d w = s.Spin;
        Collider hit = simulator.World.Colliders[contact.Collider];
        CoulombImpact.Apply(
            simulator.Scene.Ball, in hit.MaterialAt(s.Position), in contact.Normal, in contact.Velocity, in v, in w, out Vector3d velocity, out Vector3d spin);
        logs[ball].Events.Add(new BallEvent(
            BallEventKind.Impact, contact.Collider + simulator.World.FirstCollider, in contact.Normal, s.Time, s.Position, in v, in w, in velocity, in spin));
        Set(ref s, in velocity, in spin);
    }

    private static void Set(ref BallState s, in Vector3d velocity, in Vector3d spin)
    {
        s.Velocity = velocity;
        s.SpinAxis = spin;
    }

    /// <summary>Puts balls apart that overlap, each by its share, and then out of what moves, by no more than a distance, and out of what stands still.</summary>
    private void PutApart(BallState[] states, double duration)
    {
        bool moved = true;
        for (int round = 0; round < MostRounds && moved; round++)
        {
            moved = false;
            for (int i = 0; i < _solver.ContactCount; i++)
            {
                ref readonly PileContact contact = ref _solver.Contacts[i];
                if (contact.Second >= 0)
                {
                    ref readonly PileMember a = ref _solver.Members[contact.First];
                    ref readonly PileMember b = ref _solver.Members[contact.Second];
                    Vector3d apart = states[a.Ball].Position - states[b.Ball].Position;
                    double most = a.Radius + b.Radius;
                    double square = apart.LengthSquared;
                    if (square < most * most && square > 0)
                    {
                        double distance = Math.Sqrt(square);
                        double over = most - distance;
                        Vector3d shift = over * contact.NormalMass / distance * apart;
                        states[a.Ball].Position += a.PerMass * shift;
                        states[b.Ball].Position -= b.PerMass * shift;
                        moved |= over > Overlap;
                    }
                }
            }

            for (int i = 0; i < Count; i++)
            {
                moved |= KeepOut(in _solver.Members[i], states, round == 0 ? OutOfTheWay * duration : 0);
            }
        }
    }

    /// <summary>Puts a ball out of what it overlaps; what stands still comes last, so that it is never entered.</summary>
    /// <returns>Whether it was in something.</returns>
    private bool KeepOut(in PileMember member, BallState[] states, double outOfTheWay)
    {
        World world = _simulators[member.Ball].World;
        ref BallState s = ref states[member.Ball];
        bool moved = false;
        bool inside = member.OwnContacts > 0;
        for (int round = 0; round < MostCorners && inside; round++)
        {
            inside = false;
            for (int pass = 0; pass < 2; pass++)
            {
                for (int i = member.FirstContact; i < member.FirstContact + member.OwnContacts; i++)
                {
                    if (_solver.Contacts[i].Moves != (pass == 0))
                    {
                        continue;
                    }

                    Collider collider = world.Colliders[_solver.Contacts[i].Collider];
                    ShapePoint at = collider.At(s.Position, s.Time);
                    double over = member.Radius - at.Distance;
                    if (over > Closed && (pass == 1 || round == 0))
                    {
                        s.Position += (pass == 0 ? Math.Min(over, outOfTheWay) : over) * at.Normal;
                        inside |= pass == 1;
                        moved |= over > Overlap;
                    }

                    if (world.IsLevel && collider == world.Ground)
                    {
                        // Heights of a ball on level ground are exact.
                        s.Position = new Vector3d(s.Position.X, Math.Max(s.Position.Y, world.LevelContact), s.Position.Z);
                    }
                }
            }
        }

        return moved;
    }

    /// <summary>Shows a piece to the observer, if there is one: straight from place to place.</summary>
    private static void Show(in BallState before, in BallState after, StepLog log)
    {
        double h = after.Time - before.Time;
        if (log.Observer is null || !(h > 0))
        {
            return;
        }

        BallState start = before;
        BallState end = after;
        start.Velocity = (after.Position - before.Position) / h;
        end.Velocity = start.Velocity;
        Vector3d none = Vector3d.Zero;
        log.Show(in start, in end, in none, in none, 4);

        // A path whose memory is full ends a step early, not the pile.
        log.Halted = false;
    }
}
