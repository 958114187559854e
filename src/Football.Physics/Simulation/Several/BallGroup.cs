namespace Football.Physics;

/// <summary>Several balls among the same things, stepped together: they hit one another at exact times, in exact order. A training ground's fifty, or two.</summary>
/// <remarks>
/// Balls far from one another cost a step each, and a comparison. A group keeps what it has found of them between steps, so it is for one thread; groups that share a
/// <see cref="Simulator"/> may step at the same time where that may be shared. What a ball does depends on the others only where they meet: the bits are the same in any group.
/// Two balls that come together slower than 1 cm/s press each other without a bounce, and are put apart once a millisecond; what a ball presses for longer it presses as if
/// nothing moved that.
/// </remarks>
public sealed class BallGroup
{
    /// <summary>More impacts than this, and one for each pair, at one instant: the rest of it is without restitution.</summary>
    private const int MostAtOnce = 8;

    /// <summary>Balls that press each other are looked at again after so long, s.</summary>
    private const double Press = 1e-3;

    /// <summary>So many impacts between balls of a step are told, and played one by one; after them the rest of it is played as if there were no other ball.</summary>
    private const int MostImpacts = 4096;

    /// <summary>Contacts of a heap that are without restitution are gone through so often at one instant.</summary>
    private const int MostRounds = 64;

    private const int MostNewton = 12;

    /// <summary>So many events a ball are kept of a step without playing it again.</summary>
    private const int EventsOfBall = 16;

    /// <summary>Two balls touch where the gap is less than this, m.</summary>
    private const double Closed = 1e-13;

    private readonly Simulator[] _simulators;
    private readonly ContactMaterial _contact;
    private readonly bool _givesWay;
    private readonly BallNeighbours _neighbours;
    private readonly BallState[] _before;
    private readonly StepLog[] _logs;
    private readonly BallTrial[] _trials;
    private readonly double[] _reaches;
    private readonly int[] _cluster;
    private readonly bool[] _isIn;
    private readonly StepLog _look = new();
    private readonly BallTrial _measure = new();
    private readonly StepLog _flown;
    private readonly int[] _firstEvent;
    private readonly bool[] _played;
    private BallEvent[] _told = new BallEvent[16];
    private readonly RigidMotion[] _motions;
    private readonly RigidMotion[] _motionsBefore;
    private readonly RigidMotion[] _motionsAfter;
    private readonly RigidMotion[] _motionsKept;
    private readonly bool[] _again;
    private Pressing[] _presses = new Pressing[8];
    private int _pressCount;
    private int _clusterCount;
    private double _start;
    private double _step;
    private double _end;

    /// <summary>A group of equal balls in one scene.</summary>
    /// <param name="simulator">The compiled scene.</param>
    /// <param name="count">How many balls; 1 … 10 000.</param>
    /// <param name="contact">What two balls are to each other; default <see cref="Surface.Ball"/>.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public BallGroup(Simulator simulator, int count, Surface? contact = null)
        : this(Repeat(simulator, count), contact)
    {
    }

    /// <summary>A group of balls that differ.</summary>
    /// <param name="scene">The scene of all of them; its own ball is none of them.</param>
    /// <param name="balls">The balls; 1 … 10 000.</param>
    /// <param name="settings">How to integrate; default <see cref="SolverSettings.Default"/>.</param>
    /// <param name="contact">What two balls are to each other; default <see cref="Surface.Ball"/>.</param>
    /// <exception cref="ArgumentNullException">The scene, the balls or one of them is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public BallGroup(Scene scene, IReadOnlyList<BallProperties> balls, SolverSettings? settings = null, Surface? contact = null)
        : this(Compile(scene, balls, settings), contact)
    {
    }

    private BallGroup(Simulator[] simulators, Surface? contact)
    {
        Contact = contact ?? Surface.Ball;
        Contact.Validate("ballContact");
        _contact = new ContactMaterial(Contact);
        int count = simulators.Length;
        _simulators = simulators;
        World world = simulators[0].World;
        _givesWay = world.GivesWay || world.Engine is not null;
        _neighbours = new BallNeighbours([.. simulators.Select(simulator => simulator.Scene.Ball.Radius)]);
        _before = new BallState[count];
        _reaches = new double[count];
        _cluster = new int[count];
        _isIn = new bool[count];
        _played = new bool[count];
        _firstEvent = new int[count + 1];
        _flown = new StepLog(mostEvents: Math.Max(EventBuffer.DefaultMost, EventsOfBall * count));
        _logs = new StepLog[count];
        _trials = new BallTrial[count];
        for (int i = 0; i < count; i++)
        {
            _logs[i] = new StepLog();
            _trials[i] = new BallTrial();
        }

        _motions = new RigidMotion[world.Movers];
        _motionsBefore = new RigidMotion[world.Movers];
        _motionsAfter = new RigidMotion[world.Movers];
        _motionsKept = new RigidMotion[world.Movers];
        _again = new bool[count];
    }

