using System.Buffers;

namespace FootballPhysics.Tool.Sweep;

/// <summary>Consecutive rows in the format of the output.</summary>
internal sealed class RowChunk(int files)
{
    /// <summary>The bytes to append to each file.</summary>
    public ArrayBufferWriter<byte>[] Files { get; } = [.. Enumerable.Range(0, files).Select(_ => new ArrayBufferWriter<byte>(1 << 12))];

    /// <summary>The number of rows.</summary>
    public int Rows { get; set; }

    /// <summary>The counts of these rows.</summary>
    public RowCounts Counts { get; set; }
}
