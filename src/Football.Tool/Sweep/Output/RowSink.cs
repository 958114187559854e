using System.Buffers;

namespace FootballPhysics.Tool.Sweep.Output;

/// <summary>A destination of rows.</summary>
internal abstract class RowSink : IDisposable
{
    /// <summary>The number of rows written, including those of earlier runs.</summary>
    public long Rows { get; protected set; }

    /// <summary>The number of these rows that the SIMD batch passed to the scalar simulation.</summary>
    public long FlownSingly { get; protected set; }

    /// <summary>Adds rows.</summary>
    /// <param name="files">The bytes to append to each file.</param>
    /// <param name="rows">The number of rows.</param>
    /// <param name="handedOn">The number of these rows that the SIMD batch passed to the scalar simulation.</param>
    public void Add(IReadOnlyList<ArrayBufferWriter<byte>> files, int rows, long handedOn)
    {
        Write(files);
        Rows += rows;
        FlownSingly += handedOn;
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
