using System.Globalization;

namespace FootballPhysics.Benchmarks;

/// <summary>`paired FOLDER`: times the rows of `quick` with this library and with that of another folder, which alternate in one process.</summary>
internal static class PairedCommand
{
    private const string Usage = "paired FOLDER [--only TEXT] [--bound RATIO] [--runs N] [--seconds S for each row and run]";

    /// <summary>Times the rows.</summary>
    /// <returns>0; 1 if a row is above its bound; 2 if nothing can be compared.</returns>
    public static int Run(string[] arguments)
    {
        string? only = null;
        double common = 1.03;
        double seconds = 0.2;
        int runs = 3;
        for (int i = 1; i < arguments.Length; i += 2)
        {
            string value = i + 1 < arguments.Length ? arguments[i + 1] : "";
            bool known = arguments[i] switch
            {
                "--only" => (only = value).Length > 0,
                "--bound" => double.TryParse(value, NumberStyles.Float, CultureInfo.InvariantCulture, out common) && common > 0,
                "--seconds" => double.TryParse(value, NumberStyles.Float, CultureInfo.InvariantCulture, out seconds) && seconds > 0,
                "--runs" => int.TryParse(value, NumberStyles.None, CultureInfo.InvariantCulture, out runs) && runs > 0,
                _ => false,
            };
            if (!known)
            {
                return Refuse($"'{arguments[i]} {value}' is not understood. Usage: {Usage}");
            }
        }

        if (arguments.Length == 0 || !Build.Exists(arguments[0]))
        {
            return Refuse($"The folder of the other benchmarks is missing. Usage: {Usage}");
        }

        var bounds = new Bounds(common, File.ReadLines(Path.Combine(AppContext.BaseDirectory, "bounds.tsv")));
        (string Table, PairedRow[] Rows)[] tables = [.. Table.All.Select(table => (table.Name, Build.Share(table.Name).Select(row => new PairedRow(row.Name, bounds, runs)).ToArray()))];
        string[] unused = [.. bounds.Unused([.. tables.SelectMany(table => table.Rows).Select(row => row.Name)])];
        if (unused.Length > 0)
        {
            return Refuse($"No row matches '{unused[0]}' of bounds.tsv. Correct the pattern or remove the line.");
        }

        PairedRow[] rows = [.. tables.SelectMany(table => Compare(arguments[0], table.Table, [.. table.Rows.Where(row => Table.Contains(row.Name, only))], runs, seconds))];
        string[] fail = [.. rows.Where(row => row.Fails).Select(row => row.Name)];
        Console.WriteLine($"{rows.Length} rows; {rows.Count(row => row.Reason is not null)} cannot be compared; {fail.Length} above the bound in {runs} runs and in the median of {runs} more{(fail.Length > 0 ? ":" : ".")}");
        foreach (string name in fail)
        {
            Console.WriteLine(name);
        }

        return rows.All(row => row.Reason is not null) ? Refuse("No row was compared.") : fail.Length > 0 ? 1 : 0;
    }

    private static int Refuse(string message)
    {
        Console.Error.WriteLine(message);
        return 2;
    }

    /// <summary>Times rows of a table in several runs, and prints them.</summary>
    /// <remarks>Rows that are above their bound in all runs are timed in as many again. Each run loads and compiles both libraries again, so that their code lies at other addresses. The order of the two alternates.</remarks>
    private static PairedRow[] Compare(string folder, string table, PairedRow[] rows, int runs, double seconds)
    {
        PairedRow[] open = rows;
        for (int run = 0; run < 2 * runs && open.Length > 0; run++)
        {
            PairedRow.Time(open, new Build(AppContext.BaseDirectory), new Build(folder), table, run % 2 == 0, seconds);
            open = run == runs - 1 ? [.. rows.Where(row => row.Fails)] : open;
        }

        if (rows.Length > 0)
        {
            Console.WriteLine($"| {table} | ns | before | ratio in each run | flight steps | bound | |");
            Console.WriteLine("|---|--:|--:|---|--:|--:|---|");
            foreach (PairedRow row in rows)
            {
                Console.WriteLine(row.Line());
            }

            Console.WriteLine();
        }

        return rows;
    }
}
