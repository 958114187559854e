using System.Globalization;
using System.Security.Cryptography;
using System.Text;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace FootballPhysics.Mutants;

/// <summary>The mutants that the seeds draw, and the library that contains all of them.</summary>
/// <param name="Mutants">Each mutant with its room and its name. The index is the number of its switch.</param>
/// <param name="Library">The bytes of the library.</param>
internal sealed record Sample(IReadOnlyList<(string Room, Mutant Mutant, string Name)> Mutants, byte[] Library)
{
    // The switch reads the environment once, so that compiled code contains no check.
    private const string Switch = """
        internal static class Mutation
        {
            private static readonly int Active = int.Parse(System.Environment.GetEnvironmentVariable("FOOTBALL_MUTANT") ?? "-1");
            private static readonly bool[] Reached = new bool[10000];

            static Mutation()
            {
                if (Active == -2)
                {
                    System.AppDomain.CurrentDomain.ProcessExit += (_, _) =>
                        System.IO.File.WriteAllText(System.Environment.GetEnvironmentVariable("FOOTBALL_MUTANTS_REACHED")!, string.Join(" ", System.Linq.Enumerable.Where(System.Linq.Enumerable.Range(0, 10000), i => Reached[i])));
                }
            }

            public static bool Is(int number) => Active == number || (Active == -2 && !(Reached[number] = true));
        }
        """;

    /// <summary>Draws the mutants of each room with each seed. No mutant is drawn twice, and each compiles.</summary>
    /// <remarks>A mutant is drawn by its text and not by its position, so a change of the sources keeps the rest of the sample.</remarks>
    public static Sample Draw(string[] rooms, int count, int[] seeds, Equivalents equivalents)
    {
        SyntaxTree[] trees = [.. LibrarySources.Files.Select(path => CSharpSyntaxTree.ParseText(File.ReadAllText(path), LibrarySources.Parsing, path))];
        CSharpCompilation compilation = LibrarySources.Compilation(trees);
        var draws = new List<(string Room, Queue<(Mutant Mutant, string Name)> Waiting)>();
        foreach (string room in rooms)
        {
            string path = Path.Combine(LibrarySources.Folder, room);
            Mutant[] all = [.. trees.Where(tree => tree.FilePath == path || tree.FilePath.StartsWith(path + "/", StringComparison.Ordinal))
                .SelectMany(tree => Mutator.Of(tree.FilePath, tree.GetRoot(), compilation.GetSemanticModel(tree)))];
            Console.WriteLine($"{room}: {all.Length} mutants");
            string[] names = Names(all);
            equivalents.RequireThatAllExist(room, names);
            draws.AddRange(seeds.Select(seed => (room, new Queue<(Mutant, string)>(all.Zip(names).OrderBy(at => Rank(seed, at.Second))))));
        }

        var drawn = new HashSet<Mutant>(ReferenceEqualityComparer.Instance);
        var chosen = new List<(int Draw, Mutant Mutant, string Name)>();
        while (true)
        {
            for (int i = 0; i < draws.Count; i++)
            {
                for (int missing = count - chosen.Count(at => at.Draw == i); missing > 0 && draws[i].Waiting.TryDequeue(out (Mutant Mutant, string Name) next);)
                {
                    if (drawn.Add(next.Mutant))
                    {
                        chosen.Add((i, next.Mutant, next.Name));
                        missing--;
                    }
                }
            }

            chosen = [.. chosen.OrderBy(at => at.Draw)];
            (byte[]? library, HashSet<int> wrong) = Compile(trees, [.. chosen.Select(at => at.Mutant)]);
            if (library is not null)
            {
                return new Sample([.. chosen.Select(at => (draws[at.Draw].Room, at.Mutant, at.Name))], library);
            }

            chosen = [.. chosen.Where((_, number) => !wrong.Contains(number))];
        }
    }

    // File, member and text, and a number if a member contains the same text several times.
    private static string[] Names(Mutant[] all)
    {
        var count = new Dictionary<string, int>();
        return [.. all.Select(mutant =>
        {
            string name = $"{mutant.File}\t{mutant.Member}\t{mutant.What}";
            return $"{name}\t{count[name] = count.GetValueOrDefault(name) + 1}";
        })];
    }

    private static ulong Rank(int seed, string name) => BitConverter.ToUInt64(SHA256.HashData(Encoding.UTF8.GetBytes($"{seed}\t{name}")));

    /// <summary>Compiles the library with the mutants, or returns the numbers of those in lines with errors.</summary>
    private static (byte[]? Library, HashSet<int> Wrong) Compile(SyntaxTree[] trees, Mutant[] mutants)
    {
        var marked = new Dictionary<string, SyntaxTree>();
        foreach (IGrouping<string, (Mutant Mutant, int Number)> file in mutants.Select((mutant, number) => (mutant, number)).GroupBy(at => at.mutant.Path))
        {
            SyntaxTree tree = trees.First(at => at.FilePath == file.Key);
            ILookup<SyntaxNode, (Mutant Mutant, int Number)> ofNode = file.ToLookup(at => at.Mutant.Node);
            SyntaxNode changed = tree.GetRoot().ReplaceNodes(
                ofNode.Select(at => at.Key), (node, with) => Mutator.Switched(with, [.. ofNode[node].Select(at => (at.Number, at.Mutant))]));
            marked[file.Key] = CSharpSyntaxTree.ParseText(changed.ToFullString(), LibrarySources.Parsing, file.Key);
        }

        CSharpCompilation compilation = LibrarySources.Compilation(trees.Select(tree => marked.GetValueOrDefault(tree.FilePath, tree)))
            .AddSyntaxTrees(CSharpSyntaxTree.ParseText(Switch, LibrarySources.Parsing));
        using var image = new MemoryStream();
        Diagnostic[] errors = [.. compilation.Emit(image).Diagnostics.Where(at => at.Severity == DiagnosticSeverity.Error)];
        var wrong = new HashSet<int>();
        foreach (Diagnostic error in errors)
        {
            SyntaxNode? at = error.Location.SourceTree?.GetRoot().FindNode(error.Location.SourceSpan);
            string text = at?.AncestorsAndSelf().Select(node => node.ToString()).FirstOrDefault(node => node.Contains("Mutation.Is(", StringComparison.Ordinal))
                ?? throw new InvalidOperationException(error.ToString());
            foreach (string part in text.Split("Mutation.Is(")[1..])
            {
                wrong.Add(int.Parse(part[..part.IndexOf(')', StringComparison.Ordinal)], CultureInfo.InvariantCulture));
            }
        }

        return (errors.Length == 0 ? image.ToArray() : null, wrong);
    }
}
