using System.Globalization;

namespace FootballPhysics.Tool.Commands;

/// <summary>The standard file descriptors that this process inherited.</summary>
internal static class Descriptor
{
    private const string Flags = "flags:";

    /// <summary>The flag O_CLOEXEC of Linux.</summary>
    private const long CloseOnExec = 0x80000;

    /// <summary>True if a standard descriptor was inherited from the parent process.</summary>
    /// <remarks>
    /// If a descriptor was closed at the start, the first file that the runtime opens takes its number. That file is an internal pipe: reading it
    /// would block forever, and writing to it would disturb the runtime. Files of the runtime have the flag close-on-exec, which an inherited
    /// descriptor cannot have. Without /proc, as outside Linux, every descriptor counts as inherited.
    /// </remarks>
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
            // This is not Linux: the console streams handle closed descriptors.
            return true;
        }
    }
}
