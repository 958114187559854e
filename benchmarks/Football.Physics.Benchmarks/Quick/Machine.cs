using System.Runtime.InteropServices;

namespace FootballPhysics.Benchmarks;

/// <summary>The machine of the measurement.</summary>
internal static class Machine
{
    private const string Info = "/proc/cpuinfo";

    /// <summary>The name of the processor, or its architecture if the system does not report the name.</summary>
    public static string Processor { get; } =
        (File.Exists(Info) ? File.ReadLines(Info).FirstOrDefault(line => line.StartsWith("model name", StringComparison.Ordinal))?.Split(':')[^1].Trim() : null)
        ?? RuntimeInformation.ProcessArchitecture.ToString();

    /// <summary>The processor, and the number of cores that this process uses.</summary>
    public static string Description { get; } = $"{Processor} ({Environment.ProcessorCount} core{(Environment.ProcessorCount == 1 ? "" : "s")} used)";
}
