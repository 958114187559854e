using System.Diagnostics;
using System.Globalization;
using FootballPhysics.Mutants;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

// A score of mutation for a room of the library, by a sample drawn with a seed:
//   dotnet run -c Release --project tests/Mutants -- ROOM [COUNT] [SEED]
// ROOM may be a file of one, too: Contacts/BroadPhase.cs. Needs the tests to be built: dotnet build -c Release tests/Football.Physics.Tests and tests/Package.Tests.
// All mutants of the sample are compiled into one library, each behind a switch, and the tests of behaviour are played once for each that any of them reaches, up to
// the first that fails. What they let live is held to the golden bits, which see more but say nothing of right and wrong: counted by themselves. Exit code 1 where the score, golden bits included, is below 85 %.
if (args.Length is 0 or > 3)
{
    Console.Error.WriteLine("Usage: Mutants ROOM [COUNT, 40] [SEED, 1]");
    return 2;
}

string root = LibrarySources.Root;
string library = LibrarySources.Folder;
string room = Path.Combine(library, args[0]);
if (!Directory.Exists(room) && !File.Exists(room))
{
    Console.Error.WriteLine($"There is no room {args[0]} in {library}.");
    return 2;
}

// Quick tests, whose numbers are closed forms, reference cases or symmetries.
string[] things = ["Things.EdgeTests", "Things.BodyTests", "Things.SurfacePatternTests", "Things.GoalTests", "Reference.AmongReferenceTests", "Things.WorldReferenceTests"];
string[] tests = args[0].Split('/')[0] switch
{
    "Contacts" => ["Things.ImpactLawTests", "Things.SurfaceNumbersTests", "Things.BoundsTreeTests", "Things.EngineColliderTests", "Things.ContactSetTests", "Things.ContactSolverTests", "Things.ContactNewtonTests", "Things.ContactSearchTests",
        "Things.NearContactTests", "Things.NetSheetTests", "Motion.DefaultGroundTests",
        "Motion.MeasuredImpactTests", "Motion.SlipDecayTests", "Motion.RollTests", "Motion.SlideTests", .. things],
    "Laws" => ["Laws.AirContractTests", "Laws.AirLawTests", "Laws.AirRatesTests", "Laws.DragJumpTests", "Laws.KnuckleForceTests", "Laws.MeasuredLawTests", "Laws.ScaledAirTests", "Laws.TableLawTests", "Laws.TableRangeTests",
        "Motion.WindFieldTests", "Scenes.WindTests", "Motion.SpinDecayTests", "Motion.CustomForceTests", "Reference.MeasuredReferenceTests", "Reference.ReferenceTests"],
    "Simulation" => ["Several.*", "Things.WorldContactTests", "Things.BodyTubeTests", "Motion.*", "Things.WorldOrderTests", "Things.ContactSetTests", "Reference.MeasuredRunTests", "Reference.ReferenceTests", .. things],
    _ => [args[0] + ".*"],
};

// What those do not see all tests of behaviour are asked for, which takes a minute or two.
string[] others = ["Things.*", "Motion.*", "Reference.*", "Several.*", "Symmetry.*", "Scenes.*", "Stability.*", "Accuracy.*", "Queries.*", "Game.*", "Predictors.*", "Api.*"];
int count = args.Length > 1 ? int.Parse(args[1], CultureInfo.InvariantCulture) : 40;
int seed = args.Length > 2 ? int.Parse(args[2], CultureInfo.InvariantCulture) : 1;

// The sources as they are, and all that can be got wrong in them.
CSharpParseOptions parsing = LibrarySources.Parsing;
SyntaxTree[] trees = LibrarySources.Files.Select(path => CSharpSyntaxTree.ParseText(File.ReadAllText(path), parsing, path)).ToArray();
string built = Path.Combine(root, "tests/Football.Physics.Tests/bin/Release/net10.0");
CSharpCompilation compilation = LibrarySources.Compilation(trees);
SyntaxTree[] mutated = trees.Where(tree => tree.FilePath == room || tree.FilePath.StartsWith(room + "/", StringComparison.Ordinal)).ToArray();
Mutant[] all = mutated.SelectMany(tree => Mutator.Of(tree.FilePath, tree.GetRoot(), compilation.GetSemanticModel(tree))).ToArray();

