using FootballPhysics.Contacts;
using FootballPhysics.Integration;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>Whole steps of a pile with the integrator, for a few balls whose contacts keep their modes (contacts.md, Balls on
/// balls).</summary>
/// <param name="simulators">The scenes of all balls of the group.</param>
/// <param name="solver">The pile's balls and contacts.</param>
/// <param name="friction">The friction coefficient of sustained contact between balls.</param>
/// <param name="lever">b μ of such contacts, m.</param>
/// <param name="room">Memory that all piles of a group share.</param>
internal sealed class PileWholes(Simulator[] simulators, PileSolver solver, double friction, double lever, ClusterRoom room)
{
    /// <summary>Maximum rotation of a normal per whole step, rad: of a curved surface, or of the line of centres of two balls.</summary>
    private const double LargestTurn = 0.05;
    private const double LargestTurnOfBalls = 0.1;

    private readonly ClusterSystem _cluster = new(room);
    private readonly Contact[] _touching = new Contact[ClusterSystem.MostBalls * ContactSet.Room];
    private readonly int[] _touchingCount = new int[ClusterSystem.MostBalls];
    private double _time;

    /// <summary>Length of the whole step found, s.</summary>
    public double Length { get; private set; }

    /// <summary>True if the last attempt has computed the forces at the start; the balls of the pile then store them.</summary>
    public bool HasLooked { get; private set; }

    /// <summary>Returns the path of a ball in the step.</summary>
    public PathCubic PathOf(int index) => PathOf(in _cluster.Balls[index], Length);

    /// <summary>Tries a step, or the first of a few equal parts of it, with the contacts and modes at its start.</summary>
    /// <param name="states">The balls.</param>
    /// <param name="time">Start time, s.</param>
    /// <param name="left">Length of the step, s.</param>
    /// <param name="least">Minimum length of a part, s.</param>
    /// <param name="logs">Receive the counts of each ball.</param>
    /// <returns>False if no modes are found, they do not hold to the end, the balls gain energy, or a ball reaches another object.</returns>
    public bool Try(BallState[] states, double time, double left, double least, StepLog[] logs)
    {
        HasLooked = false;
        if (solver.Count < 2 || solver.Count > ClusterSystem.MostBalls || !(left > 0) || AreSlow(states))
        {
            return false;
        }

        ClusterSystem system = _cluster;
        system.Evaluations = 0;
        _time = time;
        Length = left;
        bool holds = Prepare(system, states, least) && FindModes(system);
        if (holds)
        {
            double parts = Math.Max(1.0, Math.Ceiling((left / LongestWhole(system, states, left)) - ContactTolerances.StepRounding));
            Length = left / parts;
            holds = (parts <= 1 || Length >= least) && Advance(system, Length) && ClusterModes.Hold(system) && !Overshoots(system, Length) && MeetsNothing(system, Length);
        }

        for (int i = 0; i < solver.Count; i++)
        {
            logs[solver.Members[i].Ball].Evaluations += system.Evaluations;
        }

        return holds;
    }

    /// <summary>Moves the balls within the step found. If it is cut short, the integrator repeats it up to there.</summary>
    /// <param name="states">The balls.</param>
    /// <param name="duration">The duration, s.</param>
    /// <param name="isCut">Whether that is only a part of it.</param>
    /// <param name="time">End time, s.</param>
    /// <param name="logs">Receive the pieces and counts of each ball.</param>
    public void Move(BallState[] states, double duration, bool isCut, double time, StepLog[] logs)
    {
        ClusterSystem system = _cluster;
        system.Evaluations = 0;
        if (isCut)
        {
            Advance(system, duration);
        }

        int order = MethodOf().Order;
        for (int i = 0; i < solver.Count; i++)
        {
            ref ClusterBall ball = ref system.Balls[i];
            StepLog log = logs[solver.Members[i].Ball];
            ref BallState s = ref states[solver.Members[i].Ball];
            s = ball.End;
            s.Time = time;
            log.Steps++;
            log.Evaluations += system.Evaluations;
            if (log.IsWatched)
            {
                // If its path buffer is full, a ball's own step ends early, but the pile's step continues.
                log.Show(in ball.Start, in s, ball.First.Acceleration, ball.Last.Acceleration, order);
                log.Halted = false;
            }
        }
    }

    /// <summary>Stores the impulses over a given time, s, in the pile's new contacts.</summary>
    public void Load(double duration)
    {
        for (int i = 0; i < solver.ContactCount; i++)
        {
            ref PileContact contact = ref solver.Contacts[i];
            for (int k = 0; k < _cluster.ContactCount; k++)
            {
                ref readonly ClusterContact solved = ref _cluster.Contacts[k];
                ref readonly SetContact on = ref solved.On;
                if (solved.First == contact.First && solved.Second == contact.Second && (solved.Second >= 0 || on.Collider == contact.Collider))
                {
                    contact.Load = duration * on.Load;
                    contact.Rub = duration * (on.Sticks ? on.Friction : -on.Sliding * on.Load * on.Direction);
                    contact.Twist = duration * (solved.HoldsTwist ? solved.Twist : -solved.TwistSign * solved.Lever * on.Load);
                    contact.Sticks = on.Sticks;
                }
            }
        }
    }

    /// <summary>True if all balls are slow enough to rest, or almost slow enough.</summary>
    private bool AreSlow(BallState[] states)
    {
        for (int i = 0; i < solver.Count; i++)
        {
            ref readonly PileMember member = ref solver.Members[i];
            ref readonly BallState s = ref states[member.Ball];
            double energy = 0.5 * ((s.Velocity.LengthSquared / member.PerMass) + (s.Spin.LengthSquared / member.PerInertia));
            if (energy > simulators[member.Ball].World.RestEnergy)
            {
                return false;
            }
        }

        return true;
    }

    private IIntegrator MethodOf() => simulators[solver.Members[0].Ball].Pile.Method;

    private static PathCubic PathOf(in ClusterBall ball, double h) =>
        PathCubic.Between(ball.Start.Position, ball.Start.Velocity, ball.End.Position, ball.End.Velocity, h);

    /// <summary>Sets up the balls and the contacts that neither close nor separate.</summary>
    /// <returns>False if an impulse is needed, an object moves, or there are too many contacts.</returns>
    private bool Prepare(ClusterSystem system, BallState[] states, double least)
    {
        system.Part = least;
        system.Count = solver.Count;
        system.ContactCount = 0;
        for (int i = 0; i < solver.Count; i++)
        {
            ref readonly PileMember member = ref solver.Members[i];
            ref readonly BallState s = ref states[member.Ball];
            ref ClusterBall ball = ref system.Balls[i];
            ball.Pile = simulators[member.Ball].Pile;
            ball.World = simulators[member.Ball].World;
            ball.PerMass = member.PerMass;
            ball.PerInertia = member.PerInertia;
            ball.Radius = member.Radius;
            ball.Start = s;
            ball.At = ClusterSystem.MotionOf(in s);
            if (s.Nets != 0 || s.Motion == MotionState.Pinned)
            {
                return false;
            }
        }

        for (int i = 0; i < solver.Count; i++)
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
        Span<Contact> near = _touching.AsSpan(i * ContactSet.Room, ContactSet.Room);
        int count = ContactSet.Near(ball.World, in ball.Start, ContactTolerances.Leaning, near, ball.World.Room).Length;
        if (count > near.Length)
        {
            return false;
        }

        int kept = 0;
        for (int k = 0; k < count; k++)
        {
            double rate = Vector3d.Dot(ball.Start.Velocity, in near[k].Normal);
            if (near[k].Moves || rate < -ContactTolerances.Pressing || system.ContactCount == ClusterSystem.MostContacts)
            {
                return false;
            }

            if (rate <= ContactTolerances.Pressing)
            {
                ref ClusterContact contact = ref system.Contacts[system.ContactCount++];
                contact = new ClusterContact { First = i, Second = -1 };
                contact.On.Prepare(in near[k], ball.World.Colliders[near[k].Collider], ball.World.Ball);
                near[kept++] = near[k];
            }
        }

        _touchingCount[i] = kept;
        return true;
    }

    private bool AddBalls(ClusterSystem system, int i)
    {
        ref readonly ClusterBall ball = ref system.Balls[i];
        for (int j = i + 1; j < solver.Count; j++)
        {
            ref readonly ClusterBall other = ref system.Balls[j];
            if (!BallRests.Touches(in ball.Start, ball.Radius, in other.Start, other.Radius))
            {
                continue;
            }

            BallContact.Gap(in ball.Start, ball.Radius, in other.Start, other.Radius, out _, out double rate);
            if (rate < -ContactTolerances.Pressing || system.ContactCount == ClusterSystem.MostContacts)
            {
                return false;
            }

            if (rate <= ContactTolerances.Pressing)
            {
                ref ClusterContact contact = ref system.Contacts[system.ContactCount++];
                contact = new ClusterContact { First = i, Second = j, Lever = lever };
                contact.On.Collider = -1;
                contact.On.Sliding = friction;
            }
        }

        return true;
    }

    /// <summary>Determines the modes and rates at the start, and removes remaining normal speeds and slips.</summary>
    private bool FindModes(ClusterSystem system)
    {
        system.Look(_time);
        HasLooked = true;
        for (int i = 0; i < solver.Count; i++)
        {
            solver.Members[i].Free = system.Balls[i].Free;
        }

        if (!ClusterModes.Find(system))
        {
            return false;
        }

        bool holds = true;
        if (ClusterProjection.Velocities(system, atEnd: false) > ContactTolerances.GroupUnmoved)
        {
            for (int i = 0; i < system.Count; i++)
            {
                system.Balls[i].At = ClusterSystem.MotionOf(in system.Balls[i].Start);
            }

            system.Look(_time);
            holds = system.Solve();
        }

        for (int i = 0; i < system.Count; i++)
        {
            system.Balls[i].First = system.Balls[i].Rates;
        }

        return holds;
    }

    /// <summary>Returns the longest whole step that stability, turning slips and turning normals allow, s.</summary>
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

        for (int i = 0; i < solver.Count; i++)
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

            longest = Math.Min(longest, ball.Pile.LongestWhole(in states[solver.Members[i].Ball], h, damping, gain));
        }

        return longest;
    }

    /// <summary>Takes a whole step of the integrator, and projects the balls onto their contacts.</summary>
    private bool Advance(ClusterSystem system, double h)
    {
        bool holds = system.Advance(MethodOf(), _time, h);
        for (int i = 0; i < system.Count; i++)
        {
            system.Balls[i].End.Time = _time + h;
        }

        ClusterProjection.Places(system);
        holds &= system.LookAtEnd(_time + h);
        ClusterProjection.Velocities(system, atEnd: true);
        return holds;
    }

    /// <summary>True if the balls end with more energy than they had and their forces gave: the loads then changed faster than the integrator can follow.</summary>
    private bool Overshoots(ClusterSystem system, double h)
    {
        double before = 0;
        double after = 0;
        double given = 0;
        double others = 0;
        for (int i = 0; i < system.Count; i++)
        {
            ref readonly ClusterBall ball = ref system.Balls[i];
            Surroundings around = ball.Pile.Around;
            before += EnergyOf(in ball, in ball.Start);
            after += EnergyOf(in ball, in ball.End);
            given += SetGuard.Given(around, ball.End.Position - ball.Start.Position, h, MethodOf().Order) / ball.PerMass;
            others += SetGuard.MayGive(around) ? ((ball.Free.Acceleration - around.Weight).LengthSquared / ball.PerMass) + (ball.Free.SpinAcceleration.LengthSquared / ball.PerInertia) : 0;
        }

        // The forces at the last stage stand for those of the step: allow twice their impulse.
        double change = 2.0 * h * Math.Sqrt(others);
        for (int k = 0; k < system.ContactCount; k++)
        {
            change += SetGuard.MostBySurface * system.Contacts[k].On.Surface.Length / Math.Sqrt(system.Balls[system.Contacts[k].First].PerMass);
        }

        return SetGuard.Overshoots(before, after, given, change);
    }

    /// <summary>½ m |v|² + ½ I |ω|², J.</summary>
    private static double EnergyOf(in ClusterBall ball, in BallState s) => 0.5 * ((s.Velocity.LengthSquared / ball.PerMass) + (s.Spin.LengthSquared / ball.PerInertia));

    /// <summary>True if the balls stay on the same surfaces, and reach no other object on their paths.</summary>
    private bool MeetsNothing(ClusterSystem system, double h)
    {
        for (int i = 0; i < system.Count; i++)
        {
            ref readonly ClusterBall ball = ref system.Balls[i];
            Span<Contact> held = _touching.AsSpan(i * ContactSet.Room, _touchingCount[i]);
            foreach (ref readonly Contact near in held)
            {
                Collider collider = ball.World.Colliders[near.Collider];
                if (collider.FaceMargin(ball.End.Position, _time + h) < 0
                    || (collider.LeastWidth < double.PositiveInfinity && collider.PatchAt(ball.Start.Position) != collider.PatchAt(ball.End.Position)))
                {
                    return false;
                }
            }

            int carrier = ball.Start.Motion == MotionState.Airborne ? -1 : (int)ball.World.ColliderOf(ball.Start.Carrier, ball.Start.Position, ball.Start.Time);
            PathCubic path = PathOf(in ball, h);
            if (new ContactSearch(ball.World, in path, _time).First(in ball.Start, ContactSet.Has(held, carrier) ? carrier : -1, out _, held) <= h)
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
        double most = ball.Radius + other.Radius + ContactTolerances.Touching + (h * (path.FastestSpeed + its.FastestSpeed));
        if ((ball.Start.Position - other.Start.Position).LengthSquared > most * most)
        {
            return false;
        }

        room.Way.Go(in ball.Start, in path);
        room.OtherWay.Go(in other.Start, in its);
        return room.Way.Meets(room.OtherWay, ball.Radius + other.Radius, _time, _time + h, atEnd: true) <= _time + h;
    }
}
