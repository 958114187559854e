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
    public void It_needs_no_network()
    {
        foreach (string page in s_pages)
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

    [GeneratedRegex("(?:href|src)=\"([^\"]+)\"")]
    private static partial Regex Url();
}
