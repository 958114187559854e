using System.Net;
using System.Reflection;
using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;

namespace FootballPhysics.Site;

/// <summary>Writes README.md and the pages of docs/ as a site that needs no network: with a search, light and dark.</summary>
internal static partial class SiteWriter
{
    /// <summary>Writes it; the names of its pages, the first page first.</summary>
    /// <param name="repository">The folder of the repository.</param>
    /// <param name="folder">The folder of the site.</param>
    public static IReadOnlyList<string> Write(string repository, string folder)
    {
        // The page of contents gives the order and the groups.
        (string Source, string Group)[] sources = [(SitePage.LandingSource, ""), ("README.md", ""), (SitePage.ContentsSource, ""), .. Grouped(Read(repository, SitePage.ContentsSource))];
        var api = new ApiIndex(Read(repository, SitePage.Api));
        (SitePage Page, string Group)[] pages = [.. sources.Select(source => (new SitePage(source.Source, source.Source == SitePage.Api ? api.Overview : Read(repository, source.Source), api), source.Group))];
        pages = [.. pages[..3], (new SitePage("docs/Site/gallery.md", GalleryWall.Text, api, GalleryWall.File), ""), .. pages[3..]];
        HashSet<string> types = [.. api.Types.Select(type => type.Name)];
        ILookup<string, Section> uses = Uses(pages.Where(page => page.Group == "Guides"), types).Concat(Uses(pages.Where(page => page.Page.Source == "docs/data-sets.md"), types)).ToLookup(use => use.Type, use => use.Section);
        SitePage[] all = [.. pages.Select(page => page.Page), .. api.Types.Select(type => new TypePage(type, api, [.. uses[type.Name]]))];
        Directory.CreateDirectory(folder);
        string frame = Asset("page.html");
        foreach (SitePage page in all)
        {
            string written = frame
                .Replace("{{title}}", WebUtility.HtmlEncode(page.Title), StringComparison.Ordinal)
                .Replace("{{pages}}", Menu(pages, page, api), StringComparison.Ordinal)
                .Replace("{{crumbs}}", Crumbs(pages, page), StringComparison.Ordinal)
                .Replace("{{neighbours}}", Neighbours(pages, page), StringComparison.Ordinal)
                .Replace("{{live}}", page.Html.Contains("<figure class=\"live\"", StringComparison.Ordinal) ? "<script src=\"live.js\"></script>\n" : "", StringComparison.Ordinal)
                .Replace("{{kind}}", page.File == "index.html" ? " class=\"landing\"" : "", StringComparison.Ordinal)
                .Replace("{{contents}}", page.File == "index.html" ? "" : Contents(page), StringComparison.Ordinal)
                .Replace("{{version}}", typeof(Ball).Assembly.GetName().Version!.ToString(3), StringComparison.Ordinal)
                .Replace("{{content}}", page.Html, StringComparison.Ordinal);
            File.WriteAllText(Path.Combine(folder, page.File), written);
            foreach (string picture in page.Pictures)
            {
                File.Copy(Path.Combine(repository, picture), Path.Combine(folder, Path.GetFileName(picture)), overwrite: true);
            }
        }

        File.WriteAllText(Path.Combine(folder, Tool.Playground.File), Tool.Playground.Html);
        File.WriteAllText(Path.Combine(folder, "live-runtime.js"), $"const LIVE_RUNTIME = {Runtime(Tool.Playground.Html)};\n");
        foreach (string asset in (string[])["pages.js", "live.js", "style.css", "search.js"])
        {
            File.WriteAllText(Path.Combine(folder, asset), Asset(asset));
        }

        File.WriteAllText(Path.Combine(folder, "search-index.js"), $"const SECTIONS = {Index(all)};\n");
        File.WriteAllText(Path.Combine(folder, LlmsText.File), LlmsText.Of(Read(repository, SitePage.ContentsSource), page => SitePage.FileOf("docs/" + page)));
        GalleryWall.Write(folder);
        return [.. pages.Select(page => page.Page.File)];
    }

    /// <summary>The pages that the page of contents links, each with the heading above its link.</summary>
    private static IEnumerable<(string Source, string Group)> Grouped(string contents) =>
        from part in contents.Split("\n## ").Skip(1)
        from source in Linked().Matches(part).Select(match => "docs/" + match.Groups[1].Value).Distinct()
        select (source, part.Split('\n')[0]);

    /// <summary>The sections that have a type in their code. Sections that use the type often, and few others, come first.</summary>
    private static IEnumerable<(string Type, Section Section)> Uses(IEnumerable<(SitePage Page, string Group)> pages, HashSet<string> types) =>
        from section in pages.SelectMany(page => page.Page.Sections)
        let names = Word().Matches(section.Code).Select(word => word.Value).Where(types.Contains).GroupBy(name => name).ToArray()
        from name in names
        orderby (double)Math.Min(name.Count(), 3) / names.Length descending
        select (name.Key, section);

