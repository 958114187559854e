using System.Diagnostics;
using System.Globalization;

namespace FootballPhysics.Benchmarks;

/// <summary>The rows of scripts: what another runtime, or a program compiled ahead of time, has to say.</summary>
internal static class ScriptTable
{
    /// <summary>What the selection of rows knows them by.</summary>
    public const string MonoName = "Mono";
    public const string AheadOfTimeName = "Ahead of time";

    /// <summary>The netstandard2.1 assembly on Mono, the runtime closest to Unity's; or why there is none.</summary>
    public static void Mono(Action<string> print, double share)
    {
        print("");
        print("## On Mono");
        print("");
        print("The netstandard2.1 assembly and `plain` on Mono, measured by `benchmarks/mono.sh`. Reach: ≤ 0.30 of `plain` there.");
        print("");
        Run(print, "mono.sh", share.ToString(CultureInfo.InvariantCulture));
    }

    /// <summary>Sizes of NativeAOT programs.</summary>
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
