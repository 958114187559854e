using System.Globalization;
using System.Runtime.InteropServices;

namespace FootballPhysics.Native;

/// <summary>The functions that C calls. Their declarations and comments generate the header.</summary>
/// <remarks>
/// No function throws, keeps a pointer of the caller, or calls back. A call that fails its checks changes no data of the caller. The scene, and the first call of
/// a thread, allocate the memory of a step; a step itself allocates nothing.
/// </remarks>
internal static unsafe partial class Exports
{
    /// <summary>The version of the interface. It changes with sizes, names and meanings.</summary>
    public const int AbiVersion = 2;

    /// <summary>The sizes of the structures in the order of the header, bytes.</summary>
    internal static readonly int[] Sizes =
    [
        sizeof(NativeState), sizeof(NativeBall), sizeof(NativeEvent), sizeof(NativeDerivatives), sizeof(NativeBody), sizeof(NativeMatchEvent), sizeof(NativePlayer), sizeof(NativeInterception),
        sizeof(NativeWindow), sizeof(NativeGoalChanceResult), sizeof(NativeFitResult), sizeof(NativePiece), sizeof(NativeFitMatchResult), sizeof(NativeImpactResult),
        sizeof(NativeFilterSettings), sizeof(NativeEstimate), sizeof(NativeWatch), sizeof(NativeForcesResult), sizeof(NativeContactForce),
    ];

    private static readonly byte* s_noError = MakeText("");
    private static readonly byte* s_version = MakeText(typeof(Scene).Assembly.GetName().Version!.ToString(3));

    /// <summary>Checks that the header matches the library. Call it once, as FOOTBALL_CHECK_ABI().</summary>
    /// <param name="version">FOOTBALL_ABI_VERSION.</param>
    /// <param name="stateBytes">sizeof(fp_state).</param>
    /// <param name="ballBytes">sizeof(fp_ball).</param>
    /// <param name="eventBytes">sizeof(fp_event).</param>
    /// <returns>FP_OK, or FP_ABI.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_check_abi")]
    public static NativeStatus CheckAbi(int version, int stateBytes, int ballBytes, int eventBytes)
    {
        (int, int, int, int) mine = (AbiVersion, sizeof(NativeState), sizeof(NativeBall), sizeof(NativeEvent));
        (int, int, int, int) given = (version, stateBytes, ballBytes, eventBytes);
        return given == mine
            ? NativeStatus.Ok
            : Guard.Fail(NativeStatus.Abi, $"version, state, ball and event bytes are {given}; allowed: {mine}, those of the loaded library.");
    }

    /// <summary>Checks the sizes of the structures that fp_check_abi does not check. FOOTBALL_CHECK_ABI() calls both.</summary>
    /// <param name="bodyBytes">sizeof(fp_body).</param>
    /// <param name="matchEventBytes">sizeof(fp_match_event).</param>
    /// <param name="playerBytes">sizeof(fp_player).</param>
    /// <param name="interceptionBytes">sizeof(fp_interception).</param>
    /// <param name="windowBytes">sizeof(fp_window).</param>
    /// <param name="goalChanceBytes">sizeof(fp_goal_chance_result).</param>
    /// <param name="fitBytes">sizeof(fp_fit_result).</param>
    /// <param name="pieceBytes">sizeof(fp_piece).</param>
    /// <param name="fitMatchBytes">sizeof(fp_fit_match_result).</param>
    /// <param name="impactBytes">sizeof(fp_impact_result).</param>
    /// <param name="filterBytes">sizeof(fp_filter_settings).</param>
    /// <param name="estimateBytes">sizeof(fp_estimate).</param>
    /// <param name="forcesBytes">sizeof(fp_forces_result).</param>
    /// <param name="contactBytes">sizeof(fp_contact_force).</param>
    /// <returns>FP_OK, or FP_ABI.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_check_structs")]
    public static NativeStatus CheckStructs(
        int bodyBytes, int matchEventBytes, int playerBytes, int interceptionBytes, int windowBytes, int goalChanceBytes, int fitBytes, int pieceBytes, int fitMatchBytes, int impactBytes,
        int filterBytes, int estimateBytes, int forcesBytes, int contactBytes)
    {
        (int, int, int, int, int, int, int, int, int, int, int, int, int, int) mine = (
            sizeof(NativeBody), sizeof(NativeMatchEvent), sizeof(NativePlayer), sizeof(NativeInterception), sizeof(NativeWindow), sizeof(NativeGoalChanceResult),
            sizeof(NativeFitResult), sizeof(NativePiece), sizeof(NativeFitMatchResult), sizeof(NativeImpactResult), sizeof(NativeFilterSettings), sizeof(NativeEstimate),
            sizeof(NativeForcesResult), sizeof(NativeContactForce));
        (int, int, int, int, int, int, int, int, int, int, int, int, int, int) given =
        (
            bodyBytes, matchEventBytes, playerBytes, interceptionBytes, windowBytes, goalChanceBytes, fitBytes, pieceBytes, fitMatchBytes, impactBytes, filterBytes,
            estimateBytes, forcesBytes, contactBytes);
        return given == mine
            ? NativeStatus.Ok
            : Guard.Fail(NativeStatus.Abi, $"the bytes of the structures are {given}; allowed: {mine}, those of the loaded library.");
    }

