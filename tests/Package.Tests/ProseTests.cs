namespace FootballPhysics.Package.Tests;

/// <summary>Pages and documentation comments are in plain English, as far as five expressions can see it.</summary>
public sealed class ProseTests
{
    private const double Limit = 3;

    private static readonly string[] s_generated = ["docs/api.md"];

    public static TheoryData<string> Pages => [.. Repository.Pages.Except(s_generated).Append("tests/README.md").Append("samples/Live/README.md").Append("samples/Network/README.md")
        .Append("samples/Unity/com.football.physics/Documentation~/index.md").Append("samples/Godot/addons/football_physics/README.md")];

    /// <summary>The first folders of the library, and the packages around it.</summary>
    public static TheoryData<string> Folders => [.. Sources().Select(Folder).Distinct().Order(StringComparer.Ordinal)];

    [Theory]
    [MemberData(nameof(Pages))]
    public void A_page_is_in_plain_English(string page) => Check(page, Prose.OfPage(Repository.Text(page)));

    [Theory]
    [MemberData(nameof(Folders))]
    public void Public_summaries_are_in_plain_English(string folder) =>
        Check(folder, Sources().Where(file => Folder(file) == folder).SelectMany(file => Prose.OfSource(Repository.Text(file))));

    /// <summary>The expressions find the habits, and leave plain sentences alone.</summary>
    [Theory]
    [InlineData("What the ball meets is in the event.", 1)]
    [InlineData("A game is told of it.", 1)]
    [InlineData("The value is true where the ball rests.", 1)]
    [InlineData("It is among the things of the scene.", 1)]
    [InlineData("There it is no longer; it is none of them.", 1)]
    [InlineData("The event reports the collider. What is a collider? `What is told` is code.", 0)]
    [InlineData("The ball collides with everything in the scene, at the exact time within the step.", 0)]
    public void The_checks_find_what_they_are_for(string text, int hits) => Assert.Equal(hits, Prose.Scan([text]).Hits.Count);

    [Fact]
    public void Code_and_generated_blocks_are_left_out()
    {
        const string Page = "# What is told\n\n```text\nWhat is told is one of the things.\n```\n\n<!-- rows, from the code -->\nWhat is told is one of the things.\n<!-- /rows -->\n\nThe ball flies over the wall. It lands in the goal.\n";
        Assert.Equal(["The ball flies over the wall.", "It lands in the goal."], Prose.OfPage(Page));
    }

    [Fact]
    public void Only_public_members_count() => Assert.Equal(
        ["The ball.", "Its speed, as `x` returns it."],
        Prose.OfSource("/// <summary>The ball.</summary>\npublic class A\n{\n    /// <summary>Its speed, as <see cref=\"B\"/>\n    /// returns it.</summary>\n    public int B;\n\n    /// <summary>Hidden.</summary>\n    private int C;\n}\n/// <summary>Hidden.</summary>\nclass D\n{\n    /// <summary>Hidden.</summary>\n    public int E;\n}\n"));

    /// <summary>One hit is allowed everywhere, because the expressions are wrong now and then.</summary>
    private static void Check(string name, IEnumerable<string> units)
    {
        (int words, IReadOnlyList<string> hits) = Prose.Scan(units);
        Assert.True(
            hits.Count <= 1 || 1000 * hits.Count <= Limit * words,
            $"{name}: {1000.0 * hits.Count / Math.Max(1, words):F1} hits per 1000 words; allowed: {Limit}. docs/internals/style.md has the rules.\n{string.Join('\n', hits)}");
    }

    private static IEnumerable<string> Sources() => Directory.GetFiles(Path.Combine(Repository.Root, "src"), "*.cs", SearchOption.AllDirectories)
        .Select(file => Path.GetRelativePath(Repository.Root, file).Replace('\\', '/'))
        .Where(file => file.StartsWith("src/Football.Physics", StringComparison.Ordinal) && file.Split('/') is var parts && !parts.Contains("obj") && !parts.Contains("bin"));

    private static string Folder(string file) => string.Join('/', file.Split('/') is ["src", "Football.Physics", var folder, _, ..] ? ["src", "Football.Physics", folder] : file.Split('/')[..2]);
}
