namespace FootballPhysics.Benchmarks;

/// <summary>A table of `quick`.</summary>
/// <param name="Name">The table's name for the selection of rows.</param>
/// <param name="Rows">Returns its rows.</param>
/// <param name="Print">Times rows of this table and prints them, with the time for each row, s.</param>
internal sealed record Table(string Name, Func<IReadOnlyList<Row>> Rows, Action<Action<string>, IReadOnlyList<Row>, double> Print)
{
    /// <summary>All tables, in the order of their output.</summary>
    public static IReadOnlyList<Table> All { get; } =
    [
        Of("Kick", () => KickTable.Rows, KickTable.Print),
        Of("Scene contains", () => MixtureTable.Rows, MixtureTable.Print),
        Of("Time", () => TargetTable.Rows, TargetTable.Print),
        Of("Free", () => FreeTable.Rows, FreeTable.Print),
        Of("Floor", () => FloorTable.Rows, FloorTable.Print),
        Of("World", () => WorldTable.Rows, WorldTable.Print),
        Of("Contact", () => ContactTable.Rows, ContactTable.Print),
        Of("Group", () => GroupTable.Rows, GroupTable.Print),
        Of("Heap", () => HeapTable.Rows, HeapTable.Print),
        Of("Net", () => NetTable.Rows, NetTable.Print),
        Of("Prediction", () => PredictionTable.Rows, PredictionTable.Print),
    ];

    /// <summary>Returns the rows whose name, after that of the table, contains a text.</summary>
    public IReadOnlyList<Row> Select(string? only) => [.. Rows().Where(row => Contains($"{Name}: {row.Name}", only))];

    /// <summary>Returns true if a name contains the text for the selection of rows.</summary>
    public static bool Contains(string name, string? only) => only is null || name.Contains(only, StringComparison.OrdinalIgnoreCase);

    private static Table Of<T>(string name, Func<IReadOnlyList<T>> rows, Action<Action<string>, IReadOnlyList<T>, double> print)
        where T : Row =>
        new(name, rows, (line, chosen, share) => print(line, [.. chosen.Cast<T>()], share));
}
