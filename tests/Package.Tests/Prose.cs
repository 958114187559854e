using System.Text.RegularExpressions;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace FootballPhysics.Package.Tests;

/// <summary>The prose of a page or of the documentation comments, without code, and the five checks of docs/internals/style.md.</summary>
internal static partial class Prose
{
    /// <summary>Each expression finds a habit that makes a sentence hard to read.</summary>
    public static IReadOnlyList<(string Name, Regex Expression)> Checks { get; } =
    [
        ("'what' as a pronoun", Pronoun()),
        ("code that talks", Talk()),
        ("'where' for 'if' or 'when'", Where()),
        ("a vague noun", VagueNoun()),
        ("a negation without a verb", Negation()),
    ];

    /// <summary>The number of words and all hits in some text.</summary>
    public static (int Words, IReadOnlyList<string> Hits) Scan(IEnumerable<string> units)
    {
        int words = 0;
        var hits = new List<string>();
        foreach (string text in units.Select(unit => Code().Replace(unit, "`x`")))
        {
            words += Words(text);
            hits.AddRange(from check in Checks from hit in check.Expression.Matches(text) select $"{check.Name}: '{hit.Value.Trim()}' in '{text}'");
        }

        return (words, hits);
    }

    /// <summary>The sentences of a page, from five words on; cells of tables count from eight words on. Code blocks and generated blocks are left out.</summary>
    public static IEnumerable<string> OfPage(string markdown)
    {
        markdown = Generated().Replace(markdown, "\n");
        markdown = Fence().Replace(markdown, "\n\n");
        markdown = Comment().Replace(markdown, "");
        var block = new List<string>();
        var units = new List<string>();
        void Flush()
        {
            units.AddRange(Sentences(string.Join(' ', block)));
            block.Clear();
        }

        foreach (string line in markdown.Split('\n').Select(line => line.TrimEnd()))
        {
            if (line.Trim().Length == 0 || line.StartsWith('#'))
            {
                Flush();
            }
            else if (line.StartsWith('|'))
            {
                Flush();
                units.AddRange(Cell().Split(line.Trim().Trim('|')).Where(cell => Words(Plain(cell)) >= 8).SelectMany(Sentences));
            }
            else
            {
                if (Item().IsMatch(line))
                {
                    Flush();
                }

                block.Add(Item().Replace(line, "").Trim());
            }
        }

        Flush();
        return units;
    }

    /// <summary>The summaries and remarks of the public members in a file of C#.</summary>
    public static IEnumerable<string> OfSource(string code)
    {
        SyntaxNode root = CSharpSyntaxTree.ParseText(code, new CSharpParseOptions(documentationMode: DocumentationMode.Parse)).GetRoot();
        foreach (MemberDeclarationSyntax member in root.DescendantNodes().OfType<MemberDeclarationSyntax>().Where(IsPublic))
        {
            IEnumerable<XmlElementSyntax> elements = member.GetLeadingTrivia().Select(trivia => trivia.GetStructure()).OfType<DocumentationCommentTriviaSyntax>()
                .SelectMany(comment => comment.Content.OfType<XmlElementSyntax>());
            foreach (XmlElementSyntax element in elements.Where(element => element.StartTag.Name.ToString() is "summary" or "remarks"))
            {
                string text = Slashes().Replace(element.Content.ToFullString(), " ");
                text = Reference().Replace(text, "`x`");
                text = CodeElement().Replace(text, "`x`");
                yield return Plain(Tag().Replace(text, " ").Replace("&lt;", "<", StringComparison.Ordinal).Replace("&gt;", ">", StringComparison.Ordinal).Replace("&amp;", "&", StringComparison.Ordinal));
            }
        }
    }

    private static bool IsPublic(MemberDeclarationSyntax member)
    {
        bool implied = member is EnumMemberDeclarationSyntax || member.Parent is InterfaceDeclarationSyntax;
        bool hidden = member.Modifiers.Any(modifier => modifier.Kind() is SyntaxKind.PrivateKeyword or SyntaxKind.InternalKeyword);
        return (implied ? !hidden : member.Modifiers.Any(modifier => modifier.Kind() is SyntaxKind.PublicKeyword or SyntaxKind.ProtectedKeyword) && !hidden)
            && member.Ancestors().OfType<BaseTypeDeclarationSyntax>().All(IsPublic);
    }

