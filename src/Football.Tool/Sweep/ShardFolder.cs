using FootballPhysics.Tool.Sweep.Output;

namespace FootballPhysics.Tool.Sweep;

/// <summary>A folder that contains a shard.</summary>
/// <param name="Path">The path of the folder.</param>
/// <param name="Manifest">The manifest.</param>
/// <param name="IsDone">True if the shard is complete.</param>
internal sealed record ShardFolder(string Path, Manifest Manifest, bool IsDone)
{
    public string Name => System.IO.Path.GetFileName(Path);

    /// <summary>Returns the shards in a folder, in the order of their names.</summary>
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
