using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Sweep.Columns;
using FootballPhysics.Tool.Sweep.Ranges;

namespace FootballPhysics.Tool.Sweep;

/// <summary>A field with a random value in each row.</summary>
/// <param name="Path">The path of the field; its parts are separated by points.</param>
/// <param name="Range">The range of the values.</param>
/// <param name="Direct">The index in <see cref="DirectField.OfLaunch"/> or <see cref="DirectField.OfAim"/>; −1 for a field of the scene.</param>
internal sealed record DrawnField(string Path, FieldRange Range, int Direct)
{
    public string[] Parts { get; } = FieldPath.Split(Path);

    /// <summary>The column of a field of the scene.</summary>
    public Column Column => Range is ChoiceRange { HasNumbers: false } choice
        ? Column.Word(Path, "as drawn", [.. choice.Values.Select(value => value.ValueKind == System.Text.Json.JsonValueKind.String ? value.GetString()! : value.GetRawText())])
        : Column.Real(Path, "of the field", "as drawn");
}
