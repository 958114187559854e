using System.CommandLine;
using System.ComponentModel;
using System.Diagnostics;

namespace FootballPhysics.Tool.Commands;

/// <summary>football play: writes and opens an interactive page.</summary>
internal static class PlayCommand
{
    public static Command Create(Terminal terminal)
    {
        var page = new Option<string>("--output", "-o")
        {
            HelpName = "PAGE",
            Description = "Page to write, a single file that works offline and without a server.",
            DefaultValueFactory = _ => Playground.File,
        };
        var command = new ExampleCommand(
            "play",
            "Write an interactive page and open it",
            "football play -o toy.html")
        {
            page,
        };
        command.Details = "You kick the ball yourself, over a wall and past a goalkeeper. If the output is redirected, the page is not opened.";
        command.SetAction(parsed =>
        {
            string path;
            using (OutputFile written = OutputFile.Open("--output", parsed.GetRequiredValue(page))!)
            {
                written.Write(Playground.Html);
                path = written.Path;
            }

            terminal.Person.WriteLine($"To play: {path}");
            if (!terminal.OutputRedirected)
            {
                Open(path);
            }

            return ExitCode.Done;
        });
        return command;
    }

    /// <summary>Opens a page in the desktop's browser, if there is one. Its path has already been printed.</summary>
    private static void Open(string path)
    {
        try
        {
            Process.Start(new ProcessStartInfo(Path.GetFullPath(path)) { UseShellExecute = true })?.Dispose();
        }
        catch (Exception e) when (e is Win32Exception or PlatformNotSupportedException or FileNotFoundException)
        {
        }
    }
}
