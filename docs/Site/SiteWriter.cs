using System.Net;
using System.Reflection;
using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;

namespace Football.Physics.Site;

/// <summary>Writes README.md and the pages of docs/ as a site that needs no network: with a search, light and dark.</summary>
internal static partial class SiteWriter
{
    /// <summary>Writes it; the names of its pages, the first page first.</summary>
    /// <param name="repository">The folder of the repository.</param>
    /// <param name="folder">Where the site goes.</param>
    public static IReadOnlyList<string> Write(string repository, string folder)
    {
        string readme = Read(repository, "README.md");
        // In the order of the README's last list, which is for readers; what stands in a sentence before it has its place there too.
        string[] sources = ["README.md", .. Linked().Matches(readme).Select(match => match.Groups[1].Value).Reverse().Distinct().Reverse()];
        SitePage[] pages = [.. sources.Select(source => new SitePage(source, Read(repository, source)))];
        Directory.CreateDirectory(folder);
        string frame = Asset("page.html");
        foreach (SitePage page in pages)
        {
            string written = frame
                .Replace("{{title}}", WebUtility.HtmlEncode(page.Title), StringComparison.Ordinal)
                .Replace("{{pages}}", string.Concat(pages.Select(other => Entry(other, page))), StringComparison.Ordinal)
                .Replace("{{content}}", page.Html, StringComparison.Ordinal);
            File.WriteAllText(Path.Combine(folder, page.File), written);
            foreach (string picture in page.Pictures)
            {
                File.Copy(Path.Combine(repository, picture), Path.Combine(folder, Path.GetFileName(picture)), overwrite: true);
            }
        }

        File.WriteAllText(Path.Combine(folder, "style.css"), Asset("style.css"));
        File.WriteAllText(Path.Combine(folder, "search.js"), $"const SECTIONS = {Index(pages)};\n{Asset("search.js")}");
        return [.. pages.Select(page => page.File)];
    }

    private static string Entry(SitePage page, SitePage current) =>
        $"<a href=\"{page.File}\"{(page == current ? " aria-current=\"page\"" : "")}>{WebUtility.HtmlEncode(page.Title)}</a>\n";

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

    [GeneratedRegex(@"\]\((docs/[a-z-]+\.md)")]
    private static partial Regex Linked();
}
