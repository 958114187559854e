using System.Globalization;
using System.Runtime.InteropServices;

namespace FootballPhysics.Native;

/// <content>A ball launched, kicked, stepped and read.</content>
internal static unsafe partial class Exports
{
    /// <summary>A ball at the start of its way. In the ground it is raised straight up out of it; where it lies on the ground without speed, it stays.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="position">Position of the centre, m; components within +-1e6.</param>
    /// <param name="velocity">Velocity, m/s; speed at most 1000.</param>
    /// <param name="spin">Spin, rad/s, world frame; at most 10 000.</param>
    /// <param name="out">Where the state goes.</param>
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

    /// <summary>Kicks a ball where it is: new velocity and spin, same place, time and orientation.</summary>
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

    /// <summary>Advances a ball, and returns the events on the way. Allocates nothing.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="state">The ball.</param>
    /// <param name="dt">Time to advance by, s; 0 ... 1e12. All of it is one step of the integrator, split only at events.</param>
    /// <param name="events">Receives the events, in order of time; null if they are not wanted.</param>
    /// <param name="capacity">The number of events that fit, 0 or more. A step stores at most 1 024 events: the first 1 008 and the last 16.</param>
    /// <param name="count">Receives the number of events, including those that do not fit or are not stored; null if it is not wanted.</param>
    /// <returns>
    /// FP_OK; FP_BUFFER if there are more events than capacity or than a step stores, and events or count is given: the step is taken, and the first events are
    /// there, at most capacity or 1 024; FP_ARGUMENT or FP_HANDLE, and the ball is as it was.
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
                return Tell(log.Events, events, capacity, count);
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

    /// <summary>What there is to see of a ball.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="state">The ball.</param>
    /// <param name="out">Where it goes.</param>
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

    /// <summary>Advances many balls, each by the same steps; events are not told. To use several threads, give each a part of the balls. Allocates nothing.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="states">The balls.</param>
    /// <param name="n">How many, 0 or more.</param>
    /// <param name="dt">Length of a step, s; 0 ... 1e12.</param>
    /// <param name="steps">How many steps, 0 or more.</param>
    /// <returns>FP_OK; FP_ARGUMENT or FP_HANDLE, and the balls are as they were.</returns>
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

    /// <summary>Many balls at the start of their ways, as fp_launch.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="states">Where the states go.</param>
    /// <param name="n">How many, 0 or more.</param>
    /// <param name="mask">n bytes: 0 leaves a ball as it is, or unmade; null launches all.</param>
    /// <param name="position">n rows x, y, z, m.</param>
    /// <param name="velocity">n rows x, y, z, m/s.</param>
    /// <param name="spin">n rows x, y, z, rad/s.</param>
    /// <returns>FP_OK; FP_ARGUMENT or FP_HANDLE, and no state has been written.</returns>
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

            // First all of them for the refusals alone.
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

    /// <summary>Kicks many balls where they are, as fp_kick.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="states">The balls.</param>
    /// <param name="n">How many, 0 or more.</param>
    /// <param name="mask">n bytes: 0 leaves a ball as it is; null kicks all.</param>
    /// <param name="velocity">n rows x, y, z, m/s.</param>
    /// <param name="spin">n rows x, y, z, rad/s.</param>
    /// <returns>FP_OK; FP_ARGUMENT or FP_HANDLE, and no ball has been kicked.</returns>
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

    /// <summary>Where many balls are, row by row.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="states">The balls.</param>
    /// <param name="n">How many, 0 or more.</param>
    /// <param name="position">n rows x, y, z, m; null where they are not wanted.</param>
    /// <param name="velocity">n rows x, y, z, m/s; null where they are not wanted.</param>
    /// <param name="spin">n rows x, y, z, rad/s; null where they are not wanted.</param>
    /// <param name="motion">n of fp_motion; null where they are not wanted.</param>
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

    /// <summary>The clocks of many balls.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="states">The balls.</param>
    /// <param name="n">How many, 0 or more.</param>
    /// <param name="time">n times since the launch, s.</param>
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

    /// <summary>Advances many balls in equal steps until an event or a time, each for itself: until they land, or until they rest.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="states">The balls; one that its event ended is as it was just after it.</param>
    /// <param name="n">How many, 0 or more.</param>
    /// <param name="dt">Length of a step, s; above 0, at most 1e12, at least 1e-12 of seconds. The last one is shortened.</param>
    /// <param name="seconds">How long to go on at most, s; above 0, at most 1e12.</param>
    /// <param name="stopAt">The event that ends a run, one of fp_stop.</param>
    /// <param name="ended">n numbers: 1 where the event ended the run, 0 where its time did; null where they are not wanted.</param>
    /// <returns>FP_OK; FP_ARGUMENT or FP_HANDLE, and the balls are as they were.</returns>
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

    /// <summary>Writes a state as bytes to send or to keep: little-endian on every machine, with a checksum; what Snapshot.Write writes in C#.</summary>
    /// <param name="state">The ball.</param>
    /// <param name="bytes">Where they go.</param>
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

    /// <summary>Reads what fp_snapshot_write, or Snapshot.Write in C#, wrote.</summary>
    /// <param name="bytes">The bytes.</param>
    /// <param name="out">Where the state goes.</param>
    /// <returns>FP_OK, or FP_ARGUMENT where the bytes are no state of a ball, or were changed on their way.</returns>
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

    /// <summary>Hands the events of a step over.</summary>
    private static NativeStatus Tell(EventBuffer events, NativeEvent* into, int capacity, int* count)
    {
        int told = Math.Min(capacity, events.Count);
        for (int i = 0; i < told; i++)
        {
            Put(in events[i], into + i);
        }

        return Told(events, told, into, capacity, count);
    }

    /// <summary>Reports the number of events, and whether they fitted.</summary>
    private static NativeStatus Told(EventBuffer events, int told, void* into, int capacity, int* count)
    {
        long all = events.Count + events.Dropped;
        if (count is not null)
        {
            *count = (int)Math.Min(all, int.MaxValue);
        }

        return told == all || (into is null && count is null)
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