    /// <summary>Links to all pages, in groups; a page of a type also has links to its family.</summary>
    private static string Menu((SitePage Page, string Group)[] pages, SitePage current, ApiIndex api)
    {
        var menu = new StringBuilder();
        string group = "";
        foreach ((SitePage page, string its) in pages)
        {
            menu.Append(its == group ? "" : $"<p>{its}</p>\n");
            group = its;
            menu.Append(Entry(page.File, page.Title, page.File == current.File));
            if (page.Source == SitePage.Api && current is TypePage { Type: { } type })
            {
                menu.Append("<div class=\"family\">\n").AppendJoin("", api.Types.Where(other => other.Family == type.Family).Select(other => Entry(other.Page, other.Name, other == type))).Append("</div>\n");
            }
        }

        return menu.ToString();
    }

    private static string Entry(string file, string title, bool isCurrent) => $"<a href=\"{file}\"{(isCurrent ? " aria-current=\"page\"" : "")}>{WebUtility.HtmlEncode(title)}</a>\n";

    /// <summary>The path from the first page to a page.</summary>
    private static string Crumbs((SitePage Page, string Group)[] pages, SitePage page)
    {
        SitePage home = pages[0].Page;
        if (page == home)
        {
            return "";
        }

        (string File, string Title)[] path;
        if (page is TypePage { Type.Family: { } family })
        {
            SitePage reference = pages.Single(other => other.Page.Source == SitePage.Api).Page;
            path = [(reference.File, "API"), ($"{reference.File}#{SitePage.AddressOf(family)}", family)];
        }
        else
        {
            string group = pages.Single(other => other.Page == page).Group;
            path = group.Length == 0 ? [] : [($"{SitePage.FileOf(SitePage.ContentsSource)}#{SitePage.AddressOf(group)}", group)];
        }

        return "<nav class=\"crumbs\" aria-label=\"Breadcrumb\"><ol>"
            + string.Concat(path.Prepend((home.File, "Home")).Select(step => $"<li><a href=\"{step.Item1}\">{WebUtility.HtmlEncode(step.Item2)}</a></li>"))
            + $"<li aria-current=\"page\">{WebUtility.HtmlEncode(page.Title)}</li></ol></nav>\n";
    }

    /// <summary>The headings of a page, or the members of a type, if there are more than fit on a screen.</summary>
    private static string Contents(SitePage page)
    {
        (string Address, string Heading, bool IsSub)[] sections = [.. page.Contents];
        return sections.Length < 3 ? ""
            : "<aside aria-label=\"On this page\"><details open><summary>On this page</summary>\n"
                + string.Concat(sections.Select(section => $"<a{(section.IsSub ? " class=\"sub\"" : "")} href=\"{section.Address}\">{WebUtility.HtmlEncode(section.Heading)}</a>\n")) + "</details></aside>\n";
    }

    /// <summary>Links to the pages before and after a page, in the order of the page of contents.</summary>
    private static string Neighbours((SitePage Page, string Group)[] pages, SitePage page)
    {
        int at = Array.FindIndex(pages, other => other.Page == page);
        return at <= 0 ? ""
            : "<nav class=\"neighbours\" aria-label=\"Previous and next\">" + Link(at - 1, "previous", "←") + Link(at + 1, "next", "→") + "</nav>\n";

        string Link(int index, string kind, string arrow) => index == pages.Length ? ""
            : $"<a rel=\"{(kind == "next" ? "next" : "prev")}\" href=\"{pages[index].Page.File}\"><small>{(kind == "next" ? "Next " + arrow : arrow + " Previous")}</small> {WebUtility.HtmlEncode(pages[index].Page.Title)}</a>";
    }

    /// <summary>The npm package inside the page to play with: its files by name, each packed with gzip and in base64.</summary>
    private static string Runtime(string playground)
    {
        Match resources = Resources().Match(playground);
        return resources.Success ? resources.Groups[1].Value : throw new InvalidOperationException("The page to play with contains no resources.");
    }

    private static string Index(SitePage[] pages) => JsonSerializer.Serialize(
        from page in pages
        from section in page.Sections
        where section.Text.Length > 0
        select new[] { section.Page, section.Heading, section.Address, section.Text });

    private static string Read(string repository, string source) => File.ReadAllText(Path.Combine(repository, source)).ReplaceLineEndings("\n");

    private static string Asset(string name)
    {
        using Stream asset = Assembly.GetExecutingAssembly().GetManifestResourceStream(name)!;
        return new StreamReader(asset, Encoding.UTF8).ReadToEnd();
    }

    [GeneratedRegex(@"\]\(((?:internals/)?[a-z-]+\.md)")]
    private static partial Regex Linked();

    [GeneratedRegex(@"\w+")]
    private static partial Regex Word();

    [GeneratedRegex(@"<script[^>]* id=""resources""[^>]*>\s*(\{.*?\})\s*</script>", RegexOptions.Singleline)]
    private static partial Regex Resources();
}
