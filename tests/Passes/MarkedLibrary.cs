using System.Diagnostics;
using System.Text.Json;
using FootballPhysics.Mutants;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace FootballPhysics.Passes;

/// <summary>The library, compiled with a mark in each body, and a copy of this program that uses it.</summary>
internal static class MarkedLibrary
{
    private const string Variable = "FOOTBALL_MARKED";
    private static readonly string[] s_files = LibrarySources.Files;

    /// <summary>True in the copy of the program.</summary>
    public static bool IsUsed { get; } = Is("1");

    /// <summary>The folder of the copy and of its results.</summary>
    public static string Folder { get; } = Path.Combine(LibrarySources.Root, "artifacts/passes");

    /// <summary>The bodies. Only in the copy.</summary>
    public static Method[] Methods { get; } = IsUsed ? JsonSerializer.Deserialize<Method[]>(File.ReadAllText(Path.Combine(Folder, "methods.json")))! : [];

    /// <summary>How often each body ran. Only in the copy.</summary>
    public static int[] Passed { get; } = IsUsed ? (int[])Marks("Methods") : [];

    /// <summary>The calls, the changes of file and the changes of folder. Only in the copy.</summary>
    public static int[] Counts { get; } = IsUsed ? (int[])Marks("Counts") : [];

    /// <summary>Returns the path of a body's file in the library.</summary>
    public static string PathOf(Method method) => Path.GetRelativePath(LibrarySources.Folder, s_files[method.File]);

    /// <summary>Compiles the library with marks, and runs a copy of this program with it.</summary>
    /// <returns>The exit code of the copy.</returns>
    public static int Run(string[] arguments)
    {
        var found = new List<Method>();
        List<SyntaxTree> trees = Trees(found, (number, _) => $"global::Passed.At({number});");
        trees.Add(CSharpSyntaxTree.ParseText(TypeOfMarks(found), LibrarySources.Parsing));
        return Start(Folder, trees, "methods.json", JsonSerializer.Serialize(found), "1", arguments);
    }

    /// <summary>Compiles the library from marked sources into a folder, and runs a copy of this program there.</summary>
    /// <param name="folder">The folder of the copy.</param>
    /// <param name="trees">The marked sources.</param>
    /// <param name="file">The name of the file that lists the marks.</param>
    /// <param name="marks">The content of this file.</param>
    /// <param name="value">The value by which the copy recognises itself.</param>
    /// <param name="arguments">The arguments of the copy.</param>
    /// <returns>The exit code of the copy.</returns>
    public static int Start(string folder, IEnumerable<SyntaxTree> trees, string file, string marks, string value, string[] arguments)
    {
        if (Directory.Exists(folder))
        {
            Directory.Delete(folder, true);
        }

        Directory.CreateDirectory(folder);
        foreach (string path in Directory.EnumerateFiles(AppContext.BaseDirectory))
        {
            File.Copy(path, Path.Combine(folder, Path.GetFileName(path)));
        }

        File.WriteAllText(Path.Combine(folder, file), marks);
        File.WriteAllBytes(Path.Combine(folder, "Football.Physics.dll"), Compiled(trees));
        var start = new ProcessStartInfo(Path.Combine(folder, "Passes"), arguments) { Environment = { [Variable] = value } };
        using Process process = Process.Start(start)!;
        process.WaitForExit();
        return process.ExitCode;
    }

    /// <summary>True in a copy that was started with this value.</summary>
    public static bool Is(string value) => Environment.GetEnvironmentVariable(Variable) == value;

    /// <summary>Returns the sources with a statement in each body.</summary>
    /// <param name="found">Gets the bodies.</param>
    /// <param name="mark">Returns the statement for the number and the declaration of a body; empty for none.</param>
    public static List<SyntaxTree> Trees(List<Method> found, Func<int, SyntaxNode, string> mark) =>
        [.. s_files.Select((path, number) => CSharpSyntaxTree.ParseText(
            Marker.Marked(CSharpSyntaxTree.ParseText(File.ReadAllText(path), LibrarySources.Parsing).GetRoot(), number, found, mark), LibrarySources.Parsing, path))];

    /// <summary>Returns the bytes of the library.</summary>
    /// <exception cref="InvalidOperationException">The sources have errors.</exception>
    public static byte[] Compiled(IEnumerable<SyntaxTree> trees)
    {
        using var image = new MemoryStream();
        Diagnostic[] errors = [.. LibrarySources.Compilation(trees).Emit(image).Diagnostics.Where(at => at.Severity == DiagnosticSeverity.Error)];
        return errors.Length == 0 ? image.ToArray() : throw new InvalidOperationException(string.Join<Diagnostic>('\n', errors));
    }

    private static object Marks(string field) => typeof(Simulator).Assembly.GetType("Passed")!.GetField(field)!.GetValue(null)!;

    // Numerics and State do not count as folders.
    private static string TypeOfMarks(List<Method> found)
    {
        string[] folders = [.. s_files.Select(path => Path.GetRelativePath(LibrarySources.Folder, path).Split('/', '\\')[0])];
        string[] rooms = [.. folders.Distinct().Where(folder => folder is not ("Numerics" or "State"))];
        return $$"""
            public static class Passed
            {
                public static readonly int[] Methods = new int[{{found.Count}}];
                public static readonly int[] Counts = new int[3];
                private static readonly int[] FileOf = { {{string.Join(", ", found.Select(method => method.File))}} };
                private static readonly int[] FolderOf = { {{string.Join(", ", found.Select(method => Array.IndexOf(rooms, folders[method.File])))}} };
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
            """;
    }
}
