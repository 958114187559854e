using System.Threading.Tasks.Dataflow;

namespace FootballPhysics.Scenarios.Input;

/// <summary>Answers lines on several threads, in input order, without holding more than a few of them.</summary>
public static class BatchPipeline
{
    /// <summary>Answers that may wait for one before them, per job.</summary>
    private const int Ahead = 16;

    /// <summary>Answers every line that is not blank.</summary>
    /// <param name="input">Where lines come from.</param>
    /// <param name="jobs">How many lines are answered at a time.</param>
    /// <param name="answer">Answers a line; throws nothing.</param>
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
            // If writing failed, no more input is needed: the reader's next line is declined.
            work.Complete();
        }

        await work.Completion.ConfigureAwait(false);
        await reading.ConfigureAwait(false);
    }

    /// <summary>An error is reported only after the results of all earlier lines.</summary>
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
