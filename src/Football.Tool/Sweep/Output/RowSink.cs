using System.Buffers;

namespace FootballPhysics.Tool.Sweep.Output;

/// <summary>Where rows go.</summary>
internal abstract class RowSink : IDisposable
{
    /// <summary>Rows that are there already.</summary>
    public long Rows { get; protected set; }

    /// <summary>How many of them lanes handed to the single ball.</summary>
    public long FlownSingly { get; protected set; }

    /// <summary>Adds rows.</summary>
    /// <param name="files">The bytes to append to each file.</param>
    /// <param name="rows">How many rows that is.</param>
    /// <param name="handedOn">How many of them lanes handed to the single ball.</param>
    public void Add(IReadOnlyList<ArrayBufferWriter<byte>> files, int rows, long handedOn)
    {
        Write(files);
        Rows += rows;
        FlownSingly += handedOn;
        Added();
    }

    /// <summary>Ends it: all rows are there.</summary>
    public abstract void Finish();

    public abstract void Dispose();

    protected abstract void Write(IReadOnlyList<ArrayBufferWriter<byte>> files);

    /// <summary>Rows were added.</summary>
    protected virtual void Added()
    {
    }
}
