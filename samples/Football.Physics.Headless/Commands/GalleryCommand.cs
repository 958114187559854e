using System.CommandLine;

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
        var command = new Command("gallery", "Plays a gallery of shots to rest, tells what they did, and draws them.") { folder };
        command.SetAction(parsed => Run(parsed.GetRequiredValue(folder), terminal));
        return command;
    }

    public static int Run(string folder, Terminal terminal)
    {
        return ExitCode.Done;
    }
}
