using System.Text.Json;
using System.Text.RegularExpressions;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Architecture;

/// <summary>The entries of tests/mutations.json fit the sources, so that tests/mutations.py can apply each of them.</summary>
public sealed class MutationListTests
{
    private static readonly string[] Parts = ["Batch", "Engines", "Thesis", "Tracks"];
    private static readonly string[] Projects = ["tests/Football.Physics.Tests", "tests/Football.Physics.Labs.Tests"];

    [Fact]
    public void Each_text_occurs_once_in_its_file()
    {
        Assert.All(Entries(), entry =>
        {
            string[] path = entry.GetProperty("file").GetString()!.Split('/', 2);
            string file = Parts.Contains(path[0]) ? $"src/Football.Physics.{path[0]}/{path[1]}" : $"src/Football.Physics/{path[0]}/{path[1]}";
            string old = entry.GetProperty("old").GetString()!;
            Assert.NotEqual(old, entry.GetProperty("new").GetString());
            Assert.Equal(2, RepositoryFiles.Text(file).Split(old).Length);
        });
    }

    [Fact]
    public void Each_named_test_exists()
    {
        string tests = string.Concat(Projects.SelectMany(project => Directory.EnumerateFiles(Path.Combine(RepositoryFiles.Root, project), "*Tests.cs", SearchOption.AllDirectories)).Select(File.ReadAllText));
        Assert.All(Entries().SelectMany(entry => entry.GetProperty("tests").EnumerateArray()), test =>
        {
            string[] named = test.GetString()!.Split('.');
            Assert.Matches($@"class {Regex.Escape(named[0])}\b", tests);
            Assert.All(named[1..], method => Assert.Matches($@"\b{Regex.Escape(method)}\(", tests));
        });
    }

    [Fact]
    public void No_name_occurs_twice() => Assert.Distinct(Entries().Select(entry => entry.GetProperty("name").GetString()));

    private static JsonElement[] Entries()
    {
        using var all = JsonDocument.Parse(RepositoryFiles.Text("tests/mutations.json"));
        return [.. all.RootElement.Clone().EnumerateArray()];
    }
}
