using System.Diagnostics;
using System.Globalization;
using FootballPhysics.Tool.Commands;
using FootballPhysics.Tool.Sweep.Output;

namespace FootballPhysics.Tool.Sweep;

/// <summary>Shows the progress of a sweep: as a bar in a terminal, and as a line every 30 s in a log.</summary>
internal sealed class SweepReport(Terminal terminal, Progress progress, RowSink sink, long rows)
{
    private static readonly TimeSpan s_untilLine = TimeSpan.FromSeconds(30);

    private readonly Stopwatch _clock = Stopwatch.StartNew();
    private readonly long _before = sink.Rows;
    private TimeSpan _lastLine;

    private double Rate => (sink.Rows - _before) / _clock.Elapsed.TotalSeconds;

    /// <summary>Shows the number of rows written.</summary>
    public void Show(long done)
    {
        progress.Report(done - _before, rows - _before);
        if (sink is FolderSink && terminal.ErrorRedirected && _clock.Elapsed - _lastLine >= s_untilLine)
        {
            _lastLine = _clock.Elapsed;
            terminal.Error.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{done} of {rows} rows, {Rate:0} rows/s, {(rows - done) / Rate:0} s left"));
        }
    }

    /// <summary>Returns a one-line summary of the run.</summary>
    /// <param name="folder">The folder of the rows.</param>
    public string Line(string folder)
    {
        string how = sink.Rows == _before
            ? "all there before"
            : string.Create(CultureInfo.InvariantCulture, $"{sink.Rows - _before} of them now in {_clock.Elapsed.TotalSeconds:0.0} s, {Rate:0} rows/s");
        string handedOn = sink.Counts.HandedOn is { } singly ? string.Create(CultureInfo.InvariantCulture, $"; {singly} handed to the single ball") : "";
        string unknown = Unknown(sink) is { } some ? "\n" + some : "";
        using var self = Process.GetCurrentProcess();
        return string.Create(CultureInfo.InvariantCulture, $"{folder}: {sink.Rows} rows, {how}{handedOn}; at most {self.PeakWorkingSet64 >> 20} MiB of memory{unknown}");
    }

    /// <summary>Returns a line that counts the rows without an outcome, and gives the reasons; null if there are no such rows.</summary>
    public static string? Unknown(RowSink sink)
    {
        if (sink.Counts is not { Unknown: > 0 and var unknown } counts)
        {
            return null;
        }

        (long? Count, string Reason)[] reasons =
        [
            (counts.StillMoving, "the ball still moves at the end of the longest flight"),
            (counts.TooManyEvents, "the flight has more events than are kept"),
            (counts.Overflowed, "the motion cannot be continued after the recorded end"),
        ];
        string why = string.Join("; ", reasons.Where(reason => reason.Count > 0).Select(reason => string.Create(CultureInfo.InvariantCulture, $"{reason.Count}: {reason.Reason}")));
        return string.Create(CultureInfo.InvariantCulture, $"The outcome of {unknown} of {sink.Rows} rows is unknown ({why}).");
    }
}
