using System.CommandLine;
using FootballPhysics.Tool.Gallery;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Replay;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Commands;

/// <summary>football gallery: simulates sample shots and draws them.</summary>
internal static class GalleryCommand
{
    private static readonly string s_defaultFolder = Path.Combine("out", "gallery");

    public static Command Create(Terminal terminal)
    {
        var folder = new Option<string>("--out")
        {
            HelpName = "DIR",
            Description = "Folder for the pages and drawings.",
            DefaultValueFactory = _ => s_defaultFolder,
        };
        var command = new ExampleCommand(
            "gallery",
            "Draw the sample shots",
            "football gallery --out pictures")
        {
            folder,
        };
        command.Details = "It simulates each shot until the ball rests, and writes a page to play, a page that moves and a page with all drawings.";
        command.SetAction(parsed => Run(parsed.GetRequiredValue(folder), terminal));
        return command;
    }

    /// <summary>Simulates all shots and draws them into a folder.</summary>
    private static int Run(string folder, Terminal terminal)
    {
        string full = Create(folder);
        IReadOnlyList<GalleryShot> shots = GalleryShots.All;
        string[] names = [.. shots.Select(shot => shot.Id + ".svg"), Playground.File, ContactSheet.Moving, "index.html"];
        terminal.Person.WriteLine($"Simulates {shots.Count} shots and draws them into {folder}.");
        OutputFile[] files = [.. names.Select(name => OutputFile.Open("--out", Path.Combine(full, name))!)];
        ShownShot[] shown = Progress.Show(terminal, "shots", progress => shots.Select((shot, i) =>
        {
            progress.Report(i, shots.Count, () => shot.Name);
            var made = ShownShot.Make(shot);
            files[i].Write(made.Drawing);
            return made;
        }).ToArray());
        files[^3].Write(Playground.Html);
        files[^2].Write(ReplayPage.Html("Football.Physics: gallery", [.. shown.Select(made => made.Moving)]));
        files[^1].Write(ContactSheet.Html(shown));
        foreach (OutputFile file in files)
        {
            file.Dispose();
        }

        // The data comes first, so that the paths are the last lines even if both streams go to one file.
        if (terminal.OutputRedirected)
        {
            foreach (ShownShot made in shown)
            {
                terminal.Output.Write(Line(made).Span);
            }
        }

        terminal.PersonConsole.Write(ShotReport.Figures([.. shown.Select(made => ((string?)made.Shot.Name, made.Figures))]));
        terminal.Person.WriteLine($"Drawings: {files[^1].Path}");
        terminal.Person.WriteLine($"Animated: {files[^2].Path}");
        terminal.Person.WriteLine($"To play, open in a browser: {files[^3].Path}");
        return ExitCode.Done;
    }

    private static string Create(string folder)
    {
        try
        {
            return Directory.CreateDirectory(folder).FullName;
        }
        catch (Exception e) when (OutputFile.IsFileFault(e))
        {
            throw new RefusedException($"--out {Quote.File(folder)} cannot be created. Pass a folder that can be written.");
        }
    }

    private static ReadOnlyMemory<byte> Line(ShownShot shown) => ResultWriter.Line(json =>
    {
        ShotFigures figures = shown.Figures;
        json.WriteString("name", shown.Shot.Id);
        json.WriteFinite("carry", figures.Carry);
        json.WriteFinite("apex", figures.Apex);
        json.WriteFinite("hangTime", figures.HangTime);
        json.WriteFinite("deflection", figures.Deflection);
        json.WriteNumber("bounces", figures.Bounces);
        json.WriteFinite("restTime", figures.RestTime);
        json.WriteFinite("distance", figures.Distance);
    });
}
