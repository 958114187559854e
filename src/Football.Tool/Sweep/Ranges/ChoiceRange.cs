using System.Text.Json;

namespace FootballPhysics.Tool.Sweep.Ranges;

/// <summary>A choice from several values: at random from a list, or in order from a grid.</summary>
internal sealed class ChoiceRange : FieldRange
{
    private readonly double[] _numbers;

    /// <summary>Creates a range.</summary>
    /// <param name="values">The values, at least one.</param>
    /// <param name="isGrid">True to use the values in order.</param>
    public ChoiceRange(IReadOnlyList<JsonElement> values, bool isGrid)
    {
        Values = values;
        IsGrid = isGrid;
        _numbers = [.. values.Select(value => value.ValueKind == JsonValueKind.Number && value.TryGetDouble(out double number) ? number : double.NaN)];
    }

    public IReadOnlyList<JsonElement> Values { get; }

    public bool IsGrid { get; }

    /// <summary>The number of consecutive rows with the same value of a grid: the product of the sizes of the grids after it.</summary>
    public long Stride { get; set; } = 1;

    /// <summary>True if all values are numbers.</summary>
    public bool HasNumbers => _numbers.All(double.IsFinite);

    public override IEnumerable<FieldValue> Ends => Values.Select((_, i) => Value(i));

    public override FieldValue Draw(double random, long index) =>
        Value(IsGrid ? (int)(index / Stride % Values.Count) : (int)(random * Values.Count));

    private FieldValue Value(int choice) => new(_numbers[choice], choice);
}
