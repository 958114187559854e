using FootballPhysics.Contacts;
using FootballPhysics.Game;
using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Netcode;

/// <summary>Stores the last states of a runner, and resimulates them when a kick arrives late or was mispredicted.</summary>
/// <remarks>
/// The state is stored at every step of the runner, in <see cref="FixedStepRunner.Step"/> and in <see cref="FixedStepRunner.Advance"/>. If the runner's state
/// is set from outside, the history restarts there. Resimulation needs the past positions of the game's bodies. These positions come from
/// <see cref="FixedStepRunner.MoveBodies"/>, or from the positions stored for the last ticks. If an engine's colliders moved, resimulation throws without
/// <see cref="FixedStepRunner.MoveBodies"/>. A rollback allocates only when events, kicks or positions outgrow their buffers.
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
    private long _begun;
    /// <summary>The first difference found by the last resimulation.</summary>
    private StateDifference? _difference;

    private bool _replays;

    /// <summary>Attaches to a runner, and stores its states from the current tick on.</summary>
    /// <param name="runner">The runner; a new rollback replaces an earlier one.</param>
    /// <param name="ticks">The number of ticks that a rollback can go back. 1 … 1 000 000; default 32.</param>
    /// <param name="keepsBodies">True to store the bodies' positions at each tick; default true. Not needed if the game sets
    /// <see cref="FixedStepRunner.MoveBodies"/>.</param>
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

        // Ring buffers with one slot for each of the last ticks and one for the present: tick t is stored at t mod (ticks + 1).
        _states = new BallState[(ticks + 1) * _balls];
        _motions = new RigidMotion[(ticks + 1) * _movers];
        _from = new BallState[_balls];
        runner.History = this;
        Begin(runner.Tick);
    }

    /// <summary>The runner to which it is attached.</summary>
    public FixedStepRunner Runner { get; }

    /// <summary>The number of ticks that a rollback can go back.</summary>
    public int Ticks => _ticks;

    /// <summary>The oldest tick to which a rollback can go back.</summary>
    public long OldestTick { get; private set; }

    /// <summary>The events of the steps that the last correction resimulated, in order of time.</summary>
    public EventBuffer Events { get; } = new();

    /// <summary>Returns the state at the start of a tick.</summary>
    /// <param name="tick">From <see cref="OldestTick"/> to the runner's tick.</param>
    /// <param name="ball">The index of the ball; default 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not stored, or there is no such ball.</exception>
    public BallState StateAt(long tick, int ball = 0)
    {
        Check.Within(nameof(tick), tick, OldestTick, Runner.Tick);
        Check.Index(nameof(ball), ball, _balls);
        return _states[PlaceOf(tick) + ball];
    }

    /// <summary>Returns the hash of all states at the start of a tick, for comparison between machines.</summary>
    /// <param name="tick">From <see cref="OldestTick"/> to the runner's tick.</param>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not stored.</exception>
    public ulong HashAt(long tick)
    {
        Check.Within(nameof(tick), tick, OldestTick, Runner.Tick);
        Array.Copy(_states, PlaceOf(tick), _from, 0, _balls);
        return Snapshot.Hash(_from);
    }

    /// <summary>Adds or replaces a kick, and resimulates the steps since its tick.</summary>
    /// <remarks>The new kick replaces any kick with the same player, tick and ball.</remarks>
    /// <param name="kick">The kick; its tick is <see cref="OldestTick"/> or later. A future kick waits for its tick.</param>
    /// <returns>The first tick whose state changed; null if all are bit-identical.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The tick is no longer stored; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">Bodies, or an engine's colliders, moved since, and their past positions are unknown; nothing has
    /// changed.</exception>
    public long? ApplyKick(in KickInput kick)
    {
        RefuseForgotten("kick.tick", kick.Tick);
        RefuseUnknownPlaces(kick.Tick);

        // The log rejects a ball that the runner does not have, before anything changes.
        Runner.Kicks.Add(in kick);
        return PlayAgain(kick.Tick);
    }

    /// <summary>Removes a mispredicted kick, and resimulates the steps since its tick.</summary>
    /// <param name="tick">The tick; <see cref="OldestTick"/> or later.</param>
    /// <param name="player">The player; default 0.</param>
    /// <param name="ball">The ball; default 0.</param>
    /// <returns>The first tick whose state changed; null if all are bit-identical, or there was no such kick.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The tick is no longer stored; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">Bodies, or an engine's colliders, moved since, and their past positions are unknown; nothing has
    /// changed.</exception>
    public long? Remove(long tick, int player = 0, int ball = 0)
    {
        RefuseForgotten(nameof(tick), tick);
        RefuseUnknownPlaces(tick);
        return Runner.Kicks.Remove(tick, player, ball) ? PlayAgain(tick) : null;
    }

    /// <summary>Sets the state at a tick, for instance from a server, and resimulates the following steps.</summary>
    /// <param name="tick">From <see cref="OldestTick"/> to the runner's tick.</param>
    /// <param name="state">The state at the start of the tick.</param>
    /// <param name="ball">The index of the ball; default 0.</param>
    /// <returns>The first tick whose state changed; null if all are bit-identical.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not stored, there is no such ball, or no ball of this scene can have the state;
    /// nothing has changed.</exception>
    /// <exception cref="ArgumentException"><paramref name="state"/> was never launched, or its time differs from that of the other balls; nothing has
    /// changed.</exception>
    /// <exception cref="InvalidOperationException">Bodies, or an engine's colliders, moved since, and their past positions are unknown; nothing has
    /// changed.</exception>
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

    /// <summary>Sets a validated state, and resimulates the following steps.</summary>
    internal long? Put(long tick, in BallState state, int ball)
    {
        BallState before = StateAt(tick, ball);
        if (_balls > 1 && state.Time != before.Time)
        {
            throw new ArgumentException(FormattableString.Invariant($"state.time is {state.Time:R}; allowed: {before.Time:R}, the time of the other balls."), nameof(state));
        }

        RefuseUnknownPlaces(tick);

        // Store the state in the ring buffer, because PlayAgain starts from there.
        _states[PlaceOf(tick) + ball] = state;

        // At the present tick, there is nothing to resimulate: give the runner the new state, and keep the history.
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

    /// <summary>Resimulates from a tick after changes to <see cref="FixedStepRunner.Kicks"/> or <see cref="FixedStepRunner.MoveBodies"/>.</summary>
    /// <remarks>A single call covers any number of changes since that tick.</remarks>
    /// <param name="tick">From <see cref="OldestTick"/> to the runner's tick.</param>
    /// <returns>The first tick whose state changed; null if all are bit-identical.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not stored; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">Bodies, or an engine's colliders, moved since, and their past positions are unknown; nothing has
    /// changed.</exception>
    public long? ResimulateFrom(long tick)
    {
        Check.Within(nameof(tick), tick, OldestTick, Runner.Tick);
        RefuseUnknownPlaces(tick);
        return PlayAgain(tick);
    }

    /// <summary>Resimulates the last ticks from a stored state, and compares the results.</summary>
    /// <remarks>
    /// Use it in tests, at every tick of a match. A difference means that the simulation depends on data outside the state. Likely causes are a custom force or
    /// a body that depends on more than time, or a moving engine collider.
    /// </remarks>
    /// <param name="ticks">The number of ticks to go back; 1 … <see cref="Ticks"/>. If fewer ticks are stored, only those are resimulated.</param>
    /// <returns>The first tick, ball and field that differ; null if all are bit-identical.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The number of ticks is out of range.</exception>
    /// <exception cref="InvalidOperationException">Bodies, or an engine's colliders, moved since, and their past positions are unknown; nothing has
    /// changed.</exception>
    public StateDifference? SyncTest(int ticks)
    {
        Check.Within(nameof(ticks), ticks, 1, Ticks);
        long from = Math.Max(OldestTick, Runner.Tick - ticks);
        RefuseUnknownPlaces(from);
        PlayAgain(from);
        return _difference;
    }

    /// <summary>Restarts the history at the runner's new tick.</summary>
    internal void Begin(long tick)
    {
        // A resimulation also calls this method, and must not replace the match's ring buffer.
        if (!_replays)
        {
            OldestTick = tick;
            _begun = tick;
            _bodies?.RemoveFrom(0);
            _bodiesMoved = -1;
            Keep(tick);
        }
    }

    /// <summary>Stores the states after a step.</summary>
    internal void Keep(long tick)
    {
        if (_replays)
        {
            return;
        }

        // Overwrite the oldest slot; body positions before the oldest tick are no longer needed.
        OldestTick = Math.Max(OldestTick, tick - Ticks);
        Array.Copy(Runner.States, 0, _states, PlaceOf(tick), _balls);
        Runner.Simulator.World.ReadMotions(MotionsAt(tick));
        _bodies?.RemoveBefore(OldestTick);
    }

    /// <summary>Stores the positions of the game's bodies for a tick's step.</summary>
    internal void KeepBodies(long tick, KinematicBodies bodies)
    {
        if (_replays)
        {
            return;
        }

        _bodies?.Record(tick, bodies);

        // Track this even if no positions are stored: the last tick with a moved body limits how far back a rollback can go.
        for (int i = 0; i < bodies.Count && _bodiesMoved < tick; i++)
        {
            _bodiesMoved = bodies.WasMoved(i) ? tick : _bodiesMoved;
        }
    }

    /// <summary>Moves the bodies to their stored positions for a resimulated step.</summary>
    internal void PutBodies(long tick, KinematicBodies bodies)
    {
        if (_replays)
        {
            _bodies?.Apply(tick, bodies);
        }
    }

    /// <summary>Throws if the state of a tick is no longer stored.</summary>
    private void RefuseForgotten(string field, long tick)
    {
        if (tick < OldestTick)
        {
            string cause = OldestTick == _begun
                ? "The history begins there, because the Rollback was attached, or a ball was placed or restored, at that tick"
                : FormattableString.Invariant($"This Rollback stores {Ticks} ticks. Attach one with more ticks, or apply a server's state");
            throw Check.Refusal(field, FormattableString.Invariant($"{tick}"), FormattableString.Invariant($"{OldestTick} or more. {cause}"));
        }
    }

    private int PlaceOf(long tick) => (int)(tick % (_ticks + 1)) * _balls;

    private Span<RigidMotion> MotionsAt(long tick) => _motions.AsSpan((int)(tick % (_ticks + 1)) * _movers, _movers);

    /// <summary>Throws if an object moved in the steps to resimulate and its past positions are unknown.</summary>
    private void RefuseUnknownPlaces(long from)
    {
        // MoveBodies can position the bodies at any time in the past.
        if (Runner.MoveBodies is not null)
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

    /// <summary>Resimulates from a tick to the present, with the current kicks; returns the first tick that differs.</summary>
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

        // Save the bodies that the game has already moved for the next step; restore them afterwards.
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
            // Restore the bodies, then the balls, at this tick, and simulate from there with the current kicks.
            world.WriteMotions(MotionsAt(from));
            Array.Copy(_states, PlaceOf(from), _from, 0, _balls);
            Runner.GoTo(from, _from);
            while (Runner.Tick < now)
            {
                Runner.Step();
                Events.Add(Runner.Events);

                // Store the new results, and remember the first tick that differs.
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

                world.ReadMotions(MotionsAt(Runner.Tick));
                first ??= same ? null : Runner.Tick;
            }
        }
        finally
        {
            _replays = false;
        }

        // Restore the body positions that the game has set for the next step.
        if (world.Bodies is { } moved)
        {
            _waiting.Apply(now, moved);
        }

        return first;
    }
}
