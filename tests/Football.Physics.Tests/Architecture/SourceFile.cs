using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Architecture;

/// <summary>A file of a source tree: where it is, what it says, and the code of it as tokens.</summary>
internal sealed class SourceFile
{
    public SourceFile(string path, string text)
    {
        Path = path;
        Text = text;
        Tokens = CodeToken.Of(text);
        Types = DeclaredType.In(Tokens);
    }

    /// <summary>Every file of the library, and of its parts in packages of their own, each of which is a room.</summary>
    public static IReadOnlyList<SourceFile> Library { get; } =
    [
        .. Read("Football.Physics", ""), .. Read("Football.Physics.Batch", "Batch/"), .. Read("Football.Physics.Tracks", "Tracks/"), .. Read("Football.Physics.Engines", "Engines/"), .. Read("Football.Physics.Thesis", "Thesis/"),
    ];

    /// <summary>Every file of the sources: the library, its parts, and the programs and bindings beside them.</summary>
    public static IReadOnlyList<SourceFile> Sources { get; } =
    [
        .. Library, .. Directory.EnumerateDirectories(System.IO.Path.Combine(RepositoryFiles.Root, "src")).Select(path => System.IO.Path.GetFileName(path))
            .Where(folder => folder is not ("Football.Physics" or "Football.Physics.Batch" or "Football.Physics.Tracks" or "Football.Physics.Engines" or "Football.Physics.Thesis"))
            .Order().SelectMany(folder => Read(folder, folder + "/")),
    ];

    /// <summary>Path below the library's folder, with slashes; that of a part begins with the name of its room.</summary>
    public string Path { get; }

    public string Text { get; }

    /// <summary>The first folder of the path.</summary>
    public string Room => Path.Split('/')[0];

    public IReadOnlyList<CodeToken> Tokens { get; }

    /// <summary>The types that it declares, but for those inside others.</summary>
    public IReadOnlyList<DeclaredType> Types { get; }

    public int Lines => Text.Split('\n').Length - (Text.EndsWith('\n') ? 1 : 0);

    private static IEnumerable<SourceFile> Read(string folder, string room)
    {
        string root = System.IO.Path.Combine(RepositoryFiles.Root, "src", folder);
        return from file in Directory.EnumerateFiles(root, "*.cs", SearchOption.AllDirectories)
               let path = System.IO.Path.GetRelativePath(root, file).Replace('\\', '/')
               where !path.StartsWith("bin/", StringComparison.Ordinal) && !path.StartsWith("obj/", StringComparison.Ordinal)
               orderby path
               select new SourceFile(room + path, File.ReadAllText(file));
    }
}
