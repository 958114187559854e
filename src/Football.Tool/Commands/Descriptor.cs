using System.Globalization;

namespace FootballPhysics.Tool.Commands;

/// <summary>The descriptors that this process was started with.</summary>
internal static class Descriptor
{
    private const string Flags = "flags:";

    /// <summary>O_CLOEXEC of Linux.</summary>
    private const long CloseOnExec = 0x80000;

    /// <summary>
    /// Whether a standard descriptor came from whoever started this process. One that was closed then is taken by the first file that the
    /// runtime opens for itself, a pipe on which nothing ever comes: to read it is to wait for ever, to write it is to talk to the runtime.
    /// What the runtime opens is closed on exec; what was inherited cannot be.
    /// </summary>
    public static bool IsInherited(int descriptor)
    {
        try
        {
            string? flags = File.ReadLines(string.Create(CultureInfo.InvariantCulture, $"/proc/self/fdinfo/{descriptor}"))
                .FirstOrDefault(line => line.StartsWith(Flags, StringComparison.Ordinal));
            return flags is null || (Convert.ToInt64(flags[Flags.Length..].Trim(), 8) & CloseOnExec) == 0;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or FormatException)
        {
            // No Linux: its own way decides.
            return true;
        }
    }
}
