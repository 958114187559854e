using System.Threading.Tasks.Dataflow;

namespace FootballPhysics.Scenarios.Input;

/// <summary>Processes lines on several threads, and returns the answers in input order. It holds only a few lines in memory.</summary>
public static class BatchPipeline
{
    /// <summary>The maximum number of lines in progress, per job. Answers wait for those of earlier lines.</summary>
    private const int Ahead = 16;

    /// <summary>Processes every line that is not blank.</summary>
    /// <param name="input">The source of the lines.</param>
    /// <param name="jobs">The number of lines that are processed in parallel.</param>
    /// <param name="answer">Computes the answer to a line; must not throw.</param>
    /// <param name="onAnswer">Called with each answer, in input order, from one thread at a time.</param>
    public static async Task RunAsync(LineReader input, int jobs, Func<InputLine, Answer> answer, Action<Answer> onAnswer)
    {
        var work = new TransformBlock<InputLine, Answer>(
            answer, new ExecutionDataflowBlockOptions { MaxDegreeOfParallelism = jobs, BoundedCapacity = jobs * Ahead, SingleProducerConstrained = true });
        Task reading = Task.Run(() => ReadAsync(input, work));
        try
        {
            await foreach (Answer next in work.ReceiveAllAsync().ConfigureAwait(false))
            {
                onAnswer(next);
            }
        }
        finally
        {
            // If writing failed, decline further input.
            work.Complete();
        }

        await work.Completion.ConfigureAwait(false);
        await reading.ConfigureAwait(false);
    }

    /// <summary>Reads the lines. It reports a read error only after the results of all earlier lines.</summary>
    private static async Task ReadAsync(LineReader input, TransformBlock<InputLine, Answer> work)
    {
        try
        {
            while (input.ReadLine() is { } line && (line.IsBlank || await work.SendAsync(line).ConfigureAwait(false)))
            {
            }
        }
        finally
        {
            work.Complete();
        }
    }
}
