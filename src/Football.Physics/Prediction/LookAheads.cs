namespace Football.Physics;

/// <summary>Looking ahead: the simulation itself on a copy of the state.</summary>
public static class LookAheads
{
    /// <summary>Longest step through forces of a game's own that is taken as it was asked for, s.</summary>
    internal const double LongestOwnStep = 0.04;

    /// <summary>Looks ahead. Allocates nothing once its trajectory has room.</summary>
    /// <param name="simulator">The scene, compiled for the integrator to look ahead with.</param>
    /// <param name="from">The ball; unchanged.</param>
    /// <param name="request">How far to look, and what to stop at.</param>
    /// <param name="into">Where the path and the events go.</param>
    /// <remarks>What a force of the game's own throws comes through; the path then ends before the step in which it did.</remarks>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="InvalidOperationException">A force of the game's own is not finite, or too stiff for any step.</exception>
    public static void LookAhead(this Simulator simulator, in BallState from, LookAheadRequest request, Trajectory into)
    {
        if (simulator is null)
        {
            throw new ArgumentNullException(nameof(simulator));
        }

        if (request is null)
        {
            throw new ArgumentNullException(nameof(request));
        }

        if (into is null)
        {
            throw new ArgumentNullException(nameof(into));
        }

        request.Validate();
        request.CheckClock(in from);
        BallState.Launched(in from);
        Run(simulator, in from, request, into, endsWhenFull: false);
        if (into.Overflows)
        {
            // Again, up to where there is room.
            Run(simulator, in from, request, into, endsWhenFull: true);
        }
    }

    /// <summary>Looks ahead with several balls, each among the others as they will be.</summary>
    /// <param name="group">The balls.</param>
    /// <param name="from">Where they are; unchanged.</param>
    /// <param name="request">How far to look: to the first impact of any of them, to the rest of all, or for a time; not to a plane, nor past a point.</param>
    /// <param name="into">Where the path and the events of each go; a path whose memory is full is not complete, and the ball goes on without.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">The states, or the trajectories, are not as many as the balls; or the states are not of one time, or one was never launched.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    /// <exception cref="InvalidOperationException">A force of the game's own is not finite.</exception>
    public static void LookAhead(this BallGroup group, BallState[] from, LookAheadRequest request, Trajectory[] into)
    {
        Check.Given(nameof(group), group);
        Check.Given(nameof(from), from);
        Check.Given(nameof(request), request);
        Check.Given(nameof(into), into);
        request.Validate();
        if (from.Length != group.Count || into.Length != group.Count)
        {
            throw new ArgumentException($"from has {from.Length} balls, into {into.Length} trajectories; allowed: {group.Count} of both, as many as the group.");
        }

        if (request.UntilPlane is not null || request.UntilPassing is not null)
        {
            throw Check.Refusal(request.UntilPlane is null ? "lookAhead.untilPassing" : "lookAhead.untilPlane", "given", "none where there are several balls");
        }

        request.CheckClock(in from[0]);
        double step = group.SimulatorOf(0).Scene.Forces.Custom.Count > 0 ? Math.Min(request.TimeStep, LongestOwnStep) : request.TimeStep;
        BallState[] states = [.. from];
        for (int i = 0; i < into.Length; i++)
        {
            Check.GivenItem(nameof(into), i, into[i], "a trajectory");
            into[i].Begin(group.SimulatorOf(i), in from[i], request, endsWhenFull: false);
        }

        BeginMoving(group.SimulatorOf(0), into[0], in states[0]);
        try
        {
            group.Run(states, step, request.Duration, request.StopAt, [.. into.Select(path => path.Log)], into[0].OnStep);
        }
        finally
        {
            EndMoving(group.SimulatorOf(0), into[0]);
            for (int i = 0; i < into.Length; i++)
            {
                into[i].End(in states[i]);
                into[i].EndFull();
            }
        }
    }

    private static void Run(Simulator simulator, in BallState from, LookAheadRequest request, Trajectory into, bool endsWhenFull)
    {
        into.Begin(simulator, in from, request, endsWhenFull);
        BallState state = from;
        BeginMoving(simulator, into, in state);
        try
        {
            if (into.OnStep is { } move)
            {
                double longest = simulator.Scene.Forces.Custom.Count > 0 ? LongestOwnStep : request.TimeStep;
                simulator.RunChecked(ref state, Math.Min(request.TimeStep, longest), request.Duration, request.StopAt, into.Log, move);
            }
            else if (simulator.Scene.Forces.Custom.Count > 0 && request.TimeStep > LongestOwnStep)
            {
                OwnForceSteps.Run(simulator, ref state, request, into.Log, into.Trial);
            }
            else
            {
                simulator.RunChecked(ref state, request.TimeStep, request.Duration, request.StopAt, into.Log, null);
            }
        }
        catch
        {
            into.Break(in state);
            throw;
        }
        finally
        {
            EndMoving(simulator, into);
        }

        into.End(in state);
    }

    /// <summary>The bodies of the game begin to move along their own paths, and what the ball pushes goes on.</summary>
    private static void BeginMoving(Simulator simulator, Trajectory path, in BallState from)
    {
        // What has a mass is pushed in the look-ahead too, and put back.
        World world = simulator.World;
        path.Log.Pushes = world.GivesWay;
        if (path.OnStep is not null || world.GivesWay)
        {
            world.KeepMotions();
            path.OnStep?.Invoke(in from);
        }
    }

    /// <summary>They are put back.</summary>
    private static void EndMoving(Simulator simulator, Trajectory path)
    {
        if (path.OnStep is not null || simulator.World.GivesWay)
        {
            simulator.World.PutMotionsBack();
        }
    }

    /// <summary>Looks ahead in whole steps, of which the last may end after the request does.</summary>
    internal static void LookAheadInWholeSteps(this Simulator simulator, in BallState from, LookAheadRequest request, Trajectory into)
    {
        into.Begin(simulator, in from, request, endsWhenFull: true);
        simulator.Extend(into, from.Time + request.Duration, request.TimeStep, request.StopAt);
    }

    /// <summary>Extends a trajectory in whole steps up to a time or the event that ends it.</summary>
    internal static void Extend(this Simulator simulator, Trajectory path, double end, double timeStep, StopAt stopAt)
    {
        BallState state = path.Final;
        path.Resume();
        path.Log.StopAt = stopAt;
        BeginMoving(simulator, path, in state);
        try
        {
            while (state.Time < end && !path.Log.Halted && state.Motion != MotionState.Stopped)
            {
                BallState before = state;
                StepLogMark mark = path.Log.Mark();
                simulator.Advance(ref state, timeStep, path.Log);
                if (!path.IsComplete && path.StartTime < before.Time)
                {
                    // The memory ends within this step: it is taken back, so that the path can go on from its start when there is room again.
                    path.Log.TakeBack(in mark);
                    path.Break(in before);
                    return;
                }

                path.OnStep?.Invoke(in state);
            }
        }
        catch
        {
            path.Break(in state);
            throw;
        }
        finally
        {
            EndMoving(simulator, path);
        }

        path.End(in state);
    }
}
