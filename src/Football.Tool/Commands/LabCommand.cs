using System.CommandLine;
using System.Diagnostics;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Commands;

/// <summary>football lab: starts the laboratories of a checkout. They measure the library and are not part of the tool.</summary>
internal static class LabCommand
{
    private const string Project = "benchmarks/Football.Physics.Labs/Football.Physics.Labs.csproj";

    public static Command Create(Terminal terminal)
    {
        var command = new ExampleCommand(
            "lab", "Run accuracy and stability experiments (needs a checkout)", "football lab", "football lab vacuum --seed 7 --csv vacuum.csv");
        command.SetAction(_ => Start([command.Name], terminal));
        return command;
    }

    /// <summary>Runs the laboratories with the arguments, the input and the outputs of this command.</summary>
    /// <returns>The exit code of the laboratories.</returns>
    /// <exception cref="RefusedException">Neither the command nor the current folder is within a checkout.</exception>
    public static int Start(IEnumerable<string> args, Terminal terminal)
    {
        string project = Find(AppContext.BaseDirectory) ?? Find(Environment.CurrentDirectory) ?? throw new RefusedException(
            $"lab needs a checkout of the repository, and the current folder is not in one. Change to a checkout, or run there: dotnet run -c Release --project {Path.GetDirectoryName(Project)} -- …");
        terminal.Text.Flush();
        using Process laboratories = Process.Start(new ProcessStartInfo("dotnet", ["run", "-c", "Release", "--project", project, "--", .. args]))!;
        laboratories.WaitForExit();
        return laboratories.ExitCode;
    }

    private static string? Find(string folder)
    {
        for (DirectoryInfo? at = new(folder); at is not null; at = at.Parent)
        {
            string project = Path.Combine(at.FullName, Project);
            if (File.Exists(project))
            {
                return project;
            }
        }

        return null;
    }
}
