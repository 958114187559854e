using System.CommandLine;
using System.Globalization;
using Football.Physics.Headless.Input;
using Football.Physics.Headless.Json;
using Football.Physics.Headless.Schema;
using Football.Physics.Headless.Simulate;

namespace Football.Physics.Headless.Commands;

/// <summary>Reads one scenario or a batch of them, has each answered, and writes the answers.</summary>
/// <param name="fields">The fields that a scenario may have.</param>
/// <param name="answer">Checks a scenario and makes its result line; throws <see cref="RefusedException"/> where it is not as it should be.</param>
internal sealed class BatchRunner(FieldSet fields, Func<string?, JsonValue, ReadOnlyMemory<byte>> answer)
{
    /// <summary>Runs with the arguments given.</summary>
    public int Run(BatchOptions options, ParseResult parsed, Terminal terminal)
    {
        string file = parsed.GetRequiredValue(options.File);
        FieldOverride[] overrides = parsed.GetValue(options.Set) ?? [];
        using Stream input = file == "-" ? terminal.Input : Open(file);
        var reader = new LineReader(input);
        return parsed.GetValue(options.Batch)
            ? RunBatch(reader, overrides, parsed.GetValue(options.Jobs), terminal)
            : RunOne(reader.ReadToEnd(), overrides, terminal);
    }

    private static FileStream Open(string file)
    {
        try
        {
            return File.OpenRead(file);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new RefusedException("FILE", $"{Quote.Short(file)}, which cannot be read", "a file that can be read, or - for the standard input");
        }
    }

    private int RunOne(InputLine text, FieldOverride[] overrides, Terminal terminal)
    {
        Answer answered = AnswerTo(text, overrides);
        if (answered.Refusal is not null)
        {
            terminal.Error.WriteLine($"football: {answered.Refusal}");
            return ExitCode.Refused;
        }

        Write(terminal, answered);
        return ExitCode.Done;
    }

    private int RunBatch(LineReader reader, FieldOverride[] overrides, int jobs, Terminal terminal)
    {
        long done = 0;
        long refused = 0;
        using (var progress = new Progress(terminal))
        {
            var pipeline = new BatchPipeline(jobs, line => AnswerTo(line, overrides));
            pipeline.RunAsync(
                reader,
                answered =>
                {
                    done++;
                    refused += answered.Refusal is null ? 0 : 1;
                    Write(terminal, answered);
                    progress.Report(() => string.Create(CultureInfo.InvariantCulture, $"{done} done, {refused} refused"));
                },
                CancellationToken.None).GetAwaiter().GetResult();
        }

        if (refused == 0)
        {
            return ExitCode.Done;
        }

        terminal.Error.WriteLine(string.Create(CultureInfo.InvariantCulture, $"football: {refused} of {done} refused; each has its reason in its place."));
        return ExitCode.Refused;
    }

    private static void Write(Terminal terminal, Answer answered)
    {
        terminal.Output.Write(answered.Line.Span);
        terminal.Output.Flush();
    }

    private Answer AnswerTo(InputLine line, FieldOverride[] overrides)
    {
        var input = InputCase.Read(line.Text, line.Length, fields, overrides);
        try
        {
            return new Answer(answer(input.Name, input.Scenario ?? throw input.Refusal!), null);
        }
        catch (RefusedException refusal)
        {
            return Refuse(input.Name, refusal.Message);
        }
        catch (Exception e)
        {
            // A fault of this program, not of the input: the other lines of a batch must come out all the same.
            return Refuse(input.Name, $"internal error, {e.GetType().Name}: {Quote.Short(e.Message)}");
        }
    }

    private static Answer Refuse(string? name, string message) => new(ResultWriter.Error(name, message), message);
}