    /// <summary>How many balls there are.</summary>
    public int Count => _simulators.Length;

    /// <summary>What two balls are to each other.</summary>
    public Surface Contact { get; }

    /// <summary>Advances all balls.</summary>
    /// <param name="states">The balls, as many as the group has, all of one time; unchanged where an exception is thrown.</param>
    /// <param name="dt">Time to advance by, s: 0 … 1e12.</param>
    /// <param name="log">Where the events of all are added, in order of time, then of the balls, and the counts.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">The states are not as many as the balls, or not of one time, or one was never launched; or the log has an observer.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="dt"/> is out of range, or a body was moved since the last step for a time more than 0.25 s from the balls'.</exception>
    public void Step(BallState[] states, double dt, StepLog log) => Step(states, dt, log, StopAt.Time, null);

    /// <summary>Advances all balls in equal steps until an event or a time.</summary>
    /// <param name="states">The balls, as many as the group has, all of one time. After an early end they are as they were just after the event.</param>
    /// <param name="timeStep">Length of a step, s; above 0, at most 1e12, at least 1e-12 of the duration. The last one is shortened.</param>
    /// <param name="duration">How long to go on at most, s; above 0, at most 1e12.</param>
    /// <param name="stopAt">The event that ends the run: the first impact of any ball; or rest, of all of them, at the end of a step.</param>
    /// <param name="log">Where the events of all are added, in order of time, then of the balls, and the counts.</param>
    /// <returns>True when the event ended the run, false when its time did.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">The states are not as many as the balls, or not of one time, or one was never launched; or the log has an observer.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public bool Run(BallState[] states, double timeStep, double duration, StopAt stopAt, StepLog log)
    {
        Check.Given(nameof(states), states);
        Check.Given(nameof(log), log);
        if (states.Length > 0)
        {
            Simulator.CheckRun(in states[0], timeStep, duration, stopAt);
        }

        return Run(states, timeStep, duration, stopAt, log, null, null);
    }

    /// <summary>The same for who watches the paths, with a callback after every step.</summary>
    internal bool Run(BallState[] states, double timeStep, double duration, StopAt stopAt, StepLog[] watched, Simulator.StepCallback? onStep) =>
        Run(states, timeStep, duration, stopAt, null, watched, onStep);

    private bool Run(
        BallState[] states, double timeStep, double duration, StopAt stopAt, StepLog? log, StepLog[]? watched, Simulator.StepCallback? onStep)
    {
        // At least one step is asked for, which refuses what is wrong with the states.
        double end = (states.Length > 0 ? states[0].Time : 0) + duration;
        double last = end - (1e-9 * timeStep);
        do
        {
            double left = end - (states.Length > 0 ? states[0].Time : 0);
            bool ended = Step(states, Math.Min(timeStep, left), log, stopAt == StopAt.Impact ? StopAt.Impact : StopAt.Time, watched);
            onStep?.Invoke(in states[0]);
            if (ended || (stopAt == StopAt.Rest && Array.TrueForAll(states, state => state.Motion == MotionState.Stopped)))
            {
                return true;
            }
        }
        while (states[0].Time < last);
        return false;
    }

    /// <summary>The compiled scene of a ball.</summary>
    /// <param name="ball">Which, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such ball.</exception>
    public Simulator SimulatorOf(int ball)
    {
        Check.Index(nameof(ball), ball, Count);
        return _simulators[ball];
    }

