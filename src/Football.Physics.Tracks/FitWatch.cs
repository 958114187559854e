namespace FootballPhysics.Tracks;

/// <summary>Reports the progress of a fit, and cancels it.</summary>
/// <remarks>A fit calls <see cref="Check"/> at least once per simulated flight. The number of search steps is unknown in advance, so each check covers the same share of the part that is left.</remarks>
/// <param name="progress">Receives the progress, 0 … 1; null for none.</param>
/// <param name="checks">The usual number of checks in a part, above 1.</param>
/// <param name="cancellation">Cancels the fit.</param>
internal sealed class FitWatch(IProgress<double>? progress, double checks, CancellationToken cancellation)
{
    private readonly double _perCheck = 1 / checks;
    private double _done;
    private double _end;

    /// <summary>Starts a part of the fit, from the end of the part before.</summary>
    /// <param name="end">The progress at the end of the part.</param>
    public void Start(double end)
    {
        _done = Math.Max(_done, _end);
        _end = end;
        Report();
    }

    /// <summary>Reports the progress, and throws if the fit was cancelled.</summary>
    /// <exception cref="OperationCanceledException">The fit was cancelled.</exception>
    public void Check()
    {
        _done += _perCheck * (_end - _done);
        Report();
    }

    /// <summary>Reports the end of the fit.</summary>
    public void Finish() => progress?.Report(1);

    private void Report()
    {
        // The receiver may cancel the fit.
        progress?.Report(_done);
        cancellation.ThrowIfCancellationRequested();
    }
}