    /// <summary>Checks that the structures of another language match those of the library: a check without a macro, for generated bindings.</summary>
    /// <param name="version">FOOTBALL_ABI_VERSION.</param>
    /// <param name="sizes">The sizes of the structures in bytes, in the order of the header, from fp_state on.</param>
    /// <param name="n">Their number. At least 1, and at most the number of the structures.</param>
    /// <returns>FP_OK, FP_ARGUMENT if sizes is null or n is not 1 ... the number of structures, or FP_ABI.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_check_sizes")]
    public static NativeStatus CheckSizes(int version, [In] int* sizes, int n)
    {
        ReadOnlySpan<int> mine = Sizes;
        if (sizes == null || n < 1 || n > mine.Length)
        {
            return Guard.Fail(NativeStatus.Argument, $"sizes must not be null, and n is {n}; allowed: 1 to {mine.Length}.");
        }

        var given = new ReadOnlySpan<int>(sizes, n);
        for (int i = 0; i < n; i++)
        {
            if (given[i] != mine[i])
            {
                return Guard.Fail(NativeStatus.Abi, $"sizes[{i}] is {given[i]}; allowed: {mine[i]}, that of the loaded library.");
            }
        }

        return version == AbiVersion ? NativeStatus.Ok : Guard.Fail(NativeStatus.Abi, $"version is {version}; allowed: {AbiVersion}, that of the loaded library.");
    }

    /// <summary>Returns the version of the library, for example "0.1.0".</summary>
    /// <returns>a text in UTF-8, valid while the library is loaded.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_version")]
    public static byte* Version() => s_version;

    /// <summary>Returns the message of the last call of this thread that failed: field, value and range. A call that succeeds does not change it.</summary>
    /// <returns>a text in UTF-8, valid until the thread's next call that fails; "" if no call has failed.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_last_error")]
    public static byte* LastError()
    {
        try
        {
            byte* error = ThreadMemory.Mine.Error;
            return error is null ? s_noError : error;
        }
        catch (OutOfMemoryException)
        {
            return s_noError;
        }
    }

