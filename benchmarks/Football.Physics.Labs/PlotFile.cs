using System.Diagnostics;
using System.Text;
using System.Xml.Linq;
using FootballPhysics.Tool.Commands;
using FootballPhysics.Drawing;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Labs;

/// <summary>A file for a picture: SVG, or PNG if a renderer is installed.</summary>
internal sealed class PlotFile : IDisposable
{
    private static readonly string[] Renderers = ["chromium-headless-shell", "chromium", "chromium-browser", "google-chrome"];

    private readonly string? _renderer;

    private readonly OutputFile _file;

    private PlotFile(string path, string? renderer)
    {
        _renderer = renderer;
        _file = OutputFile.Open("--plot", path)!;
    }

    public string Path => _file.Path;

    /// <summary>Checks that the picture can be written before the computation starts.</summary>
    /// <exception cref="RefusedException">The file has another extension, no renderer is installed, or the file cannot be written.</exception>
    public static PlotFile For(string path) => System.IO.Path.GetExtension(path).ToLowerInvariant() switch
    {
        ".svg" => new PlotFile(path, null),
        ".png" => new PlotFile(path, Renderers.Select(Find).FirstOrDefault(found => found is not null)
            ?? throw new RefusedException("--plot", $"{Quote.File(path)}, and no Chromium is installed to render it", "a file that ends in .svg")),
        _ => throw new RefusedException("--plot", Quote.File(path), "a file that ends in .svg or .png"),
    };

    public void Write(XElement figure)
    {
        // Use its first text as the heading.
        XElement drawing = Svg.Standing(figure.Descendants().FirstOrDefault(part => part.Name.LocalName == "text")?.Value ?? "Plot", figure);
        if (_renderer is null)
        {
            _file.Write(drawing);
            return;
        }

        DirectoryInfo folder = Directory.CreateTempSubdirectory("football-");
        try
        {
            string page = System.IO.Path.Combine(folder.FullName, "picture.html");
            File.WriteAllText(page, $"<!doctype html><meta charset=\"utf-8\"><style>body{{margin:0}}svg{{display:block}}</style>{drawing}", Encoding.UTF8);
            int width = (int)Math.Ceiling((double)drawing.Attribute("width")!);
            int height = (int)Math.Ceiling((double)drawing.Attribute("height")!);
            string picture = System.IO.Path.GetFullPath(Path);
            var start = new ProcessStartInfo(_renderer)
            {
                RedirectStandardError = true,
                RedirectStandardOutput = true,
                ArgumentList =
                {
                    "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", $"--user-data-dir={folder.FullName}",
                    $"--window-size={width},{height}", "--force-device-scale-factor=2", $"--screenshot={picture}", new Uri(page).AbsoluteUri,
                },
            };
            using Process process = Process.Start(start)!;
            Task<string> error = process.StandardError.ReadToEndAsync();
            process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            if (process.ExitCode != 0 || !File.Exists(picture))
            {
                throw new RefusedException($"--plot: {_renderer} could not render the picture: {Quote.Short(error.Result.Trim())}");
            }
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }

    public void Dispose() => _file.Dispose();

    private static string? Find(string program) => (Environment.GetEnvironmentVariable("PATH") ?? "")
        .Split(System.IO.Path.PathSeparator, StringSplitOptions.RemoveEmptyEntries)
        .Select(folder => System.IO.Path.Combine(folder, program))
        .FirstOrDefault(File.Exists);
}
