using System.Globalization;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using System.Text;

namespace FootballPhysics.Benchmarks;

/// <summary>`quick`: prints the tables of times in under a minute, while BenchmarkDotNet takes many.</summary>
internal static class QuickCommand
{
    private const string Usage = "quick [--seconds S] [--only TEXT, such as kick: | floor: | \"first use\" | world: | contact: | group: | heap: | net: | prediction:] [--markdown FILE] | quick [--seconds S] (--costs FILE | --history FILE | --against FOLDER)";

    public static int Run(string[] arguments)
    {
        double seconds = 20;
        string? only = null;
        string? markdown = null;
        string? costs = null;
        string? history = null;
        string? against = null;
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
                case "--against" when value is not null:
                    against = value;
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

        if (against is not null)
        {
            return PairedCommand.Run(against, seconds);
        }

        string text = Report(seconds, only, string.Join(' ', arguments));
        if (markdown is not null)
        {
            File.WriteAllText(markdown, text);
            Console.WriteLine($"Written to {markdown}.");
        }

        return 0;
    }

    private static string Report(double seconds, string? only, string arguments)
    {
        var text = new StringBuilder();
        Print(text, "# Benchmarks");
        Print(text, "");
        Print(text, $"{DateTime.UtcNow:yyyy-MM-dd}, {Machine.Description}, {RuntimeInformation.FrameworkDescription}, {RuntimeInformation.OSDescription.Trim()}.");
        Print(text, $"Written by `dotnet run -c Release --project benchmarks/Football.Physics.Benchmarks -- quick {arguments}`.");
        Print(text, "Medians of rounds in which subject and yardstick alternate. Compare ratios, not times: on a shared machine, the times of a row change together, by 50 % and more.");
        Print(text, "`plain` is an implementation of the same laws in straightforward double C# with `Math.Pow` and `Math.Exp`, in the same process. Reach: the project's own target.");
        Print(text, "Fast shots: 24 m/s, 20 to 30 rad/s; mixed shots: 12 to 27 m/s, 0 to 25 rad/s, on both branches of the drag law. Bytes: the memory that one operation allocates.");

        IReadOnlyList<KickRow> kicks = [.. KickTable.Rows.Where(row => Wanted("Kick: " + row.Name, only))];
        var mixtures = MixtureTable.Rows.Where(row => Wanted("Scene contains: " + row.Name, only)).ToArray();
        IReadOnlyList<TargetRow> targets = [.. TargetTable.Rows.Where(row => Wanted(row.Name, only))];
        IReadOnlyList<FreeRow> free = [.. FreeTable.Rows.Where(row => Wanted(row.Name, only))];
        var floors = FloorTable.Rows.Where(row => Wanted("Floor: " + row.Name, only)).ToArray();
        IReadOnlyList<PredictionRow> predictions = [.. PredictionTable.Rows.Where(row => Wanted("Prediction: " + row.Name, only))];
        IReadOnlyList<WorldRow> world = [.. WorldTable.Rows.Where(row => Wanted("World: " + row.Name, only))];
        IReadOnlyList<ContactRow> contacts = [.. ContactTable.Rows.Where(row => Wanted("Contact: " + row.Name, only))];
        IReadOnlyList<GroupRow> groups = [.. GroupTable.Rows.Where(row => Wanted("Group: " + row.Name, only))];
        IReadOnlyList<(string Name, int Balls, double Half, Integrator Integrator)> heaps = [.. HeapTable.Rows.Where(row => Wanted("Heap: " + row.Name, only))];
        (string Name, Integrator Integrator)[] nets = [.. NetTable.Rows.Where(row => Wanted("Net: " + row.Name, only))];
        double share = seconds / Math.Max(1, kicks.Count + targets.Count + free.Count + floors.Length + world.Count + predictions.Count + contacts.Count + groups.Count + mixtures.Length);
        if (kicks.Count > 0)
        {
            KickTable.Print(line => Print(text, line), kicks, share);
        }

        if (mixtures.Length > 0)
        {
            MixtureTable.Print(line => Print(text, line), mixtures, share);
        }

        if (targets.Count > 0)
        {
            Targets(text, targets, share);
        }

        if (free.Count > 0)
        {
            Free(text, free, share);
        }

        if (floors.Length > 0)
        {
            FloorTable.Print(line => Print(text, line), floors, share);
        }

        if (world.Count > 0)
        {
            WorldTable.Print(line => Print(text, line), world, share);
        }

        if (contacts.Count > 0)
        {
            ContactTable.Print(line => Print(text, line), contacts, share);
        }

        if (groups.Count > 0)
        {
            GroupTable.Print(line => Print(text, line), groups, share);
        }

        if (heaps.Count > 0)
        {
            HeapTable.Print(line => Print(text, line), heaps);
        }

        if (nets.Length > 0)
        {
            NetTable.Print(line => Print(text, line), nets);
        }

        if (predictions.Count > 0)
        {
            PredictionTable.Print(line => Print(text, line), predictions, share);
        }

        if (Wanted(FirstUseTable.Name, only))
        {
            ScriptTable.FirstUse(line => Print(text, line));
            FirstUseTable.JustInTime(line => Print(text, line));
        }

        if (Wanted(ScriptTable.MonoName, only))
        {
            ScriptTable.Mono(line => Print(text, line), share);
        }

        if (Wanted(ScriptTable.AheadOfTimeName, only))
        {
            ScriptTable.AheadOfTime(line => Print(text, line));
        }

        return text.ToString();
    }

