using System.Globalization;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using System.Text;

namespace FootballPhysics.Benchmarks;

/// <summary>`quick`: prints the tables of times in under a minute, while BenchmarkDotNet takes many.</summary>
internal static class QuickCommand
{
    private const string Usage = "quick [--seconds S] [--only TEXT, such as kick: | floor: | \"first use\" | world: | contact: | group: | heap: | net: | prediction:] [--markdown FILE] | quick [--seconds S] (--costs FILE | --history FILE)";

    public static int Run(string[] arguments)
    {
        double seconds = 20;
        string? only = null;
        string? markdown = null;
        string? costs = null;
        string? history = null;
        for (int i = 0; i < arguments.Length; i += 2)
        {
            string? value = i + 1 < arguments.Length ? arguments[i + 1] : null;
            switch (arguments[i])
            {
                case "--child" when value is not null && i + 2 < arguments.Length:
                    return RunChild(value, int.Parse(arguments[i + 2], CultureInfo.InvariantCulture));
                case "--seconds" when double.TryParse(value, NumberStyles.Float, CultureInfo.InvariantCulture, out double s) && s > 0:
                    seconds = s;
                    break;
                case "--only" when value is not null:
                    only = value;
                    break;
                case "--markdown" when value is not null:
                    markdown = value;
                    break;
                case "--costs" when value is not null:
                    costs = value;
                    break;
                case "--history" when value is not null:
                    history = value;
                    break;
                default:
                    Console.Error.WriteLine($"'{arguments[i]}' is not understood. Usage: {Usage}");
                    return 2;
            }
        }

        if (costs is not null)
        {
            CostTable.Write(costs, seconds);
            return 0;
        }

        if (history is not null)
        {
            HistoryCommand.Run(history, seconds);
            return 0;
        }

        string text = Report(seconds, only, string.Join(' ', arguments));
        if (markdown is not null)
        {
            WritePage(markdown, text);
            Console.WriteLine($"Written to {markdown}.");
        }

        return 0;
    }

    /// <summary>Writes the tables between the marks of a page; a file without marks is replaced.</summary>
    private static void WritePage(string file, string text)
    {
        const string Begin = "<!-- timings, from quick -->\n", End = "<!-- /timings -->";
        string page = File.Exists(file) ? File.ReadAllText(file) : "";
        int begin = page.IndexOf(Begin, StringComparison.Ordinal), end = page.IndexOf(End, StringComparison.Ordinal);
        File.WriteAllText(file, begin >= 0 && end > begin ? $"{page[..(begin + Begin.Length)]}\n{text.TrimEnd()}\n\n{page[end..]}" : text);
    }

    private static string Report(double seconds, string? only, string arguments)
    {
        var text = new StringBuilder();
        Print(text, "## All timings");
        Print(text, "");
        Print(text, $"{DateTime.UtcNow:yyyy-MM-dd}, {Machine.Description}, {RuntimeInformation.FrameworkDescription}, {RuntimeInformation.OSDescription.Trim()}.");
        Print(text, $"Written by `dotnet run -c Release --project benchmarks/Football.Physics.Benchmarks -- quick {arguments}`.");
        Print(text, "Medians of rounds in which subject and yardstick alternate. Compare ratios, not times: on a shared machine, the times of a row change together, by 50 % and more.");
        Print(text, "`plain` is an implementation of the same laws in straightforward double C# with `Math.Pow` and `Math.Exp`, in the same process. Reach: the project's own target.");
        Print(text, "Fast shots: 24 m/s, 20 to 30 rad/s; mixed shots: 12 to 27 m/s, 0 to 25 rad/s, on both branches of the drag law. Bytes: the memory that one operation allocates.");

        (Table Table, IReadOnlyList<Row> Rows)[] chosen = [.. Table.All.Select(table => (table, table.Select(only))).Where(part => part.Item2.Count > 0)];
        double share = seconds / Math.Max(1, chosen.Sum(part => part.Rows.Count));
        foreach ((Table table, IReadOnlyList<Row> rows) in chosen)
        {
            table.Print(line => Print(text, line), rows, share);
        }

        if (Table.Contains(FirstUseTable.Name, only))
        {
            ScriptTable.FirstUse(line => Print(text, line));
            FirstUseTable.JustInTime(line => Print(text, line));
        }

        if (Table.Contains(ScriptTable.MonoName, only))
        {
            ScriptTable.Mono(line => Print(text, line), share);
        }

        if (Table.Contains(ScriptTable.AheadOfTimeName, only))
        {
            ScriptTable.AheadOfTime(line => Print(text, line));
        }

        return text.ToString();
    }

    private static int RunChild(string table, int index)
    {
        if (table == "free")
        {
            Stopwatching.WarmUp([FreeTable.Rows[index].Subject()]);
            return 0;
        }

        if (table == "first")
        {
            Console.Write(FirstUseTable.Measure(warm: index == 1));
            return 0;
        }

        if (Vector512.IsHardwareAccelerated)
        {
            Console.Error.WriteLine("512-bit registers are still on.");
            return 3;
        }

        TargetRow row = TargetTable.Rows[index];
        Workload subject = row.Subject();
        Workload yardstick = row.Yardstick();
        Stopwatching.WarmUp([subject, yardstick]);
        Timing time = Stopwatching.Measure(subject, yardstick, 0.5);
        Console.Write(string.Create(CultureInfo.InvariantCulture, $"{time.Nanoseconds} {time.YardstickNanoseconds} {time.Ratio} {time.Bytes}"));
        return 0;
    }

    private static void Print(StringBuilder text, string line)
    {
        text.Append(line).Append('\n');
        Console.WriteLine(line);
    }
}
