using System.Text.RegularExpressions;
using FootballPhysics.Site;

namespace FootballPhysics.Package.Tests;

/// <summary>The pages are pleasant to read: pictures where a path is described, code that fits, and lists that are complete.</summary>
public sealed partial class PageTests
{
    private const int WidestCode = 88;
    private const int LargestPicture = 30 * 1024;
    private const string Header = "src/Football.Physics.Native/include/football_physics.h";

    /// <summary>The number of pictures that the code draws, which a page has at least.</summary>
    public static TheoryData<string, int> Pictures => new()
    {
        { "getting-started", 2 }, { "concepts", 2 }, { "scene", 2 }, { "prediction", 2 }, { "aiming", 2 }, { "players", 2 }, { "cookbook", 2 },
        { "data-sets", 2 }, { "networking", 2 }, { "unity", 2 }, { "godot", 2 }, { "performance", 2 }, { "physics", 2 }, { "c", 1 }, { "command-line", 1 },
    };

    public static TheoryData<string> CodePages => [.. Repository.Pages.Where(page => Repository.Text(page).Contains("```", StringComparison.Ordinal))];

    [Theory]
    [MemberData(nameof(Pictures))]
    public void A_page_has_its_pictures_with_alternative_texts(string page, int most)
    {
        string[][] pictures = [.. Picture().Matches(Repository.Text($"docs/{page}.md")).Select(match => (string[])[match.Groups[1].Value, match.Groups[2].Value])];
        Assert.True(pictures.Length >= most, $"{page} has {pictures.Length} pictures drawn by the code; it should have {most} or more.");
        Assert.All(pictures, picture => Assert.True(picture[0].Length > 20, $"{picture[1]} needs an alternative text that says what it shows."));
        Assert.All(pictures, picture => Assert.InRange(new FileInfo(Path.Combine(Repository.Root, "docs", "pictures", picture[1] + ".svg")).Length, 1, LargestPicture));
    }

    [Theory]
    [MemberData(nameof(CodePages))]
    public void Code_fits_the_page(string page)
    {
        string kind = "";
        int number = 0;
        foreach (string line in Repository.Text(page).Split('\n'))
        {
            number++;
            if (line.TrimStart().StartsWith("```", StringComparison.Ordinal))
            {
                kind = kind.Length > 0 ? "" : line.Trim();
            }
            else if (kind.Length > 0 && !kind.StartsWith("```text", StringComparison.Ordinal) && page.StartsWith("docs/", StringComparison.Ordinal) && !page.StartsWith("docs/internals/", StringComparison.Ordinal))
            {
                Assert.True(line.Length <= WidestCode, $"{page}, line {number} has {line.Length} characters; allowed: {WidestCode}.\n{line}");
            }
        }
    }

    [Fact]
    public void The_list_for_language_models_names_all_pages() =>
        Repository.AssertCurrent(LlmsText.File, LlmsText.Of(Repository.Text("docs/contents.md"), page => "docs/" + page));

    [Fact]
    public void The_page_for_assistants_has_ten_programs_and_ten_habits()
    {
        string page = Repository.Text("docs/assistants.md");
        Assert.Equal(10, Regex.Count(page, "^### \\d+\\. ", RegexOptions.Multiline));
        Assert.Equal(10, Regex.Count(page, "^```csharp$", RegexOptions.Multiline));
        Assert.Equal(11, page.Split("## Ten wrong habits")[1].Split('\n').Count(line => line.StartsWith("| ", StringComparison.Ordinal)));
    }

