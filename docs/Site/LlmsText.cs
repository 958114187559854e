using System.Text;
using System.Text.RegularExpressions;

namespace FootballPhysics.Site;

/// <summary>The list of all pages in the format of llmstxt.org, made from the page of contents.</summary>
internal static partial class LlmsText
{
    /// <summary>The name of the file, in the repository and in the site.</summary>
    public const string File = "llms.txt";

    /// <summary>Writes the list.</summary>
    /// <param name="contents">The text of docs/contents.md.</param>
    /// <param name="address">The address of a page, from its path inside docs/.</param>
    public static string Of(string contents, Func<string, string> address)
    {
        var text = new StringBuilder("# Football.Physics\n\n> Realistic ball physics for football (soccer) games, in C#: flight with spin, bounces, nets, prediction, aiming, bit-identical multiplayer. The namespace is FootballPhysics; units are SI; −z is forward.\n\n");
        text.Append("Read first: [For coding assistants](").Append(address("assistants.md")).Append("), with the right package, ten right programs and ten wrong habits.\n");
        foreach (string part in contents.Split("\n## ").Skip(1))
        {
            string heading = part.Split('\n')[0];
            text.Append("\n## ").Append(heading == "Internals" ? "Optional" : heading).Append("\n\n");
            foreach (Match row in Row().Matches(part))
            {
                text.Append("- [").Append(row.Groups["title"].Value).Append("](").Append(address(row.Groups["page"].Value)).Append("): ").Append(row.Groups["about"].Value).Append('\n');
            }
        }

        return text.ToString();
    }

    [GeneratedRegex(@"^\| \[(?<title>[^\]]+)\]\((?<page>[^)]+)\) \| (?<about>.*) \|$", RegexOptions.Multiline)]
    private static partial Regex Row();
}
