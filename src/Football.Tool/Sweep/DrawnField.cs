using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Sweep.Columns;
using FootballPhysics.Tool.Sweep.Ranges;

namespace FootballPhysics.Tool.Sweep;

/// <summary>A field that is drawn for every row.</summary>
/// <param name="Path">The field, its parts parted by points.</param>
/// <param name="Range">The range of the random values.</param>
/// <param name="Direct">Which number of a launch or an aim it is; −1 for a field of the scene.</param>
internal sealed record DrawnField(string Path, FieldRange Range, int Direct)
{
    /// <summary>The parts of the field's name.</summary>
    public string[] Parts { get; } = FieldPath.Split(Path);

    /// <summary>The column of a field that is none of a launch or an aim's own.</summary>
    public Column Column => Range is ChoiceRange { HasNumbers: false } choice
        ? Column.Word(Path, "as drawn", [.. choice.Values.Select(value => value.ValueKind == System.Text.Json.JsonValueKind.String ? value.GetString()! : value.GetRawText())])
        : Column.Real(Path, "of the field", "as drawn");
}