    private static void Targets(StringBuilder text, IReadOnlyList<TargetRow> rows, double share)
    {
        (TargetRow Row, Workload Subject, Workload Yardstick)[] work = [.. rows.Select(row => (row, row.Subject(), row.Yardstick()))];
        Stopwatching.WarmUp([.. work.SelectMany(w => new[] { w.Subject, w.Yardstick })]);
        Print(text, "");
        Print(text, "## Time for one ball");
        Print(text, "");
        Print(text, "10 ms steps through the public `Simulator.Step`, with events, and with the jump of the drag law located.");
        Print(text, "Error: the mean distance between the landings (for a look-ahead: the ends) and those of RK4 at 0.5 ms.");
        Print(text, "");
        Print(text, "| | ns | yardstick, ns | ratio | reach | | bytes | error | thesis (Unity) |");
        Print(text, "|---|--:|--:|--:|--:|---|--:|--:|--:|");
        foreach ((TargetRow row, Workload subject, Workload yardstick) in work)
        {
            Timing time = row.Without512Bit ? InChild(row) : Stopwatching.Measure(subject, yardstick, share);
            string verdict = row.Target is { } target ? (time.Ratio <= target ? "reached" : "**missed**") : "";
            string reach = row.Target is { } t ? $"≤ {Text.Number(t)}" : "";
            string error = row.Error is { } of ? Text.Length(of()) + (row.Note is { } note ? ", " + note() : "") : "";
            Print(text, $"| {row.Name} | {Text.Number(time.Nanoseconds)} | {Text.Number(time.YardstickNanoseconds)} | {Text.Number(time.Ratio)} | {reach} | {verdict} | {Text.Number(time.Bytes)} | {error} | {row.Thesis} |");
        }
    }

    private static void Free(StringBuilder text, IReadOnlyList<FreeRow> rows, double share)
    {
        Workload all = FreeTable.Rows[0].Subject();
        (FreeRow Row, Workload Subject)[] work = [.. rows.Select(row => (row, row.Subject()))];
        Stopwatching.WarmUp([all, .. work.Select(w => w.Subject)]);
        Print(text, "");
        Print(text, "## What a scene does not need is free");
        Print(text, "");
        Print(text, "RK2 at 10 ms. Code: the size of the integrator's method in bytes, as the JIT lists it (`DOTNET_JitDisasmSummary`), and that of the method around it, which finds events. Buoyancy is part of gravity, so the code is the same without it.");
        Print(text, "");
        Print(text, "| | ns a step | all forces then, ns | ratio | code | around it |");
        Print(text, "|---|--:|--:|--:|--:|--:|");
        foreach ((FreeRow row, Workload subject) in work)
        {
            Timing time = Stopwatching.Measure(subject, all, share);
            (int? method, int? around) = CodeSizes.Of(FreeTable.Rows.TakeWhile(r => r != row).Count(), row);
            Print(text, $"| {row.Name} | {Text.Number(time.Nanoseconds)} | {Text.Number(time.YardstickNanoseconds)} | {Text.Number(time.Ratio)} | {method?.ToString(CultureInfo.InvariantCulture) ?? "–"} | {around?.ToString(CultureInfo.InvariantCulture) ?? "–"} |");
        }
    }

    private static Timing InChild(TargetRow row)
    {
        // .NET 10 renamed the switch; each runtime ignores the other name.
        var environment = new Dictionary<string, string> { ["DOTNET_EnableAVX512"] = "0", ["DOTNET_EnableAVX512F"] = "0" };
        int index = TargetTable.Rows.TakeWhile(r => r != row).Count();
        double[] values = [.. Child.Run(environment, "quick", "--child", "target", index.ToString(CultureInfo.InvariantCulture))
            .Split(' ').Select(v => double.Parse(v, CultureInfo.InvariantCulture))];
        return new Timing(values[0], values[1], values[2], values[3]);
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

    private static bool Wanted(string name, string? only) => only is null || name.Contains(only, StringComparison.OrdinalIgnoreCase);

    private static void Print(StringBuilder text, string line)
    {
        text.Append(line).Append('\n');
        Console.WriteLine(line);
    }
}
