using System.Text.RegularExpressions;
using System.Xml.Linq;
using FootballPhysics.Site;
using FootballPhysics.Site.Pictures;

namespace FootballPhysics.Package.Tests;

/// <summary>The site: every page is there and reached, no link of it is dead, it needs no network, and its search knows every section.</summary>
public sealed partial class SiteTests
{
    private static readonly string s_folder = Directory.CreateTempSubdirectory("football-site-").FullName;
    private static readonly IReadOnlyList<string> s_pages = SiteWriter.Write(Repository.Root, s_folder);

    private static readonly string[] s_all = [.. Directory.GetFiles(s_folder, "*.html").Select(file => Path.GetFileName(file)!).Where(file => file != Tool.Playground.File)];

    [Fact]
    public void It_has_every_page_and_each_names_all_others()
    {
        string[] sources = [.. Repository.Pages.Where(page => page.StartsWith("docs/", StringComparison.Ordinal))];
        Assert.Equal(sources.Length + 1, s_pages.Count);
        Assert.Equal("index.html", s_pages[0]);
        Assert.All(s_pages, page => Assert.All(s_pages, other => Assert.Contains($"<a href=\"{other}\"", Text(page))));
    }

    [Fact]
    public void No_link_is_dead_to_the_last_heading()
    {
        Dictionary<string, HashSet<string>> anchors = s_all.ToDictionary(page => page, page => Id().Matches(Text(page)).Select(match => match.Groups[1].Value).ToHashSet());
        foreach (string page in s_all)
        {
            foreach (string url in Url().Matches(Text(page)).Select(match => match.Groups[1].Value).Where(url => !url.Contains("://", StringComparison.Ordinal)))
            {
                string[] parts = url.Split('#', 2);
                string file = parts[0].Length > 0 ? parts[0] : page;
                Assert.True(File.Exists(Path.Combine(s_folder, file)), $"{page}: {url}");
                Assert.True(parts.Length == 1 || anchors[file].Contains(parts[1]), $"{page}: {url} is no heading of {file}");
            }
        }
    }

    [Fact]
    public void The_reference_has_a_page_a_type_and_the_page_to_play_with_comes_first()
    {
        Assert.Contains("<a href=\"api-ball.html\">", Text("api.html"));
        Assert.Contains("<h1 id=\"ball\">Ball</h1>", Text("api-ball.html"));
        Assert.All(s_all, page => Assert.Contains("<a class=\"play\" href=\"play.html\"", Text(page)));
        Assert.Contains("<iframe src=\"play.html\"", Text("index.html"));
        Assert.Equal(Tool.Playground.Html, Text(Tool.Playground.File));
    }

    [Fact]
    public void Every_page_but_the_first_has_a_breadcrumb_and_that_of_a_type_names_its_family()
    {
        Assert.DoesNotContain("class=\"crumbs\"", Text("index.html"));
        Assert.All(s_all.Where(page => page != "index.html"), page => Assert.Contains("<nav class=\"crumbs\" aria-label=\"Breadcrumb\"><ol><li><a href=\"index.html\">Home</a></li>", Text(page)));
        Assert.Contains("<li><a href=\"contents.html#guides\">Guides</a></li><li aria-current=\"page\">Cookbook</li>", Text("cookbook.html"));
        string family = "";
        int types = 0;
        foreach (string line in Repository.Text("docs/api.md").Split("\n## ")[0].Split('\n'))
        {
            family = line.StartsWith("**", StringComparison.Ordinal) ? line.Trim('*') : family;
            if (Listed().Match(line) is { Success: true } type)
            {
                types++;
                string page = Text($"api-{type.Groups[2].Value}.html");
                Assert.Matches($"<li><a href=\"api.html\">API</a></li><li><a href=\"api.html#[a-z-]+\">{Regex.Escape(family)}</a></li><li aria-current=\"page\">{type.Groups[1].Value}</li>", page);
                Assert.Contains($"<a href=\"api-{type.Groups[2].Value}.html\" aria-current=\"page\">", page);
            }
        }

        Assert.Equal(s_all.Count(page => page.StartsWith("api-", StringComparison.Ordinal)), types);
    }

    [Fact]
    public void Every_member_has_an_anchor_of_its_own_with_a_link_and_stands_on_the_list_of_its_page()
    {
        foreach (string part in Repository.Text("docs/api.md").Split("\n## ").Skip(1))
        {
            string type = part.Split('\n')[0];
            string page = Text($"api-{SitePage.AddressOf(type)}.html");
            string[] ids = [.. Id().Matches(page).Select(match => match.Groups[1].Value)];
            Assert.Distinct(ids);
            string[] signatures = [.. Signature().Matches(part).Select(match => match.Groups[1].Value)];
            string[] anchors = [.. MemberAnchor().Matches(page).Select(match => match.Groups[1].Value)];
            Assert.Equal(signatures.Select(signature => ApiMember.Of(signature).Id), anchors);
            Assert.All(anchors, anchor => Assert.Contains($"<a class=\"anchor\" href=\"#{anchor}\"", page));
            if (page.Contains("<aside", StringComparison.Ordinal))
            {
                Assert.All(signatures, signature => Assert.Contains($"<a class=\"sub\" href=\"#{ApiMember.Of(signature).ShortId}\">", page));
            }
            else
            {
                Assert.True(signatures.Length < 2, type);
            }
        }
    }

