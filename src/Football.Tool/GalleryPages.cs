using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Tool;

/// <summary>The gallery as a library: what `football gallery` does.</summary>
public static class GalleryPages
{
    /// <summary>Plays the shots of the gallery to rest, prints a table of them, and writes their drawings and the page that moves into a folder.</summary>
    /// <param name="folder">The folder; made where it is not there.</param>
    /// <returns>The exit code of the command: 0 where all is written.</returns>
    public static int Write(string folder) => CommandLineEntry.Run(["gallery", "--out", folder], Terminal.OfProcess());
}
