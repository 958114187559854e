using System.Buffers;
using System.CommandLine;
using System.Text;
using System.Text.Json;
using FootballPhysics.Tool.Commands;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Labs;

/// <summary>The options of every experiment, and the output of its report.</summary>
internal sealed class LabOptions
{
    private readonly Option<long> _seed = Arguments.Whole("--seed", "Seed of the random values.", long.MinValue, long.MaxValue, 1);
    private readonly Option<string?> _json = new("--json") { HelpName = "FILE", Description = "Write the tables as JSON." };
    private readonly Option<string?> _csv = new("--csv") { HelpName = "FILE", Description = "Write the tables as CSV." };
    private readonly Option<string?> _plot = new("--plot") { HelpName = "FILE", Description = "Draw FILE.svg, or FILE.png if Chromium is installed." };

    /// <summary>Runs a smaller sample of everything.</summary>
    public static Option<bool> Quick() => new("--quick") { Description = "Run a small sample, only to check that the experiment works." };

    /// <summary>Makes the command of an experiment without a picture.</summary>
    public static Command Create(
        string name, string description, string[] examples, Terminal terminal, Func<ParseResult, long, Progress, LabReport> run, params Option[] more) =>
        new LabOptions().Make(name, description, examples, terminal, run, more);

    /// <summary>Makes the command of an experiment with a picture.</summary>
    public static Command CreateDrawn(
        string name, string description, string[] examples, Terminal terminal, Func<ParseResult, long, Progress, LabReport> run, params Option[] more)
    {
        var options = new LabOptions();
        return options.Make(name, description, examples, terminal, run, [options._plot, .. more]);
    }

    private ExampleCommand Make(
        string name, string description, string[] examples, Terminal terminal, Func<ParseResult, long, Progress, LabReport> run, Option[] more)
    {
        var command = new ExampleCommand(name, description, examples) { _seed, _json, _csv };
        foreach (Option option in more)
        {
            command.Add(option);
        }

        command.SetAction(parsed => Run(name, parsed, terminal, run));
        return command;
    }

    private int Run(string name, ParseResult parsed, Terminal terminal, Func<ParseResult, long, Progress, LabReport> run)
    {
        using PlotFile? plot = parsed.GetValue(_plot) is { } picture ? PlotFile.For(picture) : null;
        OutputFile.RefuseSame([], ("--json", parsed.GetValue(_json)), ("--csv", parsed.GetValue(_csv)));
        using var json = OutputFile.Open("--json", parsed.GetValue(_json));
        using var csv = OutputFile.Open("--csv", parsed.GetValue(_csv));
        LabReport report = Progress.Show(terminal, name, progress => run(parsed, parsed.GetValue(_seed), progress));
        foreach (LabTable table in report.Tables)
        {
            table.Print(terminal.PersonConsole);
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

        json?.Write(document.Span);
        csv?.Write(Csv(report.Rows is { } rows ? [rows] : report.Tables));
        if (plot is not null)
        {
            plot.Write(report.Picture?.Invoke() ?? throw new RefusedException($"--plot: there is nothing to draw of {report.Tables[0].Name}."));
            terminal.Person.WriteLine($"Picture: {plot.Path}");
        }

        return report.Failed ? ExitCode.Refused : ExitCode.Done;
    }

    private static string Csv(IEnumerable<LabTable> tables)
    {
        var text = new StringBuilder();
        foreach (LabTable table in tables)
        {
            table.WriteCsv(text);
            text.Append('\n');
        }

        return text.ToString();
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