// A sample of those that compile, in an order that the seed gives.
var random = new Random(seed);
random.Shuffle(all);
string work = Path.Combine(root, "artifacts/mutants", args[0].Replace('/', '-'));
if (Directory.Exists(work))
{
    Directory.Delete(work, true);
}

Directory.CreateDirectory(work);
List<Mutant> sample = Compile(Path.Combine(work, "tests"), out int refused);
CopyAll(Path.Combine(root, "tests/Package.Tests/bin/Release/net10.0"), Path.Combine(work, "golden"));
File.Copy(Path.Combine(work, "tests/Football.Physics.dll"), Path.Combine(work, "golden/Football.Physics.dll"), true);
Console.WriteLine($"{args[0]}: {all.Length} mutants, of which {sample.Count} are played (seed {seed}; {refused} of those drawn do not compile)");

// Unchanged, with what each reaches; then each that is reached.
var clock = Stopwatch.StartNew();
string reachedIn = Path.Combine(work, "reached");
if (Play(-2, [.. tests, .. others], TimeSpan.FromMinutes(20)) != 0 || Golden(-1) != 0)
{
    Console.Error.WriteLine("Without any mistake tests fail.");
    return 2;
}

TimeSpan longest = (4 * clock.Elapsed) + TimeSpan.FromSeconds(20);
HashSet<int> reached = File.ReadAllText(reachedIn).Split(' ', StringSplitOptions.RemoveEmptyEntries).Select(text => int.Parse(text, CultureInfo.InvariantCulture)).ToHashSet();
int killed = 0;
int moved = 0;
Parallel.For(0, sample.Count, new ParallelOptions { MaxDegreeOfParallelism = Environment.ProcessorCount }, i =>
{
    string end = reached.Contains(i) && (Play(i, tests, longest) is not 0 || Play(i, others, longest) is not 0) ? "killed"
        : Golden(i) is not 0 ? "GOLDEN"
        : reached.Contains(i) ? "SURVIVED" : "NOT REACHED";
    string what = string.Join(' ', sample[i].What.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries));
    Interlocked.Add(ref killed, end == "killed" ? 1 : 0);
    Interlocked.Add(ref moved, end == "GOLDEN" ? 1 : 0);
    Console.WriteLine($"{end,-11} {Path.GetRelativePath(library, sample[i].Path)}:{sample[i].Line} {(what.Length > 150 ? what[..150] + " …" : what)}");
});

Tell("killed by tests of behaviour", killed);
Tell("killed by those or golden bits", killed + moved);
Directory.Delete(work, true);
return killed + moved >= 0.85 * sample.Count ? 0 : 1;

// Wilson's interval, 95 %.
void Tell(string how, int many)
{
    double n = sample.Count;
    double share = many / n;
    const double Z = 1.96;
    double middle = (share + (Z * Z / (2 * n))) / (1 + (Z * Z / n));
    double half = Z / (1 + (Z * Z / n)) * Math.Sqrt((share * (1 - share) / n) + (Z * Z / (4 * n * n)));
    Console.WriteLine(string.Create(CultureInfo.InvariantCulture,
        $"{args[0]}: {many} of {sample.Count} {how}, {100 * share:0} % ({100 * (middle - half):0} to {100 * (middle + half):0} % with 95 % confidence)"));
}

