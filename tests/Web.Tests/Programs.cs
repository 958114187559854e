using System.Runtime.Loader;
using FootballPhysics.Package.Tests;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace FootballPhysics.Web.Tests;

/// <summary>Runs C# that somebody copied.</summary>
internal static class Programs
{
    private const string Usings = "global using System; global using System.Collections.Generic; global using System.IO; global using System.Linq;";

    /// <summary>Compiles a program against the library, as a new console project would, and returns what it prints.</summary>
    public static string Run(string code)
    {
        var compilation = CSharpCompilation.Create(
            "Copied" + Guid.NewGuid().ToString("N"),
            [CSharpSyntaxTree.ParseText(code), CSharpSyntaxTree.ParseText(Usings)],
            TrustedReferences.Where(file => TrustedReferences.IsOfRuntime(file) || file is "Football.Physics.dll"),
            new CSharpCompilationOptions(OutputKind.ConsoleApplication, nullableContextOptions: NullableContextOptions.Enable));
        using var bytes = new MemoryStream();
        var problems = compilation.Emit(bytes).Diagnostics.Where(found => found.Severity >= DiagnosticSeverity.Warning && found.Id != "CS1701").ToList();
        Assert.True(problems.Count == 0, string.Join('\n', problems) + "\n" + code);
        bytes.Position = 0;
        System.Reflection.MethodInfo main = new AssemblyLoadContext(null, isCollectible: true).LoadFromStream(bytes).EntryPoint!;
        TextWriter console = Console.Out;
        using var said = new StringWriter { NewLine = "\n" };
        try
        {
            Console.SetOut(said);
            main.Invoke(null, main.GetParameters().Length == 0 ? null : [Array.Empty<string>()]);
        }
        finally
        {
            Console.SetOut(console);
        }

        return said.ToString();
    }
}
