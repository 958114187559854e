using System.Reflection;

namespace FootballPhysics.Package.Tests;

/// <summary>Files of the repository that tests compare with what they make.</summary>
internal static class Repository
{
    /// <summary>Set by tests/regenerate.sh: files are written instead of compared.</summary>
    public static bool Regenerates { get; } = Environment.GetEnvironmentVariable("FOOTBALL_REGENERATE") == "1";

    public static string Root { get; } = Path.GetFullPath(
        typeof(Repository).Assembly.GetCustomAttributes<AssemblyMetadataAttribute>().First(a => a.Key == "Repository").Value!);

    /// <summary>README.md, CONTRIBUTING.md, and the pages of docs/ and docs/internals/, with slashes.</summary>
    public static IReadOnlyList<string> Pages { get; } =
    [
        "README.md",
        "CONTRIBUTING.md",
        .. new[] { "docs", "docs/internals" }.SelectMany(folder => Directory.GetFiles(Path.Combine(Root, folder), "*.md").Select(file => $"{folder}/{Path.GetFileName(file)}").Order(StringComparer.Ordinal)),
    ];

    public static string Text(string path) => File.ReadAllText(Path.Combine(Root, path)).ReplaceLineEndings("\n");

    /// <summary>Holds a file to what it must be, or makes it so.</summary>
    public static void AssertCurrent(string path, string expected)
    {
        string full = Path.Combine(Root, path);
        if (Regenerates)
        {
            File.WriteAllText(full, expected);
            return;
        }

        string[] has = File.Exists(full) ? Text(path).Split('\n') : [];
        string[] should = expected.Split('\n');
        int line = Enumerable.Range(0, Math.Max(has.Length, should.Length))
            .FirstOrDefault(i => i >= has.Length || i >= should.Length || has[i] != should[i], -1);
        Assert.True(
            line < 0,
            $"{path} is not current from line {line + 1} on. Look at the difference, then run tests/regenerate.sh.\n"
            + $"it has:  {has.ElementAtOrDefault(line)}\nit should have: {should.ElementAtOrDefault(line)}");
    }
}
