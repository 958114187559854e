using System.Buffers;
using System.CommandLine;
using System.Text;
using System.Text.Json;
using Football.Physics.Headless.Commands;
using Football.Physics.Headless.Json;

namespace Football.Physics.Headless.Lab;

/// <summary>The options of every experiment, and what becomes of its report.</summary>
internal sealed class LabOptions
{
    public Option<long> Seed { get; } = new("--seed") { HelpName = "N", Description = "Seed of the random shots; default 1.", DefaultValueFactory = _ => 1 };

    public Option<string?> Json { get; } = new("--json") { HelpName = "FILE", Description = "Writes the tables as JSON." };

    public Option<string?> Csv { get; } = new("--csv") { HelpName = "FILE", Description = "Writes the tables as CSV." };

    public Option<string?> Plot { get; } = new("--plot") { HelpName = "FILE", Description = PlotFile.Help };

    /// <summary>Makes an experiment's command.</summary>
    public static Command Create(string name, string description, Terminal terminal, Func<ParseResult, long, Progress, LabReport> run, params Option[] more)
    {
        var options = new LabOptions();
        var command = new Command(name, description) { options.Seed, options.Json, options.Csv, options.Plot };
        foreach (Option option in more)
        {
            command.Add(option);
        }

        command.SetAction(parsed =>
        {
            PlotFile? plot = parsed.GetValue(options.Plot) is { } file ? PlotFile.For(file) : null;
            LabReport report;
            using (var progress = new Progress(terminal))
            {
                report = run(parsed, parsed.GetValue(options.Seed), progress);
            }

            Write(report, terminal, parsed.GetValue(options.Json), parsed.GetValue(options.Csv), plot);
            return report.Failed ? ExitCode.Refused : ExitCode.Done;
        });
        return command;
    }

    private static void Write(LabReport report, Terminal terminal, string? json, string? csv, PlotFile? plot)
    {
        foreach (LabTable table in report.Tables)
        {
            table.Print(terminal.Person);
        }

        foreach (string note in report.Notes)
        {
            terminal.Person.WriteLine(note);
        }

        ReadOnlyMemory<byte> document = Document(report);
        if (terminal.OutputRedirected)
        {
            terminal.Output.Write(document.Span);
        }

        if (json is not null)
        {
            File.WriteAllBytes(json, document.Span);
        }

        if (csv is not null)
        {
            var text = new StringBuilder();
            foreach (LabTable table in report.Tables)
            {
                table.WriteCsv(text);
                text.AppendLine();
            }

            File.WriteAllText(csv, text.ToString(), new UTF8Encoding(encoderShouldEmitUTF8Identifier: false));
        }

        if (plot is not null)
        {
            plot.Write(report.Picture?.Invoke() ?? throw new RefusedException($"--plot: there is nothing to draw of {report.Tables[0].Name}."));
            terminal.Person.WriteLine($"Picture: {plot.Path}");
        }
    }

    private static ReadOnlyMemory<byte> Document(LabReport report)
    {
        var buffer = new ArrayBufferWriter<byte>();
        using (var json = new Utf8JsonWriter(buffer))
        {
            json.WriteStartObject();
            json.WriteString("lab", report.Name);
            json.WriteNumber("seed", report.Seed);
            json.WriteStartArray("tables");
            foreach (LabTable table in report.Tables)
            {
                table.WriteJson(json);
            }

            json.WriteEndArray();
            json.WriteStartArray("notes");
            foreach (string note in report.Notes)
            {
                json.WriteStringValue(note);
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        buffer.Write("\n"u8);
        return buffer.WrittenMemory;
    }
}
