using System.Text.RegularExpressions;
using System.Xml.Linq;
using FootballPhysics.Site;
using FootballPhysics.Site.Live;
using FootballPhysics.Site.Pictures;

namespace FootballPhysics.Package.Tests;

/// <summary>The site: every page is there and reached, no link of it is dead, it needs no network, and its search knows every section.</summary>
public sealed partial class SiteTests
{
    private static readonly string s_folder = Directory.CreateTempSubdirectory("football-site-").FullName;

    // Not before a test needs it: while pictures are drawn, the site may still lack them.
    private static readonly Lazy<IReadOnlyList<string>> s_site = new(() => SiteWriter.Write(Repository.Root, s_folder));
    private static readonly Lazy<string[]> s_html = new(() => [.. Directory.GetFiles(s_site.Value.Count > 0 ? s_folder : "", "*.html").Select(file => Path.GetFileName(file)!).Where(file => file != Tool.Playground.File)]);

    private static IReadOnlyList<string> Pages => s_site.Value;

    private static string[] All => s_html.Value;

    [Fact]
    public void It_has_every_page_and_each_nameAll_others()
    {
        string[] sources = [.. Repository.Pages.Where(page => page.StartsWith("docs/", StringComparison.Ordinal))];
        // The first page, README.md and the gallery are not in docs/.
        Assert.Equal(sources.Length + 3, Pages.Count);
        Assert.Equal("index.html", Pages[0]);
        Assert.All(Pages, page => Assert.All(Pages, other => Assert.Contains($"<a href=\"{other}\"", Text(page))));
    }

    [Fact]
    public void No_link_is_dead_to_the_last_heading()
    {
        Dictionary<string, HashSet<string>> anchors = All.ToDictionary(page => page, page => Id().Matches(Text(page)).Select(match => match.Groups[1].Value).ToHashSet());
        foreach (string page in All)
        {
            foreach (string url in Url().Matches(Text(page)).Select(match => match.Groups[1].Value).Where(url => !url.Contains("://", StringComparison.Ordinal) && !url.StartsWith("data:", StringComparison.Ordinal)))
            {
                string[] parts = url.Split('#', 2);
                string file = parts[0].Length > 0 ? parts[0] : page;
                Assert.True(File.Exists(Path.Combine(s_folder, file)), $"{page}: {url}");
                // The page that plays the shots reads the name of a shot from its address.
                Assert.True(parts.Length == 1 || parts[1].StartsWith("picture=", StringComparison.Ordinal) || anchors[file].Contains(parts[1]), $"{page}: {url} is no heading of {file}");
            }
        }
    }

    [Fact]
    public void The_reference_has_a_page_a_type_and_the_page_to_play_with_comes_first()
    {
        Assert.Contains("<a href=\"api-ball.html\">", Text("api.html"));
        Assert.Contains("<h1 id=\"ball\">Ball</h1>", Text("api-ball.html"));
        Assert.All(All, page => Assert.Contains("<a class=\"play\" href=\"play.html\"", Text(page)));
        Assert.DoesNotContain("<iframe", string.Concat(All.Select(Text)));
        Assert.Equal(Tool.Playground.Html, Text(Tool.Playground.File));
    }

    [Fact]
    public void Every_page_but_the_first_has_a_breadcrumb_and_that_of_a_type_names_its_family()
    {
        Assert.DoesNotContain("class=\"crumbs\"", Text("index.html"));
        Assert.All(All.Where(page => page != "index.html"), page => Assert.Contains("<nav class=\"crumbs\" aria-label=\"Breadcrumb\"><ol><li><a href=\"index.html\">Home</a></li>", Text(page)));
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

        Assert.Equal(All.Count(page => page.StartsWith("api-", StringComparison.Ordinal)), types);
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
                Assert.True(signatures.Length < 3, type);
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
        Assert.Contains("<a href=\"api-ball.html#LookAhead\"><code>Ball.LookAhead</code></a>", string.Concat(Pages.Select(Text)));
    }

    [Fact]
    public void It_needs_no_network()
    {
        foreach (string page in All)
        {
            Assert.DoesNotMatch("(src|link [^>]*href)=\"https?:", Text(page));
        }

        Assert.DoesNotContain("http", Text("style.css"));
        Assert.All((string[])["search.js", "pages.js", "live.js"], script => Assert.DoesNotContain("fetch(", Text(script)));
        Assert.Contains("prefers-color-scheme: dark", Text("style.css"));
    }

    [Theory]
    [InlineData("Rollback", "networking.html#rollback")]
    [InlineData("bouncing pass", "cookbook.html#a-bouncing-pass")]
    [InlineData("UntilPlane", "prediction.html#looking-ahead")]
    public void Its_search_knows(string words, string address)
    {
        string index = Text("search-index.js");
        int from = index.IndexOf($"\"{address}\"", StringComparison.Ordinal);
        Assert.True(from > 0, address);
        int end = index.IndexOf("\"],[", from, StringComparison.Ordinal);
        int begin = index.LastIndexOf("],[", from, StringComparison.Ordinal);
        Assert.Contains(words, index[begin..end], StringComparison.OrdinalIgnoreCase);
    }

