using System.Diagnostics;
using System.Globalization;
using FootballPhysics;
using FootballPhysics.Mutants;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

// How many files of the library a reader passes who follows a step:
//   dotnet run -c Release --project tests/Passes [-- --list]
// Each method of the sources is compiled with a mark of its file, and each play is played twice: what only the first one passes is made at first use.
string library = LibrarySources.Folder;
string[] files = LibrarySources.Files;
string work = Path.Combine(LibrarySources.Root, "artifacts/passes");
if (Environment.GetEnvironmentVariable("FOOTBALL_MARKED") != "1")
{
    return Compile() ? Again() : 2;
}

Type marks = typeof(Simulator).Assembly.GetType("Passed")!;
bool[] passed = (bool[])marks.GetField("Files")!.GetValue(null)!;
bool lists = args.Contains("--list");

var onGround = new Vector3d(0, 0.11, 0);
Tell("flight", 0.5, simulator => simulator.Launch(new Vector3d(0, 2, 0), new Vector3d(20, 8, 3), new Vector3d(0, 40, -10)), new Scene());
Tell("roll", 0.5, simulator => simulator.Launch(onGround, new Vector3d(4, 0, 0), new Vector3d(0, 0, -4 / 0.11)), new Scene());
Tell("slide", 0.2, simulator => simulator.Launch(onGround, new Vector3d(12, 0, 0), new Vector3d(0, 0, 0)), new Scene());
Tell("a whole kick", 12, simulator => simulator.Launch(onGround, new Vector3d(20, 6, 3), new Vector3d(0, 40, -10)), new Scene());

// From the penalty spot of a standard pitch into a post, and into the net.
Vector3d spot = new(0, 0.11, (Pitch.Standard.Length / 2) - 11);
Tell("into a post", 1.2, simulator => simulator.Launch(spot, new Vector3d(8.2, 5.2, 24), default), Pitch.Standard.On());
Tell("into a net", 1.2, simulator => simulator.Launch(spot, new Vector3d(4, 5, 24), default), Pitch.Standard.On());
return 0;

// The step of a play that passes the most files.
void Tell(string what, double seconds, Func<Simulator, BallState> launch, Scene scene)
{
    var simulator = new Simulator(scene);
    string[] most = [];
    string met = "";
    Play();
    Play();
    Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{what,-14} {most.Length,3} files   {met}"));
    foreach (string name in lists ? most : [])
    {
        Console.WriteLine("    " + name);
    }

    void Play()
    {
        most = [];
        BallState ball = launch(simulator);
        var log = new StepLog();
        while (ball.Time < seconds && ball.Motion != MotionState.Stopped)
        {
            double from = ball.Time;
            log.Clear();
            Array.Clear(passed);
            simulator.Step(ref ball, 0.01, log);
            string[] names = Enumerable.Range(0, files.Length).Where(i => passed[i]).Select(i => Path.GetRelativePath(library, files[i])).ToArray();
            if (names.Length > most.Length)
            {
                most = names;
                met = string.Create(CultureInfo.InvariantCulture, $"step from {from:0.00} s")
                    + string.Concat(log.Events.Span.ToArray().Select(happened => $", {happened.Kind} {simulator.NameOf(happened.Thing)}".TrimEnd()));
            }
        }
    }
}

bool Compile()
{
    CSharpParseOptions parsing = LibrarySources.Parsing;
    var trees = files.Select((path, number) => CSharpSyntaxTree.ParseText(
        Marker.Marked(File.ReadAllText(path), CSharpSyntaxTree.ParseText(File.ReadAllText(path), parsing).GetRoot(), number), parsing, path)).ToList();
    trees.Add(CSharpSyntaxTree.ParseText($$"""
        public static class Passed { public static readonly bool[] Files = new bool[{{files.Length}}]; public static void At(int file) => Files[file] = true; }
        """, parsing));
    CSharpCompilation compilation = LibrarySources.Compilation(trees);
    if (Directory.Exists(work))
    {
        Directory.Delete(work, true);
    }

    Directory.CreateDirectory(work);
    foreach (string path in Directory.EnumerateFiles(AppContext.BaseDirectory))
    {
        File.Copy(path, Path.Combine(work, Path.GetFileName(path)));
    }

    using FileStream image = File.Create(Path.Combine(work, "Football.Physics.dll"));
    Diagnostic[] errors = compilation.Emit(image).Diagnostics.Where(at => at.Severity == DiagnosticSeverity.Error).ToArray();
    foreach (Diagnostic error in errors)
    {
        Console.Error.WriteLine(error);
    }

    return errors.Length == 0;
}

int Again()
{
    var start = new ProcessStartInfo(Path.Combine(work, "Passes"), args) { Environment = { ["FOOTBALL_MARKED"] = "1" } };
    using Process process = Process.Start(start)!;
    process.WaitForExit();
    return process.ExitCode;
}

/// <summary>Text of a file whose bodies begin with a mark: what stands between them, directives included, stays as it is.</summary>
internal static class Marker
{
    public static string Marked(string text, SyntaxNode root, int file)
    {
        string mark = $" global::Passed.At({file}); ";
        var changes = new List<(int From, int To, string With)>();
        foreach (SyntaxNode node in root.DescendantNodes())
        {
            switch (node)
            {
                case BaseMethodDeclarationSyntax { ExpressionBody: { } body } method:
                    Replace(body, method.SemicolonToken, method is not ConstructorDeclarationSyntax && (method as MethodDeclarationSyntax)?.ReturnType.ToString() != "void", "");
                    break;
                case BaseMethodDeclarationSyntax { Body: { } block }:
                    changes.Add((block.OpenBraceToken.Span.End, block.OpenBraceToken.Span.End, mark));
                    break;
                case AccessorDeclarationSyntax { ExpressionBody: { } body } accessor:
                    Replace(body, accessor.SemicolonToken, accessor.IsKind(SyntaxKind.GetAccessorDeclaration), "");
                    break;
                case AccessorDeclarationSyntax { Body: { } block }:
                    changes.Add((block.OpenBraceToken.Span.End, block.OpenBraceToken.Span.End, mark));
                    break;
                case PropertyDeclarationSyntax { ExpressionBody: { } body } property:
                    Replace(body, property.SemicolonToken, true, "get");
                    break;
                case IndexerDeclarationSyntax { ExpressionBody: { } body } indexer:
                    Replace(body, indexer.SemicolonToken, true, "get");
                    break;
            }
        }

        foreach ((int from, int to, string with) in changes.OrderByDescending(change => change.From))
        {
            text = text[..from] + with + text[to..];
        }

        return text;

        void Replace(ArrowExpressionClauseSyntax body, SyntaxToken end, bool returns, string accessor)
        {
            string block = $"{{{mark}{(returns && body.Expression is not ThrowExpressionSyntax ? "return " : "")}{body.Expression}; }}";
            changes.Add((body.SpanStart, end.Span.End, accessor == "" ? block : $"{{ {accessor} {block} }}"));
        }
    }
}
