namespace FootballPhysics.Native;

/// <summary>Writes the progress of a long call for C, and checks whether C cancelled the call, in the calling thread.</summary>
internal sealed unsafe class Watch : IProgress<double>, IDisposable
{
    private readonly NativeWatch* _watch;
    private readonly CancellationTokenSource _cancellation = new();

    private Watch(NativeWatch* watch) => _watch = watch;

    /// <summary>Returns the watch of a call; null if the caller passes none.</summary>
    /// <exception cref="ArgumentException">The watch has the size of another version.</exception>
    /// <exception cref="OperationCanceledException">The watch is cancelled already.</exception>
    public static Watch? Of(NativeWatch* watch)
    {
        if (watch is null)
        {
            return null;
        }

        Guard.Within(watch->Bytes, sizeof(NativeWatch), sizeof(NativeWatch), "watch.bytes");
        var made = new Watch(watch);
        made.Report(0);
        made.Token.ThrowIfCancellationRequested();
        return made;
    }

    /// <summary>The token that cancels the call.</summary>
    public CancellationToken Token => _cancellation.Token;

    /// <inheritdoc/>
    public void Report(double value)
    {
        Volatile.Write(ref _watch->Progress, value);
        if (Volatile.Read(ref _watch->Cancel) != 0)
        {
            _cancellation.Cancel();
        }
    }

    /// <inheritdoc/>
    public void Dispose() => _cancellation.Dispose();
}
