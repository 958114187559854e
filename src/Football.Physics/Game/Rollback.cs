namespace FootballPhysics.Netcode;

/// <summary>Keeps the last states of a runner, and plays them again when a kick of the past becomes known, or was guessed wrongly.</summary>
/// <remarks>
/// It follows every step that the runner makes, in <see cref="FixedStepRunner.Step"/> as in <see cref="FixedStepRunner.Advance"/>; where the
/// runner goes elsewhere by itself, it begins anew from there. Steps that are played again have the game's bodies where they were: by
/// <see cref="FixedStepRunner.MoveBodies"/>, or by the places that it keeps of the last ticks. An engine's colliders that moved need the former; without it they are refused.
/// Nothing is allocated but where events, kicks or places outgrow their memory.
/// </remarks>
public sealed class Rollback
{
    private readonly BallState[] _states;
    private readonly RigidMotion[] _motions;
    private readonly PlacementLog? _bodies;
    private readonly PlacementLog _waiting = new();
    private readonly BallState[] _from;
    private readonly int _balls;
    private readonly int _movers;
    private readonly int _ticks;
    private long _bodiesMoved = -1;
    /// <summary>Where the last steps that were played again first came out otherwise.</summary>
    private StateDifference? _difference;

    private bool _replays;

    /// <summary>Begins to follow a runner, from its present tick on.</summary>
    /// <param name="runner">The runner; one rollback follows it, the last that was made.</param>
    /// <param name="ticks">How many ticks back it can go. 1 … 1 000 000; default 32.</param>
    /// <param name="keepsBodies">Whether it keeps where the game has put its bodies at each tick; default it does. A game that sets <see cref="FixedStepRunner.MoveBodies"/> need not.</param>
    /// <exception cref="ArgumentNullException"><paramref name="runner"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="ticks"/> is out of range.</exception>
    public Rollback(FixedStepRunner runner, int ticks = 32, bool keepsBodies = true)
    {
        Runner = runner ?? throw new ArgumentNullException(nameof(runner));
        Check.Within(nameof(ticks), ticks, 1, 1_000_000);
        _ticks = ticks;
        _balls = runner.Balls;
        _movers = runner.Simulator.World.Movers;
        _bodies = keepsBodies ? new PlacementLog() : null;

        // Rings of ticks + 1 places, the present among them: tick t lies at t mod (ticks + 1).
        _states = new BallState[(ticks + 1) * _balls];
        _motions = new RigidMotion[(ticks + 1) * _movers];
        _from = new BallState[_balls];
        runner.History = this;
        Begin(runner.Tick);
    }

    /// <summary>The runner that it follows.</summary>
    public FixedStepRunner Runner { get; }

    /// <summary>How many ticks back it can go.</summary>
    public int Ticks => _ticks;

    /// <summary>The oldest tick that it can go back to.</summary>
    public long OldestTick { get; private set; }

    /// <summary>The events of the steps that the last correction played again, in order of time.</summary>
    public EventBuffer Events { get; } = new();

    /// <summary>The state at the start of a tick.</summary>
    /// <param name="tick">From <see cref="OldestTick"/> to the runner's tick.</param>
    /// <param name="ball">Which of several balls; default the first.</param>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not kept, or there is no such ball.</exception>
    public BallState StateAt(long tick, int ball = 0)
    {
        Check.Within(nameof(tick), tick, OldestTick, Runner.Tick);
        Check.Index(nameof(ball), ball, _balls);
        return _states[PlaceOf(tick) + ball];
    }

    /// <summary>The hash of the states of all balls at the start of a tick: what two machines compare.</summary>
    /// <param name="tick">From <see cref="OldestTick"/> to the runner's tick.</param>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not kept.</exception>
    public ulong HashAt(long tick)
    {
        Check.Within(nameof(tick), tick, OldestTick, Runner.Tick);
        Array.Copy(_states, PlaceOf(tick), _from, 0, _balls);
        return Snapshot.Hash(_from);
    }

    /// <summary>Puts a kick in its place, or in the place of one of the same player, tick and ball, and plays what followed again.</summary>
    /// <param name="kick">The kick; of a tick not before <see cref="OldestTick"/>. One to come only waits.</param>
    /// <returns>The first tick whose state is not what it was, to the last bit; null where all are.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not kept any more; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">Bodies, or an engine's colliders, moved since, and nothing says where they were; nothing has changed.</exception>
    public long? ApplyKick(in KickInput kick)
    {
        Check.AtLeast(nameof(kick), kick.Tick, OldestTick);
        Check.Index("kick.ball", kick.Ball, _balls);
        RefuseUnknownPlaces(kick.Tick);
        Runner.Kicks.Add(in kick);
        return PlayAgain(kick.Tick);
    }

