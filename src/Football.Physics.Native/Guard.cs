using System.Globalization;
using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Native;

/// <summary>Checks the arguments of the exports, and stores their error messages.</summary>
internal static unsafe class Guard
{
    /// <summary>The largest time and the largest duration, s.</summary>
    public const double LongestTime = 1e12;

    /// <summary>The largest number of steps of a run.</summary>
    private const double MostSteps = 1e12;

    /// <summary>The suffix that the runtime adds to the message of an argument exception.</summary>
    private const string ParameterSuffix = " (Parameter '";

    /// <summary>Returns the scene of a handle.</summary>
    /// <exception cref="HandleException">The handle is not that of a scene.</exception>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static CompiledScene SceneOf(NativeScene* handle) => Handles.Find((nuint)handle) as CompiledScene ?? throw Invalid((nuint)handle, "scene");

    /// <summary>Returns the match of a handle.</summary>
    /// <exception cref="HandleException">The handle is not that of a match.</exception>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Match MatchOf(NativeMatch* handle) => Handles.Find((nuint)handle) as Match ?? throw Invalid((nuint)handle, "match");

    /// <summary>Returns the filter of a handle.</summary>
    /// <exception cref="HandleException">The handle is not that of a filter.</exception>
    public static FollowedBall FilterOf(NativeFilter* handle) => Handles.Find((nuint)handle) as FollowedBall ?? throw Invalid((nuint)handle, "filter");

    /// <summary>Returns the status of a new handle.</summary>
    public static NativeStatus Made(nuint handle) =>
        handle != 0 ? NativeStatus.Ok : Fail(NativeStatus.Internal, "There are 1 048 575 scenes, matches and filters. Free some.");

    /// <summary>Throws if a pointer is null.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Given(void* pointer, string name)
    {
        if (pointer is null)
        {
            throw Null(name);
        }
    }

    /// <summary>Reads a vector of the caller.</summary>
    public static Vector3d Vector(double* from, string name)
    {
        Given(from, name);
        return new Vector3d(from[0], from[1], from[2]);
    }

    /// <summary>Reads a vector of the caller; zero if it is null.</summary>
    public static Vector3d VectorOrZero(double* from) => from is null ? Vector3d.Zero : new Vector3d(from[0], from[1], from[2]);

    /// <summary>Reads a rotation of the caller.</summary>
    public static Quaterniond? RotationOrNull(double* from) => from is null ? null : new Quaterniond(from[0], from[1], from[2], from[3]);

    /// <summary>Checks a state of the caller, and returns a reference to it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static ref BallState State(NativeState* state, CompiledScene scene)
    {
        Given(state, "state");
        if (!((BallState*)state)->IsLaunched)
        {
            throw NeverLaunched("state");
        }

        scene.Simulator.Validate(in *(BallState*)state);
        return ref *(BallState*)state;
    }

    /// <summary>Throws if one of several states is invalid, before any of them is changed.</summary>
    public static void States(NativeState* states, long count, CompiledScene scene)
    {
        Several(states, count, "states");
        long i = 0;
        try
        {
            for (; i < count; i++)
            {
                if (!((BallState*)(states + i))->IsLaunched)
                {
                    throw NeverLaunched($"states[{Text(i)}]");
                }

                scene.Simulator.Validate(in *(BallState*)(states + i));
            }
        }
        catch (ArgumentOutOfRangeException refusal)
        {
            throw new ArgumentException($"states[{Text(i)}]: {refusal.Message}", refusal);
        }
    }

    /// <summary>Throws unless first and n select a range of the count items, and the array is given.</summary>
    public static void Items(void* items, string name, int first, int n, int count)
    {
        Within(first, 0, count, "first");
        Within(n, 0, count - first, "n");
        if (n > 0)
        {
            Given(items, name);
        }
    }

    /// <summary>Throws if the capacity is negative, or above 0 without an array.</summary>
    public static void Room(void* items, string name, int capacity)
    {
        if (capacity != 0)
        {
            AtLeast(capacity, 0, "capacity");
            Given(items, name);
        }
    }

    /// <summary>Throws if the players or the time of a search are out of range.</summary>
    public static void Players(NativePlayer* players, int n, double seconds)
    {
        Within(seconds, double.Epsilon, 3600, "seconds");
        Within(n, 0, 10_000, "n");
        if (n > 0)
        {
            Given(players, "players");
        }
    }

    /// <summary>Checks a player of the caller, and returns it.</summary>
    public static Player Player(NativePlayer* player, int index)
    {
        try
        {
            Vector3d position = Vector(player->Position, "position");
            Vector3d velocity = Vector(player->Velocity, "velocity");
            Check.Place("position", position);
            Check.Size("velocity", velocity, Limits.Speed, "m/s");
            Check.Within("reaction", player->Reaction, 0, LongestTime);
            Check.Positive("acceleration", player->Acceleration);
            Check.Within("speed", player->Speed, 0, Limits.Speed, exclusiveLow: true);
            Check.Within("reach", player->Reach, 0, Limits.Length);
            Check.Within("minimum_height", player->MinimumHeight, -Limits.Length, Limits.Length);
            Check.Within("maximum_height", player->MaximumHeight, player->MinimumHeight, Limits.Length);
            return new Player
            {
                Position = position,
                Velocity = velocity,
                Reaction = player->Reaction,
                Acceleration = player->Acceleration,
                Speed = player->Speed,
                Reach = player->Reach,
                MinimumHeight = player->MinimumHeight,
                MaximumHeight = player->MaximumHeight,
            };
        }
        catch (ArgumentOutOfRangeException refusal)
        {
            throw new ArgumentException($"players[{Text(index)}].{refusal.Message}", refusal);
        }
    }

