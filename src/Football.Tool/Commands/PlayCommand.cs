using System.CommandLine;
using System.ComponentModel;
using System.Diagnostics;

namespace FootballPhysics.Tool.Commands;

/// <summary>football play: the page to play with.</summary>
internal static class PlayCommand
{
    public static Command Create(Terminal terminal)
    {
        var page = new Option<string>("--output", "-o")
        {
            HelpName = "PAGE",
            Description = "The page: one file that needs no network and no server.",
            DefaultValueFactory = _ => Playground.File,
        };
        var command = new ExampleCommand(
            "play",
            "Writes a page on which you kick the ball yourself, over a wall and past a goalkeeper, and opens it in a browser where there is a terminal.",
            "football play -o toy.html")
        {
            page,
        };
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

    /// <summary>Opens a page in the browser of the desktop, if there is one; its path has been told.</summary>
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