    /// <summary>Advances all balls up to the first event that ends the step.</summary>
    /// <param name="states">The balls.</param>
    /// <param name="dt">Time to advance by, s.</param>
    /// <param name="log">Where events and counts are added.</param>
    /// <param name="stopAt">The impact of any ball may end it.</param>
    /// <param name="watched">Logs of the balls, one each, whose observers see their pieces; null where nobody watches.</param>
    /// <returns>Whether an event ended it.</returns>
    internal bool Step(BallState[] states, double dt, StepLog? log, StopAt stopAt, StepLog[]? watched)
    {
        Check.Given(nameof(states), states);
        if (watched is null)
        {
            Check.Given(nameof(log), log);
        }

        if (log?.Observer is not null)
        {
            throw new ArgumentException("log has an observer; allowed: none, it would not know whose pieces it sees. Look ahead for paths.", nameof(log));
        }

        Check.Within(nameof(dt), dt, 0, Limits.Time);
        if (states.Length != Count)
        {
            throw new ArgumentException($"states has {states.Length} balls; allowed: {Count}, as many as the group.", nameof(states));
        }

        World world = _simulators[0].World;
        world.Bodies?.CheckTimes(states[0].Time);
        world.ReadMotions(_motionsBefore);
        _start = states[0].Time;
        _step = dt;
        _end = _start + dt;
        bool ended;
        Array.Copy(states, _before, Count);
        try
        {
            // 1. Every ball as if there were no other. 2. The neighbours that may have met. 3. Those again, meeting by meeting.
            world.Engine?.KeepPushes();
            bool pushes = Fly(states, dt, stopAt, out bool holds);
            if (!holds)
            {
                RenewNeighbours(dt);
            }

            FindCluster(all: pushes || stopAt == StopAt.Impact || watched is not null);
            ended = _clusterCount > 0 && PlayCluster(states, _end, stopAt, watched);
        }
        catch
        {
            Array.Copy(_before, states, Count);
            Restore(_motionsBefore);
            throw;
        }

        if (log is not null)
        {
            Tell(log);
        }

        return ended;
    }

    private static Simulator[] Repeat(Simulator simulator, int count)
    {
        Check.Given(nameof(simulator), simulator);
        Check.Within(nameof(count), count, 1, 10_000);
        var all = new Simulator[count];
        all.AsSpan().Fill(simulator);
        return all;
    }

    private static Simulator[] Compile(Scene scene, IReadOnlyList<BallProperties> balls, SolverSettings? settings)
    {
        Check.Given(nameof(scene), scene);
        Check.Given(nameof(balls), balls);
        Check.Within("balls", balls.Count, 1, 10_000);
        var all = new Simulator[balls.Count];
        for (int i = 0; i < all.Length; i++)
        {
            Check.GivenItem(nameof(balls), i, balls[i], "a ball");
            int same = 0;
            while (same < i && !balls[same].Equals(balls[i]))
            {
                same++;
            }

            // What an impact moves is one thing to all of them.
            Scene its = scene with { Ball = balls[i], Motions = i > 0 ? all[0].World.Obstacles : null };
            all[i] = same < i ? all[same] : new Simulator(its, settings);
        }

        return all;
    }

    /// <summary>Every ball takes its step as if there were no other.</summary>
    /// <returns>Whether one of them pushed something, which the others then find elsewhere, or something ended its step; or not all events had room.</returns>
    private bool Fly(BallState[] states, double dt, StopAt stopAt, out bool holds)
    {
        holds = true;
        double time = states[0].Time;
        StepLog log = _flown;
        log.Clear();
        log.StopAt = stopAt;
        log.Pushes = true;
        log.HaltsAtPush = _givesWay;
        bool halts = false;
        for (int i = 0; i < states.Length; i++)
        {
            ref BallState s = ref states[i];
            if (s.Time != time || s.BaseOrientation == default)
            {
                Refuse(in s, i, time);
            }

            ref readonly BallState before = ref _before[i];
            int first = log.Events.Count;
            _firstEvent[i] = first;
            log.Events.Ball = i;
            _simulators[i].Advance(ref s, dt, log);
            halts |= log.Halted;
            log.Halted = false;
            bool keeps = _neighbours.Holds(i, in before, in s, dt) && (first == log.Events.Count || KeepsPace(i, first));
            _reaches[i] = keeps ? _neighbours.ReachOf(i) : double.PositiveInfinity;
            holds &= keeps;
        }

        _firstEvent[states.Length] = log.Events.Count;
        return halts || log.Events.Dropped > 0;
    }

    private static void Refuse(in BallState state, int ball, double time)
    {
        BallState.Launched(in state);
        throw new ArgumentException(
            FormattableString.Invariant($"states[{ball}].time is {state.Time:R}; allowed: {time:R}, the time of the first ball."), "states");
    }

    /// <summary>How far those balls got that did not keep to what was expected; and the neighbours anew where one left its sphere.</summary>
    private void RenewNeighbours(double dt)
    {
        bool holds = true;
        for (int i = 0; i < Count; i++)
        {
            if (_reaches[i] < double.PositiveInfinity)
            {
                continue;
            }

            _measure.Run(_simulators[i], in _before[i], dt, StopAt.Time);
            _reaches[i] = _measure.Reach;
            holds &= _neighbours.Holds(i, in _before[i], _reaches[i], dt);
        }

        if (!holds)
        {
            _neighbours.Renew(_before, _reaches, dt);
        }
    }

