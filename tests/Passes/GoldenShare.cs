using System.Globalization;
using System.Text.Json;
using FootballPhysics.Golden;
using FootballPhysics.Mutants;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace FootballPhysics.Passes;

/// <summary>The share of Simulation and Contacts that the golden lines execute: of the bodies, and of the working lines in their blocks.</summary>
/// <remarks>A mark at the start of each block counts its own working lines, without those of the blocks in it.</remarks>
internal static class GoldenShare
{
    private const string Value = "golden";
    private static readonly string[] s_folders = ["Simulation", "Contacts"];
    private static readonly string s_work = Path.Combine(LibrarySources.Root, "artifacts/passes-golden");

    /// <summary>Prints the shares of the lines up to "total", and of all lines.</summary>
    /// <param name="lists">True to print each body with working lines that no golden line executes.</param>
    /// <returns>The exit code: 1 if the golden lines are not those of golden.txt.</returns>
    public static int Run(bool lists)
    {
        if (!MarkedLibrary.Is(Value))
        {
            var found = new List<Block>();
            var trees = LibrarySources.Files.Select(path => CSharpSyntaxTree.ParseText(Marked(path, found), LibrarySources.Parsing, path)).ToList();
            trees.Add(CSharpSyntaxTree.ParseText($$"""public static class Ran { public static readonly bool[] Blocks = new bool[{{found.Count}}]; }""", LibrarySources.Parsing));
            return MarkedLibrary.Start(s_work, trees, "blocks.json", JsonSerializer.Serialize(found), Value, lists ? ["--golden", "--list"] : ["--golden"]);
        }

        Block[] blocks = JsonSerializer.Deserialize<Block[]>(File.ReadAllText(Path.Combine(s_work, "blocks.json")))!;
        var ran = (bool[])typeof(Simulator).Assembly.GetType("Ran")!.GetField("Blocks")!.GetValue(null)!;
        var lines = new List<string>();
        foreach (string line in GoldenShots.Lines())
        {
            lines.Add(line);
            if (line.StartsWith("total", StringComparison.Ordinal))
            {
                Tell(string.Create(CultureInfo.InvariantCulture, $"{lines.Count} golden lines"), blocks, ran);
            }
        }

        foreach (IGrouping<string, int> body in Enumerable.Range(0, lists ? blocks.Length : 0).GroupBy(i => blocks[i].Body))
        {
            int missing = body.Sum(i => ran[i] ? 0 : blocks[i].Lines.Length);
            if (missing > 0)
            {
                Console.WriteLine($"    {body.Key}: {missing} of {body.Sum(i => blocks[i].Lines.Length)} working lines, {string.Join(' ', body.Where(i => !ran[i]).SelectMany(i => blocks[i].Lines).Order())}");
            }
        }

        bool same = File.ReadAllLines(Path.Combine(LibrarySources.Root, "tests/Golden/golden.txt")).SequenceEqual(lines);
        Console.WriteLine(same ? "The lines are those of golden.txt." : "The lines are not those of golden.txt.");
        return same ? 0 : 1;
    }

    private static void Tell(string what, Block[] blocks, bool[] ran)
    {
        foreach (string folder in s_folders)
        {
            int[] those = [.. Enumerable.Range(0, blocks.Length).Where(i => blocks[i].Body.StartsWith(folder, StringComparison.Ordinal))];
            int[] bodies = [.. those.Where(i => blocks[i].IsBody)];
            int lines = those.Sum(i => blocks[i].Lines.Length);
            int run = those.Sum(i => ran[i] ? blocks[i].Lines.Length : 0);
            Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{what}, {folder}: {bodies.Count(i => ran[i])} of {bodies.Length} bodies ({100.0 * bodies.Count(i => ran[i]) / bodies.Length:0.0} %), {run} of {lines} working lines in blocks ({100.0 * run / lines:0.0} %)"));
        }
    }

    private static string Marked(string path, List<Block> blocks)
    {
        string text = File.ReadAllText(path);
        string name = Path.GetRelativePath(LibrarySources.Folder, path);
        if (!s_folders.Contains(name.Split('/', '\\')[0]))
        {
            return text;
        }

        SyntaxNode root = CSharpSyntaxTree.ParseText(text, LibrarySources.Parsing).GetRoot();
        var inserted = new List<(int At, string Text)>();
        foreach (SyntaxNode node in root.DescendantNodes().Where(node => node is BlockSyntax or ArrowExpressionClauseSyntax))
        {
            string mark = $" global::Ran.Blocks[{blocks.Count}] = true; ";
            if (node is ArrowExpressionClauseSyntax arrow)
            {
                bool returns = arrow.Expression is not ThrowExpressionSyntax && arrow.Parent switch
                {
                    ConstructorDeclarationSyntax => false,
                    MethodDeclarationSyntax method => method.ReturnType.ToString() != "void",
                    LocalFunctionStatementSyntax local => local.ReturnType.ToString() != "void",
                    AccessorDeclarationSyntax accessor => accessor.IsKind(SyntaxKind.GetAccessorDeclaration),
                    _ => true,
                };
                bool isProperty = arrow.Parent is PropertyDeclarationSyntax or IndexerDeclarationSyntax;
                SyntaxToken end = arrow.GetLastToken().GetNextToken();
                text = text[..arrow.ArrowToken.SpanStart] + "  " + text[arrow.ArrowToken.Span.End..];
                text = text[..end.SpanStart] + " " + text[end.Span.End..];
                inserted.Add((arrow.SpanStart, (isProperty ? "{ get {" : "{") + mark + (returns ? "return " : "")));
                inserted.Add((end.SpanStart, isProperty ? "; } }" : "; }"));
            }
            else
            {
                inserted.Add((node.SpanStart + 1, mark));
            }

            int[] lines = [.. node.DescendantTokens().Where(IsWork).Where(token => Innermost(token) == node).Select(LineOf).Distinct()];
            SyntaxNode body = BodyOf(node);
            blocks.Add(new Block($"{name} {Marker.NameOf(body.Parent!)}", body == node, lines));
        }

        foreach ((int at, string added) in inserted.OrderByDescending(insertion => insertion.At))
        {
            text = text[..at] + added + text[at..];
        }

        return text;
    }

    // The first token of a line that is not a bracket.
    private static bool IsWork(SyntaxToken token)
    {
        for (SyntaxToken before = token.GetPreviousToken(); before.RawKind != 0 && LineOf(before) == LineOf(token); before = before.GetPreviousToken())
        {
            if (!IsBracket(before))
            {
                return false;
            }
        }

        return !IsBracket(token);
    }

    private static bool IsBracket(SyntaxToken token) => token.Text is "{" or "}" or "(" or ")" or "[" or "]" or ";" or ",";

    private static int LineOf(SyntaxToken token) => token.GetLocation().GetLineSpan().StartLinePosition.Line + 1;

    private static SyntaxNode? Innermost(SyntaxToken token) => token.Parent!.AncestorsAndSelf().FirstOrDefault(node => node is BlockSyntax or ArrowExpressionClauseSyntax);

    // The outermost block or arrow of the member.
    private static SyntaxNode BodyOf(SyntaxNode node) => node.AncestorsAndSelf().Last(at => at is BlockSyntax or ArrowExpressionClauseSyntax);

    /// <summary>A block: the member that it is in, whether it is the whole body, and its own working lines.</summary>
    private sealed record Block(string Body, bool IsBody, int[] Lines);
}
