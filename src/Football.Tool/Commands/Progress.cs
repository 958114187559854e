using Spectre.Console;

namespace FootballPhysics.Tool.Commands;

/// <summary>A line with the progress, the rate and the remaining time of a long computation. It is hidden if the error output is redirected.</summary>
internal sealed class Progress
{
    private readonly ProgressTask? _task;

    private Progress(ProgressTask? task) => _task = task;

    /// <summary>Runs a computation and shows its progress in a line, which disappears at the end.</summary>
    /// <param name="terminal">The terminal that shows the line.</param>
    /// <param name="what">The label of the line.</param>
    /// <param name="work">The computation.</param>
    /// <param name="writes">True if the computation writes to the output. In the same terminal, the line would then disturb the output, so it is
    /// hidden.</param>
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

    /// <summary>Shows the current activity.</summary>
    public void Report(Func<string> what)
    {
        if (_task is not null)
        {
            _task.Description = Cell.Of(what());
        }
    }

    /// <summary>Shows the completed amount and the total.</summary>
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