    [Fact]
    public void The_page_about_C_lists_all_functions_status_codes_and_events()
    {
        string header = Repository.Text(Header);
        string[] functions = [.. Function().Matches(header).Select(match => $"| `{match.Groups["name"].Value}` | {Sentence(match.Groups["words"].Value)} |")];
        Assert.Equal(Regex.Count(header, "^FOOTBALL_API ", RegexOptions.Multiline), functions.Length);
        string[] codes = [.. Values(header, "FP_OK").Select(value => $"| {value.Number} | `{value.Name}` | {value.Words} |")];
        string[] events = [.. Values(header, "FP_EVENT_IMPACT").Select(value => $"| {value.Number} | `{value.Name}` | {value.Words} |")];
        Assert.Equal((8, 10), (codes.Length, events.Length));
        string page = Repository.Text("docs/c.md");
        page = Filled(page, "functions", ["| function | purpose |", "|---|---|", .. functions]);
        page = Filled(page, "status codes", ["| value | name | meaning |", "|--:|---|---|", .. codes]);
        page = Filled(page, "event kinds", ["| value | name | when |", "|--:|---|---|", .. events]);
        Repository.AssertCurrent("docs/c.md", page);
        Assert.DoesNotContain("```js", page);
        Assert.DoesNotContain("```lua", page);
    }

    [Fact]
    public void A_term_of_the_glossary_is_in_a_comment()
    {
        string comments = string.Join('\n', Directory.GetFiles(Path.Combine(Repository.Root, "src", "Football.Physics"), "*.cs", SearchOption.AllDirectories).Concat(Directory.GetFiles(Path.Combine(Repository.Root, "src", "Football.Physics.Batch"), "*.cs", SearchOption.AllDirectories))
            .Where(file => !file.Contains($"{Path.DirectorySeparatorChar}obj{Path.DirectorySeparatorChar}", StringComparison.Ordinal))
            .SelectMany(File.ReadLines).Where(line => line.Contains("//", StringComparison.Ordinal)).Select(line => line[line.IndexOf("//", StringComparison.Ordinal)..]));
        string[] terms = [.. Term().Matches(Repository.Text("docs/internals/glossary.md")).Select(match => match.Groups[1].Value).Where(term => term != "term")];
        Assert.True(terms.Length >= 20);
        Assert.All(terms, term => Assert.Matches($@"(?i)\b{string.Join(@"[ \n/]+", term.Split(' '))}", comments));
    }

    private static string Filled(string page, string name, string[] lines) =>
        Regex.Replace(page, $"(<!-- {name}, from [^>]*-->\n).*?(<!-- /{name} -->)", match => match.Groups[1].Value + string.Join('\n', lines) + "\n" + match.Groups[2].Value, RegexOptions.Singleline);

    /// <summary>The first sentence of a comment, in one line of a table.</summary>
    private static string Sentence(string comment)
    {
        string text = Blanks().Replace(comment, " ").Trim();
        int end = text.IndexOf(". ", StringComparison.Ordinal);
        return (end < 0 ? text : text[..(end + 1)]).TrimEnd('.').Replace("|", "\\|", StringComparison.Ordinal);
    }

    /// <summary>The values of the enumeration that begins with a name, without the last one, which fixes the size.</summary>
    private static IEnumerable<(string Name, string Number, string Words)> Values(string header, string first)
    {
        string list = header[..header.IndexOf('}', header.IndexOf($" {first} = ", StringComparison.Ordinal))];
        list = list[list.LastIndexOf("enum {", StringComparison.Ordinal)..];
        return Value().Matches(list).Where(match => match.Groups["number"].Value != "-1")
            .Select(match => (match.Groups["name"].Value, match.Groups["number"].Value, Sentence(match.Groups["words"].Value)));
    }

    [GeneratedRegex(@"!\[([^\]]*)\]\(pictures/([\w-]+)\.svg\)")]
    private static partial Regex Picture();

    [GeneratedRegex(@"/\*\* (?<words>(?:(?!\*/)[\s\S])*?)\*/\nFOOTBALL_API [^(]*?(?<name>fp_\w+)\(")]
    private static partial Regex Function();

    [GeneratedRegex(@"/\*\* (?<words>(?:(?!\*/)[\s\S])*?)\*/\s*(?<name>FP_\w+) = (?<number>-?\d+)")]
    private static partial Regex Value();

    [GeneratedRegex(@"\s+")]
    private static partial Regex Blanks();

    [GeneratedRegex(@"^\| ([a-z ]+) \|", RegexOptions.Multiline)]
    private static partial Regex Term();
}
