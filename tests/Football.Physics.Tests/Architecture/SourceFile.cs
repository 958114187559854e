using Football.Physics.Tests.Support;

namespace Football.Physics.Tests.Architecture;

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

    /// <summary>Every file of the library.</summary>
    public static IReadOnlyList<SourceFile> Library { get; } = Read(System.IO.Path.Combine(RepositoryFiles.Root, "src", "Football.Physics"));

    /// <summary>Path below the library's folder, with slashes.</summary>
    public string Path { get; }

    public string Text { get; }

    /// <summary>The first folder of the path.</summary>
    public string Room => Path.Split('/')[0];

    public IReadOnlyList<CodeToken> Tokens { get; }

    /// <summary>The types that it declares, but for those inside others.</summary>
    public IReadOnlyList<DeclaredType> Types { get; }

    public int Lines => Text.Split('\n').Length - (Text.EndsWith('\n') ? 1 : 0);

    private static IReadOnlyList<SourceFile> Read(string folder) =>
    [
        .. from file in Directory.EnumerateFiles(folder, "*.cs", SearchOption.AllDirectories)
           let path = System.IO.Path.GetRelativePath(folder, file).Replace('\\', '/')
           where !path.StartsWith("bin/", StringComparison.Ordinal) && !path.StartsWith("obj/", StringComparison.Ordinal)
           orderby path
           select new SourceFile(path, File.ReadAllText(file)),
    ];
}
