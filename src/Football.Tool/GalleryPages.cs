using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Tool;

/// <summary>The gallery as a function: the same as the command `football gallery`.</summary>
public static class GalleryPages
{
    /// <summary>Simulates the shots of the gallery to rest, prints a table, and writes the drawings and the animated page to a folder.</summary>
    /// <param name="folder">The folder; created if it does not exist.</param>
    /// <returns>The exit code of the command; 0 on success.</returns>
    public static int Write(string folder) => CommandLineEntry.Run(["gallery", "--out", folder], Terminal.OfProcess());
}
