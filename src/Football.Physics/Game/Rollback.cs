namespace Football.Physics.Netcode;

/// <summary>Keeps the last states of a runner, and plays them again when a kick of the past becomes known, or was guessed wrongly.</summary>
/// <remarks>
/// It follows every step that the runner makes, in <see cref="FixedStepRunner.Step"/> as in <see cref="FixedStepRunner.Advance"/>; where the
/// runner goes elsewhere by itself, it begins anew from there. Nothing is allocated but where events or kicks outgrow their memory.
/// </remarks>
public sealed class Rollback
{
    private readonly BallState[] _states;
    private bool _replays;

    /// <summary>Begins to follow a runner, from its present tick on.</summary>
    /// <param name="runner">The runner; one rollback follows it, the last that was made.</param>
    /// <param name="ticks">How many ticks back it can go. 1 … 1 000 000; default 32.</param>
    /// <exception cref="ArgumentNullException"><paramref name="runner"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="ticks"/> is out of range.</exception>
    public Rollback(FixedStepRunner runner, int ticks = 32)
    {
        Runner = runner ?? throw new ArgumentNullException(nameof(runner));
        Check.Within(nameof(ticks), ticks, 1, 1_000_000);
        _states = new BallState[ticks + 1];
        runner.History = this;
        Begin(runner.Tick, runner.State);
    }

    /// <summary>The runner that it follows.</summary>
    public FixedStepRunner Runner { get; }

    /// <summary>How many ticks back it can go.</summary>
    public int Ticks => _states.Length - 1;

    /// <summary>The oldest tick that it can go back to.</summary>
    public long OldestTick { get; private set; }

    /// <summary>The events of the steps that the last correction played again, in order of time.</summary>
    public EventBuffer Events { get; } = new();

    /// <summary>The state at the start of a tick.</summary>
    /// <param name="tick">From <see cref="OldestTick"/> to the runner's tick.</param>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not kept.</exception>
    public BallState StateAt(long tick)
    {
        Check.Within(nameof(tick), tick, OldestTick, Runner.Tick);
        return _states[tick % _states.Length];
    }

    /// <summary>The hash of the state at the start of a tick: what two machines compare.</summary>
    /// <param name="tick">From <see cref="OldestTick"/> to the runner's tick.</param>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not kept.</exception>
    public ulong HashAt(long tick) => Snapshot.Hash(StateAt(tick));

    /// <summary>Puts a kick in its place, or in the place of one of the same player and tick, and plays what followed again.</summary>
    /// <param name="kick">The kick; of a tick not before <see cref="OldestTick"/>. One to come only waits.</param>
    /// <returns>The first tick whose state is not what it was, to the last bit; null where all are.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not kept any more; nothing has changed.</exception>
    public long? Correct(in KickInput kick)
    {
        Check.AtLeast(nameof(kick), kick.Tick, OldestTick);
        Runner.Kicks.Add(in kick);
        return PlayAgain(kick.Tick);
    }

    /// <summary>Takes a kick back that was only guessed, and plays what followed again.</summary>
    /// <param name="tick">Its tick; not before <see cref="OldestTick"/>.</param>
    /// <param name="player">Its player; default 0.</param>
    /// <returns>The first tick whose state is not what it was, to the last bit; null where all are, or there was no such kick.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not kept any more; nothing has changed.</exception>
    public long? Remove(long tick, int player = 0)
    {
        Check.AtLeast(nameof(tick), tick, OldestTick);
        return Runner.Kicks.Remove(tick, player) ? PlayAgain(tick) : null;
    }

    /// <summary>Sets the state at a tick, for instance a server's, and plays what followed again.</summary>
    /// <param name="tick">From <see cref="OldestTick"/> to the runner's tick.</param>
    /// <param name="state">The state at its start.</param>
    /// <returns>The first tick whose state is not what it was, to the last bit; null where all are.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not kept; nothing has changed.</exception>
    /// <exception cref="ArgumentException"><paramref name="state"/> was never launched; nothing has changed.</exception>
    public long? Correct(long tick, in BallState state)
    {
        BallState before = StateAt(tick);
        if (Snapshot.Same(in before, in state))
        {
            return null;
        }

        BallState.Launched(in state);
        _states[tick % _states.Length] = state;
        PlayAgain(tick);
        return tick;
    }

    /// <summary>Begins anew where the runner went.</summary>
    internal void Begin(long tick, in BallState state)
    {
        if (!_replays)
        {
            OldestTick = tick;
            _states[tick % _states.Length] = state;
        }
    }

    /// <summary>Keeps the state after a step.</summary>
    internal void Keep(long tick, in BallState state)
    {
        if (!_replays)
        {
            OldestTick = Math.Max(OldestTick, tick - Ticks);
            _states[tick % _states.Length] = state;
        }
    }

    /// <summary>Plays from a tick to the present.</summary>
    private long? PlayAgain(long from)
    {
        Events.Clear();
        long now = Runner.Tick;
        long? first = null;
        if (from >= now)
        {
            return null;
        }

        // The bodies were moved for the present, not for the ticks that are played again.
        Runner.Simulator.World.Bodies?.ForgetTimes();
        _replays = true;
        try
        {
            Runner.Restore(from, in _states[from % _states.Length]);
            while (Runner.Tick < now)
            {
                Runner.Step();
                Events.Add(Runner.Events);
                BallState state = Runner.State;
                ref BallState kept = ref _states[Runner.Tick % _states.Length];
                if (first is null && !Snapshot.Same(in kept, in state))
                {
                    first = Runner.Tick;
                }

                kept = state;
            }
        }
        finally
        {
            _replays = false;
        }

        return first;
    }
}
