namespace FootballPhysics;

/// <summary>Looking ahead, which is the simulation itself on a copy of the state, and warming up.</summary>
/// <remarks>Extensions, since a simulator knows nothing of trajectories; in its namespace, so that they are found as its members are.</remarks>
public static class SimulatorExtensions
{
    /// <summary>Longest step through forces of a game's own that is taken as it was asked for, s.</summary>
    internal const double LongestOwnStep = 0.04;

    /// <summary>A frame of a warm-up, s, and how many of them a ball has to come to rest in.</summary>
    private const double Frame = 1.0 / 60.0;
    private const int MostFrames = 1200;

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
        Check.Given(nameof(simulator), simulator);
        Check.Given(nameof(request), request);
        Check.Given(nameof(into), into);
        request.Validate();
        request.CheckClock(in from);
        BallState.Launched(in from);
        Run(simulator, in from, request, into, endsWhenFull: false);

        // A path that fills the memory exactly is complete: only one for which it was too small is flown a second time.
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
            throw new ArgumentException($"from has {from.Length} states and into has {into.Length} trajectories, but the group has {group.Count} balls. Pass one of each for each ball.");
        }

        // One ball at its plane would end the path of all.
        if (request.UntilPlane is not null || request.UntilPassing is not null)
        {
            string field = request.UntilPlane is null ? "lookAhead.untilPassing" : "lookAhead.untilPlane";
            throw Check.Conflict(field, field + " is not supported for several balls. Leave it unset, and search each path for the crossing.");
        }

        request.CheckClock(in from[0]);

        // All balls of a group have one step: where forces of a game's own act, the longest that is taken as it is.
        double step = group.SimulatorOf(0).Scene.HasOwnForces ? Math.Min(request.TimeStep, LongestOwnStep) : request.TimeStep;
        BallState[] states = [.. from];
        for (int i = 0; i < into.Length; i++)
        {
            Check.GivenItem(nameof(into), i, into[i], "a trajectory");

            // Each path keeps the pieces and events of its own ball.
            into[i].Begin(group.SimulatorOf(i), in from[i], request, endsWhenFull: false, goesOn: true);
        }

        BeginMoving(group.SimulatorOf(0), into[0], in states[0]);
        try
        {
            group.Run(states, step, request.Duration, request.StopAt, [.. into.Select(path => path.Log)], into[0].OnStep);
        }
        finally
        {
            // Also where something throws: bodies go back to where the game has them, and each path ends where its ball got to.
            EndMoving(group.SimulatorOf(0), into[0]);
            for (int i = 0; i < into.Length; i++)
            {
                into[i].End(in states[i]);
                into[i].EndFull();
            }
        }
    }

    /// <summary>Steps, impacts, slides, rolls and looks ahead with balls that nobody sees, so that no frame of a game has to compile the code or make the tables.</summary>
    /// <remarks>
    /// Where code is compiled just in time, the first impact, the first roll and the first look-ahead cost milliseconds each. To be called while a level
    /// loads; nothing that can be seen changes. Forces of a game's own are asked meanwhile. A runtime compiles in full what runs often, but counts from
    /// a tenth of a second later: called once more by the end of the loading, it makes the first roll and the first look-ahead several times faster.
    /// </remarks>
    /// <param name="simulator">The scene.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="InvalidOperationException">A force of the game's own is not finite.</exception>
    public static void WarmUp(this Simulator simulator)
    {
        Check.Given(nameof(simulator), simulator);
        var path = new Trajectory();
        var look = new LookAheadRequest();
        var log = new StepLog();
        Vector3d from = simulator.OnGround(0, 0);

        // A shot, a drive without spin, a pass along the ground.
        foreach ((Vector3d velocity, Vector3d spin) in ((Vector3d, Vector3d)[])
            [(new Vector3d(2, 7, -22), new Vector3d(10, 30, 0)), (new Vector3d(0, 2, -12), Vector3d.Zero), (new Vector3d(0, 0, -8), Vector3d.Zero)])
        {
            // Ahead and step by step, to its rest: what both of them compile.
            BallState ball = simulator.Launch(from, velocity, spin);
            simulator.LookAhead(in ball, look, path);
            for (int i = 0; i < MostFrames && ball.Motion != MotionState.Rest; i++)
            {
                log.Clear();
                simulator.Step(ref ball, Frame, log);
            }

            path.TryGetCrossing(new Plane3d(new Vector3d(0, 0, -5), new Vector3d(0, 0, 1)), out PathPoint at);
            path.ClosestApproach(at.Position);
        }

        // Contacts of several things at once, pushes and nets happen only where there are things.
        if (!simulator.World.IsBare)
        {
            WarmUpScenes.Press(simulator.Settings, log);
            WarmUpScenes.Net(simulator.Settings, log);
        }

        WarmUpScenes.Group(simulator.Settings, log);
    }

    private static void Run(Simulator simulator, in BallState from, LookAheadRequest request, Trajectory into, bool endsWhenFull)
    {
        into.Begin(simulator, in from, request, endsWhenFull);
        BallState state = from;
        BeginMoving(simulator, into, in state);
        try
        {
            // Bodies are moved between steps that are known before, short ones where forces of a game's own act; else stiff forces may divide a step.
            if (into.OnStep is { } move)
            {
                double longest = simulator.Scene.HasOwnForces ? LongestOwnStep : request.TimeStep;
                simulator.RunChecked(ref state, Math.Min(request.TimeStep, longest), request.Duration, request.StopAt, into.Log, move);
            }
            else if (simulator.Scene.HasOwnForces && request.TimeStep > LongestOwnStep)
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
            // The pieces of the step that threw are taken back.
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
        path.Log.Pushes = world.MayGiveWay;
        if (path.OnStep is not null || world.MayGiveWay)
        {
            world.KeepMotions();

            // To where they are at the start: the game may have moved them for another time.
            path.OnStep?.Invoke(in from);
        }
    }

    /// <summary>They are put back.</summary>
    private static void EndMoving(Simulator simulator, Trajectory path)
    {
        if (path.OnStep is not null || simulator.World.MayGiveWay)
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
            while (state.Time < end && !path.Log.Halted && !simulator.StaysAtRest(in state))
            {
                // Kept for where the memory ends within the step: then it is as if that had not been made.
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
