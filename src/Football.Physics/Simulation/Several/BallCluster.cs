namespace Football.Physics;

/// <summary>Balls that may meet in a step, played again from before it: always the first that happens among them, to the last bit by the balls' own steps.</summary>
internal sealed class BallCluster
{
    /// <summary>More impacts than this, and one for each pair, at one instant: the rest of it is without restitution.</summary>
    private const int MostAtOnce = 8;

    /// <summary>Balls that press each other are looked at again after so long, s.</summary>
    private const double Press = 1e-3;

    /// <summary>So many impacts of a step are played one by one; after them the rest of it is played as if there were no other ball.</summary>
    private const int MostImpacts = 4096;

    private const int MostNewton = 12;

    /// <summary>Two balls touch where the gap is less than this, m; and of two times closer than this, s, one is the other.</summary>
    private const double Closed = 1e-13;

    private readonly Simulator[] _simulators;
    private readonly ContactMaterial _contact;
    private readonly double _friction;
    private readonly BallState[] _before;
    private readonly double[] _reaches;
    private readonly StepLog[] _logs;
    private readonly BallTrial[] _trials;
    private readonly int[] _cluster;
    private readonly bool[] _isIn;
    private readonly bool[] _again;
    private readonly StepLog _look = new();
    private readonly RigidMotion[] _motions;
    private readonly RigidMotion[] _motionsAfter;
    private readonly RigidMotion[] _motionsKept;
    private Pressing[] _presses = new Pressing[8];
    private int _pressCount;
    private int _clusterCount;
    private double _start;
    private double _step;
    private double _end;

    /// <param name="simulators">The scenes of all balls of the group.</param>
    /// <param name="contact">What two balls are to each other.</param>
    /// <param name="friction">The friction of that, where two balls press each other.</param>
    /// <param name="before">The balls before the step.</param>
    /// <param name="reaches">Not less than how far each gets in it, m.</param>
    /// <param name="logs">Where events and counts of each go.</param>
    public BallCluster(Simulator[] simulators, in ContactMaterial contact, double friction, BallState[] before, double[] reaches, StepLog[] logs)
    {
        int count = simulators.Length;
        _simulators = simulators;
        _contact = contact;
        _friction = friction;
        _before = before;
        _reaches = reaches;
        _logs = logs;
        _trials = new BallTrial[count];
        for (int i = 0; i < count; i++)
        {
            _trials[i] = new BallTrial();
        }

        _cluster = new int[count];
        _isIn = new bool[count];
        _again = new bool[count];
        int movers = simulators[0].World.Movers;
        _motions = new RigidMotion[movers];
        _motionsAfter = new RigidMotion[movers];
        _motionsKept = new RigidMotion[movers];
    }

    /// <summary>How many balls are in it.</summary>
    public int Count => _clusterCount;

    /// <summary>A ball of it.</summary>
    public int this[int index] => _cluster[index];

    /// <summary>True when a ball is in it.</summary>
    public bool Has(int ball) => _isIn[ball];

    /// <summary>Takes all balls out.</summary>
    public void Clear()
    {
        for (int k = 0; k < _clusterCount; k++)
        {
            _isIn[_cluster[k]] = false;
        }

        _clusterCount = 0;
    }

    /// <summary>True when two balls may meet that get so far in the step, m.</summary>
    public bool MayMeet(int i, double reach, int j, double otherReach)
    {
        double most = reach + otherReach + Distance(i, j) + ContactSearch.Touching;
        return (_before[i].Position - _before[j].Position).LengthSquared <= most * most;
    }

    private double Distance(int i, int j) => _simulators[i].Scene.Ball.Radius + _simulators[j].Scene.Ball.Radius;

    /// <summary>Takes a ball in.</summary>
    public void Join(int ball)
    {
        if (!_isIn[ball])
        {
            _isIn[ball] = true;
            _cluster[_clusterCount++] = ball;
        }
    }

