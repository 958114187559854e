using System.Buffers;

namespace FootballPhysics.Tool.Sweep;

/// <summary>Some rows, written.</summary>
internal sealed class RowChunk(int files)
{
    /// <summary>The bytes to append to each file.</summary>
    public ArrayBufferWriter<byte>[] Files { get; } = [.. Enumerable.Range(0, files).Select(_ => new ArrayBufferWriter<byte>(1 << 12))];

    /// <summary>How many rows.</summary>
    public int Rows { get; set; }

    /// <summary>How many of them lanes handed to the single ball.</summary>
    public long FlownSingly { get; set; }
}
