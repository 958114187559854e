using System.Reflection;

namespace Football.Physics.Package.Tests;

/// <summary>Files of the repository that tests compare with what they make.</summary>
internal static class Repository
{
    /// <summary>Set by tests/regenerate.sh: files are written instead of compared.</summary>
    private const string Regenerate = "FOOTBALL_REGENERATE";

    public static string Root { get; } = Path.GetFullPath(
        typeof(Repository).Assembly.GetCustomAttributes<AssemblyMetadataAttribute>().First(a => a.Key == "Repository").Value!);

    public static string Text(string path) => File.ReadAllText(Path.Combine(Root, path)).ReplaceLineEndings("\n");

    /// <summary>Holds a file to what it must be, or makes it so.</summary>
    public static void AssertCurrent(string path, string expected)
    {
        string full = Path.Combine(Root, path);
        if (Environment.GetEnvironmentVariable(Regenerate) == "1")
        {
            File.WriteAllText(full, expected);
            return;
        }

        string[] is_ = File.Exists(full) ? Text(path).Split('\n') : [];
        string[] should = expected.Split('\n');
        int line = Enumerable.Range(0, Math.Max(is_.Length, should.Length))
            .FirstOrDefault(i => i >= is_.Length || i >= should.Length || is_[i] != should[i], -1);
        Assert.True(
            line < 0,
            $"{path} is not current from line {line + 1} on. Look at the difference, then run tests/regenerate.sh.\n"
            + $"it has:  {is_.ElementAtOrDefault(line)}\nit should have: {should.ElementAtOrDefault(line)}");
    }
}
