using System.Globalization;
using System.Runtime.CompilerServices;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Native;

/// <summary>The checks that every call makes first, and their error messages.</summary>
internal static unsafe class Guard
{
    /// <summary>The longest time that anything takes, s.</summary>
    public const double LongestTime = 1e12;

    /// <summary>Steps that a run may have.</summary>
    private const double MostSteps = 1e12;

    /// <summary>The suffix that the runtime adds to the message of an argument exception.</summary>
    private const string ParameterSuffix = " (Parameter '";

    /// <summary>The scene of a handle.</summary>
    /// <exception cref="HandleException">It has none.</exception>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static CompiledScene SceneOf(NativeScene* handle) => SceneHandles.Find((nuint)handle) ?? throw NoScene(handle);

    /// <summary>Refuses null.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Given(void* pointer, string name)
    {
        if (pointer is null)
        {
            throw Null(name);
        }
    }

    /// <summary>Three numbers of the caller's.</summary>
    public static Vector3d Vector(double* from, string name)
    {
        Given(from, name);
        return new Vector3d(from[0], from[1], from[2]);
    }

    /// <summary>A state of the caller's, where it lies.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static ref BallState State(NativeState* state, CompiledScene scene)
    {
        Given(state, "state");
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
                scene.Simulator.Validate(in *(BallState*)(states + i));
            }
        }
        catch (ArgumentOutOfRangeException refusal)
        {
            throw new ArgumentException($"states[{Text(i)}]: {refusal.Message}", refusal);
        }
    }

    /// <summary>Refuses a number of states that cannot be.</summary>
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

    /// <summary>Refuses a run whose numbers are out of range, for any of several balls.</summary>
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

    /// <summary>Refuses a whole number below a bound.</summary>
    public static void AtLeast(long value, long low, string name)
    {
        if (value < low)
        {
            throw Refusal(name, Text(value), $"{Text(low)} or more");
        }
    }

    /// <summary>Refuses a number that is not within bounds, NaN included.</summary>
    public static void Within(double value, double low, double high, string name)
    {
        if (!(value >= low && value <= high))
        {
            throw Refusal(name, Text(value), $"{Text(low)} … {Text(high)}");
        }
    }

    /// <summary>The refusal of an argument.</summary>
    public static ArgumentException Refusal(string name, string value, string allowed) => new($"{name} is {value}; allowed: {allowed}.");

    /// <summary>Stores the message of a failed call.</summary>
    public static NativeStatus Fail(Exception exception)
    {
        NativeStatus status = exception switch
        {
            HandleException => NativeStatus.Handle,
            RefusedException => NativeStatus.Scene,
            ArgumentException or FormatException => NativeStatus.Argument,
            _ => NativeStatus.Internal,
        };
        string sentence = exception.Message;
        int suffix = sentence.LastIndexOf(ParameterSuffix, StringComparison.Ordinal);
        return Fail(status, suffix < 0 ? sentence : sentence[..suffix]);
    }

    /// <summary>Keeps a sentence.</summary>
    /// <returns>The status.</returns>
    public static NativeStatus Fail(NativeStatus status, string sentence)
    {
        try
        {
            ThreadMemory.Mine.Fail(sentence);
        }
        catch (OutOfMemoryException)
        {
            // The status has to do.
        }

        return status;
    }

    private static ArgumentException Null(string name) => Refusal(name, "null", "a pointer");

    private static HandleException NoScene(NativeScene* handle) => new(
        handle is null ? "scene is null. Pass a scene from fp_scene_create." : "scene is not a valid handle, or was freed. Pass a scene from fp_scene_create.");

    private static string Text(double value) => value.ToString("R", CultureInfo.InvariantCulture);

    private static string Text(long value) => value.ToString(CultureInfo.InvariantCulture);
}

/// <summary>A handle has no scene.</summary>
/// <param name="message">The sentence.</param>
internal sealed class HandleException(string message) : Exception(message);
