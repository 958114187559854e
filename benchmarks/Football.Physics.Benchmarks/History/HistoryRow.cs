namespace FootballPhysics.Benchmarks;

/// <summary>A ratio in the history: a permanent name, a subject and its yardstick.</summary>
internal sealed record HistoryRow(string Name, Workload Subject, Workload Yardstick)
{
    private static readonly string[] s_steps = ["flight step, ", "3 s look-ahead, default scene, RK4, 80 ms"];

    /// <summary>Returns the rows of "A kick" in the default scene, and those of "Time for one ball" that a change of every step would affect.</summary>
    public static HistoryRow[] All()
    {
        var scene = new Scene();
        return
        [
            .. KickTable.Rows.Select(row => new HistoryRow(row.Name, row.Subject(scene), row.Yardstick(scene))),
            .. TargetTable.Rows.Where(row => !row.Without512Bit && s_steps.Any(start => row.Name.StartsWith(start, StringComparison.Ordinal)))
                .Select(row => new HistoryRow(row.Name, row.Subject(), row.Yardstick())),
        ];
    }
}
