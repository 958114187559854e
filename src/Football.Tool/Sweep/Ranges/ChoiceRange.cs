using System.Text.Json;

namespace FootballPhysics.Tool.Sweep.Ranges;

/// <summary>One of some values: drawn from a list, or in turn from a grid.</summary>
internal sealed class ChoiceRange : FieldRange
{
    private readonly double[] _numbers;

    /// <summary>Makes a range.</summary>
    /// <param name="values">The values; at least one.</param>
    /// <param name="isGrid">Whether they come in turn.</param>
    public ChoiceRange(IReadOnlyList<JsonElement> values, bool isGrid)
    {
        Values = values;
        IsGrid = isGrid;
        _numbers = [.. values.Select(value => value.ValueKind == JsonValueKind.Number && value.TryGetDouble(out double number) ? number : double.NaN)];
    }

    public IReadOnlyList<JsonElement> Values { get; }

    public bool IsGrid { get; }

    /// <summary>Rows for which a value of a grid stays: the product of the grids after it.</summary>
    public long Stride { get; set; } = 1;

    /// <summary>Whether all values are numbers.</summary>
    public bool HasNumbers => _numbers.All(double.IsFinite);

    public override IEnumerable<FieldValue> Ends => Values.Select((_, i) => Value(i));

    public override FieldValue Draw(double random, long index) =>
        Value(IsGrid ? (int)(index / Stride % Values.Count) : (int)(random * Values.Count));

    private FieldValue Value(int choice) => new(_numbers[choice], choice);
}
