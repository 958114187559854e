using System.Diagnostics;

namespace FootballPhysics.Tests.Support;

/// <summary>Runs a line of a shell that knows the command football, in a folder of its own.</summary>
internal sealed record Shell(int ExitCode, string Output, string Error)
{
    /// <summary>Long enough for every line here on a busy machine; what takes longer does not end.</summary>
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(3);

    /// <summary>The tool; with the laboratories in it, where the tests have them.</summary>
    private static string Command => File.Exists(Path.Combine(AppContext.BaseDirectory, "football-lab.dll")) ? "football-lab.dll" : "football.dll";

    public static async Task<Shell> RunAsync(string line)
    {
        NeededPrograms.Need("apt-get install bash", "bash");
        DirectoryInfo folder = Directory.CreateTempSubdirectory("football-shell-");
        try
        {
            var start = new ProcessStartInfo("bash")
            {
                WorkingDirectory = folder.FullName,
                RedirectStandardInput = true,
                RedirectStandardOutput = true,
                RedirectStandardError = true,
                ArgumentList = { "-c", $"football() {{ dotnet \"$FOOTBALL\" \"$@\"; }}; {line}" },
                Environment = { ["FOOTBALL"] = Path.Combine(AppContext.BaseDirectory, Command) },
            };
            using Process process = Process.Start(start)!;
            process.StandardInput.Close();
            Task<string> output = process.StandardOutput.ReadToEndAsync();
            Task<string> error = process.StandardError.ReadToEndAsync();
            using var patience = new CancellationTokenSource(Patience);
            try
            {
                await process.WaitForExitAsync(patience.Token);
            }
            catch (OperationCanceledException)
            {
                process.Kill(entireProcessTree: true);
                Assert.Fail($"{line} does not end");
            }

            return new Shell(process.ExitCode, await output, await error);
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }
}
