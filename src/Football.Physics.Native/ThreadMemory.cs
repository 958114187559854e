using System.Buffers;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Text.Unicode;

namespace FootballPhysics.Native;

/// <summary>What each thread that calls has of its own: the log of its steps, made by its first call, and its last error.</summary>
internal sealed unsafe class ThreadMemory
{
    /// <summary>Bytes that a sentence may have; a longer one is cut.</summary>
    private const int LongestError = 2048;

    [ThreadStatic]
    private static ThreadMemory? t_mine;

    private readonly StepLog _log = new();
    private byte* _error;

    private ThreadMemory()
    {
    }

    ~ThreadMemory() => NativeMemory.Free(_error);

    /// <summary>That of this thread.</summary>
    public static ThreadMemory Mine
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => t_mine ?? Make();
    }

    /// <summary>A log without events, for what is stepped now. Its counts go on: nothing reads them.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public StepLog ClearLog()
    {
        if (_log.Events.Count > 0)
        {
            _log.Clear();
        }

        return _log;
    }

    /// <summary>The sentence of the last call that failed, UTF-8 with a zero at its end; null before.</summary>
    public byte* Error => _error;

    /// <summary>Keeps a sentence. What was returned before stays where it is, and reads as the new one.</summary>
    public void Fail(string sentence)
    {
        if (_error is null)
        {
            _error = (byte*)NativeMemory.AllocZeroed(LongestError);
        }

        Copy(sentence, _error, LongestError);
    }

    /// <summary>Writes a text as UTF-8 with a zero at its end, cut between two characters where there is no room.</summary>
    /// <returns>False where it was cut.</returns>
    public static bool Copy(string text, byte* into, int capacity)
    {
        OperationStatus status = Utf8.FromUtf16(text, new Span<byte>(into, capacity - 1), out _, out int used, replaceInvalidSequences: true);
        into[used] = 0;
        return status == OperationStatus.Done;
    }

    private static ThreadMemory Make() => t_mine = new ThreadMemory();
}
