using System.Runtime.InteropServices;

namespace FootballPhysics.Native;

/// <content>Matches: several balls that are stepped together, and bodies that the caller moves.</content>
internal static unsafe partial class Exports
{
    /// <summary>Creates a match at time 0, with its balls at rest on the ground, side by side along x from the origin.</summary>
    /// <param name="json">An object in UTF-8 with the members of a scene, as for fp_scene_create, and bodies. Obstacles and bodies can have a mass. balls, a list of objects with a ball each, gives each ball its own size, mass and drag; ballContact is the material of their contacts.</param>
    /// <param name="jsonBytes">Its length in bytes, without a terminating zero; at most 1 048 576.</param>
    /// <param name="balls">The number of balls; 1 ... 10 000. If the JSON has a list balls, the number must equal its length.</param>
    /// <param name="dt">The length of a step, s; above 0, at most 1e12.</param>
    /// <param name="match">Receives the handle; null if the call fails.</param>
    /// <returns>FP_OK, FP_SCENE if the text is rejected, or FP_ARGUMENT.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_create")]
    public static NativeStatus MatchCreate([In] byte* json, long jsonBytes, int balls, double dt, NativeMatch** match)
    {
        try
        {
            Guard.Given(match, "match");
            *match = null;
            Guard.Within(balls, 1, 10_000, "balls");
            Guard.Within(dt, double.Epsilon, Guard.LongestTime, "dt");
            nuint handle = Handles.Add(Requests.Match(Requests.Text(json, jsonBytes, "json"), balls, dt));
            *match = (NativeMatch*)handle;
            return Guard.Made(handle);
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Frees a match. A running call of another thread finishes normally.</summary>
    /// <param name="match">The match; null or a freed handle is rejected.</param>
    /// <returns>FP_OK, or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_free")]
    public static NativeStatus MatchFree(NativeMatch* match)
    {
        try
        {
            Guard.MatchOf(match);
            return Handles.Remove((nuint)match) ? NativeStatus.Ok : Guard.Fail(NativeStatus.Handle, "match was freed by another thread.");
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Writes the name of the object of an event in a match: "ground", "left post", or the name of a body or an obstacle.</summary>
    /// <param name="match">The match.</param>
    /// <param name="thing">The member thing of the event; the name of -1 is "".</param>
    /// <param name="name">Receives the name in UTF-8, with a terminating zero.</param>
    /// <param name="capacity">The number of bytes at name, at least 1. If the name is longer, it is truncated, and the call returns FP_BUFFER.</param>
    /// <returns>FP_OK, FP_BUFFER, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_name")]
    public static NativeStatus MatchName([In] NativeMatch* match, int thing, byte* name, int capacity)
    {
        try
        {
            return WriteName(Guard.MatchOf(match).Runner.Simulator, thing, name, capacity);
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Kicks a ball at the start of the next step: sets its velocity and spin. A second kick of this ball before the step replaces the first.</summary>
    /// <param name="match">The match.</param>
    /// <param name="ball">The index of the ball, from 0.</param>
    /// <param name="velocity">Velocity, m/s; speed at most 1000.</param>
    /// <param name="spin">Spin, rad/s, world frame; at most 10 000.</param>
    /// <returns>FP_OK, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_kick")]
    public static NativeStatus MatchKick(NativeMatch* match, int ball, [In][CArray(3)] double* velocity, [In][CArray(3)] double* spin)
    {
        try
        {
            Match played = Guard.MatchOf(match);
            lock (played.Gate)
            {
                played.Plays();
                played.Runner.QueueKick(Guard.Vector(velocity, "velocity"), Guard.Vector(spin, "spin"), ball);
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Moves bodies for the next step, in which they keep their velocity and spin. Bodies that you do not move continue their motion. Allocates nothing.</summary>
    /// <param name="match">The match.</param>
    /// <param name="first">The index of the first body, from 0, in the order of the JSON.</param>
    /// <param name="n">The number of bodies, 0 or more.</param>
    /// <param name="bodies">The n bodies.</param>
    /// <returns>FP_OK; FP_ARGUMENT or FP_HANDLE, with no body moved.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_move_bodies")]
    public static NativeStatus MatchMoveBodies(NativeMatch* match, int first, int n, [In] NativeBody* bodies)
    {
        try
        {
            Match played = Guard.MatchOf(match);
            lock (played.Gate)
            {
                played.Plays();
                Guard.Items(bodies, "bodies", first, n, played.Bodies.Count);

                // Check all of them before the first one moves.
                for (int i = 0; i < 2 * n; i++)
                {
                    NativeBody body = bodies[i % n];
                    if (i < n)
                    {
                        Guard.Body(&body, i);
                    }
                    else
                    {
                        Move(played.Bodies[first + i - n], &body);
                    }
                }
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Takes a step: applies the restarts, then the kicks, advances all balls, and returns the events. Allocates nothing, except if a recording grows.</summary>
    /// <param name="match">The match.</param>
    /// <param name="events">Receives the events of all balls, ordered by time, then by ball; null to skip them.</param>
    /// <param name="capacity">The number of events that fit, 0 or more. A step stores at most 1 024 events: the first 1 008 and the last 16.</param>
    /// <param name="count">Receives the number of events, including those that do not fit or are not stored; null to skip it.</param>
    /// <returns>
    /// FP_OK; FP_BUFFER if events or count is given, and there are more events than capacity or than a step stores. The step is then complete, and the first events
    /// are written, at most capacity or 1 024. FP_ARGUMENT or FP_HANDLE, with nothing changed.
    /// </returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_step")]
    public static NativeStatus MatchStep(NativeMatch* match, NativeMatchEvent* events, int capacity, int* count)
    {
        try
        {
            Match played = Guard.MatchOf(match);
            Guard.Room(events, "events", capacity);
            lock (played.Gate)
            {
                played.Step();
                EventBuffer happened = played.Runner.Events;
                int written = Math.Min(capacity, happened.Count);
                for (int i = 0; i < written; i++)
                {
                    ref readonly BallEvent from = ref happened[i];
                    NativeMatchEvent* to = events + i;
                    Put(in from, &to->Event);
                    to->Ball = from.Ball;
                    to->OtherBall = from.OtherBall;
                    to->Body = played.BodyOf(in from);
                    to->Reserved = 0;
                    Put(played.Impulse(in from), to->Impulse);
                    to->AddedEnergy = from.AddedEnergy;
                }

                return Counted(happened, written, events, capacity, count);
            }
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Computes the outputs of an impact in the last step: impulses, slip, duration, compression, peak force, energy.</summary>
    /// <param name="match">The match.</param>
    /// <param name="event">The index of the event in the last step, from 0, as fp_match_step writes them; below 1 024.</param>
    /// <param name="out">Receives the outputs.</param>
    /// <returns>FP_OK, FP_HANDLE, or FP_ARGUMENT: the last step has no such event, or the event is not an impact.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_impact")]
    public static NativeStatus MatchImpact([In] NativeMatch* match, int @event, NativeImpactResult* @out)
    {
        try
        {
            Match played = Guard.MatchOf(match);
            Guard.Given(@out, "out");
            lock (played.Gate)
            {
                ref readonly BallEvent happened = ref played.Runner.Events[@event];
                if (happened.Kind != BallEventKind.Impact)
                {
                    throw new ArgumentException($"event is {@event}, of the kind {(int)happened.Kind}; allowed: the index of an impact.");
                }

                Put(played.ImpactOf(in happened), @out);
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Reads balls.</summary>
    /// <param name="match">The match.</param>
    /// <param name="first">The index of the first ball, from 0.</param>
    /// <param name="n">The number of balls, 0 or more.</param>
    /// <param name="balls">Receives the n balls. Their time counts from the start of the match.</param>
    /// <returns>FP_OK, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_read_balls")]
    public static NativeStatus MatchReadBalls([In] NativeMatch* match, int first, int n, NativeBall* balls)
    {
        try
        {
            Match played = Guard.MatchOf(match);
            Guard.Items(balls, "balls", first, n, played.Runner.Balls);
            lock (played.Gate)
            {
                for (int i = 0; i < n; i++)
                {
                    Put(in played.Runner.States[first + i], balls + i);
                }
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Reads bodies, with the impulses of the last step.</summary>
    /// <param name="match">The match.</param>
    /// <param name="first">The index of the first body, from 0, in the order of the JSON.</param>
    /// <param name="n">The number of bodies, 0 or more.</param>
    /// <param name="bodies">Receives the n bodies. Position and orientation apply at the body's time; since then it has moved with its velocity and spin.</param>
    /// <returns>FP_OK, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_read_bodies")]
    public static NativeStatus MatchReadBodies([In] NativeMatch* match, int first, int n, NativeBody* bodies)
    {
        try
        {
            Match played = Guard.MatchOf(match);
            Guard.Items(bodies, "bodies", first, n, played.Bodies.Count);
            lock (played.Gate)
            {
                for (int i = 0; i < n; i++)
                {
                    Put(played.Bodies[first + i], played.ImpulseOn(first + i), bodies + i);
                }
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Copies a ball into a scene, with the same position and motion, for fp_look_ahead, fp_intercept and fp_aim. The scene determines what the ball touches.</summary>
    /// <param name="match">The match; unchanged.</param>
    /// <param name="ball">The index of the ball, from 0.</param>
    /// <param name="scene">The scene, for example that of the match without its bodies.</param>
    /// <param name="out">Receives the state.</param>
    /// <returns>FP_OK, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_state")]
    public static NativeStatus MatchState([In] NativeMatch* match, int ball, [In] NativeScene* scene, NativeState* @out)
    {
        try
        {
            Match played = Guard.MatchOf(match);
            CompiledScene compiled = Guard.SceneOf(scene);
            Guard.Given(@out, "out");
            lock (played.Gate)
            {
                *(BallState*)@out = compiled.Simulator.Continue(played.SimulatorOf(ball), played.Runner.StateOf(ball));
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Returns a 64-bit hash of all balls. It equals Snapshot.Hash in C#, and is the same on every machine.</summary>
    /// <param name="match">The match.</param>
    /// <returns>the hash; 0 if the handle is invalid.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_hash")]
    public static ulong MatchHash([In] NativeMatch* match)
    {
        try
        {
            Match played = Guard.MatchOf(match);
            lock (played.Gate)
            {
                return Snapshot.Hash(played.Runner.States);
            }
        }
        catch (Exception e)
        {
            Guard.Fail(e);
            return 0;
        }
    }

    /// <summary>Returns the number of steps since the start of the match.</summary>
    /// <param name="match">The match.</param>
    /// <returns>the number; -1 if the handle is invalid.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_tick")]
    public static long MatchTick([In] NativeMatch* match)
    {
        try
        {
            Match played = Guard.MatchOf(match);
            lock (played.Gate)
            {
                return played.Runner.Tick;
            }
        }
        catch (Exception e)
        {
            Guard.Fail(e);
            return -1;
        }
    }

    private static void Move(KinematicBody body, NativeBody* to)
    {
        if (to->InPlay == 0)
        {
            body.Withdraw();
        }
        else
        {
            Vector3d position = Guard.Vector(to->Position, "position");
            var orientation = new Quaterniond(to->Orientation[0], to->Orientation[1], to->Orientation[2], to->Orientation[3]);
            body.MoveTo(position, orientation, Guard.Vector(to->Velocity, "velocity"), Guard.Vector(to->Spin, "spin"), to->Time);
        }
    }

    private static void Put(KinematicBody from, Vector3d impulse, NativeBody* to)
    {
        Put(from.Position, to->Position);
        Put(from.Orientation, to->Orientation);
        Put(from.Velocity, to->Velocity);
        Put(from.Spin, to->Spin);
        to->Time = from.Time;
        Put(impulse, to->Impulse);
        to->InPlay = from.IsWithdrawn ? 0 : 1;
        to->Reserved = 0;
    }
}