    /// <summary>Takes a kick back that was only guessed, and plays what followed again.</summary>
    /// <param name="tick">Its tick; not before <see cref="OldestTick"/>.</param>
    /// <param name="player">Its player; default 0.</param>
    /// <param name="ball">Its ball; default 0.</param>
    /// <returns>The first tick whose state is not what it was, to the last bit; null where all are, or there was no such kick.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not kept any more; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">Bodies, or an engine's colliders, moved since, and nothing says where they were; nothing has changed.</exception>
    public long? Remove(long tick, int player = 0, int ball = 0)
    {
        Check.AtLeast(nameof(tick), tick, OldestTick);
        RefuseUnknownPlaces(tick);
        return Runner.Kicks.Remove(tick, player, ball) ? PlayAgain(tick) : null;
    }

    /// <summary>Sets the state at a tick, for instance a server's, and plays what followed again.</summary>
    /// <param name="tick">From <see cref="OldestTick"/> to the runner's tick.</param>
    /// <param name="state">The state at its start.</param>
    /// <param name="ball">Which of several balls; default the first.</param>
    /// <returns>The first tick whose state is not what it was, to the last bit; null where all are.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not kept, there is no such ball, or none of this scene can have the state; nothing has changed.</exception>
    /// <exception cref="ArgumentException"><paramref name="state"/> was never launched, or is of another time than the other balls; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">Bodies, or an engine's colliders, moved since, and nothing says where they were; nothing has changed.</exception>
    public long? ApplyServerState(long tick, in BallState state, int ball = 0)
    {
        BallState before = StateAt(tick, ball);
        if (Snapshot.Same(in before, in state))
        {
            return null;
        }

        BallState.Launched(in state);
        Runner.SimulatorOf(ball).Validate(in state);
        return Put(tick, in state, ball);
    }

    /// <summary>Sets a state that has been looked at, and plays what followed again.</summary>
    internal long? Put(long tick, in BallState state, int ball)
    {
        BallState before = StateAt(tick, ball);
        if (_balls > 1 && state.Time != before.Time)
        {
            throw new ArgumentException(FormattableString.Invariant($"state.time is {state.Time:R}; allowed: {before.Time:R}, the time of the other balls."), nameof(state));
        }

        RefuseUnknownPlaces(tick);

        // Put into the ring: PlayAgain starts from there.
        _states[PlaceOf(tick) + ball] = state;

        // Nothing follows the present that could be played: the runner itself is set, without forgetting the past for it.
        if (tick == Runner.Tick)
        {
            _replays = true;
            Array.Copy(_states, PlaceOf(tick), _from, 0, _balls);
            Runner.GoTo(tick, _from);
            _replays = false;
        }

        PlayAgain(tick);
        return tick;
    }

    /// <summary>Plays again from a tick on, after what <see cref="FixedStepRunner.MoveBodies"/> says, or what is in <see cref="FixedStepRunner.Kicks"/>, has changed: once for all that has.</summary>
    /// <param name="tick">From <see cref="OldestTick"/> to the runner's tick.</param>
    /// <returns>The first tick whose state is not what it was, to the last bit; null where all are.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not kept; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">Bodies, or an engine's colliders, moved since, and nothing says where they were; nothing has changed.</exception>
    public long? ResimulateFrom(long tick)
    {
        Check.Within(nameof(tick), tick, OldestTick, Runner.Tick);
        RefuseUnknownPlaces(tick);
        return PlayAgain(tick);
    }

    /// <summary>
    /// Plays the last ticks again from the state that was kept, and compares: for tests, in every tick of a match. A difference means that something is not
    /// in the state: a force or a body of the game's that depends on more than the time, or an engine's collider that moved.
    /// </summary>
    /// <param name="ticks">How many ticks to go back; 1 … <see cref="Ticks"/>. Fewer where fewer are kept.</param>
    /// <returns>The first tick, ball and field that came out otherwise; null where all are the same to the last bit.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The number of ticks is out of range.</exception>
    /// <exception cref="InvalidOperationException">Bodies, or an engine's colliders, moved since, and nothing says where they were; nothing has changed.</exception>
    public StateDifference? SyncTest(int ticks)
    {
        Check.Within(nameof(ticks), ticks, 1, Ticks);
        long from = Math.Max(OldestTick, Runner.Tick - ticks);
        RefuseUnknownPlaces(from);
        PlayAgain(from);
        return _difference;
    }

