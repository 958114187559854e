namespace Football.Physics;

/// <content>Whole steps of the method: a few balls whose contacts keep their modes all along (contacts.md, Balls on balls).</content>
internal sealed partial class BallPile
{
    /// <summary>So many whole steps are tried in a step.</summary>
    private const int MostWholes = 16;

    /// <summary>Faster than this, m/s, balls come together or apart, and do not press each other.</summary>
    private const double Pressing = 1e-5;

    /// <summary>A correction of less than this, m/s, leaves the forces as they are.</summary>
    private const double Corrected = 1e-11;

    /// <summary>A normal turns by no more than this in a whole step, rad: that of a curved thing, and the line of centres of two balls.</summary>
    private const double LargestTurn = 0.05;
    private const double LargestTurnOfBalls = 0.1;

    private readonly ClusterRoom _room;
    private readonly ClusterSystem _cluster;
    private readonly Contact[] _near = new Contact[ClusterSystem.MostBalls * ContactSet.Most];
    private readonly int[] _nearCount = new int[ClusterSystem.MostBalls];
    private int _wholes;

    /// <summary>True when the balls go on by a whole step of the method; else straight on.</summary>
    public bool IsWhole { get; private set; }

    /// <summary>The way of a ball in a whole step.</summary>
    public PathCubic PathOf(int index) => PathOf(in _cluster.Balls[index], Until - Time);

    private static PathCubic PathOf(in ClusterBall ball, double h) =>
        PathCubic.Between(ball.Start.Position, ball.Start.Velocity, ball.End.Position, ball.End.Velocity, h);

    /// <summary>Tries what is left of the step, or the first of few equal parts of it, with the contacts and their modes as they are now.</summary>
    /// <returns>False where no modes are found, or they do not hold up to its end, or something is met in it.</returns>
    private bool TryWhole(BallState[] states, double end, StepLog[] logs)
    {
        bool mayBe = Count >= 2 && Count <= ClusterSystem.MostBalls && (IsWhole || !(_length > 0)) && _wholes < MostWholes;
        IsWhole = false;
        if (!mayBe || !(end > Time) || AreSlow(states))
        {
            return false;
        }

        _wholes++;
        ClusterSystem system = _cluster;
        system.Evaluations = 0;
        double h = end - Time;
        bool holds = Prepare(system, states, h) && FindModes(system);
        if (holds)
        {
            double longest = LongestWhole(system, states, h);
            double parts = Math.Max(1.0, Math.Ceiling((h / longest) - 1e-9));
            h /= parts;
            holds = (parts <= 1 || h >= Part) && Advance(system, h) && ClusterModes.Hold(system) && MeetsNothing(system, h);
            Until = parts > 1 ? Time + h : end;
        }

        for (int i = 0; i < Count; i++)
        {
            logs[_solver.Members[i].Ball].Evaluations += system.Evaluations;
        }

        IsWhole = holds;
        _length = holds ? h : _length;
        Until = holds ? Until : Time;
        return holds;
    }

