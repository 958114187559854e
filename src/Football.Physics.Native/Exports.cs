using System.Globalization;
using System.Runtime.InteropServices;

namespace FootballPhysics.Native;

/// <summary>The functions that C sees. The header is made of them and of their documentation.</summary>
/// <remarks>
/// None throws, keeps a pointer of the caller's, or calls back. A refused call has changed nothing that the caller gave. What a step needs was made with the
/// scene, and by the first call of the thread: a step allocates nothing.
/// </remarks>
internal static unsafe partial class Exports
{
    /// <summary>The version of the interface: sizes, names and meaning.</summary>
    public const int AbiVersion = 1;

    private static readonly byte* s_noError = MakeText("");
    private static readonly byte* s_version = MakeText(typeof(Scene).Assembly.GetName().Version!.ToString(3));

    /// <summary>Checks that header and library belong together. Call it once, as FP_CHECK_ABI().</summary>
    /// <param name="version">FP_ABI_VERSION.</param>
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

    /// <summary>Checks the sizes of the structures that fp_check_abi does not check. FP_CHECK_ABI() calls both.</summary>
    /// <param name="bodyBytes">sizeof(fp_body).</param>
    /// <param name="matchEventBytes">sizeof(fp_match_event).</param>
    /// <param name="playerBytes">sizeof(fp_player).</param>
    /// <param name="interceptionBytes">sizeof(fp_interception).</param>
    /// <param name="windowBytes">sizeof(fp_window).</param>
    /// <param name="goalChanceBytes">sizeof(fp_goal_chance_result).</param>
    /// <param name="fitBytes">sizeof(fp_fit_result).</param>
    /// <param name="pieceBytes">sizeof(fp_piece).</param>
    /// <param name="fitMatchBytes">sizeof(fp_fit_match_result).</param>
    /// <returns>FP_OK, or FP_ABI.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_check_structs")]
    public static NativeStatus CheckStructs(
        int bodyBytes, int matchEventBytes, int playerBytes, int interceptionBytes, int windowBytes, int goalChanceBytes, int fitBytes, int pieceBytes, int fitMatchBytes)
    {
        (int, int, int, int, int, int, int, int, int) mine = (
            sizeof(NativeBody), sizeof(NativeMatchEvent), sizeof(NativePlayer), sizeof(NativeInterception), sizeof(NativeWindow), sizeof(NativeGoalChanceResult),
            sizeof(NativeFitResult), sizeof(NativePiece), sizeof(NativeFitMatchResult));
        (int, int, int, int, int, int, int, int, int) given =
            (bodyBytes, matchEventBytes, playerBytes, interceptionBytes, windowBytes, goalChanceBytes, fitBytes, pieceBytes, fitMatchBytes);
        return given == mine
            ? NativeStatus.Ok
            : Guard.Fail(NativeStatus.Abi, $"the bytes of the structures are {given}; allowed: {mine}, those of the loaded library.");
    }

    /// <summary>The version of the library, like "0.1.0".</summary>
    /// <returns>a text in UTF-8, for as long as the library is loaded.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_version")]
    public static byte* Version() => s_version;

    /// <summary>The sentence of the last call of this thread that failed: field, value and range. No call that succeeds changes it.</summary>
    /// <returns>a text in UTF-8, until the thread's next call that fails; "" where none has.</returns>
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
    /// <param name="json">An object in UTF-8 with members of a scenario: profile, ball, air, gravity, forces, ground, goals, obstacles, nets, zones, dials, solver; {} is the default scene.</param>
    /// <param name="jsonBytes">Its length in bytes, without a zero at its end; at most 1 048 576.</param>
    /// <param name="scene">Where the handle goes; null there where the call fails.</param>
    /// <returns>FP_OK, FP_SCENE where the text is refused, or FP_ARGUMENT.</returns>
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

    /// <summary>Frees a scene. A call of another thread that uses it goes on to its end.</summary>
    /// <param name="scene">The scene; a handle that is freed twice is refused, and so is null.</param>
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

    /// <summary>The name of what an event tells of: "ground", "left post", an obstacle's.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="thing">The event's thing; -1 has the name "".</param>
    /// <param name="name">Where it goes, UTF-8 with a zero at its end.</param>
    /// <param name="capacity">Bytes there, at least 1; where they are too few, the name is cut, and the call returns FP_BUFFER.</param>
    /// <returns>FP_OK, FP_BUFFER, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_name")]
    public static NativeStatus Name([In] NativeScene* scene, int thing, byte* name, int capacity)
    {
        try
        {
            return TellName(Guard.SceneOf(scene).Simulator, thing, name, capacity);
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>The energy that an impact with a bumper added to the ball: an obstacle whose restitution is above 1, or that has a least exit speed.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="event">An event of a step in that scene.</param>
    /// <returns>the energy, J; 0 for any other event, and where a pointer is refused.</returns>
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

            // Colliders are the ground, then the obstacles. Their motion is constant, and none of them has a mass.
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

    /// <summary>A hash of a state, of 64 bits: the one that Snapshot.Hash has in C#, on every machine.</summary>
    /// <param name="state">The state.</param>
    /// <returns>the hash; 0 where the state is null.</returns>
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

    private static NativeStatus TellName(Simulator simulator, int thing, byte* name, int capacity)
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
