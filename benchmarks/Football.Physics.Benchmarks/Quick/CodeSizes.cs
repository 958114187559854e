using System.Globalization;
using System.Text.RegularExpressions;

namespace FootballPhysics.Benchmarks;

/// <summary>Reads the size of optimised machine code from the JIT's own listing.</summary>
internal static partial class CodeSizes
{
    /// <summary>Returns the sizes, bytes, of a row's step method and of the method around it that finds events.</summary>
    public static (int? Method, int? Around) Of(int row, FreeRow free)
    {
        if (free.Method is not { } method)
        {
            return (null, null);
        }

        string file = Path.GetTempFileName();
        try
        {
            var environment = new Dictionary<string, string> { ["DOTNET_JitStdOutFile"] = file, ["DOTNET_JitDisasmSummary"] = "1" };
            Child.Run(environment, "quick", "--child", "free", row.ToString(CultureInfo.InvariantCulture));
            string[] lines = File.ReadAllLines(file);
            return (Last(lines, method), method.Contains(":Fly[", StringComparison.Ordinal) ? Last(lines, "MidpointRungeKutta]:Step(") : null);
        }
        finally
        {
            File.Delete(file);
        }
    }

    private static int? Last(string[] lines, string method)
    {
        string? line = lines.LastOrDefault(l => l.Contains(method, StringComparison.Ordinal)
            && (l.Contains("Tier1", StringComparison.Ordinal) || l.Contains("FullOpts", StringComparison.Ordinal)) && !l.Contains("OSR", StringComparison.Ordinal));
        return line is not null && Size().Match(line) is { Success: true } match ? int.Parse(match.Groups[1].Value, CultureInfo.InvariantCulture) : null;
    }

    [GeneratedRegex(@"code size=(\d+)")]
    private static partial Regex Size();
}
