namespace FootballPhysics.Tool.Sweep.Columns;

/// <summary>A column of a data set.</summary>
/// <param name="Name">The name.</param>
/// <param name="Kind">The type of its values.</param>
/// <param name="Unit">The unit of the values; empty for none.</param>
/// <param name="Meaning">The meaning of the values.</param>
internal sealed record Column(string Name, ColumnKind Kind, string Unit, string Meaning)
{
    /// <summary>The maximum number of different words in a column: a word's index is stored in one byte.</summary>
    public const int MostWords = 256;

    /// <summary>The code of a missing word. A column that can miss words has fewer than <see cref="MostWords"/>.</summary>
    public const byte Missing = 255;

    private static readonly string[] s_xyz = ["x", "y", "z"];

    /// <summary>The names of the elements along each axis of a value; no axes for a single number.</summary>
    public IReadOnlyList<IReadOnlyList<string>> Axes { get; init; } = [];

    /// <summary>The words that occur in a column of words.</summary>
    public IReadOnlyList<string> Words { get; init; } = [];

    /// <summary>True if a word can be missing; its code is then <see cref="Missing"/>. Default false.</summary>
    public bool CanMiss { get; init; }

    /// <summary>The number of elements in each row.</summary>
    public int Size { get; private init; } = 1;

    /// <summary>The name of each element.</summary>
    public IEnumerable<string> Labels => Axes.Aggregate<IReadOnlyList<string>, IEnumerable<string>>([Name], (names, axis) => names.SelectMany(name => axis.Select(place => $"{name}.{place}")));

    /// <summary>Creates a column with one number per row.</summary>
    public static Column Real(string name, string unit, string meaning) => new(name, ColumnKind.Real, unit, meaning);

    /// <summary>Creates a column with one vector per row.</summary>
    public static Column Vector(string name, string unit, string meaning) => Real(name, unit, meaning).Along(s_xyz);

    /// <summary>Creates a column with one whole number per row.</summary>
    public static Column Whole(string name, string unit, string meaning) => new(name, ColumnKind.Whole, unit, meaning);

    /// <summary>Creates a column with one word per row.</summary>
    public static Column Word(string name, string meaning, params IReadOnlyList<string> words) => new(name, ColumnKind.Word, "", meaning) { Words = words };

    /// <summary>Returns the column with several values per row; the new axis comes before the existing axes.</summary>
    public Column Along(IReadOnlyList<string> axis) => this with { Axes = [axis, .. Axes], Size = Size * axis.Count };
}
