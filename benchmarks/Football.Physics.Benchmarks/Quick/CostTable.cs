using System.Globalization;
using FootballPhysics.Labs;

namespace FootballPhysics.Benchmarks;

/// <summary>The twelve rows of docs/performance.md with the cost of each call, as times and as ratios to a step in flight.</summary>
internal static class CostTable
{
    private const int Seed = 1;
    private const int Aims = 64;

    /// <summary>The first words of the table's header.</summary>
    private const string Header = "| call | time |";

    private static readonly Integrator s_method = SolverSettings.Default.Integrator;

    private static (string Name, Func<Workload> Subject)[] Rows { get; } =
    [
        ("a step in flight", Flight),
        ("a step in flight, with RK2", () => Workloads.Flight(new Scene(), Integrator.Rk2, ShotSets.Fast)),
        ("a step at 60 Hz, on average over a kick until rest", () => Workloads.Kick(new Scene(), s_method)),
        ("a step with an impact", () => Workloads.Impacts(new Scene(), s_method)),
        ("a step of a rolling ball", () => Workloads.Chain(new Scene(), s_method, ShotSets.Rolling)),
        ("a step of a ball at rest", () => Workloads.Stopped(s_method)),
        ("a step in flight before a goal, among 22 bodies", () => WorldTable.BeforeTheGoal(new StadiumScenes(new Scene()).WithBodies(out _))),
        ("a step of a ball in a net", () => ContactCase.All.Single(item => item.Name == "kicked in the net of a goal").Make(s_method, false).Workload),
        ("a look-ahead of 3 s", QueryRows.LookAhead),
        ("an aim at one target, with its measured miss", Aim),
        ("all interception windows of 22 players on a look-ahead", QueryRows.Windows),
        ("the chance of a goal, by 2000 simulated kicks", () => GoalChanceRows.Chance(2, 1, 3)),
    ];

    /// <summary>Times the rows, and replaces the table in a page.</summary>
    /// <param name="file">The page.</param>
    /// <param name="seconds">The time for all rows, in s.</param>
    /// <exception cref="InvalidOperationException">The page has no such table.</exception>
    public static void Write(string file, double seconds)
    {
        string[] lines = File.ReadAllLines(file);
        int first = Array.FindIndex(lines, line => line.StartsWith(Header, StringComparison.Ordinal));
        if (first < 0)
        {
            throw new InvalidOperationException($"{file} has no line that starts with '{Header}'. Add one where the table belongs.");
        }

        int last = first;
        while (last < lines.Length && lines[last].StartsWith('|'))
        {
            last++;
        }

        File.WriteAllText(file, string.Join('\n', [.. lines[..first], .. Table(seconds), .. lines[last..]]) + "\n");
        Console.WriteLine($"Written to {file}.");
    }

    private static List<string> Table(double seconds)
    {
        Workload flight = Flight();
        (string Name, Workload Subject)[] work = [.. Rows.Select(row => (row.Name, row.Subject()))];
        Stopwatching.WarmUp([flight, .. work.Select(row => row.Subject)]);
        var table = new List<string> { Header + " in flight steps |", "|---|--:|--:|" };
        foreach ((string name, Workload subject) in work)
        {
            Timing time = Stopwatching.Measure(subject, flight, seconds / work.Length);
            table.Add($"| {name} | {Time(time.Nanoseconds)} | {Rounded(time.Ratio)} |");
            Console.WriteLine(table[^1]);
        }

        return table;
    }

    private static Workload Flight() => Workloads.Flight(new Scene(), s_method, ShotSets.Fast);

    private static Workload Aim()
    {
        var aimer = new Aimer();
        AimRequest[] requests = AimSets.Thesis(Seed, Aims);
        return new Workload(() => requests.Sum(request => aimer.Find(request).Time), requests.Length);
    }

    /// <summary>Returns two significant digits with the unit that fits.</summary>
    private static string Time(double nanoseconds) => nanoseconds switch
    {
        >= 1e6 => Rounded(1e-6 * nanoseconds) + " ms",
        >= 1e3 => Rounded(1e-3 * nanoseconds) + " µs",
        _ => Rounded(nanoseconds) + " ns",
    };

    private static string Rounded(double value)
    {
        double unit = Math.Pow(10, Math.Floor(Math.Log10(value)) - 1);
        return (Math.Round(value / unit) * unit).ToString(value < 0.995 ? "0.0##" : value < 9.95 ? "0.0" : "0", CultureInfo.InvariantCulture);
    }
}
