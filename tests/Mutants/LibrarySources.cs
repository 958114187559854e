using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace FootballPhysics.Mutants;

/// <summary>The sources of the library as the compiler for .NET 10 receives them. Use them to compile the library with changes.</summary>
internal static class LibrarySources
{
    /// <summary>The folder of the repository.</summary>
    public static string Root { get; } = FindRoot();

    /// <summary>The folder of the library.</summary>
    public static string Folder { get; } = Path.Combine(Root, "src/Football.Physics");

    /// <summary>The files of the library, with those of many balls and of engines, and the files that the build generates.</summary>
    public static string[] Files { get; } = new[] { Folder, Folder + ".Batch", Folder + ".Engines" }
        .SelectMany(folder => Directory.EnumerateFiles(folder, "*.cs", SearchOption.AllDirectories))
        .Where(path => !path.Contains("/bin/", StringComparison.Ordinal) && !path.Contains("/Polyfills/", StringComparison.Ordinal)
            && (!path.Contains("/obj/", StringComparison.Ordinal) || Path.GetDirectoryName(path) == Path.Combine(Folder, "obj/Release/net10.0")))
        .Order(StringComparer.Ordinal)
        .ToArray();

    /// <summary>The language version and the symbols.</summary>
    public static CSharpParseOptions Parsing { get; } = new CSharpParseOptions(LanguageVersion.CSharp13).WithPreprocessorSymbols(
        "NET", "NET5_0_OR_GREATER", "NET6_0_OR_GREATER", "NET7_0_OR_GREATER", "NET8_0_OR_GREATER", "NET9_0_OR_GREATER", "NET10_0", "NET10_0_OR_GREATER",
        "NETCOREAPP", "NETCOREAPP3_0_OR_GREATER", "NETCOREAPP3_1_OR_GREATER", "RELEASE");

    /// <summary>Returns a compilation of the library from syntax trees.</summary>
    public static CSharpCompilation Compilation(IEnumerable<SyntaxTree> trees) => CSharpCompilation.Create(
        "Football.Physics",
        trees,
        ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!).Split(':')
            .Where(path => Path.GetFileName(path).StartsWith("System.", StringComparison.Ordinal) && !path.Contains("CodeAnalysis", StringComparison.Ordinal))
            .Select(path => MetadataReference.CreateFromFile(path)),
        new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, optimizationLevel: OptimizationLevel.Release, allowUnsafe: true, nullableContextOptions: NullableContextOptions.Enable));

    private static string FindRoot()
    {
        string root = AppContext.BaseDirectory;
        while (!File.Exists(Path.Combine(root, "Football.Physics.sln")))
        {
            root = Path.GetDirectoryName(root) ?? throw new InvalidOperationException("There is no Football.Physics.sln above the program.");
        }

        return root;
    }
}
