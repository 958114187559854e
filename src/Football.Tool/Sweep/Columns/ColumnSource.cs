namespace FootballPhysics.Tool.Sweep.Columns;

/// <summary>A column that rows can have, and where its values come from.</summary>
/// <param name="Column">The column.</param>
/// <param name="Fill">Sets its values: from which row on, and of how many.</param>
/// <param name="IsDefault">Whether rows have it where nobody chooses columns.</param>
internal sealed record ColumnSource(Column Column, Action<ColumnData, int, int> Fill, bool IsDefault = true);