    /// <summary>Whether a ball was never faster in its step than its sphere was made for: before and after each event.</summary>
    private bool KeepsPace(int ball, int first)
    {
        for (int k = first; k < _flown.Events.Count; k++)
        {
            ref readonly BallEvent happened = ref _flown.Events[k];
            if (happened.Kind == BallEventKind.Squeezed
                || !_neighbours.Allows(ball, happened.VelocityBefore.LengthSquared) || !_neighbours.Allows(ball, happened.Velocity.LengthSquared))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>The balls that may meet another in this step.</summary>
    private void FindCluster(bool all)
    {
        _clusterCount = 0;
        if (!all)
        {
            for (int k = 0; k < _neighbours.Count && !all; k++)
            {
                (int i, int j) = _neighbours[k];
                if (MayMeet(i, _reaches[i], j, _reaches[j]))
                {
                    // What one of them then pushes may be met by any.
                    all = _givesWay;
                    Join(i);
                    Join(j);
                }
            }
        }

        for (int i = 0; all && i < Count; i++)
        {
            Join(i);
        }
    }

    private bool MayMeet(int i, double reach, int j, double otherReach)
    {
        double most = reach + otherReach + Distance(i, j) + ContactSearch.Touching;
        return (_before[i].Position - _before[j].Position).LengthSquared <= most * most;
    }

    private double Distance(int i, int j) => _simulators[i].Scene.Ball.Radius + _simulators[j].Scene.Ball.Radius;

    private void Join(int ball)
    {
        if (!_isIn[ball])
        {
            _isIn[ball] = true;
            _cluster[_clusterCount++] = ball;
        }
    }

    /// <summary>Plays the balls of a cluster again from before the step: always the first that happens, then all whose way that changes anew.</summary>
    /// <returns>Whether an event ended the step.</returns>
    private bool PlayCluster(BallState[] states, double end, StopAt stopAt, StepLog[]? watched)
    {
        Array.Sort(_cluster, 0, _clusterCount);
        _pressCount = 0;
        Restore(_motionsBefore);
        _simulators[0].World.Engine?.PutPushesBack();
        int begun = 0;
        int impacts = 0;
        int atOnce = 0;
        double last = double.NegativeInfinity;
        bool ended = false;
        while (!ended)
        {
            // A ball that joins later begins at the step's start, as it was there.
            for (; begun < _clusterCount; begun++)
            {
                Begin(states, _cluster[begun], watched);
                Try(states, _cluster[begun], end, stopAt);
            }

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
                bool presses = atOnce > MostAtOnce + (_clusterCount * (_clusterCount - 1) / 2);
                ended = Collide(states, in first, presses, stopAt, watched);
                Try(states, first.Ball, end, stopAt);
                Try(states, first.Other, end, stopAt);
            }
            else
            {
                ended = Push(states, in first, end, stopAt, watched);
            }
        }

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

            _isIn[i] = false;
            _played[i] = watched is null;
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
        world.ReadMotions(_motionsKept);
        world.Engine?.KeepPushes();
        _trials[i].Run(_simulators[i], in states[i], Left(in states[i], end), stopAt);
        world.Engine?.PutPushesBack();
        Restore(_motionsKept);
        double reach = (states[i].Position - _before[i].Position).Length + _trials[i].Reach;
        for (int k = 0; reach > _reaches[i] && k < Count; k++)
        {
            if (!_isIn[k] && MayMeet(i, reach, k, _reaches[k]))
            {
                Join(k);
            }
        }

        _reaches[i] = Math.Max(_reaches[i], reach);
    }

    /// <summary>What happens first: two balls meet, or one meets what it pushes, or what ends the step. At one time that of the lower ball, its meeting with another first.</summary>
    private Happening FindFirst(double end)
    {
        var first = new Happening(double.PositiveInfinity, -1, Happening.NoOther);
        for (int a = 0; a < _clusterCount; a++)
        {
            int i = _cluster[a];
            for (int b = 0; b < _clusterCount; b++)
            {
                int j = _cluster[b];
                if (j > i && MayMeet(i, _reaches[i], j, _reaches[j]))
                {
                    double until = Math.Min(Math.Min(end, first.Time), Math.Min(_trials[i].HaltsAt, _trials[j].HaltsAt));
                    double from = Math.Max(Math.Max(_trials[i].From, _trials[j].From), PressedUntil(i, j));
                    double time = _trials[i].Meets(_trials[j], Distance(i, j), from, until);
                    first = Precedes(time, i, j, in first) ? new Happening(time, i, j) : first;
                }
            }

            double halt = _trials[i].HaltsAt;
            first = Precedes(halt, i, Happening.NoOther, in first) ? new Happening(halt, i, Happening.NoOther) : first;
        }

        return first;
    }

    private static bool Precedes(double time, int ball, int other, in Happening first) =>
        time < first.Time || (time == first.Time && time < double.PositiveInfinity && (ball < first.Ball || (ball == first.Ball && other < first.Other)));

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
        presses |= rate > -BallContact.Gentle;
        ContactMaterial material = presses ? new ContactMaterial(0, 0, Contact.ImpactFriction) : _contact;
        BallContact.Impact(ball, other, in material, in n, in states[i], in states[j], out Motion first, out Motion second);
        StepLog own = LogOf(i, watched);
        StepLog its = LogOf(j, watched);
        if (presses)
        {
            own.Untold++;
            SetPressed(i, j, time);

            // What overlaps is put apart, each by its share.
            double share = other.Mass / (ball.Mass + other.Mass);
            double over = Math.Max(0, -gap);
            states[i].Position += share * over * n;
            states[j].Position -= (1.0 - share) * over * n;
        }
        else
        {
            own.Events.Add(new BallEvent(j, in n, time, in states[i], in first.Velocity, in first.Spin));
            its.Events.Add(new BallEvent(i, -n, time, in states[j], in second.Velocity, in second.Spin));
        }

        _simulators[i].Struck(ref states[i], in first.Velocity, in first.Spin, in n, presses, own);
        _simulators[j].Struck(ref states[j], in second.Velocity, in second.Spin, -n, presses, its);
        return stopAt == StopAt.Impact && !presses;
    }

