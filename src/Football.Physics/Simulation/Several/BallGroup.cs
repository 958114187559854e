using FootballPhysics.Contacts;
using FootballPhysics.Numerics;
using FootballPhysics.Simulation;

namespace FootballPhysics;

/// <summary>Several balls in one scene, stepped together. They collide at exact times and in the exact order.</summary>
/// <remarks>
/// Balls that are far apart cost one step and one comparison each. A group caches data between steps, so use it from one thread.
/// Groups that share a <see cref="Simulator"/> may step at the same time if the simulator can be shared between threads.
/// A ball's path depends on other balls only through contacts, so it is bit-identical in any group and order. The only exception is impacts at exactly the same
/// time: that of the ball with the lower index comes first. Two balls that approach each other at less than 1 cm/s are in sustained contact and form a pile.
/// The balls of a pile are solved together and come to rest together. The pile divides a step into parts of 2 ms, at most 16. A ball in a resting pile stores
/// its contacts in its state, and wakes if one is removed.
/// A pile treats objects with a mass as immovable.
/// </remarks>
public sealed partial class BallGroup
{
    /// <summary>Number of events per ball that a step can store without being repeated.</summary>
    private const int EventsOfBall = 16;

    private readonly Simulator[] _simulators;
    private readonly Simulator? _alone; // null if there are several balls, or if code of the game may throw within a step
    private readonly bool _mayThrow;
    private readonly bool[] _pushes;
    private readonly BallNeighbours _neighbours;
    private readonly BallState[] _before;
    private readonly StepLog[] _logs;
    private readonly double[] _reaches;
    private readonly StepLog _flown;
    private readonly int[] _firstEvent;
    private BallEvent[] _reported = new BallEvent[16];
    private readonly MotionSnapshot _motions;
    private readonly BallCluster _cluster;

    /// <summary>Creates a group of equal balls in one scene.</summary>
    /// <param name="simulator">The compiled scene.</param>
    /// <param name="count">The number of balls; 1 … 10 000.</param>
    /// <param name="contact">The material of contacts between two balls; default <see cref="SurfaceMaterial.Ball"/>.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A value is out of range. The message names the field, the value and the
    /// range.</exception>
    public BallGroup(Simulator simulator, int count, SurfaceMaterial? contact = null)
        : this(Repeat(simulator, count), contact)
    {
    }

    /// <summary>Creates a group of different balls.</summary>
    /// <param name="scene">The scene of all balls. Its own ball is not used.</param>
    /// <param name="balls">The balls; 1 … 10 000.</param>
    /// <param name="settings">The integrator and solver settings; default <see cref="SolverSettings.Default"/>.</param>
    /// <param name="contact">The material of contacts between two balls; default <see cref="SurfaceMaterial.Ball"/>.</param>
    /// <exception cref="ArgumentNullException">The scene, the balls or one of them is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A value is out of range. The message names the field, the value and the
    /// range.</exception>
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