    /// <summary>True when all balls are so slow that they rest, or are about to.</summary>
    private bool AreSlow(BallState[] states)
    {
        for (int i = 0; i < Count; i++)
        {
            ref readonly PileMember member = ref _solver.Members[i];
            ref readonly BallState s = ref states[member.Ball];
            double energy = 0.5 * ((s.Velocity.LengthSquared / member.PerMass) + (s.Spin.LengthSquared / member.PerInertia));
            if (energy > _simulators[member.Ball].World.RestEnergy)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>The balls and what they touch, neither closing nor leaving.</summary>
    /// <returns>False where an impulse is called for, something moves, or there are too many contacts.</returns>
    private bool Prepare(ClusterSystem system, BallState[] states, double h)
    {
        system.Length = h;
        system.Count = Count;
        system.ContactCount = 0;
        for (int i = 0; i < Count; i++)
        {
            ref readonly PileMember member = ref _solver.Members[i];
            ref readonly BallState s = ref states[member.Ball];
            ref ClusterBall ball = ref system.Balls[i];
            ball.Pile = _simulators[member.Ball].Pile;
            ball.World = _simulators[member.Ball].World;
            ball.PerMass = member.PerMass;
            ball.PerInertia = member.PerInertia;
            ball.Radius = member.Radius;
            ball.Start = s;
            ball.At = ClusterSystem.MotionOf(in s);
            if (s.Nets != 0 || s.Motion == MotionState.Squeezed || s.Time < s.SqueezeUntil)
            {
                return false;
            }
        }

        for (int i = 0; i < Count; i++)
        {
            if (!AddThings(system, i) || !AddBalls(system, i))
            {
                return false;
            }
        }

        return true;
    }

    private bool AddThings(ClusterSystem system, int i)
    {
        ref readonly ClusterBall ball = ref system.Balls[i];
        Span<Contact> near = _near.AsSpan(i * ContactSet.Most, ContactSet.Most);
        int count = ContactSet.Near(ball.World, in ball.Start, Leaning, near);
        int kept = 0;
        for (int k = 0; k < count; k++)
        {
            double rate = Vector3d.Dot(ball.Start.Velocity, in near[k].Normal);
            if (near[k].Moves || rate < -Pressing || system.ContactCount == ClusterSystem.MostContacts)
            {
                return false;
            }

            if (rate <= Pressing)
            {
                ref ClusterContact contact = ref system.Contacts[system.ContactCount++];
                contact = new ClusterContact { First = i, Second = -1 };
                contact.On.Prepare(in near[k], ball.World.Colliders[near[k].Collider], ball.World.Ball);
                near[kept++] = near[k];
            }
        }

        _nearCount[i] = kept;
        return true;
    }

    private bool AddBalls(ClusterSystem system, int i)
    {
        ref readonly ClusterBall ball = ref system.Balls[i];
        for (int j = i + 1; j < Count; j++)
        {
            ref readonly ClusterBall other = ref system.Balls[j];
            if (!BallRests.Touches(in ball.Start, ball.Radius, in other.Start, other.Radius))
            {
                continue;
            }

            BallContact.Gap(in ball.Start, ball.Radius, in other.Start, other.Radius, out _, out double rate);
            if (rate < -Pressing || system.ContactCount == ClusterSystem.MostContacts)
            {
                return false;
            }

            if (rate <= Pressing)
            {
                ref ClusterContact contact = ref system.Contacts[system.ContactCount++];
                contact = new ClusterContact { First = i, Second = j, Lever = _friction * Math.Max(LeastDrilling, _contact.DrillingLength) };
                contact.On.Collider = -1;
                contact.On.Sliding = _friction;
            }
        }

        return true;
    }

    /// <summary>The modes at the start, and the rates there; leftover speeds of what bears and sticks are ended.</summary>
    private bool FindModes(ClusterSystem system)
    {
        system.Look(Time);
        if (!ClusterModes.Find(system))
        {
            return false;
        }

        bool holds = true;
        if (ClusterProjection.Velocities(system, atEnd: false) > Corrected)
        {
            for (int i = 0; i < system.Count; i++)
            {
                system.Balls[i].At = ClusterSystem.MotionOf(in system.Balls[i].Start);
            }

            system.Look(Time);
            holds = system.Solve();
        }

        for (int i = 0; i < system.Count; i++)
        {
            system.Balls[i].First = system.Balls[i].Rates;
        }

        return holds;
    }

    /// <summary>How long a whole step may be by stability, slips that turn and normals that turn, s.</summary>
    private double LongestWhole(ClusterSystem system, BallState[] states, double h)
    {
        double longest = h;
        for (int i = 0; i < system.ContactCount; i++)
        {
            ref readonly ClusterContact contact = ref system.Contacts[i];
            ref readonly SetContact on = ref contact.On;
            bool isThing = contact.Second < 0;
            double turn = on.Turning.Length * h;
            double most = isThing ? LargestTurn : LargestTurnOfBalls;
            longest = turn > most ? Math.Min(longest, h * most / turn) : longest;
            double slip = on.Slip.Length;
            if (on.Bears && !on.Sticks && on.Sliding > 0 && slip > 0)
            {
                longest = TurnLimit.Shorten(longest, h, in on.Direction, slip, ClusterModes.SlipRate(system, in contact), isThing && on.IsFixed);
            }

            ref readonly ClusterBall ball = ref system.Balls[contact.First];
            if (isThing)
            {
                longest = SurfaceBorder.LongestPiece(ball.World.Colliders[on.Collider], ball.Start.Velocity.Length, longest);
            }
        }

        for (int i = 0; i < Count; i++)
        {
            ref readonly ClusterBall ball = ref system.Balls[i];
            double damping = ball.Bearer < 0 ? 0 : system.Contacts[ball.Bearer].On.Damping;
            double gain = 0;
            for (int k = 0; k < system.ContactCount; k++)
            {
                ref readonly ClusterContact contact = ref system.Contacts[k];
                bool slips = contact.On.Bears && !contact.On.Sticks && (contact.First == i || contact.Second == i);
                gain += slips ? h * contact.On.Sliding * contact.On.Load * ball.PerMass : 0;
            }

            longest = Math.Min(longest, ball.Pile.LongestWhole(in states[_solver.Members[i].Ball], h, damping, gain));
        }

        return longest;
    }

    /// <summary>Takes a whole step of the method, and puts the balls onto what bears them.</summary>
    private bool Advance(ClusterSystem system, double h)
    {
        IIntegrator method = _simulators[_solver.Members[0].Ball].Pile.Method;
        bool holds = system.Advance(method, Time, h);
        for (int i = 0; i < system.Count; i++)
        {
            system.Balls[i].End.Time = Time + h;
        }

        ClusterProjection.Places(system);
        holds &= system.LookAtEnd(Time + h);
        ClusterProjection.Velocities(system, atEnd: true);
        return holds;
    }

    /// <summary>True when the balls stay on the same surfaces, and meet nothing else on their ways.</summary>
    private bool MeetsNothing(ClusterSystem system, double h)
    {
        for (int i = 0; i < system.Count; i++)
        {
            ref readonly ClusterBall ball = ref system.Balls[i];
            Span<Contact> held = _near.AsSpan(i * ContactSet.Most, _nearCount[i]);
            foreach (ref readonly Contact near in held)
            {
                Collider collider = ball.World.Colliders[near.Collider];
                if (collider.FaceMargin(ball.End.Position, Time + h) < 0
                    || (collider.LeastWidth < double.PositiveInfinity && collider.PatchAt(ball.Start.Position) != collider.PatchAt(ball.End.Position)))
                {
                    return false;
                }
            }

            int carrier = ball.Start.Motion == MotionState.Airborne ? -1 : (int)ball.Start.Carrier - ball.World.FirstCollider;
            PathCubic path = PathOf(in ball, h);
            if (new ContactSearch(ball.World, in path, Time).First(in ball.Start, ContactSet.Has(held, carrier) ? carrier : -1, held, out _) <= h)
            {
                return false;
            }

            for (int j = i + 1; j < system.Count; j++)
            {
                if (!AreOne(system, i, j) && Meet(in ball, in path, in system.Balls[j], h))
                {
                    return false;
                }
            }
        }

        return true;
    }

    private static bool AreOne(ClusterSystem system, int i, int j)
    {
        for (int k = 0; k < system.ContactCount; k++)
        {
            if (system.Contacts[k].First == i && system.Contacts[k].Second == j)
            {
                return true;
            }
        }

        return false;
    }

    private bool Meet(in ClusterBall ball, in PathCubic path, in ClusterBall other, double h)
    {
        PathCubic its = PathOf(in other, h);
        double most = ball.Radius + other.Radius + ContactSearch.Touching + (h * (path.FastestSpeed + its.FastestSpeed));
        if ((ball.Start.Position - other.Start.Position).LengthSquared > most * most)
        {
            return false;
        }

        _room.Way.Go(in ball.Start, in path);
        _room.OtherWay.Go(in other.Start, in its);
        return _room.Way.Meets(_room.OtherWay, ball.Radius + other.Radius, Time, Time + h, atEnd: true) <= Time + h;
    }

    /// <summary>Moves the balls on to a time within the whole step: where that is cut short the method takes it anew, up to there.</summary>
    private void MoveWhole(BallState[] states, double time, StepLog[] logs)
    {
        ClusterSystem system = _cluster;
        double duration = time - Time;
        system.Evaluations = 0;
        if (time < Until)
        {
            Advance(system, duration);
        }

        int order = _simulators[_solver.Members[0].Ball].Pile.Method.Order;
        for (int i = 0; i < Count; i++)
        {
            ref ClusterBall ball = ref system.Balls[i];
            StepLog log = logs[_solver.Members[i].Ball];
            ref BallState s = ref states[_solver.Members[i].Ball];
            s = ball.End;
            s.Time = time;
            log.Steps++;
            log.Evaluations += system.Evaluations;
            if (log.Observer is not null)
            {
                // A path whose memory is full ends a step early, not the pile.
                log.Show(in ball.Start, in s, ball.First.Acceleration, ball.Last.Acceleration, order);
                log.Halted = false;
            }
        }

        // What bears them, for those who ask.
        Find(states, Leaning, 0);
        for (int i = 0; i < _solver.ContactCount; i++)
        {
            ref PileContact contact = ref _solver.Contacts[i];
            for (int k = 0; k < system.ContactCount; k++)
            {
                ref readonly ClusterContact solved = ref system.Contacts[k];
                if (solved.First == contact.First && solved.Second == contact.Second && (solved.Second >= 0 || solved.On.Collider == contact.Collider))
                {
                    contact.Load = duration * solved.On.Load;
                    contact.Rub = duration * (solved.On.Sticks ? solved.On.Friction : -solved.On.Sliding * solved.On.Load * solved.On.Direction);
                    contact.Twist = duration * (solved.HoldsTwist ? solved.Twist : -solved.TwistSign * solved.Lever * solved.On.Load);
                    contact.Sticks = solved.On.Sticks;
                }
            }
        }
    }
}
