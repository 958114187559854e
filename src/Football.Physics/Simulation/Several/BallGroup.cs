namespace FootballPhysics;

/// <summary>Several balls among the same things, stepped together: they hit one another at exact times, in exact order. A training ground's fifty, or two.</summary>
/// <remarks>
/// Balls far from one another cost a step each, and a comparison. A group keeps what it has found of them between steps, so it is for one thread; groups that share a
/// <see cref="Simulator"/> may step at the same time where that may be shared. What a ball does depends on the others only where they meet: the bits are the same in any group, and in
/// any order, but for impacts at exactly one time: of those the ball of the lower number has its first. A group of one costs what its ball does.
/// Two balls that come together slower than 1 cm/s press each other without a bounce: they are a pile, whose balls are solved as one and come to rest together. Up to eight of them, among
/// what stands still, go by whole steps of the method as long as their contacts stick, slip and bear as they do; else, and where they are more, in parts of 2 ms, at most 16 a step. A ball of a resting pile keeps in its state what it touches, and moves when that is taken away. Against a pile what has a mass stands firm.
/// </remarks>
public sealed partial class BallGroup
{
    /// <summary>So many events a ball are kept of a step without playing it again.</summary>
    private const int EventsOfBall = 16;

    private readonly Simulator[] _simulators;
    private readonly Simulator? _alone; // null if there are several balls, or code of the game may throw within a step
    private readonly bool _mayThrow;
    private readonly bool[] _pushes;
    private readonly BallNeighbours _neighbours;
    private readonly BallState[] _before;
    private readonly StepLog[] _logs;
    private readonly double[] _reaches;
    private readonly BallTrial _measure = new();
    private readonly StepLog _flown;
    private readonly int[] _firstEvent;
    private BallEvent[] _told = new BallEvent[16];
    private readonly MotionsBefore _motions;
    private readonly BallCluster _cluster;

    /// <summary>A group of equal balls in one scene.</summary>
    /// <param name="simulator">The compiled scene.</param>
    /// <param name="count">How many balls; 1 … 10 000.</param>
    /// <param name="contact">What two balls are to each other; default <see cref="SurfaceMaterial.Ball"/>.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public BallGroup(Simulator simulator, int count, SurfaceMaterial? contact = null)
        : this(Repeat(simulator, count), contact)
    {
    }

    /// <summary>A group of balls that differ.</summary>
    /// <param name="scene">The scene of all of them; its own ball is none of them.</param>
    /// <param name="balls">The balls; 1 … 10 000.</param>
    /// <param name="settings">How to integrate; default <see cref="SolverSettings.Default"/>.</param>
    /// <param name="contact">What two balls are to each other; default <see cref="SurfaceMaterial.Ball"/>.</param>
    /// <exception cref="ArgumentNullException">The scene, the balls or one of them is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public BallGroup(Scene scene, IReadOnlyList<BallProperties> balls, SolverSettings? settings = null, SurfaceMaterial? contact = null)
        : this(Compile(scene, balls, settings), contact)
    {
    }

    private BallGroup(Simulator[] simulators, SurfaceMaterial? contact)
    {
        Contact = contact ?? SurfaceMaterial.Ball;
        Contact.Validate("ballContact", mayAdd: false);
        int count = simulators.Length;
        _simulators = simulators;
        World world = simulators[0].World;
        Scene scene = simulators[0].Scene;
        _mayThrow = scene.Forces.CustomForces.Count > 0 || scene.Air.WindField is not null || world.Engine is not null;
        _alone = count == 1 && !_mayThrow ? simulators[0] : null;
        _pushes = new bool[count];
        _neighbours = new BallNeighbours([.. simulators.Select(simulator => simulator.Scene.Ball.Radius)]);
        _before = new BallState[count];
        _reaches = new double[count];
        _firstEvent = new int[count + 1];
        _flown = new StepLog(mostEvents: Math.Max(EventBuffer.DefaultMost, EventsOfBall * count));
        _logs = new StepLog[count];
        for (int i = 0; i < count; i++)
        {
            _logs[i] = new StepLog();
        }

        _motions = new MotionsBefore(world);
        _flown.Motions = _motions;
        _cluster = new BallCluster(simulators, new ContactMaterial(Contact, simulators.Min(simulator => simulator.Scene.Ball.Bounce)), Contact.ImpactFriction, _before, _reaches, _logs);
    }

    /// <summary>How many balls there are.</summary>
    public int Count => _simulators.Length;

    /// <summary>SurfaceMaterial of an impact between two balls.</summary>
    public SurfaceMaterial Contact { get; }