        _motions = MotionSnapshot.OfPushed(world);
        _flown.Motions = _motions;
        _cluster = new BallCluster(simulators, new ContactMaterial(Contact, simulators.Min(simulator => simulator.Scene.Ball.Bounce)), Contact.ImpactFriction, _before, _reaches, _logs);
    }

    /// <summary>The number of balls.</summary>
    public int Count => _simulators.Length;

    /// <summary>The material of contacts between two balls.</summary>
    public SurfaceMaterial Contact { get; }

    /// <summary>Advances all balls by one step.</summary>
    /// <param name="states">The balls: one state per ball, all at the same time. Unchanged if an exception is thrown.</param>
    /// <param name="dt">The time to advance, in s; 0 … 1e12.</param>
    /// <param name="log">Receives the events of all balls, ordered by time and then by ball, and the counts.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">The number of states is wrong, their times differ, a state was never launched, or the log has an
    /// observer.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="dt"/> is out of range, or a body was moved for a time more than 0.25 s
    /// from the balls' time.</exception>
    public void Step(BallState[] states, double dt, StepLog log)
    {
        // A single ball takes its own step, without bookkeeping.
        if (_alone is not null && states is { Length: 1 } && log is { Observer: null })
        {
            BallState.Launched(in states[0]);
            _alone.Step(ref states[0], dt, log);
            return;
        }

        Step(states, dt, log, StopAt.Time, null);
    }

    /// <summary>Advances all balls in equal steps until an event or the end of the duration.</summary>
    /// <param name="states">The balls: one state per ball, all at the same time. If an event ends the run, these are the states just after
    /// it.</param>
    /// <param name="timeStep">The length of a step, in s; above 0, at most 1e12, at least 1e-12 of the duration. The last step is
    /// shortened.</param>
    /// <param name="duration">The maximum time to simulate, in s; above 0, at most 1e12.</param>
    /// <param name="stopAt">The event that ends the run: the first impact of any ball, or rest of all balls at the end of a step.</param>
    /// <param name="log">Receives the events of all balls, ordered by time and then by ball, and the counts.</param>
    /// <param name="afterStep">Called after every step, when the states are those at its end; default none.</param>
    /// <returns>True if the event ended the run; false if the time ran out.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">The number of states is wrong, their times differ, a state was never launched, or the log has an
    /// observer.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A value is out of range. The message names the field, the value and the
    /// range.</exception>
    public bool Run(BallState[] states, double timeStep, double duration, StopAt stopAt, StepLog log, Action? afterStep = null)
    {
        Check.Given(nameof(states), states);
        Check.Given(nameof(log), log);
        if (states.Length > 0)
        {
            Simulator.CheckRun(in states[0], timeStep, duration, stopAt);
        }

        // Take at least one step, because the step validates the states.
        double end = (states.Length > 0 ? states[0].Time : 0) + duration;
        double last = end - (ContactTolerances.StepRounding * timeStep);
        do
        {
            double left = end - (states.Length > 0 ? states[0].Time : 0);
            bool ended = Step(states, Math.Min(timeStep, left), log, stopAt == StopAt.Impact ? StopAt.Impact : StopAt.Time, null);
            afterStep?.Invoke();
            if (ended || (stopAt == StopAt.Rest && Array.TrueForAll(states, state => state.Motion == MotionState.Rest)))
            {
                return true;
            }
        }
        while (states[0].Time < last);
        return false;
    }

    /// <summary>Returns the compiled scene of a ball.</summary>
    /// <param name="ball">The index of the ball.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such ball.</exception>
    public Simulator SimulatorOf(int ball)
    {
        Check.Index(nameof(ball), ball, Count);
        return _simulators[ball];
    }

    /// <summary>Advances all balls up to the first event that ends the step.</summary>
    /// <param name="states">The balls.</param>
    /// <param name="dt">Time to advance, s.</param>
    /// <param name="log">Receives events and counts.</param>
    /// <param name="stopAt">The event that ends the step.</param>
    /// <param name="watched">One log per ball, whose observers receive the pieces; null without observers.</param>
    /// <returns>True if an event ended it.</returns>
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

        // A look-ahead does not end the moves for the next step.
        World world = _simulators[0].World;
        if (watched is null)
        {
            world.Bodies?.CheckTimes(states[0].Time);
        }

        // A single ball takes its own step, without bookkeeping.
        if (Count == 1 && log is not null)
        {
            return _mayThrow ? TryAlone(ref states[0], dt, log, stopAt) : StepAlone(ref states[0], dt, log, stopAt);
        }

        // Save the states, to restore them if a custom force throws, and to repeat the steps of balls that may collide.
        _motions.Begin();
        bool ended;
        Array.Copy(states, _before, Count);
        try
        {
            // Find the piles, step every other ball alone, find neighbours that may collide, and repeat the steps of balls with contacts.
            FindPiles(dt);
            bool pushes = Fly(states, dt, stopAt, out bool holds, out bool again);

            // Find the balls that share a pushed object before other steps: these may depend on the spheres of neighbours from earlier steps.
            _cluster.Clear();
            _cluster.ForgetShares();
            if (pushes)
            {
                _cluster.FindShares(_motions, dt);
            }

            if (!holds)
            {
                RenewNeighbours(dt, again);
            }

            FindCluster(all: again || stopAt == StopAt.Impact || watched is not null, pushes);
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
            Report(log);
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

            // Balls with equal properties share a compiled scene.
            int same = 0;
            while (same < i && !balls[same].Equals(balls[i]))
            {
                same++;
            }

            // All balls share the motions of pushed objects.
            Scene its = scene with { Ball = balls[i], Motions = i > 0 ? all[0].World.Obstacles : null };
            all[i] = same < i ? all[same] : new Simulator(its, settings);
        }

        return all;
    }

    /// <summary>Steps a single ball with code of the game. If that throws, the ball is unchanged.</summary>
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

    /// <summary>Steps a single ball.</summary>
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
