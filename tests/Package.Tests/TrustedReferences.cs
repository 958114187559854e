using Microsoft.CodeAnalysis;

namespace FootballPhysics.Package.Tests;

/// <summary>The assemblies beside a test project and those of the runtime, as references of a compilation. The compiler reads an assembly once per reference, so all compilations share them.</summary>
internal static class TrustedReferences
{
    private static readonly (string File, MetadataReference Reference)[] s_all =
    [
        .. ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!).Split(Path.PathSeparator)
            .Select(path => (Path.GetFileName(path), (MetadataReference)MetadataReference.CreateFromFile(path))),
    ];

    /// <summary>Those whose file has a name that is wanted.</summary>
    public static IEnumerable<MetadataReference> Where(Func<string, bool> isWanted) => s_all.Where(item => isWanted(item.File)).Select(item => item.Reference);

    /// <summary>True for the runtime's assemblies that a new console project refers to.</summary>
    public static bool IsOfRuntime(string file) => file.StartsWith("System.", StringComparison.Ordinal) || file is "netstandard.dll" or "mscorlib.dll";
}
