using System.Buffers;

namespace FootballPhysics.Tool.Sweep.Output;

/// <summary>A destination of rows.</summary>
/// <param name="counts">The counts of no rows.</param>
internal abstract class RowSink(RowCounts counts) : IDisposable
{
    /// <summary>The number of rows written, including those of earlier runs.</summary>
    public long Rows { get; protected set; }

    /// <summary>The counts of these rows.</summary>
    public RowCounts Counts { get; protected set; } = counts;

    /// <summary>Adds rows.</summary>
    /// <param name="files">The bytes to append to each file.</param>
    /// <param name="rows">The number of rows.</param>
    /// <param name="counts">The counts of these rows.</param>
    public void Add(IReadOnlyList<ArrayBufferWriter<byte>> files, int rows, RowCounts counts)
    {
        Write(files);
        Rows += rows;
        Counts += counts;
        Added();
    }

    /// <summary>Completes the output after the last row.</summary>
    public abstract void Finish();

    public abstract void Dispose();

    protected abstract void Write(IReadOnlyList<ArrayBufferWriter<byte>> files);

    /// <summary>Called after rows were added.</summary>
    protected virtual void Added()
    {
    }
}
