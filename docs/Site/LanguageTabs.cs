using Markdig.Helpers;
using Markdig.Syntax;
using Markdig.Syntax.Inlines;

namespace FootballPhysics.Site;

/// <summary>Joins programs that do the same in several languages into one block with a tab for each language.</summary>
internal static class LanguageTabs
{
    /// <summary>The languages, by the first word of a code block.</summary>
    private static readonly Dictionary<string, string> s_names = new() { ["csharp"] = "C#", ["python"] = "Python", ["c"] = "C", ["js"] = "JavaScript" };

    /// <summary>
    /// Finds programs that follow each other in different languages: only pictures, and one paragraph that names the language, may stand
    /// between them. The paragraph goes into the tab, the pictures go below all tabs.
    /// </summary>
    public static void Group(MarkdownDocument document)
    {
        for (int i = 0; i < document.Count; i++)
        {
            if (LanguageOf(document[i]) is not { } first)
            {
                continue;
            }

            var tabs = new List<(string Language, List<Block> Blocks)>();
            var pictures = new List<Block>();
            int end = AddProgram(document, i, first, [], tabs);
            while (Next(document, end, tabs) is { } next)
            {
                pictures.AddRange(next.Pictures);
                end = AddProgram(document, next.At, next.Language, next.Words, tabs);
            }

            if (tabs.Count > 1)
            {
                i = Replace(document, i, end, tabs, pictures);
            }
            else
            {
                i = end - 1;
            }
        }
    }

    private static string? LanguageOf(Block block) => block is FencedCodeBlock { Info: { } info } code && string.IsNullOrEmpty(code.Arguments) && s_names.ContainsKey(info) ? info : null;

    /// <summary>Adds the program at an index and its output; returns the index after them.</summary>
    private static int AddProgram(MarkdownDocument document, int at, string language, List<Block> words, List<(string, List<Block>)> tabs)
    {
        List<Block> blocks = [.. words, document[at++]];
        if (at < document.Count && document[at] is FencedCodeBlock { Info: "text" } output)
        {
            blocks.Add(output);
            at++;
        }

        tabs.Add((language, blocks));
        return at;
    }

    /// <summary>The program in another language that follows; null if none does.</summary>
    private static (int At, string Language, List<Block> Words, List<Block> Pictures)? Next(MarkdownDocument document, int at, List<(string Language, List<Block> Blocks)> tabs)
    {
        var pictures = new List<Block>();
        var words = new List<Block>();
        for (; at < document.Count && document[at] is ParagraphBlock paragraph; at++)
        {
            (IsPicture(paragraph) ? pictures : words).Add(paragraph);
        }

        bool isNext = at < document.Count && LanguageOf(document[at]) is { } language && words.Count <= 1 && tabs.TrueForAll(tab => tab.Language != language)
            && words.TrueForAll(text => SitePage.Words(text).Contains(s_names[language], StringComparison.Ordinal));
        return isNext ? (at, LanguageOf(document[at])!, words, pictures) : null;
    }

    private static bool IsPicture(ParagraphBlock paragraph) => paragraph.Inline is { FirstChild: LinkInline { IsImage: true, NextSibling: null } };

    /// <summary>Replaces the blocks between two indices; returns the index of the last block of the group.</summary>
    private static int Replace(MarkdownDocument document, int from, int to, List<(string Language, List<Block> Blocks)> tabs, List<Block> pictures)
    {
        for (int i = to - 1; i >= from; i--)
        {
            document.RemoveAt(i);
        }

        int at = from;
        document.Insert(at++, Raw("<div class=\"tabs\">"));
        foreach ((string language, List<Block> blocks) in tabs)
        {
            document.Insert(at++, Raw($"<div class=\"tab\" data-language=\"{s_names[language]}\">"));
            foreach (Block block in blocks)
            {
                document.Insert(at++, block);
            }

            document.Insert(at++, Raw("</div>"));
        }

        document.Insert(at++, Raw("</div>"));
        foreach (Block picture in pictures)
        {
            document.Insert(at++, picture);
        }

        return at - 1;
    }

    /// <summary>A block of HTML.</summary>
    internal static HtmlBlock Raw(string html) => new(null) { Lines = new StringLineGroup(html) };
}