    /// <summary>Begins anew where the runner went.</summary>
    internal void Begin(long tick)
    {
        // A runner that plays again comes here too: then the ring is still that of the match.
        if (!_replays)
        {
            OldestTick = tick;
            _bodies?.RemoveFrom(0);
            _bodiesMoved = -1;
            Keep(tick);
        }
    }

    /// <summary>Keeps the states after a step.</summary>
    internal void Keep(long tick)
    {
        if (_replays)
        {
            return;
        }

        // The oldest place is written over, and what was kept of bodies before it is not needed any more.
        OldestTick = Math.Max(OldestTick, tick - Ticks);
        Array.Copy(Runner.States, 0, _states, PlaceOf(tick), _balls);
        KeepMotions(tick);
        _bodies?.RemoveBefore(OldestTick);
    }

    /// <summary>Keeps where the game has put its bodies for a tick's step.</summary>
    internal void KeepBodies(long tick, KinematicBodies bodies)
    {
        if (_replays)
        {
            return;
        }

        _bodies?.Record(tick, bodies);

        // Known even where they are not kept: the last tick at which one moved says how far back nobody can go.
        for (int i = 0; i < bodies.Count && _bodiesMoved < tick; i++)
        {
            _bodiesMoved = bodies.IsTold(i) ? tick : _bodiesMoved;
        }
    }

    /// <summary>Puts the bodies where they were for a step that is played again.</summary>
    internal void PutBodies(long tick, KinematicBodies bodies)
    {
        if (_replays)
        {
            _bodies?.Apply(tick, bodies);
        }
    }

    private int PlaceOf(long tick) => (int)(tick % (_ticks + 1)) * _balls;

    private Span<RigidMotion> MotionsAt(long tick) => _motions.AsSpan((int)(tick % (_ticks + 1)) * _movers, _movers);

    private void KeepMotions(long tick)
    {
        if (_movers > 0)
        {
            Runner.Simulator.World.ReadMotions(MotionsAt(tick));
        }
    }

    /// <summary>Refuses to play steps again in which something moved of which nobody says where it was.</summary>
    private void RefuseUnknownPlaces(long from)
    {
        // The game that says where bodies are at any time can be asked again.
        if (Runner.MoveBodies is not null || from >= Runner.Tick)
        {
            return;
        }

        if (Runner.EngineMoved >= from)
        {
            throw new InvalidOperationException(
                $"Engine colliders moved at tick {Runner.EngineMoved}, so that tick cannot be resimulated. Set runner.MoveBodies, which positions them at any time.");
        }

        if (_bodies is null && _bodiesMoved >= from)
        {
            throw new InvalidOperationException(
                $"Bodies moved at tick {_bodiesMoved}, so that tick cannot be resimulated. Set runner.MoveBodies, or create the Rollback with keepsBodies: true.");
        }
    }

    /// <summary>Plays from a tick to the present.</summary>
    private long? PlayAgain(long from)
    {
        Events.Clear();
        _difference = null;
        long now = Runner.Tick;
        long? first = null;
        if (from >= now)
        {
            return null;
        }

        // Bodies that the game has moved for the step to come are put there again afterwards.
        World world = Runner.Simulator.World;
        _waiting.RemoveFrom(0);
        if (world.Bodies is { } bodies)
        {
            _waiting.Record(now, bodies);
            bodies.ForgetTimes();
        }

        _replays = true;
        try
        {
            // Bodies, then balls, as they were at that tick; from there with the kicks that are known now.
            if (_movers > 0)
            {
                world.WriteMotions(MotionsAt(from));
            }

            Array.Copy(_states, PlaceOf(from), _from, 0, _balls);
            Runner.GoTo(from, _from);
            while (Runner.Tick < now)
            {
                Runner.Step();
                Events.Add(Runner.Events);

                // What comes out takes the place of what was kept; the first tick that differs is told.
                bool same = true;
                for (int i = 0; i < _balls; i++)
                {
                    ref BallState kept = ref _states[PlaceOf(Runner.Tick) + i];
                    if (!Snapshot.Same(in kept, in Runner.States[i]))
                    {
                        same = false;
                        _difference ??= Snapshot.Difference(in kept, in Runner.States[i])?.At(Runner.Tick, i);
                    }

                    kept = Runner.States[i];
                }

                KeepMotions(Runner.Tick);
                first ??= same ? null : Runner.Tick;
            }
        }
        finally
        {
            _replays = false;
        }

        // The step to come finds the bodies where the game put them before all this.
        if (world.Bodies is { } moved)
        {
            _waiting.Apply(now, moved);
        }

        return first;
    }
}
