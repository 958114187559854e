using System.CommandLine;
using System.Globalization;
using System.Text;
using System.Xml.Linq;
using Football.Physics.Headless.Gallery;
using Football.Physics.Headless.Simulate;

namespace Football.Physics.Headless.Commands;

/// <summary>football gallery: plays a few shots and draws them.</summary>
internal static class GalleryCommand
{
    public static string DefaultFolder { get; } = Path.Combine("out", "gallery");

    public static Command Create(Terminal terminal)
    {
        var folder = new Option<string>("--out")
        {
            HelpName = "DIR",
            Description = "Where the drawings go.",
            DefaultValueFactory = _ => DefaultFolder,
        };
        var command = new Command(
            "gallery", "Plays a gallery of shots to rest, tells what they did, and draws them; with the output redirected the figures go there as JSON.")
        {
            folder,
        };
        command.SetAction(parsed => Run(parsed.GetRequiredValue(folder), terminal));
        return command;
    }

    /// <summary>Plays and draws all shots into a folder.</summary>
    public static int Run(string folder, Terminal terminal)
    {
        string full = Directory.CreateDirectory(folder).FullName;
        IReadOnlyList<GalleryShot> shots = GalleryShots.All;
        var table = new FigureTable(shots.Select(shot => shot.Name));
        terminal.Person.WriteLine(table.Header);
        var shown = new List<ShownShot>();
        using (var progress = new Progress(terminal))
        {
            foreach (GalleryShot shot in shots)
            {
                progress.Report(() => string.Create(CultureInfo.InvariantCulture, $"shot {shown.Count + 1} of {shots.Count}: {shot.Name}"));
                var made = ShownShot.Make(shot);
                shown.Add(made);
                Save(Path.Combine(full, shot.Id + ".svg"), made.Drawing.ToString(SaveOptions.DisableFormatting) + "\n");
                progress.Clear();
                terminal.Person.WriteLine(table.Line(shot.Name, made.Figures.Texts));
            }
        }

        string sheet = Path.Combine(full, "index.html");
        Save(sheet, ContactSheet.Html(shown));
        terminal.Person.WriteLine($"Drawings: {sheet}");
        if (terminal.OutputRedirected)
        {
            foreach (ShownShot made in shown)
            {
                terminal.Output.Write(Line(made).Span);
            }
        }

        return ExitCode.Done;
    }

    private static void Save(string file, string text) => File.WriteAllText(file, text, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false));

    private static ReadOnlyMemory<byte> Line(ShownShot shown) => ResultWriter.Line(json =>
    {
        ShotFigures figures = shown.Figures;
        json.WriteString("name", shown.Shot.Id);
        Write("carry", figures.Carry);
        Write("apex", figures.Apex);
        Write("hangTime", figures.HangTime);
        Write("deflection", figures.Deflection);
        json.WriteNumber("bounces", figures.Bounces);
        Write("restTime", figures.RestTime);
        Write("distance", figures.Distance);

        void Write(string name, double? value)
        {
            if (value is null)
            {
                json.WriteNull(name);
            }
            else
            {
                json.WriteNumber(name, value.Value);
            }
        }
    });
}