// The library with the first mutants of the order that compile, beside the tests.
List<Mutant> Compile(string folder, out int refused)
{
    CopyAll(built, folder);
    var chosen = new List<Mutant>(all.Take(count));
    int next = chosen.Count;
    refused = 0;
    while (true)
    {
        var numbers = chosen.Select((mutant, number) => (mutant, number)).ToLookup(at => at.mutant.Path);
        var marked = new Dictionary<string, SyntaxTree>();
        foreach (IGrouping<string, (Mutant Mutant, int Number)> file in numbers)
        {
            SyntaxTree tree = trees.First(at => at.FilePath == file.Key);
            ILookup<SyntaxNode, (Mutant Mutant, int Number)> ofNode = file.ToLookup(at => at.Mutant.Node);
            SyntaxNode changed = tree.GetRoot().ReplaceNodes(
                ofNode.Select(at => at.Key), (node, with) => Mutator.Switched(with, ofNode[node].Select(at => (at.Number, at.Mutant)).ToArray()));
            marked[file.Key] = CSharpSyntaxTree.ParseText(changed.ToFullString(), parsing, file.Key);
        }

        CSharpCompilation with = LibrarySources.Compilation(trees.Select(tree => marked.GetValueOrDefault(tree.FilePath, tree)))
            .AddSyntaxTrees(CSharpSyntaxTree.ParseText(Switch, parsing));
        using var image = new MemoryStream();
        Diagnostic[] errors = with.Emit(image).Diagnostics.Where(at => at.Severity == DiagnosticSeverity.Error).ToArray();
        if (errors.Length == 0)
        {
            File.WriteAllBytes(Path.Combine(folder, "Football.Physics.dll"), image.ToArray());
            return chosen;
        }

        // Each error takes the mutants of its line away, and others of the order come instead.
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

        refused += wrong.Count;
        chosen = [.. chosen.Where((_, number) => !wrong.Contains(number)), .. all.Skip(next).Take(wrong.Count)];
        next += wrong.Count;
    }
}

// Plays tests: 0 where all pass; null where they do not end.
int? Play(int mutant, string[] chosen, TimeSpan limit) => Run("tests/Football.Physics.Tests", mutant, limit, chosen.Select(name => "Football.Physics.Tests." + name));

int? Golden(int mutant) => Run("golden/Package.Tests", mutant, TimeSpan.FromMinutes(2), ["FootballPhysics.Package.Tests.GoldenTests"]);

int? Run(string program, int mutant, TimeSpan limit, IEnumerable<string> classes)
{
    string path = Path.Combine(work, program);
    var start = new ProcessStartInfo(path)
    {
        WorkingDirectory = Path.GetDirectoryName(path),
        RedirectStandardOutput = true,
        RedirectStandardError = true,
        Environment = { ["FOOTBALL_MUTANT"] = mutant.ToString(CultureInfo.InvariantCulture), ["FOOTBALL_MUTANTS_REACHED"] = reachedIn },
    };
    foreach (string argument in (string[])["-maxThreads", "1", "-noColor", "-stopOnFail", .. classes.SelectMany(name => (string[])["-class", name])])
    {
        start.ArgumentList.Add(argument);
    }

    using Process process = Process.Start(start)!;
    process.OutputDataReceived += (_, line) => Report(line.Data);
    process.ErrorDataReceived += (_, _) => { };
    process.BeginOutputReadLine();
    process.BeginErrorReadLine();
    if (!process.WaitForExit(limit))
    {
        process.Kill(true);
        return null;
    }

    return process.ExitCode;

    void Report(string? line)
    {
        if (mutant < 0 && line is not null && line.Contains("[FAIL]", StringComparison.Ordinal))
        {
            Console.Error.WriteLine(line);
        }
    }
}

static void CopyAll(string from, string to)
{
    foreach (string path in Directory.EnumerateFiles(from, "*", SearchOption.AllDirectories))
    {
        string at = Path.Combine(to, Path.GetRelativePath(from, path));
        Directory.CreateDirectory(Path.GetDirectoryName(at)!);
        File.Copy(path, at);
    }
}

internal static partial class Program
{
    // Read once, so that a compiled switch costs nothing.
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
}
