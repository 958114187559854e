namespace FootballPhysics.Tool.Commands;

/// <summary>What the process reports at its end.</summary>
internal static class ExitCode
{
    public const int Done = 0;

    /// <summary>The input was refused, or a case failed.</summary>
    public const int Refused = 1;

    /// <summary>Wrong usage.</summary>
    public const int Usage = 2;

    /// <summary>Whoever read the output closed it: what a program that SIGPIPE (13) ends is reported with.</summary>
    public const int OutputClosed = 128 + 13;
}
