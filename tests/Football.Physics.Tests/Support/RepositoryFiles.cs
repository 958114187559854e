namespace FootballPhysics.Tests.Support;

/// <summary>Files of the repository that tests hold to what they make, or write anew when told to.</summary>
internal static class RepositoryFiles
{
    public static string Root { get; } = FindRoot();

    /// <summary>Set by tests/regenerate.sh.</summary>
    public static bool Regenerates { get; } = Environment.GetEnvironmentVariable("FOOTBALL_REGENERATE") == "1";

    public static string Text(string path) => File.ReadAllText(Path.Combine(Root, path)).ReplaceLineEndings("\n");

    /// <summary>Holds what stands between two lines of a file to what it must be, or makes it so.</summary>
    public static void AssertBetween(string path, string first, string last, string expected)
    {
        string text = Text(path);
        int from = text.IndexOf(first, StringComparison.Ordinal);
        int to = text.IndexOf(last, Math.Max(from, 0), StringComparison.Ordinal);
        Assert.True(from >= 0 && to >= 0, $"{path} has no part between {first} and {last}");
        from += first.Length;
        if (Regenerates)
        {
            File.WriteAllText(Path.Combine(Root, path), text[..from] + expected + text[to..]);
            return;
        }

        Assert.Equal(expected, text[from..to]);
    }

    private static string FindRoot()
    {
        DirectoryInfo? folder = new(AppContext.BaseDirectory);
        while (folder is not null && !File.Exists(Path.Combine(folder.FullName, "Football.Physics.sln")))
        {
            folder = folder.Parent;
        }

        return folder?.FullName ?? throw new InvalidOperationException("Football.Physics.sln not found above the tests");
    }
}
