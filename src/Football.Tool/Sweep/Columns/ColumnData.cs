using System.Runtime.InteropServices;

namespace FootballPhysics.Tool.Sweep.Columns;

/// <summary>The values of a column for some rows.</summary>
/// <param name="column">The column.</param>
/// <param name="capacity">The maximum number of rows.</param>
internal sealed class ColumnData(Column column, int capacity)
{
    public Column Column { get; } = column;

    /// <summary>The values of a column of real numbers, row by row.</summary>
    public double[] Reals { get; } = column.Kind == ColumnKind.Real ? new double[capacity * column.Size] : [];

    /// <summary>The values of a column of whole numbers, row by row.</summary>
    public long[] Wholes { get; } = column.Kind == ColumnKind.Whole ? new long[capacity * column.Size] : [];

    /// <summary>The values of a column of words, row by row: indices into <see cref="Column.Words"/>, or <see cref="Column.Missing"/>.</summary>
    public byte[] Words { get; } = column.Kind == ColumnKind.Word ? new byte[capacity * column.Size] : [];

    /// <summary>Sets a vector.</summary>
    /// <param name="place">The index of the vector, counted from the first row.</param>
    /// <param name="vector">The vector.</param>
    public void Set(int place, in Vector3d vector)
    {
        Reals[3 * place] = vector.X;
        Reals[(3 * place) + 1] = vector.Y;
        Reals[(3 * place) + 2] = vector.Z;
    }

    /// <summary>Returns the values of the first rows, as stored in memory.</summary>
    public ReadOnlySpan<byte> Bytes(int rows) => Column.Kind switch
    {
        ColumnKind.Real => MemoryMarshal.AsBytes(Reals.AsSpan(0, rows * Column.Size)),
        ColumnKind.Whole => MemoryMarshal.AsBytes(Wholes.AsSpan(0, rows * Column.Size)),
        _ => Words.AsSpan(0, rows * Column.Size),
    };
}