    /// <summary>Advances all balls.</summary>
    /// <param name="states">The balls, as many as the group has, all of one time; unchanged where an exception is thrown.</param>
    /// <param name="dt">Time to advance by, s: 0 … 1e12.</param>
    /// <param name="log">Where the events of all are added, in order of time, then of the balls, and the counts.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">The states are not as many as the balls, or not of one time, or one was never launched; or the log has an observer.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="dt"/> is out of range, or a body was moved since the last step for a time more than 0.25 s from the balls'.</exception>
    public void Step(BallState[] states, double dt, StepLog log)
    {
        // One ball takes its own step, without bookkeeping.
        if (_alone is not null && states is { Length: 1 } && log is { Observer: null })
        {
            BallState.Launched(in states[0]);
            _alone.Step(ref states[0], dt, log);
            return;
        }

        Step(states, dt, log, StopAt.Time, null);
    }

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
    public bool Run(BallState[] states, double timeStep, double duration, StopAt stopAt, StepLog log) => Run(states, timeStep, duration, stopAt, log, null);

    /// <summary>Steps all balls until an event or a time, and calls back after every step.</summary>
    /// <param name="states">The balls, as in the other overload.</param>
    /// <param name="timeStep">Length of a step, s, as in the other overload.</param>
    /// <param name="duration">How long to go on at most, s; above 0, at most 1e12.</param>
    /// <param name="stopAt">The event that ends the run, as in the other overload.</param>
    /// <param name="log">Where the events of all are added, in order of time, then of the balls, and the counts.</param>
    /// <param name="afterStep">Called after every step, when the states are those at its end; null: nobody is.</param>
    /// <returns>True when the event ended the run, false when its time did.</returns>
    /// <exception cref="ArgumentNullException">States or log are null.</exception>
    /// <exception cref="ArgumentException">The states are not as many as the balls, or not of one time, or one was never launched; or the log has an observer.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public bool Run(BallState[] states, double timeStep, double duration, StopAt stopAt, StepLog log, Action? afterStep)
    {
        Check.Given(nameof(states), states);
        Check.Given(nameof(log), log);
        if (states.Length > 0)
        {
            Simulator.CheckRun(in states[0], timeStep, duration, stopAt);
        }

        return Run(states, timeStep, duration, stopAt, log, null, afterStep is null ? null : (in BallState _) => afterStep());
    }

    /// <summary>Runs the balls with logs that watch their paths, and a callback after every step.</summary>
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
            if (ended || (stopAt == StopAt.Rest && Array.TrueForAll(states, state => state.Motion == MotionState.Rest)))
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
            throw new ArgumentException("A BallGroup does not support StepLog.Observer. Use LookAhead to get paths.", nameof(log));
        }

        Check.Within(nameof(dt), dt, 0, Limits.Time);
        if (states.Length != Count)
        {
            throw new ArgumentException($"states.Length is {states.Length}; allowed: {Count}, one state for each ball of the group.", nameof(states));
        }

        World world = _simulators[0].World;
        world.Bodies?.CheckTimes(states[0].Time);

        // One ball takes its own step, without bookkeeping.
        if (Count == 1 && log is not null)
        {
            return _mayThrow ? TryAlone(ref states[0], dt, log, stopAt) : StepAlone(ref states[0], dt, log, stopAt);
        }

        // To go back to, where balls may meet or a force throws.
        _motions.Begin();
        bool ended;
        Array.Copy(states, _before, Count);
        try
        {
            // 0. What lies on each other. 1. Every other ball as if there were no other. 2. The neighbours that may have met. 3. Those again, meeting by meeting.
            FindPiles(dt);
            bool pushes = Fly(states, dt, stopAt, out bool holds, out bool again);
            if (!holds)
            {
                RenewNeighbours(dt, again);
            }

            FindCluster(all: again || stopAt == StopAt.Impact || watched is not null, pushes, dt);
            ended = _cluster.Count > 0 && _cluster.Play(states, dt, stopAt, watched, _motions);
            if (world.MayGiveWay)
            {
                ForgetSpaceAhead(states);
            }
        }
        catch
        {
            Array.Copy(_before, states, Count);
            _motions.PutBack();
            _cluster.Abandon();
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

            // Equal balls share a compiled scene.
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

    /// <summary>The step of one ball that calls code of the game: if that throws, nothing has changed.</summary>
    private bool TryAlone(ref BallState state, double dt, StepLog log, StopAt stopAt)
    {
        _before[0] = state;
        _motions.Begin();
        _motions.Read();
        try
        {
            return StepAlone(ref state, dt, log, stopAt);
        }
        catch
        {
            state = _before[0];
            _motions.PutBack();
            throw;
        }
    }

    /// <summary>The step of one ball.</summary>
    private bool StepAlone(ref BallState state, double dt, StepLog log, StopAt stopAt)
    {
        BallState.Launched(in state);
        log.Halted = false;
        log.StopAt = stopAt;
        log.Pushes = true;
        log.HaltsAtPush = false;
        log.Events.Ball = 0;
        _simulators[0].Advance(ref state, dt, log);
        return log.Halted;
    }
}
