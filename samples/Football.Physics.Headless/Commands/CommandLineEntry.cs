using System.CommandLine;
using Football.Physics.Headless.Aim;
using Football.Physics.Headless.Json;
using Football.Physics.Headless.Sweep;

namespace Football.Physics.Headless.Commands;

/// <summary>The whole command: arguments in, exit code out.</summary>
internal static class CommandLineEntry
{
    /// <summary>Runs the command.</summary>
    public static int Run(string[] args, Terminal terminal)
    {
        // No @file: an argument means what it says.
        ParseResult parsed = Root(terminal).Parse(args, new ParserConfiguration { ResponseFileTokenReplacer = null });
        if (parsed.Errors.Count > 0)
        {
            foreach (string message in parsed.Errors.Select(error => error.Message).Distinct())
            {
                terminal.Error.WriteLine($"football: {message}");
            }

            terminal.Error.WriteLine("football --help tells how to use it.");
            return ExitCode.Usage;
        }

        try
        {
            return parsed.Invoke(new InvocationConfiguration { Output = terminal.Text, Error = terminal.Error, EnableDefaultExceptionHandler = false });
        }
        catch (RefusedException refusal)
        {
            terminal.Error.WriteLine($"football: {refusal.Message}");
            return ExitCode.Refused;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // A file that cannot be read or written, or a reader of the output that went away.
            terminal.Error.WriteLine($"football: {Quote.Short(e.Message)}");
            return ExitCode.Refused;
        }
    }

    private static RootCommand Root(Terminal terminal)
    {
        var root = new RootCommand("Plays shots of a football without a window. Without a command: the gallery.")
        {
            GalleryCommand.Create(terminal),
            SimulateCommand.Create(terminal),
            AimCommand.Create(terminal),
            LabCommand.Create(terminal),
            SweepCommand.Create(terminal),
        };
        root.SetAction(_ => GalleryCommand.Run(GalleryCommand.DefaultFolder, terminal));
        return root;
    }
}