    /// <summary>Throws if a number of bytes is negative, or above 0 without the bytes.</summary>
    public static void Bytes(void* bytes, long count, string name)
    {
        AtLeast(count, 0, name);
        if (count > 0)
        {
            Given(bytes, "bytes");
        }
    }

    /// <summary>Throws if a body is out of range.</summary>
    public static void Body(NativeBody* body, int index)
    {
        if (body->InPlay is not (0 or 1))
        {
            throw Refusal($"bodies[{Text(index)}].in_play", Text(body->InPlay), "0 or 1");
        }

        if (body->InPlay == 0)
        {
            return;
        }

        try
        {
            Check.Place("position", Vector(body->Position, "position"));
            Check.Rotation("orientation", new Quaterniond(body->Orientation[0], body->Orientation[1], body->Orientation[2], body->Orientation[3]));
            Check.Size("velocity", Vector(body->Velocity, "velocity"), Limits.Speed, "m/s");
            Check.Size("spin", Vector(body->Spin, "spin"), Limits.Spin, "rad/s");
            Check.Within("time", body->Time, -LongestTime, LongestTime);
        }
        catch (ArgumentOutOfRangeException refusal)
        {
            throw new ArgumentException($"bodies[{Text(index)}].{refusal.Message}", refusal);
        }
    }

    /// <summary>Throws if a number of states is out of range, or above 0 without the states.</summary>
    public static void Several(void* first, long count, string name)
    {
        if (count < 0 || count > long.MaxValue / NativeState.Size)
        {
            throw Refusal("n", Text(count), "the number of states, 0 or more");
        }

        if (count > 0)
        {
            Given(first, name);
        }
    }

    /// <summary>Throws if the numbers of a run of several balls are out of range.</summary>
    public static void Run(NativeState* states, long count, double dt, double seconds, int stopAt)
    {
        Within(dt, double.Epsilon, LongestTime, "dt");
        Within(seconds, double.Epsilon, Math.Min(LongestTime, MostSteps * dt), "seconds");
        Within(stopAt, (int)StopAt.Time, (int)StopAt.Rest, "stop_at");
        for (long i = 0; i < count; i++)
        {
            double end = ((BallState*)(states + i))->Time + seconds;
            if (!(end + (0.25 * dt) > end))
            {
                throw Refusal("dt", Text(dt), $"more than the rounding error of the clock of states[{Text(i)}] at {Text(end)} s");
            }
        }
    }

    /// <summary>Throws if an integer is below a bound.</summary>
    public static void AtLeast(long value, long low, string name)
    {
        if (value < low)
        {
            throw Refusal(name, Text(value), $"{Text(low)} or more");
        }
    }

    /// <summary>Throws if a number is not within bounds, or is NaN.</summary>
    public static void Within(double value, double low, double high, string name)
    {
        if (!(value >= low && value <= high))
        {
            throw Refusal(name, Text(value), $"{Text(low)} … {Text(high)}");
        }
    }

    /// <summary>Returns the exception for a rejected argument.</summary>
    public static ArgumentException Refusal(string name, string value, string allowed) => new($"{name} is {value}; allowed: {allowed}.");

    /// <summary>Stores the message of a failed call, and returns its status.</summary>
    public static NativeStatus Fail(Exception exception)
    {
        NativeStatus status = exception switch
        {
            HandleException => NativeStatus.Handle,
            RefusedException => NativeStatus.Scene,
            OperationCanceledException => NativeStatus.Cancelled,
            ArgumentException or FormatException => NativeStatus.Argument,
            _ => NativeStatus.Internal,
        };
        string sentence = status == NativeStatus.Cancelled ? "watch.cancel is set. The call was cancelled, and wrote no result." : exception.Message;
        int suffix = sentence.LastIndexOf(ParameterSuffix, StringComparison.Ordinal);
        return Fail(status, suffix < 0 ? sentence : sentence[..suffix]);
    }

    /// <summary>Stores a message, and returns the status.</summary>
    /// <returns>The status that was passed.</returns>
    public static NativeStatus Fail(NativeStatus status, string sentence)
    {
        try
        {
            ThreadMemory.Mine.Fail(sentence);
        }
        catch (OutOfMemoryException)
        {
            // Without memory for the message, return only the status.
        }

        return status;
    }

    private static ArgumentException NeverLaunched(string name) => new($"{name} was never launched. Launch the ball first.");

    private static ArgumentException Null(string name) => Refusal(name, "null", "a pointer");

    private static HandleException Invalid(nuint handle, string kind) => new(
        $"{kind} is {(handle == 0 ? "null" : "not a valid handle, or was freed")}. Pass a {kind} from fp_{kind}_create.");

    private static string Text(double value) => value.ToString("R", CultureInfo.InvariantCulture);

    private static string Text(long value) => value.ToString(CultureInfo.InvariantCulture);
}

/// <summary>The exception for an invalid handle.</summary>
/// <param name="message">The message.</param>
internal sealed class HandleException(string message) : Exception(message);
