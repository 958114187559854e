using FootballPhysics.Tool.Sweep.Output;

namespace FootballPhysics.Tool.Sweep;

/// <summary>A folder with a shard.</summary>
/// <param name="Path">The folder.</param>
/// <param name="Manifest">Its manifest.</param>
/// <param name="IsDone">Whether that is all of the shard.</param>
internal sealed record ShardFolder(string Path, Manifest Manifest, bool IsDone)
{
    /// <summary>Its name.</summary>
    public string Name => System.IO.Path.GetFileName(Path);

    /// <summary>Those in a folder, in the order of their names.</summary>
    public static List<ShardFolder> All(string folder)
    {
        List<ShardFolder> found = [];
        foreach (string path in Directory.GetDirectories(folder).Order(StringComparer.Ordinal))
        {
            Manifest? done = Manifest.Read(path, Manifest.Done);
            if ((done ?? Manifest.Read(path, Manifest.Unfinished)) is { } manifest)
            {
                found.Add(new ShardFolder(path, manifest, done is not null));
            }
        }

        return found;
    }
}
