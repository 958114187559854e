using System.Diagnostics;
using System.Globalization;

namespace FootballPhysics.Benchmarks;

/// <summary>The rows from scripts: results of another runtime, or of a program compiled ahead of time.</summary>
internal static class ScriptTable
{
    /// <summary>The name of the Mono rows for the selection of rows.</summary>
    public const string MonoName = "Mono";
    public const string AheadOfTimeName = "Ahead of time";

    /// <summary>Prints the times of the netstandard2.1 assembly on Mono, the runtime closest to Unity's; or the reason for their absence.</summary>
    public static void Mono(Action<string> print, double share)
    {
        print("");
        print("## On Mono");
        print("");
        print("The netstandard2.1 assembly and `plain` on Mono, measured by `benchmarks/mono.sh`. Reach: ≤ 0.30 of `plain` there.");
        print("");
        Run(print, "mono.sh", share.ToString(CultureInfo.InvariantCulture));
    }

    /// <summary>Prints the first uses with the packages of a release.</summary>
    public static void FirstUse(Action<string> print)
    {
        print("");
        print($"## {FirstUseTable.Name}");
        print("");
        print("With packages as in a release, which contain code compiled ahead of time for .NET 8 and later on Windows and Linux (x64), measured by `benchmarks/firstuse.sh`.");
        Run(print, "firstuse.sh");
    }

    /// <summary>Prints the sizes of NativeAOT programs.</summary>
    public static void AheadOfTime(Action<string> print)
    {
        print("");
        print($"## {AheadOfTimeName}");
        print("");
        print("Programs with one ball, compiled with NativeAOT for speed, symbols stripped, measured by `benchmarks/aot.sh`. Before profiles, the library alone took 17.8 MB and 57 s.");
        print("");
        Run(print, "aot.sh");
    }

    private static void Run(Action<string> print, string name, params string[] arguments)
    {
        string? script = Script(name);
        if (OperatingSystem.IsWindows() || script is null)
        {
            print($"benchmarks/{name} is not here.");
            return;
        }

        var start = new ProcessStartInfo("bash") { RedirectStandardOutput = true, RedirectStandardError = true, UseShellExecute = false };
        start.ArgumentList.Add(script);
        foreach (string argument in arguments)
        {
            start.ArgumentList.Add(argument);
        }

        using Process process = Process.Start(start) ?? throw new InvalidOperationException("bash did not start.");
        Task<string> errors = process.StandardError.ReadToEndAsync();
        string output = process.StandardOutput.ReadToEnd().Trim();
        process.WaitForExit();
        foreach (string line in process.ExitCode == 0 ? output.Split('\n') : [$"benchmarks/{name} ended with {process.ExitCode}: {errors.Result.Trim().Split('\n')[0]}"])
        {
            print(line);
        }
    }

    private static string? Script(string name)
    {
        for (DirectoryInfo? folder = new(AppContext.BaseDirectory); folder is not null; folder = folder.Parent)
        {
            string file = Path.Combine(folder.FullName, "benchmarks", name);
            if (File.Exists(file))
            {
                return file;
            }
        }

        return null;
    }
}
