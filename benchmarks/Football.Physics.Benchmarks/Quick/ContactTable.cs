using System.Globalization;

namespace FootballPhysics.Benchmarks;

/// <summary>The rows of "A ball that several surfaces touch": steps of 10 ms in the default scene, as ratios to a flight step of the same method.</summary>
internal static class ContactTable
{
    public static IReadOnlyList<ContactRow> Rows { get; } =
    [
        .. from item in ContactCase.All
           from atRest in new[] { false, true }
           from method in new[] { (Integrator: Integrator.Rk4, Name: "RK4"), (Integrator: Integrator.Rk2, Name: "RK2") }
           select new ContactRow($"{item.Name}, {(atRest ? "at rest" : "moving")}: {method.Name}", method.Integrator, () => item.Make(method.Integrator, atRest)),
    ];

    /// <summary>Times the rows.</summary>
    public static void Print(Action<string> print, IReadOnlyList<ContactRow> rows, double share)
    {
        (ContactRow Row, ContactCase Case, Workload Subject, Workload Flight)[] work =
        [
            .. rows.Select(row => (row, Case: row.Subject(), Flight: Workloads.Flight(new Scene(), row.Integrator, ShotSets.Fast)))
                .Select(item => (item.row, item.Case, item.Case.Workload, item.Flight)),
        ];
        Stopwatching.WarmUp([.. work.SelectMany(w => new[] { w.Subject, w.Flight })]);
        print("");
        print("## A ball that several surfaces touch");
        print("");
        print("Steps of 10 ms in the default scene, relative to a flight step of the same method in the same run. Worst: the slowest of 24 steps, each measured seven times; the minimum counts.");
        print("");
        print("| | ns a step | flight step, ns | ratio | worst step, ns | ratio | evaluations | most | bytes | |");
        print("|---|--:|--:|--:|--:|--:|--:|--:|--:|---|");
        foreach ((ContactRow row, ContactCase item, Workload subject, Workload flight) in work)
        {
            Timing time = Stopwatching.Measure(subject, flight, share);
            double worst = item.Worst();
            (double mean, long most) = item.Evaluations();
            string rests = row.Name.Contains("at rest", StringComparison.Ordinal) && !item.IsAtRest ? "**does not rest**" : "";
            print(string.Create(CultureInfo.InvariantCulture, $"| {row.Name} | {Text.Number(time.Nanoseconds)} | {Text.Number(time.YardstickNanoseconds)} | {Text.Number(time.Ratio)} | {Text.Number(worst)} | {Text.Number(worst / time.YardstickNanoseconds)} | {Text.Number(mean)} | {most} | {Text.Number(time.Bytes)} | {rests} |"));
        }
    }
}
