namespace FootballPhysics.Tests.Support;

/// <summary>Programs that some tests need and the .NET SDK does not bring. A test without its program is skipped, with the reason.</summary>
internal static class NeededPrograms
{
    private static readonly string[] s_suffixes = OperatingSystem.IsWindows() ? [".exe", ".cmd"] : [""];

    /// <summary>Returns the path of the first program of these names in PATH; null if there is none.</summary>
    public static string? Find(params ReadOnlySpan<string> names)
    {
        string[] folders = (Environment.GetEnvironmentVariable("PATH") ?? "").Split(Path.PathSeparator, StringSplitOptions.RemoveEmptyEntries);
        foreach (string name in names)
        {
            string? found = folders.SelectMany(folder => s_suffixes.Select(suffix => Path.Combine(folder, name + suffix))).FirstOrDefault(File.Exists);
            if (found is not null)
            {
                return found;
            }
        }

        return null;
    }

    /// <summary>Skips the test if the programs are missing.</summary>
    /// <param name="install">The command that installs them on Debian.</param>
    /// <param name="names">The programs.</param>
    public static void Need(string install, params ReadOnlySpan<string> names)
    {
        foreach (string name in names)
        {
            Assert.SkipWhen(Find(name) is null, $"{name} is not in PATH. Install it, on Debian: {install}");
        }
    }
}
