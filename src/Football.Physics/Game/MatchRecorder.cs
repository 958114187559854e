using FootballPhysics.Contacts;

namespace FootballPhysics.Game;

/// <summary>The recorder of a runner: positions the bodies, adds every step to the current recording, and ends a recording that no longer applies.</summary>
internal sealed class MatchRecorder
{
    /// <summary>The current recording; null if nothing is recorded.</summary>
    public Recording? Recording { get; private set; }

    /// <summary>The last tick in which an engine's colliders moved; −1 if none have moved.</summary>
    public long EngineMoved { get; private set; } = -1;

    /// <summary>Starts a recording at a runner's current tick.</summary>
    public Recording Start(FixedStepRunner runner)
    {
        Recording = new Recording(runner);
        return Recording;
    }

    /// <summary>Ends the recording, if there is one.</summary>
    public void Stop() => Recording = null;

    /// <summary>Rewinds the recording to a tick; ends it if it does not contain these states.</summary>
    public void GoTo(long tick, BallState[] states)
    {
        // The steps from this tick on are discarded, and their moves with them.
        EngineMoved = Math.Min(EngineMoved, tick - 1);
        if (Recording is { } recording && !recording.TryRewind(tick, Snapshot.Hash(states)))
        {
            Recording = null;
        }
    }

    /// <summary>Positions the bodies for the current tick of a runner, stores their positions, and notes whether engine colliders move.</summary>
    public void MoveBodies(FixedStepRunner runner, World world)
    {
        // Prefer the callback, because it can also position the bodies when ticks are resimulated.
        long tick = runner.Tick;
        KinematicBodies? bodies = world.Bodies;
        if (runner.MoveBodies is { } move)
        {
            move(runner.Time);
            world.Engine?.ForgetPushes();
        }
        else if (bodies is not null)
        {
            runner.Script?.Apply(tick, bodies);
            runner.Rollback?.PutBodies(tick, bodies);
        }

        // Store the final positions, because a resimulation must use exactly the positions of this step.
        if (bodies is not null)
        {
            runner.Rollback?.KeepBodies(tick, bodies);
            Recording?.Bodies.Record(tick, bodies);
        }

        if (world.Engine is { GreatestSpeed: > 0 })
        {
            EngineMoved = tick;
            Recording?.MovesEngine();
        }
    }
}