    private static string Plain(string text) => Blank().Replace(Link().Replace(Image().Replace(text, " "), "$1").Replace("**", "", StringComparison.Ordinal), " ").Trim();

    private static IEnumerable<string> Sentences(string text) => Split().Split(Plain(text)).Where(sentence => Words(sentence) >= 5);

    private static int Words(string text) => Word().Count(Code().Replace(text, " x "));

    [GeneratedRegex(@"(?:(?:^|[.;:|]\s+|<\w+>\s*)What\s+(?!is\b[^.]*\?|are\b[^.]*\?|do\b|does\b|can\b|should\b)[a-z]|\b(?:of|by|from|with|on|to|for|than|beyond|beside|through|in|at|off|among|and|or|but|less|takes|is|are)\s+what\b)")]
    private static partial Regex Pronoun();

    [GeneratedRegex(@"\b(?:is|are|was|were|be|been)\s+(?:asked|told)\b|\b(?:tells|says|knows|asks|wants)\b")]
    private static partial Regex Talk();

    [GeneratedRegex(@"\b(?:[Tt]rue|[Ff]alse|null|NaN|none|0|zero|nothing|[Ee]lse|infinite|only|except|also|[Ll]ess|[Aa]s)\s+where\b|(?:^|[.;:]\s+)Where\s+[^.?]{3,80},")]
    private static partial Regex Where();

    [GeneratedRegex(@"\b[Tt]hings?\b|\banew\b|\bas ever\b|\b(?:straight|its|the ball's|a) way\b|\bplaces\b|\bits place\b")]
    private static partial Regex VagueNoun();

    [GeneratedRegex(@"(?<!there )(?<!There )\b(?:is|are) (?:none\b|no (?!longer\b|more\b|less\b|such\b)[a-z]+)|\bno number\b|\bbut for\b|\b(?:of|for|to) who\b|\b[Ww]hoever\b|(?:^|[.;:,]\s+)[Ee]lse\b")]
    private static partial Regex Negation();

    [GeneratedRegex("`[^`]*`")]
    private static partial Regex Code();

    [GeneratedRegex(@"<!-- (?!/)[^>]*from [^>]*-->.*?<!-- /[^>]*-->", RegexOptions.Singleline)]
    private static partial Regex Generated();

    [GeneratedRegex(@"^```.*?^```[^\n]*$", RegexOptions.Singleline | RegexOptions.Multiline)]
    private static partial Regex Fence();

    [GeneratedRegex("<!--.*?-->", RegexOptions.Singleline)]
    private static partial Regex Comment();

    [GeneratedRegex(@"(?<!\\)\|")]
    private static partial Regex Cell();

    [GeneratedRegex(@"^\s*(?:[-*]|\d+\.)\s+")]
    private static partial Regex Item();

    [GeneratedRegex(@"(?<=[.!?])\s+(?=[A-Z`“""(*0-9])")]
    private static partial Regex Split();

    [GeneratedRegex(@"[A-Za-zÀ-ÿ][A-Za-zÀ-ÿ'’\-]*")]
    private static partial Regex Word();

    [GeneratedRegex(@"\s+")]
    private static partial Regex Blank();

    [GeneratedRegex(@"!\[[^\]]*\]\([^)]*\)")]
    private static partial Regex Image();

    [GeneratedRegex(@"\[([^\]]*)\]\([^)]*\)")]
    private static partial Regex Link();

    [GeneratedRegex(@"^\s*///", RegexOptions.Multiline)]
    private static partial Regex Slashes();

    [GeneratedRegex("<(?:see|paramref|typeparamref|seealso)[^>]*/>")]
    private static partial Regex Reference();

    [GeneratedRegex("<c>.*?</c>", RegexOptions.Singleline)]
    private static partial Regex CodeElement();

    [GeneratedRegex("<[^>]*>")]
    private static partial Regex Tag();
}
