using System.Diagnostics;
using System.Globalization;
using System.Text.Json;
using FootballPhysics;
using FootballPhysics.Mutants;
using FootballPhysics.Tests.Architecture;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

// Counts the code of the library that runs in a step: files, methods, lines of these methods, calls, and changes of file and folder.
//   dotnet run -c Release --project tests/Passes [-- --list|--methods|--sizes]
// --list prints the files of a step. --methods prints its methods, each with its lines and its calls.
// --sizes prints the working lines of each folder and the counts that tests/ceilings.tsv limits; nothing else runs.
// Each method of the sources is compiled with a mark, and each play is played twice: code that runs only in the first one initialises something.
// Numerics and State do not count as folders.
if (args.Contains("--sizes"))
{
    Console.WriteLine(CodeSize.Of(Path.Combine(LibrarySources.Root, "src")));
    return 0;
}

string library = LibrarySources.Folder;
string[] files = LibrarySources.Files;
string work = Path.Combine(LibrarySources.Root, "artifacts/passes");
if (Environment.GetEnvironmentVariable("FOOTBALL_MARKED") != "1")
{
    return Compile() ? Again() : 2;
}

Type marks = typeof(Simulator).Assembly.GetType("Passed")!;
var passed = (int[])marks.GetField("Methods")!.GetValue(null)!;
var counts = (int[])marks.GetField("Counts")!.GetValue(null)!;
Method[] methods = JsonSerializer.Deserialize<Method[]>(File.ReadAllText(Path.Combine(work, "methods.json")))!;
bool lists = args.Contains("--list");
bool namesMethods = args.Contains("--methods");

var onGround = new Vector3d(0, 0.11, 0);
Tell("flight", 0.5, simulator => simulator.Launch(new Vector3d(0, 2, 0), new Vector3d(20, 8, 3), new Vector3d(0, 40, -10)), new Scene());
Tell("roll", 0.5, simulator => simulator.Launch(onGround, new Vector3d(4, 0, 0), new Vector3d(0, 0, -4 / 0.11)), new Scene());
Tell("slide", 0.2, simulator => simulator.Launch(onGround, new Vector3d(12, 0, 0), new Vector3d(0, 0, 0)), new Scene());
Tell("bounce", 1.2, simulator => simulator.Launch(new Vector3d(0, 0.6, 0), new Vector3d(14, -3, 1), default), new Scene());
Tell("a whole kick", 12, simulator => simulator.Launch(onGround, new Vector3d(20, 6, 3), new Vector3d(0, 40, -10)), new Scene());

// From the penalty spot of a standard pitch into a post, and into the net.
Vector3d spot = new(0, 0.11, (Pitch.Standard.Length / 2) - 11);
Tell("into a post", 1.2, simulator => simulator.Launch(spot, new Vector3d(8.2, 5.2, 24), default), Pitch.Standard.On());
Tell("into a net", 1.2, simulator => simulator.Launch(spot, new Vector3d(4, 5, 24), default), Pitch.Standard.On());
return 0;

// The step of a play that runs the most lines.
void Tell(string what, double seconds, Func<Simulator, BallState> launch, Scene scene)
{
    var simulator = new Simulator(scene);
    string[] most = [];
    string[] calls = [];
    int lines = 0;
    string counted = "";
    string met = "";
    Play();
    Play();
    Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{what,-14} {most.Length,3} files, {counted}   {met}"));
    foreach (string name in namesMethods ? calls : lists ? most : [])
    {
        Console.WriteLine("    " + name);
    }

    void Play()
    {
        lines = 0;
        BallState ball = launch(simulator);
        var log = new StepLog();
        while (ball.Time < seconds && ball.Motion != MotionState.Rest)
        {
            double from = ball.Time;
            log.Clear();
            Array.Clear(passed);
            Array.Clear(counts);
            simulator.Step(ref ball, 0.01, log);
            Method[] ran = Enumerable.Range(0, methods.Length).Where(i => passed[i] > 0).Select(i => methods[i]).ToArray();
            if (ran.Sum(method => method.Lines) > lines)
            {
                lines = ran.Sum(method => method.Lines);
                most = ran.Select(method => Path.GetRelativePath(library, files[method.File])).Distinct().Order(StringComparer.Ordinal).ToArray();
                calls = Enumerable.Range(0, methods.Length).Where(i => passed[i] > 0).Select(i => $"{Path.GetRelativePath(library, files[methods[i].File])} {methods[i].Name}: {methods[i].Lines} lines, {passed[i]} calls").ToArray();
                counted = string.Create(CultureInfo.InvariantCulture, $"{ran.Length,3} methods, {lines,4} lines, {counts[0],6} calls, {counts[1],5} changes of file, {counts[2],4} of folder");
                met = string.Create(CultureInfo.InvariantCulture, $"step from {from:0.00} s")
                    + string.Concat(log.Events.Span.ToArray().Select(happened => $", {happened.Kind} {simulator.NameOf(happened.ColliderIndex)}".TrimEnd()));
            }
        }
    }
}

