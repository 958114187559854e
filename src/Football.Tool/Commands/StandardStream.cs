namespace FootballPhysics.Tool.Commands;

/// <summary>A standard output or error stream. If the data stream is closed, the run ends. If the stream of hints is closed, output to it is ignored.</summary>
/// <param name="inner">The underlying stream.</param>
/// <param name="carriesData">True if the stream carries data, so that all of it must arrive.</param>
internal sealed class StandardStream(Stream inner, bool carriesData) : Stream
{
    private const int BrokenPipe = 32;
    private const int WindowsBrokenPipe = unchecked((int)0x8007006D);
    private const int WindowsNoData = unchecked((int)0x800700E8);

    public override bool CanRead => false;

    public override bool CanSeek => false;

    public override bool CanWrite => true;

    public override long Length => throw new NotSupportedException();

    public override long Position
    {
        get => throw new NotSupportedException();
        set => throw new NotSupportedException();
    }

    public override void Write(ReadOnlySpan<byte> buffer)
    {
        try
        {
            inner.Write(buffer);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ObjectDisposedException)
        {
            Failed(e);
        }
    }

    public override void Write(byte[] buffer, int offset, int count) => Write(buffer.AsSpan(offset, count));

    public override void Flush()
    {
        try
        {
            inner.Flush();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ObjectDisposedException)
        {
            Failed(e);
        }
    }

    public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

    public override void SetLength(long value) => throw new NotSupportedException();

    /// <summary>Handles a failed write: a full disk is an error, a closed descriptor or pipe is not.</summary>
    private void Failed(Exception e)
    {
        bool closed = e is not IOException || e.HResult is BrokenPipe or WindowsBrokenPipe or WindowsNoData;
        if (carriesData && closed)
        {
            throw new OutputClosedException(e);
        }

        if (carriesData)
        {
            throw e;
        }
    }
}
