using System.Globalization;
using System.Runtime.InteropServices;

namespace FootballPhysics.Native;

/// <content>Matches as bytes: saved for a rollback, or recorded for a replay.</content>
internal static unsafe partial class Exports
{
    /// <summary>Saves a match between two steps: balls, kicks, restarts, bodies and movable obstacles. After fp_match_restore, the steps are bit-identical. Allocates nothing.</summary>
    /// <param name="match">The match.</param>
    /// <param name="bytes">Receives the bytes, which are the same on every machine; null if capacity is 0.</param>
    /// <param name="capacity">The number of bytes that fit, 0 or more.</param>
    /// <param name="written">Receives the total number of bytes, which is fixed for a match; null to skip it.</param>
    /// <returns>FP_OK; FP_BUFFER if capacity is too small, with nothing written at bytes; FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_save")]
    public static NativeStatus MatchSave([In] NativeMatch* match, CByte* bytes, long capacity, long* written)
    {
        try
        {
            Match played = Guard.MatchOf(match);
            Guard.Bytes(bytes, capacity, "capacity");
            lock (played.Gate)
            {
                played.Plays();
                int size = played.Blob.Size;
                if (capacity >= size)
                {
                    played.Blob.Save(new Span<byte>(bytes, size));
                }

                return Fits(size, capacity, written);
            }
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Restores a match from the bytes of fp_match_save, also in another process or on another machine. Allocates nothing.</summary>
    /// <param name="match">The saved match, or one that was created with the same arguments by the same version of the library.</param>
    /// <param name="bytes">The bytes.</param>
    /// <param name="n">The number of bytes.</param>
    /// <returns>FP_OK; FP_ARGUMENT if the bytes are corrupt, or belong to another match or to an earlier version of the library, or FP_HANDLE, with nothing changed.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_restore")]
    public static NativeStatus MatchRestore(NativeMatch* match, [In] CByte* bytes, long n)
    {
        try
        {
            Match played = Guard.MatchOf(match);
            Guard.Bytes(bytes, n, "n");
            lock (played.Gate)
            {
                played.Plays();
                played.Blob.Restore(bytes, n);
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Starts a recording at this tick. It ends when you place a ball, or restore a state that it does not contain.</summary>
    /// <param name="match">The match.</param>
    /// <returns>FP_OK, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_record")]
    public static NativeStatus MatchRecord(NativeMatch* match)
    {
        try
        {
            Match played = Guard.MatchOf(match);
            lock (played.Gate)
            {
                played.Plays();
                played.Runner.Record();
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Returns the recording so far as bytes, which Recording.FromBytes also reads in C#. The recording continues.</summary>
    /// <param name="match">The match.</param>
    /// <param name="bytes">Receives the bytes; null if capacity is 0.</param>
    /// <param name="capacity">The number of bytes that fit, 0 or more.</param>
    /// <param name="written">Receives the total number of bytes; null to skip it.</param>
    /// <returns>FP_OK; FP_BUFFER if capacity is too small, with nothing written at bytes; FP_ARGUMENT if no recording was started, or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_recording")]
    public static NativeStatus MatchRecording([In] NativeMatch* match, CByte* bytes, long capacity, long* written)
    {
        try
        {
            Match played = Guard.MatchOf(match);
            Guard.Bytes(bytes, capacity, "capacity");
            byte[] all;
            lock (played.Gate)
            {
                all = played.Runner.Recording?.ToBytes() ?? throw new ArgumentException("match has no recording, or it has ended. Start one with fp_match_record.");
            }

            if (capacity >= all.Length)
            {
                all.CopyTo(new Span<byte>(bytes, all.Length));
            }

            return Fits(all.Length, capacity, written);
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Creates a match at the start of a recording. Its steps repeat the recorded kicks, restarts and the motions of the bodies; you can only step, seek and read it.</summary>
    /// <param name="json">The scene, as for fp_match_create.</param>
    /// <param name="jsonBytes">Its length in bytes; at most 1 048 576.</param>
    /// <param name="recording">The recording: bytes from fp_match_recording, or from Recording.ToBytes in C# for a BallGroup.</param>
    /// <param name="n">The number of bytes of the recording.</param>
    /// <param name="match">Receives the handle; null if the call fails.</param>
    /// <returns>FP_OK, FP_SCENE if the text is rejected, or FP_ARGUMENT if the recording is corrupt or belongs to another scene.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_replay")]
    public static NativeStatus MatchReplay([In] byte* json, long jsonBytes, [In] CByte* recording, long n, NativeMatch** match)
    {
        try
        {
            Guard.Given(match, "match");
            *match = null;
            ReadOnlySpan<byte> text = Requests.Text(json, jsonBytes, "json");
            Guard.Given(recording, "recording");
            Guard.Within(n, 0, int.MaxValue, "n");
            nuint handle = Handles.Add(Requests.Replay(text, new ReadOnlySpan<byte>(recording, (int)n)));
            *match = (NativeMatch*)handle;
            return Guard.Made(handle);
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Moves a replay to a tick, forwards or backwards, by at most 63 steps from a recorded state.</summary>
    /// <param name="match">A match from fp_match_replay.</param>
    /// <param name="tick">The tick, from the first to the last of the recording.</param>
    /// <returns>FP_OK, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_seek")]
    public static NativeStatus MatchSeek(NativeMatch* match, long tick)
    {
        try
        {
            Match played = Guard.MatchOf(match);
            lock (played.Gate)
            {
                played.Replayed.Seek(played.Runner, tick);
                played.ForgetImpulses();
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Replays a recording from its start, and compares the hash of the balls after every step. The replay then is at the tick that differs, or at the end.</summary>
    /// <param name="match">A match from fp_match_replay.</param>
    /// <param name="tick">Receives the first tick at which the balls differ; -1 if all are bit-identical.</param>
    /// <returns>FP_OK, FP_ARGUMENT or FP_HANDLE.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_match_verify")]
    public static NativeStatus MatchVerify(NativeMatch* match, long* tick)
    {
        try
        {
            Match played = Guard.MatchOf(match);
            Guard.Given(tick, "tick");
            lock (played.Gate)
            {
                *tick = played.FirstDivergence();
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    /// <summary>Writes the number of bytes. Returns FP_BUFFER if it exceeds the capacity.</summary>
    private static NativeStatus Fits(int size, long capacity, long* written)
    {
        if (written is not null)
        {
            *written = size;
        }

        return capacity >= size
            ? NativeStatus.Ok
            : Guard.Fail(NativeStatus.Buffer, string.Create(CultureInfo.InvariantCulture, $"capacity is {capacity}; there are {size} bytes."));
    }
}
