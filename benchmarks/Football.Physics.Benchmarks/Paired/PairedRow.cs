namespace FootballPhysics.Benchmarks;

/// <summary>A row of `paired`: its times and ratios in each run.</summary>
internal sealed class PairedRow(string name, Bounds bounds, int runs)
{
    /// <summary>The number of calls that show whether a workload uses a member that the other library lacks: all parts of its shots.</summary>
    private const int Calls = 4;

    private readonly List<double> _nanoseconds = [];
    private readonly List<double> _before = [];
    private readonly List<double> _ratios = [];
    private readonly List<double> _flightSteps = [];

    /// <summary>The table and the row.</summary>
    public string Name => name;

    /// <summary>The reason why the row cannot be compared; null if it can.</summary>
    public string? Reason { get; private set; }

    /// <summary>True if the row is above its bound in all runs, and in the median of those that follow.</summary>
    public bool Fails => bounds.Fails(name, _ratios, _flightSteps, runs);

    /// <summary>Times the rows once.</summary>
    /// <param name="rows">The rows of a table.</param>
    /// <param name="now">The build of the work tree.</param>
    /// <param name="then">The build with the other library.</param>
    /// <param name="table">The table.</param>
    /// <param name="nowFirst">True if the work tree comes first in the warm-up and in each round.</param>
    /// <param name="seconds">The time for each row, s.</param>
    public static void Time(IReadOnlyList<PairedRow> rows, Build now, Build then, string table, bool nowFirst, double seconds)
    {
        Dictionary<string, Func<Workload>[]> ours = now.Rows(table);
        Dictionary<string, Func<Workload>[]> theirs = [];
        string? none = Refusal(() => theirs = then.Rows(table));
        var work = new List<(PairedRow Row, Workload Now, Workload Then, Workload[] Flight)>();
        foreach (PairedRow row in rows)
        {
            Workload? before = null;
            row.Reason ??= none ?? Refusal(() => before = Try(theirs[row.Name][0]));
            if (row.Reason is null)
            {
                Func<Workload>[] make = ours[row.Name];
                work.Add((row, Try(make[0]), before!, [.. make[1..].Select(Try)]));
            }
        }

        Stopwatching.WarmUp([.. work.SelectMany(w => (Workload[])[nowFirst ? w.Now : w.Then, nowFirst ? w.Then : w.Now, .. w.Flight])]);
        foreach ((PairedRow row, Workload subject, Workload before, Workload[] flight) in work)
        {
            (Workload first, Workload second) = nowFirst ? (subject, before) : (before, subject);
            Timing time = Stopwatching.Measure(first, second, seconds, ofProcessor: true);
            row._nanoseconds.Add(nowFirst ? time.Nanoseconds : time.YardstickNanoseconds);
            row._before.Add(nowFirst ? time.YardstickNanoseconds : time.Nanoseconds);
            row._ratios.Add(nowFirst ? time.Ratio : 1 / time.Ratio);
            row._flightSteps.AddRange(flight.Select(unit => Stopwatching.Measure(subject, unit, 0.5 * seconds, ofProcessor: true).Ratio));
        }
    }

    /// <summary>Returns the line of the table.</summary>
    public string Line()
    {
        if (Reason is not null)
        {
            return $"| {name} | | | cannot be compared: {Reason} | | | |";
        }

        (bool inFlightSteps, double most) = bounds.Of(name);
        string bound = $"≤ {Text.Number(most)}{(inFlightSteps ? " " + Bounds.FlightSteps : "")}";
        string flight = _flightSteps.Count > 0 ? Text.Number(Stopwatching.Median([.. _flightSteps])) : "";
        FormattableString ratios = $"{Stopwatching.Median([.. _ratios]):F3} ({_ratios.Min():F3} to {_ratios.Max():F3})";
        return $"| {name} | {Text.Number(Stopwatching.Median([.. _nanoseconds]))} | {Text.Number(Stopwatching.Median([.. _before]))} | {FormattableString.Invariant(ratios)} | {flight} | {bound} | {(Fails ? "**above**" : "")} |";
    }

    /// <summary>Makes a workload, and calls it.</summary>
    private static Workload Try(Func<Workload> make)
    {
        Workload workload = make();
        for (int i = 0; i < Calls; i++)
        {
            workload.Run();
        }

        return workload;
    }

    /// <summary>Returns the reason why a call on the other library fails, such as a missing member; null if it succeeds.</summary>
    private static string? Refusal(Action call)
    {
        try
        {
            call();
            return null;
        }
        catch (Exception refused)
        {
            Exception cause = refused.GetBaseException();
            return $"{cause.GetType().Name}: {cause.Message.Split('\n')[0].Trim()}";
        }
    }
}
