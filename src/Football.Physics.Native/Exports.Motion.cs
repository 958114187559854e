using System.Globalization;
using System.Runtime.InteropServices;

namespace FootballPhysics.Native;

/// <content>Functions that launch, kick, step and read balls.</content>
internal static unsafe partial class Exports
{
    /// <summary>Launches a ball. If it overlaps the ground, it is raised vertically onto the surface. A ball on the ground without speed stays at rest.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="position">Position of the centre, m; components within +-1e6.</param>
    /// <param name="velocity">Velocity, m/s; speed at most 1000.</param>
    /// <param name="spin">Spin, rad/s, world frame; at most 10 000.</param>
    /// <param name="out">Receives the state.</param>
    /// <returns>FP_OK, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_launch")]
    public static NativeStatus Launch(
        [In] NativeScene* scene,
        [In][CArray(3)] double* position,
        [In][CArray(3)] double* velocity,
        [In][CArray(3)] double* spin,
        NativeState* @out)
    {
        try
        {
            CompiledScene compiled = Guard.SceneOf(scene);
            Guard.Given(@out, "out");
            *(BallState*)@out = compiled.Simulator.Launch(Guard.Vector(position, "position"), Guard.Vector(velocity, "velocity"), Guard.Vector(spin, "spin"));
            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Kicks a ball: sets its velocity and spin, and keeps its position, time and orientation.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="state">The ball.</param>
    /// <param name="velocity">Velocity, m/s; speed at most 1000.</param>
    /// <param name="spin">Spin, rad/s, world frame; at most 10 000.</param>
    /// <returns>FP_OK, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_kick")]
    public static NativeStatus Kick([In] NativeScene* scene, NativeState* state, [In][CArray(3)] double* velocity, [In][CArray(3)] double* spin)
    {
        try
        {
            CompiledScene compiled = Guard.SceneOf(scene);
            compiled.Simulator.Kick(ref Guard.State(state, compiled), Guard.Vector(velocity, "velocity"), Guard.Vector(spin, "spin"));
            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Advances a ball by a time, and returns the events in between. Allocates nothing.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="state">The ball.</param>
    /// <param name="dt">Time to advance by, s; 0 ... 1e12. It is one step of the integrator, which splits it only at events.</param>
    /// <param name="events">Receives the events, in order of time; null to skip them.</param>
    /// <param name="capacity">The number of events that fit, 0 or more. A step stores at most 1 024 events: the first 1 008 and the last 16.</param>
    /// <param name="count">Receives the number of events, including those that do not fit or are not stored; null to skip it.</param>
    /// <returns>
    /// FP_OK; FP_BUFFER if events or count is given, and there are more events than capacity or than a step stores. The step is then complete, and the first events
    /// are written, at most capacity or 1 024. FP_ARGUMENT or FP_HANDLE, with the ball unchanged.
    /// </returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_step")]
    public static NativeStatus Step([In] NativeScene* scene, NativeState* state, double dt, NativeEvent* events, int capacity, int* count)
    {
        try
        {
            CompiledScene compiled = Guard.SceneOf(scene);
            Guard.Room(events, "events", capacity);
            ref BallState ball = ref Guard.State(state, compiled);
            StepLog log = ThreadMemory.Mine.ClearLog();
            compiled.Simulator.Step(ref ball, dt, log);
            if (log.Events.Count > 0)
            {
                return WriteEvents(log.Events, events, capacity, count);
            }

            if (count is not null)
            {
                *count = 0;
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Reads position, velocity, spin, orientation, time and motion of a ball.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="state">The ball.</param>
    /// <param name="out">Receives them.</param>
    /// <returns>FP_OK, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_read")]
    public static NativeStatus Read([In] NativeScene* scene, [In] NativeState* state, NativeBall* @out)
    {
        try
        {
            ref BallState ball = ref Guard.State(state, Guard.SceneOf(scene));
            Guard.Given(@out, "out");
            Put(in ball, @out);
            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Advances many balls by the same number of steps, without reporting events. To use several threads, pass each thread a part of the balls. Allocates nothing.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="states">The balls.</param>
    /// <param name="n">The number of balls, 0 or more.</param>
    /// <param name="dt">Length of a step, s; 0 ... 1e12.</param>
    /// <param name="steps">The number of steps, 0 or more.</param>
    /// <returns>FP_OK; FP_ARGUMENT or FP_HANDLE, with the balls unchanged.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_step_many")]
    public static NativeStatus StepMany([In] NativeScene* scene, NativeState* states, long n, double dt, int steps)
    {
        try
        {
            CompiledScene compiled = Guard.SceneOf(scene);
            Guard.Within(dt, 0, Guard.LongestTime, "dt");
            Guard.AtLeast(steps, 0, "steps");
            Guard.States(states, n, compiled);
            for (long i = 0; i < n; i++)
            {
                ref BallState ball = ref *(BallState*)(states + i);
                StepLog log = ThreadMemory.Mine.ClearLog();
                for (int step = 0; step < steps; step++)
                {
                    compiled.Simulator.Step(ref ball, dt, log);
                }
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Launches many balls, as fp_launch does.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="states">Receives the states.</param>
    /// <param name="n">The number of balls, 0 or more.</param>
    /// <param name="mask">n bytes: 0 skips a ball and leaves its state unchanged, even if uninitialised; null launches all.</param>
    /// <param name="position">n rows x, y, z, m.</param>
    /// <param name="velocity">n rows x, y, z, m/s.</param>
    /// <param name="spin">n rows x, y, z, rad/s.</param>
    /// <returns>FP_OK; FP_ARGUMENT or FP_HANDLE, with no state written.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_launch_many")]
    public static NativeStatus LaunchMany(
        [In] NativeScene* scene, NativeState* states, long n, [In] CByte* mask, [In] double* position, [In] double* velocity, [In] double* spin)
    {
        try
        {
            CompiledScene compiled = Guard.SceneOf(scene);
            Guard.Several(states, n, "states");
            Guard.Several(position, n, "position");
            Guard.Several(velocity, n, "velocity");
            Guard.Several(spin, n, "spin");

            // The first pass only checks the arguments.
            for (long i = 0; i < 2 * n; i++)
            {
                long ball = i < n ? i : i - n;
                if (mask is null || mask[ball].Value != 0)
                {
                    BallState launched = compiled.Simulator.Launch(Row(position, ball), Row(velocity, ball), Row(spin, ball));
                    if (i >= n)
                    {
                        *(BallState*)(states + ball) = launched;
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

    /// <summary>Kicks many balls, as fp_kick does.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="states">The balls.</param>
    /// <param name="n">The number of balls, 0 or more.</param>
    /// <param name="mask">n bytes: 0 leaves a ball unchanged; null kicks all.</param>
    /// <param name="velocity">n rows x, y, z, m/s.</param>
    /// <param name="spin">n rows x, y, z, rad/s.</param>
    /// <returns>FP_OK; FP_ARGUMENT or FP_HANDLE, with no ball kicked.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_kick_many")]
    public static NativeStatus KickMany([In] NativeScene* scene, NativeState* states, long n, [In] CByte* mask, [In] double* velocity, [In] double* spin)
    {
        try
        {
            CompiledScene compiled = Guard.SceneOf(scene);
            Guard.States(states, n, compiled);
            Guard.Several(velocity, n, "velocity");
            Guard.Several(spin, n, "spin");
            for (long i = 0; i < 2 * n; i++)
            {
                long ball = i < n ? i : i - n;
                if (mask is null || mask[ball].Value != 0)
                {
                    BallState kicked = *(BallState*)(states + ball);
                    compiled.Simulator.Kick(ref kicked, Row(velocity, ball), Row(spin, ball));
                    if (i >= n)
                    {
                        *(BallState*)(states + ball) = kicked;
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

    /// <summary>Reads position, velocity, spin and motion of many balls, one row per ball.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="states">The balls.</param>
    /// <param name="n">The number of balls, 0 or more.</param>
    /// <param name="position">Receives n rows x, y, z, m; null to skip them.</param>
    /// <param name="velocity">Receives n rows x, y, z, m/s; null to skip them.</param>
    /// <param name="spin">Receives n rows x, y, z, rad/s; null to skip them.</param>
    /// <param name="motion">Receives n values of fp_motion; null to skip them.</param>
    /// <returns>FP_OK, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_read_many")]
    public static NativeStatus ReadMany([In] NativeScene* scene, [In] NativeState* states, long n, double* position, double* velocity, double* spin, int* motion)
    {
        try
        {
            Guard.States(states, n, Guard.SceneOf(scene));
            for (long i = 0; i < n; i++)
            {
                ref BallState ball = ref *(BallState*)(states + i);
                if (position is not null)
                {
                    Put(ball.Position, position + (3 * i));
                }

                if (velocity is not null)
                {
                    Put(ball.Velocity, velocity + (3 * i));
                }

                if (spin is not null)
                {
                    Put(ball.Spin, spin + (3 * i));
                }

                if (motion is not null)
                {
                    motion[i] = (int)ball.Motion;
                }
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Reads the clocks of many balls.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="states">The balls.</param>
    /// <param name="n">The number of balls, 0 or more.</param>
    /// <param name="time">Receives n times since the launch, s.</param>
    /// <returns>FP_OK, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_time_many")]
    public static NativeStatus TimeMany([In] NativeScene* scene, [In] NativeState* states, long n, double* time)
    {
        try
        {
            Guard.States(states, n, Guard.SceneOf(scene));
            Guard.Several(time, n, "time");
            for (long i = 0; i < n; i++)
            {
                time[i] = ((BallState*)(states + i))->Time;
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Advances many balls in equal steps, each until its own event (such as landing or rest) or until a time.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="states">The balls. A ball whose run ends with its event has the state just after that event.</param>
    /// <param name="n">The number of balls, 0 or more.</param>
    /// <param name="dt">Length of a step, s; above 0, at most 1e12, at least 1e-12 of seconds. The last step is shortened.</param>
    /// <param name="seconds">The maximum duration, s; above 0, at most 1e12.</param>
    /// <param name="stopAt">The event that ends a run, one of fp_stop.</param>
    /// <param name="ended">Receives n numbers: 1 if the event ended the run, 0 if the time did; null to skip them.</param>
    /// <returns>FP_OK; FP_ARGUMENT or FP_HANDLE, with the balls unchanged.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_run_many")]
    public static NativeStatus RunMany([In] NativeScene* scene, NativeState* states, long n, double dt, double seconds, int stopAt, int* ended)
    {
        try
        {
            CompiledScene compiled = Guard.SceneOf(scene);
            Guard.States(states, n, compiled);
            Guard.Run(states, n, dt, seconds, stopAt);
            for (long i = 0; i < n; i++)
            {
                StepLog log = ThreadMemory.Mine.ClearLog();
                bool byEvent = compiled.Simulator.Run(ref *(BallState*)(states + i), dt, seconds, (StopAt)stopAt, log);
                if (ended is not null)
                {
                    ended[i] = byEvent ? 1 : 0;
                }
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Writes a state as bytes to send or store, little-endian on every machine, with a checksum. Snapshot.Write in C# writes the same bytes.</summary>
    /// <param name="state">The ball.</param>
    /// <param name="bytes">Receives the bytes.</param>
    /// <returns>FP_OK or FP_ARGUMENT.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_snapshot_write")]
    public static NativeStatus SnapshotWrite([In] NativeState* state, [CArray(Snapshot.Size)] byte* bytes)
    {
        try
        {
            Guard.Given(state, "state");
            Guard.Given(bytes, "bytes");
            Snapshot.Write(in *(BallState*)state, new Span<byte>(bytes, Snapshot.Size));
            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Reads the bytes that fp_snapshot_write, or Snapshot.Write in C#, wrote.</summary>
    /// <param name="bytes">The bytes.</param>
    /// <param name="out">Receives the state.</param>
    /// <returns>FP_OK, or FP_ARGUMENT if the bytes are not the state of a ball, or are corrupt.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_snapshot_read")]
    public static NativeStatus SnapshotRead([In][CArray(Snapshot.Size)] byte* bytes, NativeState* @out)
    {
        try
        {
            Guard.Given(bytes, "bytes");
            Guard.Given(@out, "out");
            *(BallState*)@out = Snapshot.Read(new ReadOnlySpan<byte>(bytes, Snapshot.Size));
            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Writes the events of a step, and their number.</summary>
    private static NativeStatus WriteEvents(EventBuffer events, NativeEvent* into, int capacity, int* count)
    {
        int written = Math.Min(capacity, events.Count);
        for (int i = 0; i < written; i++)
        {
            Put(in events[i], into + i);
        }

        return Counted(events, written, into, capacity, count);
    }

    /// <summary>Writes the number of events. Returns FP_BUFFER if some of them were not written.</summary>
    private static NativeStatus Counted(EventBuffer events, int written, void* into, int capacity, int* count)
    {
        long all = events.Count + events.Dropped;
        if (count is not null)
        {
            *count = (int)Math.Min(all, int.MaxValue);
        }

        return written == all || (into is null && count is null)
            ? NativeStatus.Ok
            : Guard.Fail(NativeStatus.Buffer, string.Create(CultureInfo.InvariantCulture, $"capacity is {capacity}; the step had {all} events."));
    }

    private static void Put(in BallEvent from, NativeEvent* to)
    {
        to->Kind = (int)from.Kind;
        to->Thing = from.ColliderIndex;
        to->Time = from.Time;
        Put(from.Position, to->Position);
        Put(from.VelocityBefore, to->VelocityBefore);
        Put(from.Velocity, to->Velocity);
        Put(from.SpinBefore, to->SpinBefore);
        Put(from.Spin, to->Spin);
        Put(from.Normal, to->Normal);
    }

    private static void Put(in BallState from, NativeBall* to)
    {
        Put(from.Position, to->Position);
        Put(from.Velocity, to->Velocity);
        Put(from.Spin, to->Spin);
        Put(from.Orientation, to->Orientation);
        to->Time = from.Time;
        to->Motion = (int)from.Motion;
        to->Reserved = 0;
    }

    private static Vector3d Row(double* rows, long row) => new(rows[3 * row], rows[(3 * row) + 1], rows[(3 * row) + 2]);

    private static void Put(Vector3d from, double* to)
    {
        to[0] = from.X;
        to[1] = from.Y;
        to[2] = from.Z;
    }

    private static void Put(Quaterniond from, double* to)
    {
        to[0] = from.X;
        to[1] = from.Y;
        to[2] = from.Z;
        to[3] = from.W;
    }
}
