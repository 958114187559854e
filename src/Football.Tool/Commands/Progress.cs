using Spectre.Console;

namespace FootballPhysics.Tool.Commands;

/// <summary>A line with the progress, the rate and the remaining time of long work; nothing if the error output is redirected.</summary>
internal sealed class Progress
{
    private readonly ProgressTask? _task;

    private Progress(ProgressTask? task) => _task = task;

    /// <summary>Works, with the line below; it is gone afterwards.</summary>
    /// <param name="terminal">Where the line is shown.</param>
    /// <param name="what">The label of the work.</param>
    /// <param name="work">Does it.</param>
    /// <param name="writes">Whether it writes to the output meanwhile: in the same terminal the line would be in the way.</param>
    public static T Show<T>(Terminal terminal, string what, Func<Progress, T> work, bool writes = false) =>
        terminal.ErrorRedirected || (writes && !terminal.OutputRedirected)
            ? work(new Progress(null))
            : terminal.ErrorConsole.Progress()
                .AutoClear(true)
                .Columns(
                    new SpinnerColumn(), new TaskDescriptionColumn(), new ProgressBarColumn(), new PercentageColumn(), new RateColumn(), new RemainingTimeColumn())
                .Start(context =>
                {
                    ProgressTask task = context.AddTask(Cell.Of(what));
                    task.IsIndeterminate = true;
                    return work(new Progress(task));
                });

    /// <summary>Says what is being done now.</summary>
    public void Report(Func<string> what)
    {
        if (_task is not null)
        {
            _task.Description = Cell.Of(what());
        }
    }

    /// <summary>Says how much is done of how much there is.</summary>
    public void Report(double done, double total, Func<string>? what = null)
    {
        if (_task is null)
        {
            return;
        }

        _task.IsIndeterminate = false;
        _task.MaxValue = Math.Max(total, done);
        _task.Value = done;
        if (what is not null)
        {
            Report(what);
        }
    }
}
