using System.CommandLine;
using System.Globalization;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Commands;

/// <summary>Reads one scenario or a batch, runs each scenario, and writes the results.</summary>
/// <typeparam name="T">The result of a scenario.</typeparam>
/// <param name="work">Reads a scenario and runs it; throws <see cref="RefusedException"/> if it is invalid.</param>
/// <param name="write">Formats the output line of a result.</param>
/// <param name="show">Prints a result in a terminal.</param>
internal sealed class BatchRunner<T>(Func<InputFields, T> work, Func<string?, T, ReadOnlyMemory<byte>> write, Action<T, Terminal> show)
{
    private readonly Argument<string> _file = new("FILE") { Description = "Scenario as JSON; - is standard input." };

    private readonly Option<bool> _batch = new("--batch")
    {
        Description = "FILE has one object per line, a scenario or {\"name\", \"scenario\"}; writes one result per line, in the same order.",
    };

    private readonly Option<bool> _json = new("--json") { Description = "Write JSON in a terminal, too." };
    private readonly Option<long> _jobs = Arguments.Jobs("Threads for a batch; default: one per processor.");
    private readonly Option<FieldOverride[]> _profile = Arguments.Profile();
    private readonly Option<FieldOverride[]> _set = Arguments.Set("solver.timeStep=0.04");

    /// <summary>The command's options that set members of the input from files.</summary>
    public IReadOnlyList<Option<FieldOverride[]>> Tables { get; init; } = [];

    /// <summary>Completes a command: adds the options and the action.</summary>
    /// <param name="command">The command.</param>
    /// <param name="terminal">The input and output.</param>
    /// <param name="instead">An alternative that needs no FILE: its option, and the function that runs it with overrides and the choice of JSON.</param>
    public Command Of(ExampleCommand command, Terminal terminal, (Option<string?> Option, Func<ParseResult, FieldOverride[], bool, int> Run)? instead = null)
    {
        command.Add(_file);
        command.Add(_batch);
        command.Add(_json);
        command.Add(_jobs);
        command.Add(_profile);
        command.Add(_set);
        foreach (Option<FieldOverride[]> table in Tables)
        {
            command.Add(table);
        }

        if (instead is not { } other)
        {
            command.SetAction(parsed => Run(parsed, terminal));
            return command;
        }

        _file.Arity = ArgumentArity.ZeroOrOne;
        command.Validators.Add(result =>
        {
            bool isGiven = result.GetResult(_file) is { Tokens.Count: > 0 };
            if (isGiven == result.GetResult(other.Option) is not null)
            {
                result.AddError($"FILE and {other.Option.Name} exclude each other. Pass exactly one of them.");
            }
        });
        command.SetAction(parsed =>
        {
            bool json = parsed.GetValue(_json) || terminal.OutputRedirected;
            return parsed.GetValue(other.Option) is not null ? other.Run(parsed, Overrides(parsed), json) : Run(parsed, terminal);
        });
        return command;
    }

    private int Run(ParseResult parsed, Terminal terminal)
    {
        FieldOverride[] overrides = Overrides(parsed);
        using Stream input = Arguments.OpenInput(parsed.GetRequiredValue(_file), terminal);
        var reader = new LineReader(input);
        return parsed.GetValue(_batch)
            ? RunBatch(reader, input.CanSeek ? input.Length : null, overrides, (int)parsed.GetValue(_jobs), terminal)
            : RunOne(reader.ReadToEnd(), overrides, terminal, parsed.GetValue(_json) || terminal.OutputRedirected);
    }

    private FieldOverride[] Overrides(ParseResult parsed) => [.. parsed.GetRequiredValue(_profile), .. Tables.SelectMany(parsed.GetRequiredValue), .. parsed.GetRequiredValue(_set)];

    private int RunOne(InputLine text, FieldOverride[] overrides, Terminal terminal, bool json)
    {
        T? done = default;
        Answer answered = AnswerTo(text, overrides, result => done = result);
        if (answered.Refusal is not null)
        {
            terminal.Error.WriteLine($"football: {answered.Refusal}");
            return ExitCode.Refused;
        }

        if (json)
        {
            terminal.Output.Write(answered.Line.Span);
        }
        else
        {
            show(done!, terminal);
        }

        return ExitCode.Done;
    }

    private int RunBatch(LineReader reader, long? length, FieldOverride[] overrides, int jobs, Terminal terminal)
    {
        long done = 0;
        long refused = 0;
        Progress.Show(
            terminal,
            "batch",
            progress =>
            {
                void Write(Answer answered)
                {
                    done++;
                    refused += answered.Refusal is null ? 0 : 1;
                    terminal.Output.Write(answered.Line.Span);
                    terminal.Output.Flush();
                    string What() => string.Create(CultureInfo.InvariantCulture, $"{done} done, {refused} refused");
                    if (length is { } bytes)
                    {
                        progress.Report(reader.BytesRead, bytes, What);
                    }
                    else
                    {
                        progress.Report(What);
                    }
                }

                BatchPipeline.RunAsync(reader, jobs, line => AnswerTo(line, overrides), Write).GetAwaiter().GetResult();
                return done;
            },
            writes: true);
        if (refused == 0)
        {
            return ExitCode.Done;
        }

        terminal.Error.WriteLine(string.Create(CultureInfo.InvariantCulture, $"football: {refused} of {done} refused; each has its reason in its place."));
        return ExitCode.Refused;
    }

    private Answer AnswerTo(InputLine line, FieldOverride[] overrides, Action<T>? result = null)
    {
        InputCase input = InputCase.Read(line, overrides);
        string message;
        try
        {
            T done = work(input.Scenario ?? throw input.Refusal!);
            result?.Invoke(done);
            return new Answer(write(input.Name, done), null);
        }
        catch (RefusedException refusal)
        {
            message = refusal.Message;
        }
        catch (ArgumentException refusal) when (LibraryRefusal.Of(refusal, input.Scenario!) is { } translated)
        {
            message = translated.Message;
        }
        catch (Exception e)
        {
            // A bug of this program, not an error in the input: the other lines of the batch must still produce output.
            message = $"internal error, {e.GetType().Name}: {Quote.Short(e.Message)}";
        }

        return new Answer(ResultWriter.Error(input.Name, message), message);
    }
}
