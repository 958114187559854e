using System.Buffers;
using FootballPhysics.Tool.Sweep.Columns;

namespace FootballPhysics.Tool.Sweep.Formats;

/// <summary>One NumPy array file per column. The first axis of the array is the row.</summary>
internal sealed class NumpyFormat(IReadOnlyList<Column> columns) : RowFormat
{
    public override string Name => "npy";

    public override IReadOnlyList<string> Files { get; } = [.. columns.Select(NameOf)];

    public override string FileOf(Column column) => NameOf(column);

    public override byte[] Header(int file, long rows) => NumpyHeader.Of(columns[file], rows);

    public override long? Bytes(long rows) => columns.Sum(column => NumpyHeader.Of(column, rows).Length + (rows * column.Size * NumpyHeader.BytesOf(column.Kind)));

    public override void Write(IReadOnlyList<ColumnData> columns, int rows, IReadOnlyList<ArrayBufferWriter<byte>> to)
    {
        for (int c = 0; c < columns.Count; c++)
        {
            to[c].Write(columns[c].Bytes(rows));
        }
    }

    private static string NameOf(Column column) => column.Name + ".npy";
}
