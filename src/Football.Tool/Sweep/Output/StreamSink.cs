using System.Buffers;

namespace FootballPhysics.Tool.Sweep.Output;

/// <summary>Writes rows to the standard output.</summary>
internal sealed class StreamSink : RowSink
{
    private readonly Stream _output;

    public StreamSink(Stream output, byte[] header, RowCounts noRows)
        : base(noRows)
    {
        _output = output;
        _output.Write(header);
    }

    public override void Finish() => _output.Flush();

    public override void Dispose()
    {
    }

    protected override void Write(IReadOnlyList<ArrayBufferWriter<byte>> files)
    {
        _output.Write(files[0].WrittenSpan);
        _output.Flush();
    }
}