    /// <summary>Plays the balls of a cluster again from before the step: always the first that happens, then all whose way that changes anew.</summary>
    /// <returns>Whether an event ended the step.</returns>
    public bool Play(BallState[] states, double dt, StopAt stopAt, StepLog[]? watched, RigidMotion[] motions)
    {
        _start = _before[0].Time;
        _step = dt;
        _end = _start + dt;
        double end = _end;

        // By number: of what happens at one time the first that is asked for counts.
        Array.Sort(_cluster, 0, _clusterCount);
        _pressCount = 0;

        // What they pushed in the first try goes back with them.
        Restore(motions);
        _simulators[0].World.Engine?.PutPushesBack();
        int begun = 0;
        int impacts = 0;
        int atOnce = 0;
        double last = double.NegativeInfinity;
        bool ended = false;
        bool pushed = false;
        while (!ended)
        {
            // A ball that joins later begins at the step's start, as it was there.
            for (; begun < _clusterCount; begun++)
            {
                Begin(states, _cluster[begun], watched);
                Try(states, _cluster[begun], end, stopAt);
            }

            // Up to the first thing that happens every ball goes as if it were alone.
            Happening first = FindFirst(end);
            if (!(first.Time <= end) || impacts >= MostImpacts)
            {
                break;
            }

            atOnce = first.Time - last <= Closed ? atOnce + 1 : 0;
            last = first.Time;
            impacts++;
            if (first.IsMeeting)
            {
                // As many impacts at one instant as contacts and some more, as in a pile: the rest of it without restitution.
                bool presses = atOnce > MostAtOnce + (_clusterCount * (_clusterCount - 1) / 2);
                ended = Collide(states, in first, presses, stopAt, watched);
                Try(states, first.Ball, end, stopAt);
                Try(states, first.Other, end, stopAt);
            }
            else
            {
                ended = Push(states, in first, end, stopAt, watched);
                pushed = true;
            }
        }

        // Nothing more happens: on to the end of the step, or up to what ended it.
        for (int k = 0; k < _clusterCount; k++)
        {
            int i = _cluster[k];
            if (!ended)
            {
                Commit(states, i, end, watched);
            }
            else if (states[i].Time < last)
            {
                Commit(states, i, last, watched);
            }

            // What was free ahead of any ball was so before something was pushed.
            states[i].ClearUntil = pushed ? 0 : states[i].ClearUntil;
        }

        return ended;
    }

    /// <summary>Puts a ball back to where it was before the step.</summary>
    private void Begin(BallState[] states, int i, StepLog[]? watched)
    {
        states[i] = _before[i];
        StepLog own = LogOf(i, watched);
        if (watched is null)
        {
            own.Clear();
        }

        own.Events.Ball = i;
        own.StopAt = StopAt.Time;
        own.Halted = false;
        own.HaltsAtPush = false;
        own.Pushes = true;
    }

    private StepLog LogOf(int i, StepLog[]? watched) => watched is null ? _logs[i] : watched[i];

    /// <summary>Looks where a ball goes from where it has got to; and who may be in its way that was not before.</summary>
    private void Try(BallState[] states, int i, double end, StopAt stopAt)
    {
        World world = _simulators[i].World;

        // A try pushes what has a mass as the step would: afterwards that is put back.
        world.ReadMotions(_motionsKept);
        world.Engine?.KeepPushes();
        _trials[i].Run(_simulators[i], in states[i], Left(in states[i], end), stopAt);
        world.Engine?.PutPushesBack();
        Restore(_motionsKept);

        // Struck, it may get farther than was expected of it, and meet balls that were no neighbours.
        double reach = (states[i].Position - _before[i].Position).Length + _trials[i].Reach;
        for (int k = 0; reach > _reaches[i] && k < _isIn.Length; k++)
        {
            if (!_isIn[k] && MayMeet(i, reach, k, _reaches[k]))
            {
                Join(k);
            }
        }

        _reaches[i] = Math.Max(_reaches[i], reach);
    }

    /// <summary>The first event: two balls meet, or one meets what it pushes, or what ends the step.</summary>
    private Happening FindFirst(double end)
    {
        Happening first = Happening.None;
        for (int a = 0; a < _clusterCount; a++)
        {
            int i = _cluster[a];
            for (int b = 0; b < _clusterCount; b++)
            {
                int j = _cluster[b];
                if (j > i && MayMeet(i, _reaches[i], j, _reaches[j]))
                {
                    // Not beyond what was found first so far, nor beyond where one of the two halts.
                    double until = Math.Min(Math.Min(end, first.Time), Math.Min(_trials[i].HaltsAt, _trials[j].HaltsAt));
                    double from = Math.Max(Math.Max(_trials[i].From, _trials[j].From), PressedUntil(i, j));
                    double time = _trials[i].Meets(_trials[j], Distance(i, j), from, until, atEnd: until < end);
                    first = Earlier(new Happening(time, i, j), in first);
                }
            }

            first = Earlier(new Happening(_trials[i].HaltsAt, i, Happening.NoOther), in first);
        }

        return first;
    }

