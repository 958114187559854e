using System.Globalization;
using System.Text;
using System.Text.RegularExpressions;
using FootballPhysics.Site.Live;

namespace FootballPhysics.Site;

/// <summary>All pages in a table: words, pictures, live examples and the widest line of code.</summary>
internal static partial class PageTable
{
    /// <summary>Counts the pages of a repository.</summary>
    public static string Of(string repository)
    {
        var table = new StringBuilder("| page | words | pictures | live | widest code |\n|---|--:|--:|--:|--:|\n");
        foreach (string page in Directory.GetFiles(Path.Combine(repository, "docs"), "*.md").Order(StringComparer.Ordinal).Append(Path.Combine(repository, "README.md")))
        {
            string text = File.ReadAllText(page).ReplaceLineEndings("\n");
            string name = Path.GetFileNameWithoutExtension(page);
            int widest = Fence().Matches(text).Where(block => !block.Groups["kind"].Value.StartsWith("text", StringComparison.Ordinal))
                .SelectMany(block => block.Groups["code"].Value.Split('\n')).Select(line => line.Length).DefaultIfEmpty(0).Max();
            int words = Word().Count(Fence().Replace(text, ""));
            int live = LiveExample.All.Count(example => example.Page == name + ".html");
            table.Append(CultureInfo.InvariantCulture, $"| {name} | {words} | {Picture().Count(text)} | {live} | {widest} |\n");
        }

        return table.ToString();
    }

    [GeneratedRegex(@"^ *```(?<kind>[^\n]*)\n(?<code>.*?)^ *```$", RegexOptions.Multiline | RegexOptions.Singleline)]
    private static partial Regex Fence();

    [GeneratedRegex(@"[A-Za-zÀ-ÿ][A-Za-zÀ-ÿ'’-]*")]
    private static partial Regex Word();

    [GeneratedRegex(@"!\[[^\]]*\]\(")]
    private static partial Regex Picture();
}
