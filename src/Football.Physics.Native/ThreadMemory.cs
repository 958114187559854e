using System.Buffers;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Text.Unicode;

namespace FootballPhysics.Native;

/// <summary>The data of each calling thread: the log of its steps, created by its first call, its last error, and its last aim.</summary>
internal sealed unsafe class ThreadMemory
{
    /// <summary>The maximum length of a message in bytes; a longer message is truncated.</summary>
    private const int LongestText = 2048;

    [ThreadStatic]
    private static ThreadMemory? t_mine;

    private readonly StepLog _log = new();
    private byte* _error;
    private byte* _reason;

    private ThreadMemory()
    {
    }

    ~ThreadMemory()
    {
        NativeMemory.Free(_error);
        NativeMemory.Free(_reason);
    }

    /// <summary>The data of the calling thread.</summary>
    public static ThreadMemory Mine { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => t_mine ?? Make(); }

    /// <summary>Returns a log without events, for the next step. Its counters are not reset, because nothing reads them.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public StepLog ClearLog()
    {
        if (_log.Events.Count > 0)
        {
            _log.Clear();
        }

        return _log;
    }

    /// <summary>The message of the last call that failed, in UTF-8 with a terminating zero; null if no call has failed.</summary>
    public byte* Error => _error;

    /// <summary>Stores a message. A pointer that was returned before stays valid and shows the new message.</summary>
    public void Fail(string sentence) => Put(sentence, ref _error);

    /// <summary>The result of the last aim; a hit if there is none.</summary>
    public AimResult Aim { get; set; }

    /// <summary>Writes the reason for the last aim in UTF-8 with a terminating zero; empty for a hit.</summary>
    public byte* AimReason() => Put(Aim.Reason ?? "", ref _reason);

    /// <summary>Writes a text as UTF-8 with a terminating zero. If it does not fit, truncates it between two characters.</summary>
    /// <returns>False if the message was truncated.</returns>
    public static bool Copy(string text, byte* into, int capacity)
    {
        OperationStatus status = Utf8.FromUtf16(text, new Span<byte>(into, capacity - 1), out _, out int used, replaceInvalidSequences: true);
        into[used] = 0;
        return status == OperationStatus.Done;
    }

    private static byte* Put(string text, ref byte* into)
    {
        if (into is null)
        {
            into = (byte*)NativeMemory.AllocZeroed(LongestText);
        }

        Copy(text, into, LongestText);
        return into;
    }

    private static ThreadMemory Make() => t_mine = new ThreadMemory();
}
