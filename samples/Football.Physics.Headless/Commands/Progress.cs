using System.Diagnostics;

namespace Football.Physics.Headless.Commands;

/// <summary>One line that tells how far long work is; nothing where nobody looks, or where the work is short.</summary>
internal sealed class Progress(Terminal terminal) : IDisposable
{
    private static readonly TimeSpan Interval = TimeSpan.FromMilliseconds(500);

    private readonly Stopwatch _since = Stopwatch.StartNew();
    private int _shown;

    /// <summary>Shows the text in the place of the last one, at most twice a second.</summary>
    public void Report(Func<string> text)
    {
        if (terminal.ErrorRedirected || _since.Elapsed < Interval)
        {
            return;
        }

        _since.Restart();
        string line = text();
        terminal.Error.Write("\r" + line.PadRight(_shown));
        terminal.Error.Flush();
        _shown = line.Length;
    }

    public void Dispose() => Clear();

    /// <summary>Takes the line away, to make room for another.</summary>
    public void Clear()
    {
        if (_shown > 0)
        {
            terminal.Error.Write("\r" + new string(' ', _shown) + "\r");
            terminal.Error.Flush();
            _shown = 0;
        }
    }
}