bool Compile()
{
    CSharpParseOptions parsing = LibrarySources.Parsing;
    var found = new List<Method>();
    var trees = files.Select((path, number) => CSharpSyntaxTree.ParseText(
        Marker.Marked(File.ReadAllText(path), CSharpSyntaxTree.ParseText(File.ReadAllText(path), parsing).GetRoot(), number, found), parsing, path)).ToList();
    string[] folders = files.Select(path => Path.GetRelativePath(library, path).Split('/', '\\')[0]).ToArray();
    string[] rooms = folders.Distinct().Where(folder => folder is not ("Numerics" or "State")).ToArray();
    string fileOf = string.Join(", ", found.Select(method => method.File));
    string folderOf = string.Join(", ", found.Select(method => Array.IndexOf(rooms, folders[method.File])));
    trees.Add(CSharpSyntaxTree.ParseText($$"""
        public static class Passed
        {
            public static readonly int[] Methods = new int[{{found.Count}}];
            public static readonly int[] Counts = new int[3];
            private static readonly int[] FileOf = { {{fileOf}} };
            private static readonly int[] FolderOf = { {{folderOf}} };
            private static int file;
            private static int folder;

            public static void At(int method)
            {
                Methods[method]++;
                Counts[0]++;
                Counts[1] += FileOf[method] != file ? 1 : 0;
                Counts[2] += FolderOf[method] >= 0 && FolderOf[method] != folder ? 1 : 0;
                file = FileOf[method];
                folder = FolderOf[method] >= 0 ? FolderOf[method] : folder;
            }
        }
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

    File.WriteAllText(Path.Combine(work, "methods.json"), JsonSerializer.Serialize(found));
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

/// <summary>A method, by the index of its file, its number of lines and its name.</summary>
internal sealed record Method(int File, int Lines, string Name);

/// <summary>Inserts a mark at the start of each body. The rest of the text, with its directives, stays.</summary>
internal static class Marker
{
    /// <summary>Returns the name of the type and of the method, property or operator.</summary>
    private static string NameOf(SyntaxNode node)
    {
        string type = node.FirstAncestorOrSelf<TypeDeclarationSyntax>()!.Identifier.Text;
        SyntaxNode member = node is AccessorDeclarationSyntax ? node.Parent!.Parent! : node;
        string name = member switch
        {
            MethodDeclarationSyntax method => method.Identifier.Text,
            PropertyDeclarationSyntax property => property.Identifier.Text,
            ConstructorDeclarationSyntax => "new",
            OperatorDeclarationSyntax operation => operation.OperatorToken.Text,
            _ => member.Kind().ToString(),
        };
        return $"{type}.{name}";
    }

    public static string Marked(string text, SyntaxNode root, int file, List<Method> methods)
    {
        var changes = new List<(int From, int To, string With)>();
        foreach (SyntaxNode node in root.DescendantNodes())
        {
            string mark = $" global::Passed.At({methods.Count}); ";
            int marked = changes.Count;
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

            if (changes.Count > marked)
            {
                FileLinePositionSpan span = node.SyntaxTree.GetLineSpan(node.Span);
                methods.Add(new Method(file, span.EndLinePosition.Line - span.StartLinePosition.Line + 1, NameOf(node)));
            }

            void Replace(ArrowExpressionClauseSyntax body, SyntaxToken end, bool returns, string accessor)
            {
                string block = $"{{{mark}{(returns && body.Expression is not ThrowExpressionSyntax ? "return " : "")}{body.Expression}; }}";
                changes.Add((body.SpanStart, end.Span.End, accessor == "" ? block : $"{{ {accessor} {block} }}"));
            }
        }

        foreach ((int from, int to, string with) in changes.OrderByDescending(change => change.From))
        {
            text = text[..from] + with + text[to..];
        }

        return text;
    }
}
