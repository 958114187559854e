namespace FootballPhysics.Tool.Sweep.Columns;

/// <summary>A possible column, and the source of its values.</summary>
/// <param name="Column">The column.</param>
/// <param name="Fill">Sets the values of some rows: the parameters are the first row and the number of rows.</param>
/// <param name="IsDefault">True if the column is written when the input does not choose columns. Default true.</param>
internal sealed record ColumnSource(Column Column, Action<ColumnData, int, int> Fill, bool IsDefault = true);
