using System.Diagnostics;
using System.Globalization;

namespace Football.Physics.Benchmarks;

/// <summary>The rows of benchmarks/mono.sh: the netstandard2.1 assembly on Mono, the runtime closest to Unity's.</summary>
internal static class MonoTable
{
    /// <summary>What the selection of rows knows it by.</summary>
    public const string Name = "Mono";

    /// <summary>Prints the section, or why there is none.</summary>
    public static void Print(Action<string> print, double share)
    {
        print("");
        print("## On Mono");
        print("");
        print("The netstandard2.1 assembly and `plain` on Mono, by `benchmarks/mono.sh`. Reach: ≤ 0.30 of plain there.");
        print("");
        foreach (string line in Run(share))
        {
            print(line);
        }
    }

    private static string[] Run(double seconds)
    {
        string? script = Script();
        if (OperatingSystem.IsWindows() || script is null)
        {
            return ["benchmarks/mono.sh is not here."];
        }

        var start = new ProcessStartInfo("bash") { RedirectStandardOutput = true, RedirectStandardError = true, UseShellExecute = false };
        start.ArgumentList.Add(script);
        start.ArgumentList.Add(seconds.ToString(CultureInfo.InvariantCulture));
        using Process process = Process.Start(start) ?? throw new InvalidOperationException("bash did not start.");
        Task<string> errors = process.StandardError.ReadToEndAsync();
        string output = process.StandardOutput.ReadToEnd().Trim();
        process.WaitForExit();
        return process.ExitCode == 0 ? output.Split('\n') : [$"benchmarks/mono.sh ended with {process.ExitCode}: {errors.Result.Trim().Split('\n')[0]}"];
    }

    private static string? Script()
    {
        for (DirectoryInfo? folder = new(AppContext.BaseDirectory); folder is not null; folder = folder.Parent)
        {
            string file = Path.Combine(folder.FullName, "benchmarks", "mono.sh");
            if (File.Exists(file))
            {
                return file;
            }
        }

        return null;
    }
}