    [Theory]
    [InlineData("new Ball(Scene? scene = null, SolverSettings? settings = null)", "Constructors", "new", "new-Scene-SolverSettings")]
    [InlineData("void Kick(in AimResult kick)", "Methods", "Kick", "Kick-AimResult")]
    [InlineData("Vector3d Position { get; }", "Properties", "Position", "Position")]
    [InlineData("ref KickInput this[int index] { get; }", "Properties", "this", "this-int")]
    [InlineData("static IReadOnlyDictionary<string, Ground> Presets { get; }", "Properties", "Presets", "Presets")]
    [InlineData("const int Size = 228", "Fields", "Size", "Size")]
    [InlineData("double X", "Fields", "X", "X")]
    [InlineData("event Action<int> Changed", "Events", "Changed", "Changed")]
    [InlineData("Impact", "Values", "Impact", "Impact")]
    [InlineData("static Vector3d operator Multiply(double left, Vector3d right)", "Operators", "operator Multiply", "operator-Multiply-double-Vector3d")]
    [InlineData("static IForce From(Func<ForceContext, Vector3d> force, double[] at)", "Methods", "From", "From-Func-ForceContext-Vector3d-double-array")]
    [InlineData("ReadOnlySpan<T>.Enumerator GetEnumerator()", "Methods", "GetEnumerator", "GetEnumerator")]
    public void The_anchor_of_a_member_is_its_name_and_the_types_of_its_parameters(string signature, string group, string name, string id) =>
        Assert.Equal(new ApiMember(group, name, id), ApiMember.Of(signature));

    [Fact]
    public void Types_in_signatures_texts_and_guides_lead_to_the_reference_and_a_type_to_its_guides()
    {
        string ball = Text("api-ball.html");
        Assert.Contains("void <b>LookAhead</b>(<a href=\"api-lookaheadrequest.html\">LookAheadRequest</a> request, <a href=\"api-trajectory.html\">Trajectory</a> into)", ball);
        Assert.Contains("<a href=\"api-simulator.html\">Simulator</a> <b>Simulator</b> { get; set; }", ball);
        Assert.Contains("<a href=\"api-solversettings.html#Default\"><code>SolverSettings.Default</code></a>", ball);
        Assert.Contains("<a href=\"prediction.html#looking-ahead\">", Text("api-trajectory.html"));
        Assert.Contains("<a href=\"api-ball.html#LookAhead\"><code>Ball.LookAhead</code></a>", string.Concat(s_pages.Select(Text)));
    }

    [Fact]
    public void It_needs_no_network()
    {
        foreach (string page in s_all)
        {
            Assert.DoesNotMatch("(src|link [^>]*href)=\"https?:", Text(page));
        }

        Assert.DoesNotContain("http", Text("style.css"));
        Assert.DoesNotContain("fetch(", Text("search.js"));
        Assert.Contains("prefers-color-scheme: dark", Text("style.css"));
    }

    [Theory]
    [InlineData("Rollback", "networking.html#rollback")]
    [InlineData("bouncing pass", "cookbook.html#a-bouncing-pass")]
    [InlineData("UntilPlane", "prediction.html#looking-ahead")]
    public void Its_search_knows(string words, string address)
    {
        string index = Text("search.js");
        int from = index.IndexOf($"\"{address}\"", StringComparison.Ordinal);
        Assert.True(from > 0, address);
        int end = index.IndexOf("\"],[", from, StringComparison.Ordinal);
        int begin = index.LastIndexOf("],[", from, StringComparison.Ordinal);
        Assert.Contains(words, index[begin..end], StringComparison.OrdinalIgnoreCase);
    }

    public static TheoryData<string> Pictures => [.. DocPictures.All.Select(picture => picture.Name)];

    [Theory]
    [MemberData(nameof(Pictures))]
    public void A_picture_of_the_docs_is_what_the_library_draws_and_stands_on_a_page(string name)
    {
        string file = $"{DocPictures.Folder}/{name}.svg";
        Repository.AssertCurrent(file, DocPictures.All.Single(picture => picture.Name == name).Draw().ToString(SaveOptions.DisableFormatting));
        Assert.Contains(Repository.Pages, page => Repository.Text(page).Contains($"pictures/{name}.svg)", StringComparison.Ordinal));
        Assert.True(File.Exists(Path.Combine(s_folder, name + ".svg")));
    }

    private static string Text(string file) => File.ReadAllText(Path.Combine(s_folder, file));

    [GeneratedRegex("id=\"([^\"]+)\"")]
    private static partial Regex Id();

    [GeneratedRegex("<li id=\"([^\"]+)\">(?:<span id=\"[^\"]+\"></span>)?<code class=\"signature\">")]
    private static partial Regex MemberAnchor();

    [GeneratedRegex("^- `([^`]+)`", RegexOptions.Multiline)]
    private static partial Regex Signature();

    [GeneratedRegex(@"^- \[(\w+)\]\(#([\w-]+)\)")]
    private static partial Regex Listed();

    [GeneratedRegex("(?:href|src)=\"([^\"]+)\"")]
    private static partial Regex Url();
}
