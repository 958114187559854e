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
    /// <param name="folder">Where the site goes.</param>
    public static IReadOnlyList<string> Write(string repository, string folder)
    {
        // The page of contents gives the order.
        string[] sources = ["README.md", SitePage.ContentsSource, .. Linked().Matches(Read(repository, SitePage.ContentsSource)).Select(match => "docs/" + match.Groups[1].Value).Distinct()];
        string[] reference = Read(repository, SitePage.Api).Split("\n## ");
        var types = reference.Skip(1).Select(part => SitePage.AddressOf(part.Split('\n')[0])).ToHashSet();
        SitePage[] pages = [.. sources.Select(source => new SitePage(source, source == SitePage.Api ? reference[0] : Read(repository, source), types))];
        SitePage[] all =
        [
            .. pages,
            .. reference.Skip(1).Select(part => new SitePage(SitePage.Api, "# " + part, types, SitePage.TypePage(SitePage.AddressOf(part.Split('\n')[0])))),
        ];
        Directory.CreateDirectory(folder);
        string frame = Asset("page.html");
        foreach (SitePage page in all)
        {
            string written = frame
                .Replace("{{title}}", WebUtility.HtmlEncode(page.Title), StringComparison.Ordinal)
                .Replace("{{pages}}", Menu(pages, page), StringComparison.Ordinal)
                .Replace("{{first}}", page.File == "index.html" ? Asset("first.html") : "", StringComparison.Ordinal)
                .Replace("{{contents}}", Contents(page), StringComparison.Ordinal)
                .Replace("{{version}}", typeof(Ball).Assembly.GetName().Version!.ToString(3), StringComparison.Ordinal)
                .Replace("{{content}}", page.Html, StringComparison.Ordinal);
            File.WriteAllText(Path.Combine(folder, page.File), written);
            foreach (string picture in page.Pictures)
            {
                File.Copy(Path.Combine(repository, picture), Path.Combine(folder, Path.GetFileName(picture)), overwrite: true);
            }
        }

        File.WriteAllText(Path.Combine(folder, Tool.Playground.File), Tool.Playground.Html);
        File.WriteAllText(Path.Combine(folder, "pages.js"), Asset("pages.js"));
        File.WriteAllText(Path.Combine(folder, "style.css"), Asset("style.css"));
        File.WriteAllText(Path.Combine(folder, "search.js"), $"const SECTIONS = {Index(all)};\n{Asset("search.js")}");
        return [.. pages.Select(page => page.File)];
    }

    /// <summary>Links to all pages; those for contributors follow under a heading.</summary>
    private static string Menu(SitePage[] pages, SitePage current)
    {
        int guides = pages.Count(page => !page.Source.StartsWith(SitePage.Internals, StringComparison.Ordinal));
        return string.Concat(pages.Take(guides).Select(page => Entry(page, current))) + "<p>Internals</p>\n"
            + string.Concat(pages.Skip(guides).Select(page => Entry(page, current)));
    }

    private static string Entry(SitePage page, SitePage current) =>
        $"<a href=\"{page.File}\"{(page.Source == current.Source ? " aria-current=\"page\"" : "")}>{WebUtility.HtmlEncode(page.Title)}</a>\n";

    /// <summary>What is on a page, where that is more than fits on a screen.</summary>
    private static string Contents(SitePage page)
    {
        (string Address, string Heading)[] sections = [.. page.Contents];
        return sections.Length < 3 ? ""
            : "<aside aria-label=\"On this page\"><details open><summary>On this page</summary>\n"
                + string.Concat(sections.Select(section => $"<a href=\"{section.Address}\">{WebUtility.HtmlEncode(section.Heading)}</a>\n")) + "</details></aside>\n";
    }

    private static string Index(SitePage[] pages) => JsonSerializer.Serialize(
        from page in pages
        from section in page.Sections
        where section.Text.Length > 0
        select new[] { page.Title, section.Heading, section.Address, section.Text });

    private static string Read(string repository, string source) => File.ReadAllText(Path.Combine(repository, source)).ReplaceLineEndings("\n");

    private static string Asset(string name)
    {
        using Stream asset = Assembly.GetExecutingAssembly().GetManifestResourceStream(name)!;
        return new StreamReader(asset, Encoding.UTF8).ReadToEnd();
    }

    [GeneratedRegex(@"\]\(((?:internals/)?[a-z-]+\.md)")]
    private static partial Regex Linked();
}