    /// <summary>When two balls touch by their own steps: Newton's method from what their dense paths say.</summary>
    private double Locate(BallState[] states, in Happening met)
    {
        double from = Math.Max(states[met.Ball].Time, states[met.Other].Time);
        double time = Math.Max(from, met.Time);
        for (int k = 0; k < MostNewton; k++)
        {
            BallState a = Look(states, met.Ball, time);
            BallState b = Look(states, met.Other, time);
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

    /// <summary>Whether a ball may come to a place, in the rest of a step, where something is that was pushed, or would have been.</summary>
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
                Bounds3d box = world.BoundsOfMover(m, time);
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

    /// <summary>Adds the events of all balls in order of time, then of the balls; and the counts.</summary>
    private void Tell(StepLog log)
    {
        log.Steps += _flown.Steps;
        log.Evaluations += _flown.Evaluations;
        log.Stalled += _flown.Stalled;
        log.Untold += _flown.Untold;
        int told = 0;
        for (int i = 0; i < Count; i++)
        {
            // Of a ball that was played again counts what it did then.
            for (int k = _firstEvent[i]; k < _firstEvent[i + 1] && !_played[i]; k++)
            {
                Insert(in _flown.Events[k], told++);
            }
        }

        for (int k = 0; k < _clusterCount; k++)
        {
            StepLog own = _logs[_cluster[k]];
            _played[_cluster[k]] = false;
            log.Steps += own.Steps;
            log.Evaluations += own.Evaluations;
            log.Stalled += own.Stalled;
            log.Untold += own.Untold;
            for (int e = 0; e < own.Events.Count; e++)
            {
                Insert(in own.Events[e], told++);
            }
        }

        for (int k = 0; k < told; k++)
        {
            log.Events.Add(in _told[k]);
        }
    }

    /// <summary>Puts an event in its place among those of the step: by time, then by ball, then as they happened to it.</summary>
    private void Insert(in BallEvent happened, int count)
    {
        if (count == _told.Length)
        {
            Array.Resize(ref _told, 2 * count);
        }

        int place = count;
        for (; place > 0 && (_told[place - 1].Time > happened.Time || (_told[place - 1].Time == happened.Time && _told[place - 1].Ball > happened.Ball)); place--)
        {
            _told[place] = _told[place - 1];
        }

        _told[place] = happened;
    }

    /// <summary>Something that happens to one ball, or to two.</summary>
    private readonly struct Happening(double time, int ball, int other)
    {
        public readonly double Time = time;
        public readonly int Ball = ball;

        /// <summary>The other ball, or none.</summary>
        public readonly int Other = other;

        /// <summary>No other ball.</summary>
        public const int NoOther = int.MaxValue;

        /// <summary>Whether two balls meet.</summary>
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
