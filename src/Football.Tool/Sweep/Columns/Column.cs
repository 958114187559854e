namespace FootballPhysics.Tool.Sweep.Columns;

/// <summary>A column of a data set.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Kind">The type of its values.</param>
/// <param name="Unit">Their unit; empty for none.</param>
/// <param name="Meaning">The meaning of the values.</param>
internal sealed record Column(string Name, ColumnKind Kind, string Unit, string Meaning)
{
    /// <summary>Most words of a column: a byte's.</summary>
    public const int MostWords = 256;

    private static readonly string[] s_xyz = ["x", "y", "z"];

    /// <summary>Names of the places along each axis of a row's value; no axis for a single value.</summary>
    public IReadOnlyList<IReadOnlyList<string>> Axes { get; init; } = [];

    /// <summary>The words, where the values are words.</summary>
    public IReadOnlyList<string> Words { get; init; } = [];

    /// <summary>Numbers of a row.</summary>
    public int Size { get; private init; } = 1;

    /// <summary>A name for each number of a row.</summary>
    public IEnumerable<string> Labels => Axes.Aggregate<IReadOnlyList<string>, IEnumerable<string>>([Name], (names, axis) => names.SelectMany(name => axis.Select(place => $"{name}.{place}")));

    /// <summary>One number a row.</summary>
    public static Column Real(string name, string unit, string meaning) => new(name, ColumnKind.Real, unit, meaning);

    /// <summary>A vector a row.</summary>
    public static Column Vector(string name, string unit, string meaning) => Real(name, unit, meaning).Along(s_xyz);

    /// <summary>One whole number a row.</summary>
    public static Column Whole(string name, string unit, string meaning) => new(name, ColumnKind.Whole, unit, meaning);

    /// <summary>One word a row.</summary>
    public static Column Word(string name, string meaning, params IReadOnlyList<string> words) => new(name, ColumnKind.Word, "", meaning) { Words = words };

    /// <summary>The same, several a row: the new axis comes before those that are there.</summary>
    public Column Along(IReadOnlyList<string> axis) => this with { Axes = [axis, .. Axes], Size = Size * axis.Count };
}