    /// <summary>The earlier of two events. At one time that which is asked first: that of the ball of the lower number, its meetings with others first, that with the lowest before.</summary>
    private static Happening Earlier(in Happening next, in Happening first) => next.Time < first.Time ? next : first;

    /// <summary>How long a ball goes to a time within the step, s: a whole step is that to the last bit.</summary>
    private double Left(in BallState s, double time) => s.Time == _start && time == _end ? _step : Math.Max(0, time - s.Time);

    /// <summary>Moves a ball on to a time within its way, as its step would have gone.</summary>
    private void Commit(BallState[] states, int i, double time, StepLog[]? watched)
    {
        ref BallState s = ref states[i];
        double left = Left(in s, time);
        if (left > 0)
        {
            StepLog own = LogOf(i, watched);
            _simulators[i].Advance(ref s, left, own);
        }

        // A path whose memory is full ends a step early, not the ball.
        for (StepLog own = LogOf(i, watched); own.Halted && s.Time < time;)
        {
            own.Halted = false;
            _simulators[i].Advance(ref s, Left(in s, time), own);
        }

        s.Time = time;
    }

    /// <summary>Two balls meet: both go there, to the last bit by their own steps, and both get the impulse.</summary>
    /// <returns>Whether that ends the step.</returns>
    private bool Collide(BallState[] states, in Happening met, bool presses, StopAt stopAt, StepLog[]? watched)
    {
        int i = met.Ball;
        int j = met.Other;
        double time = Locate(states, in met);
        Commit(states, i, time, watched);
        Commit(states, j, time, watched);
        BallProperties ball = _simulators[i].Scene.Ball;
        BallProperties other = _simulators[j].Scene.Ball;
        double gap = BallContact.Gap(in states[i], ball.Radius, in states[j], other.Radius, out Vector3d n, out double rate);

        // Gently they press each other: no restitution, friction alone, and apart again after a while.
        presses |= rate > -BallContact.Gentle;
        ContactMaterial material = presses ? new ContactMaterial(0, 0, _friction) : _contact;
        BallContact.Impact(ball, other, in material, in n, in states[i], in states[j], out Motion first, out Motion second);
        StepLog own = LogOf(i, watched);
        StepLog its = LogOf(j, watched);
        if (presses)
        {
            own.Untold++;
            SetPressed(i, j, time);

            // What overlaps is put apart, each by its share.
            double over = Math.Max(0, -gap) / (ball.Mass + other.Mass);
            Vector3d at = states[i].Position;
            Vector3d otherAt = states[j].Position;
            states[i].Position += other.Mass * over * n;
            states[j].Position -= ball.Mass * over * n;
            _simulators[i].Displaced(ref states[i], in at, own);
            _simulators[j].Displaced(ref states[j], in otherAt, its);
        }
        else
        {
            own.Events.Add(new BallEvent(j, in n, time, in states[i], in first.Velocity, in first.Spin));
            its.Events.Add(new BallEvent(i, -n, time, in states[j], in second.Velocity, in second.Spin));
        }

        // What becomes of each: on the ground it keeps its carrier, unless the impulse lifts it.
        _simulators[i].Struck(ref states[i], in first.Velocity, in first.Spin, in n, presses, own);
        _simulators[j].Struck(ref states[j], in second.Velocity, in second.Spin, -n, presses, its);
        return stopAt == StopAt.Impact && !presses;
    }

    /// <summary>When two balls touch by their own steps: Newton's method from what their dense paths say.</summary>
    private double Locate(BallState[] states, in Happening met)
    {
        double from = Math.Max(Math.Max(states[met.Ball].Time, states[met.Other].Time), PressedUntil(met.Ball, met.Other));
        double time = Math.Max(from, met.Time);
        for (int k = 0; k < MostNewton; k++)
        {
            BallState a = Look(states, met.Ball, time);
            BallState b = Look(states, met.Other, time);

            // Newton on the gap of the two steps, t − f/f', not before both balls are there.
            double gap = BallContact.Gap(in a, _simulators[met.Ball].Scene.Ball.Radius, in b, _simulators[met.Other].Scene.Ball.Radius, out _, out double rate);
            double next = rate < 0 ? Math.Max(from, time - (gap / rate)) : time;
            if (Math.Abs(gap) <= Closed || next == time || Math.Abs(next - met.Time) > Press)
            {
                break;
            }

            time = next;
        }

        return time;
    }

