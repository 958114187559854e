using System.Reflection.PortableExecutable;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Architecture;

/// <summary>What a build is made from, and what it leaves behind.</summary>
public sealed class BuildTests
{
    [Fact]
    public void Every_project_has_a_lock_file()
    {
        foreach (string project in Directory.EnumerateFiles(RepositoryFiles.Root, "*.csproj", SearchOption.AllDirectories))
        {
            // The package's consumers restore what was packed a moment ago; an engine's project is restored by its editor.
            if (!project.Contains("/samples/Godot/", StringComparison.Ordinal) && !Path.GetFileName(project).StartsWith("Package.Consumer", StringComparison.Ordinal) && !Path.GetFileName(project).StartsWith("Package.Mono", StringComparison.Ordinal))
            {
                Assert.True(File.Exists(Path.Combine(Path.GetDirectoryName(project)!, "packages.lock.json")), project);
            }
        }
    }

    /// <summary>With the path of its symbols in it, the same source would give other bytes in another folder.</summary>
    [Fact]
    public void The_library_names_no_folder_of_the_machine_that_built_it()
    {
        using var reader = new PEReader(File.OpenRead(Path.Combine(AppContext.BaseDirectory, "Football.Physics.dll")));
        DebugDirectoryEntry symbols = reader.ReadDebugDirectory().First(entry => entry.Type == DebugDirectoryEntryType.CodeView);
        Assert.StartsWith("/_/", reader.ReadCodeViewDebugDirectoryData(symbols).Path);
        Assert.Contains(reader.ReadDebugDirectory(), entry => entry.Type == DebugDirectoryEntryType.Reproducible);
    }
}
