namespace FootballPhysics.Tool.Commands;

/// <summary>The exit codes of the process.</summary>
internal static class ExitCode
{
    public const int Done = 0;

    /// <summary>The input was rejected, or a case failed.</summary>
    public const int Refused = 1;

    /// <summary>Wrong usage.</summary>
    public const int Usage = 2;

    /// <summary>The reader closed the output; the shell reports this code for a program that SIGPIPE (13) ends.</summary>
    public const int OutputClosed = 128 + 13;
}