    /// <summary>Reads, checks and compiles a scene.</summary>
    /// <param name="json">An object in UTF-8 with members of a scenario: profile, ball, air, gravity, forces, ground, goals, obstacles, nets, zones, dials, solver; {} for the default scene.</param>
    /// <param name="jsonBytes">Its length in bytes, without a terminating zero; at most 1 048 576.</param>
    /// <param name="scene">Receives the handle; null if the call fails.</param>
    /// <returns>FP_OK, FP_SCENE if the text is rejected, or FP_ARGUMENT.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_scene_create")]
    public static NativeStatus SceneCreate([In] byte* json, long jsonBytes, NativeScene** scene)
    {
        try
        {
            Guard.Given(scene, "scene");
            *scene = null;
            nuint handle = Handles.Add(Requests.Scene(Requests.Text(json, jsonBytes, "json")));
            *scene = (NativeScene*)handle;
            return Guard.Made(handle);
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Frees a scene. A running call of another thread finishes normally.</summary>
    /// <param name="scene">The scene; null or a freed handle is rejected.</param>
    /// <returns>FP_OK, or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_scene_free")]
    public static NativeStatus SceneFree(NativeScene* scene)
    {
        try
        {
            Guard.SceneOf(scene);
            return Handles.Remove((nuint)scene) ? NativeStatus.Ok : Guard.Fail(NativeStatus.Handle, "scene was freed by another thread.");
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Writes the name of the object of an event: "ground", "left post", or the name of an obstacle.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="thing">The member thing of the event; the name of -1 is "".</param>
    /// <param name="name">Receives the name in UTF-8, with a terminating zero.</param>
    /// <param name="capacity">The number of bytes at name, at least 1. If the name is longer, it is truncated, and the call returns FP_BUFFER.</param>
    /// <returns>FP_OK, FP_BUFFER, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_name")]
    public static NativeStatus Name([In] NativeScene* scene, int thing, byte* name, int capacity)
    {
        try
        {
            return WriteName(Guard.SceneOf(scene).Simulator, thing, name, capacity);
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Computes the energy that an impact with a bumper added to the ball. A bumper is an obstacle with a restitution above 1 or a minimum exit speed.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="event">An event of a step in that scene.</param>
    /// <returns>the energy, J; 0 for any other event, or if a pointer is rejected.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_added_energy")]
    public static double AddedEnergy([In] NativeScene* scene, [In] NativeEvent* @event)
    {
        try
        {
            CompiledScene compiled = Guard.SceneOf(scene);
            Guard.Given(@event, "event");
            Scene made = compiled.Simulator.Scene;
            if (@event->Kind != (int)BallEventKind.Impact || @event->Thing < 1 || @event->Thing > made.Obstacles.Count)
            {
                return 0;
            }

            // The first collider is the ground, the others are the obstacles. Their motion is constant, and none of them has a mass.
            Obstacle hit = made.Obstacles[@event->Thing - 1];
            Vector3d n = Guard.Vector(@event->Normal, "event");
            Vector3d contact = Guard.Vector(@event->Position, "event") - (made.Ball.Radius * n);
            Vector3d surface = hit.Velocity + Vector3d.Cross(hit.Spin, contact - (hit.Pivot + (@event->Time * hit.Velocity)));
            double before = Vector3d.Dot(Guard.Vector(@event->VelocityBefore, "event") - surface, in n);
            double after = Vector3d.Dot(Guard.Vector(@event->Velocity, "event") - surface, in n);
            bool adds = hit.Surface.NormalRestitution > 1 || hit.Surface.MinimumExitSpeed > 0;
            double added = adds ? Math.Max(0, 0.5 * made.Ball.Mass * ((after * after) - (before * before))) : 0;
            return double.IsFinite(added) ? added : 0;
        }
        catch (Exception e)
        {
            Guard.Fail(e);
            return 0;
        }
    }

    /// <summary>Returns a 64-bit hash of a state. It equals Snapshot.Hash in C#, and is the same on every machine.</summary>
    /// <param name="state">The state.</param>
    /// <returns>the hash; 0 if the state is null.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_hash")]
    public static ulong Hash([In] NativeState* state)
    {
        try
        {
            Guard.Given(state, "state");
            return Snapshot.Hash(in *(BallState*)state);
        }
        catch (Exception e)
        {
            Guard.Fail(e);
            return 0;
        }
    }

    private static NativeStatus WriteName(Simulator simulator, int thing, byte* name, int capacity)
    {
        Guard.Given(name, "name");
        Guard.AtLeast(capacity, 1, "capacity");
        string text = simulator.NameOf(thing) ?? "";
        return ThreadMemory.Copy(text, name, capacity)
            ? NativeStatus.Ok
            : Guard.Fail(NativeStatus.Buffer, string.Create(CultureInfo.InvariantCulture, $"capacity is {capacity}; the name \"{text}\" has more bytes."));
    }

    private static byte* MakeText(string text)
    {
        byte[] bytes = System.Text.Encoding.UTF8.GetBytes(text + "\0");
        byte* copy = (byte*)NativeMemory.Alloc((nuint)bytes.Length);
        bytes.CopyTo(new Span<byte>(copy, bytes.Length));
        return copy;
    }
}
