using System.Diagnostics;
using System.Text;
using System.Xml.Linq;
using Football.Physics.Headless.Json;

namespace Football.Physics.Headless.Lab;

/// <summary>A file for a picture: SVG, or PNG where a program that renders it is installed.</summary>
internal sealed class PlotFile
{
    /// <summary>What a command says of its option.</summary>
    public const string Help = "Draws FILE.svg, or FILE.png where Chromium is installed.";

    private static readonly string[] Renderers = ["chromium", "chromium-browser", "google-chrome"];

    private readonly string? _renderer;

    private PlotFile(string path, string? renderer)
    {
        Path = path;
        _renderer = renderer;
    }

    public string Path { get; }

    /// <summary>Checks that the picture can be made before anything is computed.</summary>
    /// <exception cref="RefusedException">Another ending, or no renderer.</exception>
    public static PlotFile For(string path) => System.IO.Path.GetExtension(path).ToLowerInvariant() switch
    {
        ".svg" => new PlotFile(path, null),
        ".png" => new PlotFile(path, Renderers.Select(Find).FirstOrDefault(found => found is not null)
            ?? throw new RefusedException("--plot", $"{Quote.Short(path)}, and no Chromium is installed to render it", "a file that ends in .svg")),
        _ => throw new RefusedException("--plot", Quote.Short(path), "a file that ends in .svg or .png"),
    };

    public void Write(XElement drawing)
    {
        string svg = drawing.ToString(SaveOptions.DisableFormatting) + "\n";
        if (_renderer is null)
        {
            File.WriteAllText(Path, svg, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false));
            return;
        }

        DirectoryInfo folder = Directory.CreateTempSubdirectory("football-");
        try
        {
            string page = System.IO.Path.Combine(folder.FullName, "picture.html");
            File.WriteAllText(page, $"<!doctype html><meta charset=\"utf-8\"><style>body{{margin:0}}svg{{display:block}}</style>{svg}", Encoding.UTF8);
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

    private static string? Find(string program) => (Environment.GetEnvironmentVariable("PATH") ?? "")
        .Split(System.IO.Path.PathSeparator, StringSplitOptions.RemoveEmptyEntries)
        .Select(folder => System.IO.Path.Combine(folder, program))
        .FirstOrDefault(File.Exists);
}