    private BallState Look(BallState[] states, int i, double time)
    {
        BallState state = states[i];
        _look.Clear();
        _look.Pushes = false;
        if (time > state.Time)
        {
            _simulators[i].Advance(ref state, Left(in state, time), _look);
        }

        return state;
    }

    /// <summary>A ball meets what it pushes, or what ends the step: all that may meet that too go there first.</summary>
    /// <returns>Whether it ends the step.</returns>
    private bool Push(BallState[] states, in Happening met, double end, StopAt stopAt, StepLog[]? watched)
    {
        World world = _simulators[0].World;

        // The ball goes up to what it pushes, which then moves differently.
        world.ReadMotions(_motions);
        StepLog own = LogOf(met.Ball, watched);
        own.HaltsAtPush = true;
        own.StopAt = stopAt;
        _simulators[met.Ball].Advance(ref states[met.Ball], Left(in states[met.Ball], end), own);
        own.HaltsAtPush = false;
        own.StopAt = StopAt.Time;
        own.Halted = false;
        if (stopAt == StopAt.Impact)
        {
            return true;
        }

        // Who may find it elsewhere goes to that time while it is where it was, and looks again.
        world.ReadMotions(_motionsAfter);
        Restore(_motions);
        for (int k = 0; k < _clusterCount; k++)
        {
            int i = _cluster[k];
            if (i != met.Ball && FindsElsewhere(i, in states[i], met.Time, end))
            {
                Commit(states, i, Math.Max(states[i].Time, met.Time), watched);
                states[i].ClearUntil = 0;
                _again[i] = true;
            }
        }

        Restore(_motionsAfter);
        _again[met.Ball] = true;
        for (int k = 0; k < _clusterCount; k++)
        {
            int i = _cluster[k];
            if (_again[i])
            {
                _again[i] = false;
                Try(states, i, end, stopAt);
            }
        }

        return false;
    }

    /// <summary>True when a ball may come to a place, in the rest of a step, where something is that was pushed, or would have been.</summary>
    private bool FindsElsewhere(int ball, in BallState s, double time, double end)
    {
        World world = _simulators[0].World;
        if (world.Engine is not null)
        {
            return true;
        }

        double reach = _trials[ball].Reach + _simulators[ball].Scene.Ball.Radius;
        for (int m = 0; m < _motions.Length; m++)
        {
            if (_motions[m].Velocity != _motionsAfter[m].Velocity)
            {
                // All that it sweeps until the end, pushed and not pushed.
                Bounds3d box = world.BoundsOfMover(m, time, end - time);
                box = box.With(box.Moved((end - time) * _motions[m].Velocity)).With(box.Moved((end - time) * _motionsAfter[m].Velocity));
                if (box.Grown(reach).Touches(new Bounds3d(s.Position, s.Position)))
                {
                    return true;
                }
            }
        }

        return false;
    }

    private void Restore(RigidMotion[] motions)
    {
        if (motions.Length > 0)
        {
            _simulators[0].World.WriteMotions(motions);
        }
    }

    private double PressedUntil(int i, int j)
    {
        for (int k = 0; k < _pressCount; k++)
        {
            if (_presses[k].Ball == i && _presses[k].Other == j)
            {
                return _presses[k].Until;
            }
        }

        return double.NegativeInfinity;
    }

    private void SetPressed(int i, int j, double time)
    {
        int k = 0;
        while (k < _pressCount && !(_presses[k].Ball == i && _presses[k].Other == j))
        {
            k++;
        }

        if (k == _presses.Length)
        {
            Array.Resize(ref _presses, 2 * k);
        }

        _presses[k] = new Pressing(i, j, time + Press);
        _pressCount = Math.Max(_pressCount, k + 1);
    }

    /// <summary>Something that happens to one ball, or to two.</summary>
    private readonly struct Happening(double time, int ball, int other)
    {
        public readonly double Time = time;
        public readonly int Ball = ball;

        /// <summary>The other ball, or none.</summary>
        public readonly int Other = other;

        /// <summary>No other ball.</summary>
        public const int NoOther = -1;

        /// <summary>Nothing, ever.</summary>
        public static Happening None => new(double.PositiveInfinity, NoOther, NoOther);

        /// <summary>True when two balls meet.</summary>
        public bool IsMeeting => Other != NoOther;
    }

    private readonly struct Pressing(int ball, int other, double until)
    {
        public readonly int Ball = ball;
        public readonly int Other = other;

        /// <summary>Until then, s, they are not looked at.</summary>
        public readonly double Until = until;
    }
}
