using System.Diagnostics;
using System.Reflection;
using System.Runtime.Loader;
using System.Text.RegularExpressions;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Laws;

/// <summary>
/// A copy of the library whose drag law has another exponent, changed in one place: every kernel follows, and what compares them with the
/// laws holds as before.
/// </summary>
public sealed class ChangedLawTests : IDisposable
{
    private const string Law = "src/Football.Physics/Laws/Forces/FittedDrag.cs";
    private const string Published = "public const double D = 0.3056;";
    private const string Changed = "public const double D = 0.31;";
    private const string Tests = "tests/Football.Physics.Tests";

    private readonly string _copy = Directory.CreateTempSubdirectory("football").FullName;

    [Fact]
    public void An_exponent_stands_once_and_every_kernel_follows_it()
    {
        CopySources();
        Assert.Equal(1, Occurrences("0.3056"));
        Write(Law, Read(Law).Replace(Published, Changed, StringComparison.Ordinal));
        Assert.Equal(0, Occurrences("0.3056"));

        Run("build", Tests, "-c", "Release", "-m:1", "-p:RunAnalyzers=false", "-p:GenerateDocumentationFile=false", "-p:NuGetAudit=false", "-p:RestoreSources=" + Path.Combine(_copy, Tests));
        string assembly = Path.Combine(_copy, Tests, "bin/Release/net10.0/Football.Physics.Tests.dll");
        string said = Run("exec", assembly, "-noLogo", "-trait-", "Constants=Published");
        Assert.Matches("Total: [1-9][0-9]+,", said);

        // By every kernel this shot lands elsewhere now: by one and the same law, so by the same distance but for the rounding of floats.
        double[] before = [.. FlightEnds.All()];
        double[] after = EndsOf(assembly);
        double[] moved = [.. before.Zip(after, (was, now) => now - was)];
        for (int i = 0; i < moved.Length; i++)
        {
            Assert.InRange(Math.Abs(moved[i]), 1e-3, 1);
            Assert.Equal(moved[i % 2], moved[i], 1e-4);
        }
    }

    public void Dispose()
    {
        try
        {
            Directory.Delete(_copy, recursive: true);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // Where a loaded assembly cannot be deleted, the system's own cleaning does it.
        }
    }

    /// <summary>The library, and the tests that compare its laws, for this runtime alone.</summary>
    private void CopySources()
    {
        foreach (string file in (string[])["Directory.Build.props", "Directory.Build.targets", "Directory.Packages.props", "global.json", "BannedSymbols.txt"])
        {
            Write(file, Regex.Replace(RepositoryFiles.Text(file), "<Using Include=\"FootballPhysics.(Thesis|Tracks)\" />", ""));
        }

        string[] sources =
        [
            .. Files("src/Football.Physics"), .. Files("src/Football.Physics.Batch"), .. Files("src/Packaging"), .. Files("benchmarks/Football.Physics.Yardsticks"), .. Files(Tests + "/Laws"), .. Files(Tests + "/Support"),
            Tests + "/Batch/BatchScenes.cs", Tests + "/Batch/LaneLawTests.cs", Tests + "/Batch/LaneLawPointTests.cs",
        ];
        foreach (string file in sources.Where(file => Path.GetFileNameWithoutExtension(file) != nameof(ChangedLawTests)))
        {
            Write(file, RepositoryFiles.Text(file));
        }

        foreach (string file in (string[])["src/Football.Physics/Football.Physics.csproj", "src/Packaging/Package.props", "src/Packaging/Package.targets"])
        {
            Write(file, Regex.Replace(RepositoryFiles.Text(file), "<Import Project=\"[^/\"]*\" />", "").Replace(
                "<TargetFrameworks>netstandard2.1;net8.0;net10.0</TargetFrameworks>", "<TargetFramework>net10.0</TargetFramework>", StringComparison.Ordinal));
        }

        const string Project = Tests + "/Football.Physics.Tests.csproj";
        const string Yardsticks = "<ProjectReference Include=\"../../benchmarks/Football.Physics.Yardsticks/Football.Physics.Yardsticks.csproj\" />";
        const string Compiled = "<Compile Include=\"../../benchmarks/Football.Physics.Yardsticks/Plain/FittedLaws.cs;../../benchmarks/Football.Physics.Yardsticks/Shots/SeededRandom.cs\" />";
        Write(Project, string.Join('\n', RepositoryFiles.Text(Project).Split('\n').Where(line => !Regex.IsMatch(line, @"Football\.(Scenarios|Physics\.(Engines|Thesis|Tracks)/)")))
            .Replace(Yardsticks, Compiled, StringComparison.Ordinal));
    }

    private static IEnumerable<string> Files(string folder) =>
        from file in Directory.EnumerateFiles(Path.Combine(RepositoryFiles.Root, folder), "*.cs", SearchOption.AllDirectories)
        let path = Path.GetRelativePath(RepositoryFiles.Root, file).Replace('\\', '/')
        where !path.StartsWith(folder + "/obj/", StringComparison.Ordinal) && !path.StartsWith(folder + "/bin/", StringComparison.Ordinal)
        select path;

    private int Occurrences(string number) =>
        Directory.EnumerateFiles(Path.Combine(_copy, "src"), "*.cs", SearchOption.AllDirectories)
            .Sum(file => File.ReadAllText(file).Split(number).Length - 1);

    private string Read(string path) => File.ReadAllText(Path.Combine(_copy, path));

    private void Write(string path, string text)
    {
        string full = Path.Combine(_copy, path);
        Directory.CreateDirectory(Path.GetDirectoryName(full)!);
        File.WriteAllText(full, text);
    }

    /// <summary>What a command prints; it must end well.</summary>
    private string Run(params string[] arguments)
    {
        var start = new ProcessStartInfo("dotnet", arguments) { WorkingDirectory = _copy, RedirectStandardOutput = true };
        start.Environment["MSBUILDDISABLENODEREUSE"] = "1";
        start.Environment["UseSharedCompilation"] = "false";
        using Process process = Process.Start(start)!;
        string said = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        Assert.True(process.ExitCode == 0, $"dotnet {string.Join(' ', arguments)} ended with {process.ExitCode}:\n{said}");
        return said;
    }

    /// <summary><see cref="FlightEnds"/> as the copy has them.</summary>
    private static double[] EndsOf(string assembly)
    {
        var copy = new CopyContext(assembly);
        try
        {
            MethodInfo all = copy.LoadFromAssemblyPath(assembly).GetType(typeof(FlightEnds).FullName!)!.GetMethod(nameof(FlightEnds.All))!;
            return [.. (IEnumerable<double>)all.Invoke(null, null)!];
        }
        finally
        {
            copy.Unload();
        }
    }

    /// <summary>Loads the copy's library, and its batches, where this process has its own already.</summary>
    private sealed class CopyContext(string assembly) : AssemblyLoadContext("changed law", isCollectible: true)
    {
        private readonly string _folder = Path.GetDirectoryName(assembly)!;

        protected override Assembly? Load(AssemblyName assemblyName) =>
            assemblyName.Name == typeof(Scene).Assembly.GetName().Name ? LoadFromAssemblyPath(Path.Combine(_folder, assemblyName.Name + ".dll")) : null;
    }
}
