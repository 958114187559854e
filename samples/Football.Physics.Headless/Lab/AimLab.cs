using System.CommandLine;
using System.Globalization;
using System.Text;
using Football.Physics.Headless.Commands;

namespace Football.Physics.Headless.Lab;

/// <summary>football lab aim: the thesis' experiments with predictors, and the library's own solver in them.</summary>
internal static class AimLab
{
    private const int Requests = 10_000;
    private const int ScanEvery = 4;

    public static Command Create(Terminal terminal)
    {
        var seed = new Option<int>("--seed") { HelpName = "N", Description = "Seed of everything random; default 1.", DefaultValueFactory = _ => 1 };
        var json = new Option<string?>("--json") { HelpName = "FILE", Description = "Writes the tables as JSON." };
        var csv = new Option<string?>("--csv") { HelpName = "FILE", Description = "Writes every kick as a line." };
        var plot = new Option<string?>("--plot") { HelpName = "FILE", Description = PlotFile.Help };
        var quick = new Option<bool>("--quick") { Description = "Fewer kicks of everything." };
        var full = new Option<bool>("--full") { Description = "Holds every one of the 10 000 random requests that was not hit against the dense scan, not one in four." };
        var command = new Command("aim", "The predictors: 4.1.3, 4.2.3, 4.3.2, and 10 000 random requests against a dense scan.") { seed, json, csv, plot, quick, full };
        command.SetAction(parsed =>
        {
            PlotFile? picture = parsed.GetValue(plot) is { } file ? PlotFile.For(file) : null;
            AimReport report = Run(parsed.GetValue(seed), parsed.GetValue(quick), parsed.GetValue(full), terminal);
            report.Print(terminal.Person);
            Save(parsed.GetValue(json), () => Encoding.UTF8.GetString(report.Json().Span));
            Save(parsed.GetValue(csv), report.Csv);
            picture?.Write(report.Plot());
            if (terminal.OutputRedirected)
            {
                terminal.Output.Write(report.Json().Span);
            }

            return report.Reached ? ExitCode.Done : ExitCode.Refused;
        });
        return command;
    }

    private static AimReport Run(int seed, bool quick, bool full, Terminal terminal)
    {
        using var progress = new Progress(terminal);
        var experiments = new AimExperiments(seed, quick);
        var sections = new List<AimSection>();
        void Add(string name, Func<AimSection> make)
        {
            progress.Report(() => name);
            sections.Add(make());
        }

        Add("4.1.3, Method A", experiments.MethodA);
        Add("4.1.3, high elevations", experiments.HighElevations);
        Add("4.1.3, the studio's setting", experiments.Studio);
        Add("4.2.3, Method B", experiments.MethodB);
        progress.Report(() => "4.3.2, two points");
        sections.AddRange(experiments.TwoPoints());
        Add("two points, out of reach", experiments.Targets);
        AimVerdicts verdicts = AimVerdicts.Of(
            seed,
            quick ? Requests / 10 : Requests,
            full ? 1 : ScanEvery,
            done => progress.Report(() => string.Create(CultureInfo.InvariantCulture, $"{done} random requests")));
        return new AimReport(seed, sections, verdicts);
    }

    private static void Save(string? file, Func<string> text)
    {
        if (file is not null)
        {
            File.WriteAllText(file, text(), new UTF8Encoding(encoderShouldEmitUTF8Identifier: false));
        }
    }
}