    [Fact]
    public void The_first_page_has_three_sentences_one_kick_and_three_buttons()
    {
        string page = Text("index.html");
        string main = page[page.IndexOf("<main>", StringComparison.Ordinal)..];
        string words = main[(main.IndexOf("<p>", StringComparison.Ordinal) + 3)..main.IndexOf("</p>", StringComparison.Ordinal)];
        Assert.Equal(3, words.Count(letter => letter == '.'));
        Assert.Single(Figure().Matches(main));
        string buttons = main.Split("<p class=\"buttons\">")[1].Split("</p>")[0];
        Assert.Equal(["getting-started.html", "play.html", "gallery.html"], Url().Matches(buttons).Select(match => match.Groups[1].Value));
    }

    [Fact]
    public void Pages_have_their_neighbours_tabs_and_live_examples()
    {
        Assert.Contains("<a rel=\"next\" href=\"unity.html\">", Text("getting-started.html"));
        Assert.Contains("<a rel=\"prev\" href=\"getting-started.html\">", Text("unity.html"));
        Assert.DoesNotContain("class=\"neighbours\"", Text("api-ball.html"));
        Assert.Matches("(?s)<div class=\"tabs\">\\s*<div class=\"tab\" data-language=\"C#\">.*?<div class=\"tab\" data-language=\"Python\">", Text("aiming.html"));
        Assert.Equal(LiveExample.All.Count, All.Sum(page => Figure().Count(Text(page))));
        Assert.All(All, page => Assert.Equal(Figure().IsMatch(Text(page)), Text(page).Contains("<script src=\"live.js\">", StringComparison.Ordinal)));
    }

    /// <summary>Each recipe with a program of C# runs in the page, or the page says why not.</summary>
    [Fact]
    public void Recipes_of_motion_prediction_and_aiming_run_or_say_why_not()
    {
        Assert.True(LiveExample.All.Count >= 20);
        foreach (string page in LiveBlocks.Pages)
        {
            foreach (string section in Text(page).Split("<h2 ").Skip(1).Where(section => section.Contains("language-csharp\"", StringComparison.Ordinal)))
            {
                Assert.True(Figure().IsMatch(section) != section.Contains("<p class=\"still\">Not live: ", StringComparison.Ordinal), $"{page}: {section[..60]}");
            }
        }
    }

    [Fact]
    public void The_gallery_is_a_wall_of_pictures_that_exist()
    {
        string[] pictures = [.. Url().Matches(Text("gallery.html")).Select(match => match.Groups[1].Value).Where(url => url.EndsWith(".svg", StringComparison.Ordinal))];
        Assert.Equal(Tool.Gallery.GalleryShots.All.Count, pictures.Length);
        Assert.All(pictures, picture => Assert.True(new FileInfo(Path.Combine(s_folder, picture)).Length > 2000, picture));
        Assert.Equal(pictures.Length, Regex.Count(Text("gallery.html"), "loading=\"lazy\""));
    }

    public static TheoryData<string> Pictures => [.. DocPictures.All.Select(picture => picture.Name)];

    [Theory]
    [MemberData(nameof(Pictures))]
    public void A_picture_of_the_docs_is_what_the_library_draws_and_stands_on_a_page(string name)
    {
        string file = $"{DocPictures.Folder}/{name}.svg";
        Repository.AssertCurrent(file, DocPictures.All.Single(picture => picture.Name == name).Draw().ToString(SaveOptions.DisableFormatting));
        Assert.Contains(Repository.Pages, page => Repository.Text(page).Contains($"pictures/{name}.svg)", StringComparison.Ordinal));
        Assert.True(Repository.Regenerates || File.Exists(Path.Combine(Pages.Count > 0 ? s_folder : "", name + ".svg")));
    }

    private static string Text(string file) => File.ReadAllText(Path.Combine(Pages.Count > 0 ? s_folder : "", file));

    [GeneratedRegex("id=\"([^\"]+)\"")]
    private static partial Regex Id();

    [GeneratedRegex("<li id=\"([^\"]+)\">(?:<span id=\"[^\"]+\"></span>)?<code class=\"signature\">")]
    private static partial Regex MemberAnchor();

    [GeneratedRegex("^- `([^`]+)`", RegexOptions.Multiline)]
    private static partial Regex Signature();

    [GeneratedRegex(@"^- \[(\w+)\]\(#([\w-]+)\)")]
    private static partial Regex Listed();

    [GeneratedRegex("<figure class=\"live\"")]
    private static partial Regex Figure();

    [GeneratedRegex("(?:href|src)=\"([^\"]+)\"")]
    private static partial Regex Url();
}
