using System.Threading.Channels;

namespace Football.Physics.Headless.Input;

/// <summary>Answers lines on several threads, in input order, without holding more than a few of them.</summary>
internal sealed class BatchPipeline(int jobs, Func<InputLine, Answer> answer)
{
    /// <summary>Answers that may wait for one before them, per job.</summary>
    private const int Ahead = 16;

    /// <summary>Answers every line that is not blank.</summary>
    /// <param name="input">Where lines come from.</param>
    /// <param name="onAnswer">Called with each answer, in input order, from one thread at a time.</param>
    /// <param name="cancel">Ends early.</param>
    public async Task RunAsync(LineReader input, Action<Answer> onAnswer, CancellationToken cancel)
    {
        using var stop = CancellationTokenSource.CreateLinkedTokenSource(cancel);
        Channel<Task<Answer>> order = Channel.CreateBounded<Task<Answer>>(jobs * Ahead);
        Task reading = Task.Run(() => ReadAsync(input, order.Writer, stop.Token), CancellationToken.None);
        try
        {
            await foreach (Task<Answer> next in order.Reader.ReadAllAsync(stop.Token).ConfigureAwait(false))
            {
                onAnswer(await next.ConfigureAwait(false));
            }
        }
        finally
        {
            await stop.CancelAsync().ConfigureAwait(false);
        }

        await reading.ConfigureAwait(false);
    }

    /// <summary>Of a line that was cut nobody knows what came later.</summary>
    private static bool IsBlank(InputLine line) => line.Length == line.Text.Length && line.Text.AsSpan().IndexOfAnyExcept(" \t\r"u8) < 0;

    private async Task ReadAsync(LineReader input, ChannelWriter<Task<Answer>> order, CancellationToken cancel)
    {
        using var free = new SemaphoreSlim(jobs);
        var running = new List<Task>();
        Exception? failure = null;
        try
        {
            while (input.ReadLine() is { } line)
            {
                if (IsBlank(line))
                {
                    continue;
                }

                await free.WaitAsync(cancel).ConfigureAwait(false);
                Task<Answer> task = Task.Run(() => AnswerOne(line, free), CancellationToken.None);
                running.RemoveAll(done => done.IsCompleted);
                running.Add(task);
                await order.WriteAsync(task, cancel).ConfigureAwait(false);
            }
        }
        catch (Exception e) when (e is IOException or OperationCanceledException)
        {
            failure = e;
        }

        // The semaphore must outlive those that release it.
        await Task.WhenAll(running).ConfigureAwait(false);
        order.Complete(failure);
    }

    private Answer AnswerOne(InputLine line, SemaphoreSlim free)
    {
        try
        {
            return answer(line);
        }
        finally
        {
            free.Release();
        }
    }
}
