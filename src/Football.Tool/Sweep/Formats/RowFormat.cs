using System.Buffers;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Sweep.Columns;

namespace FootballPhysics.Tool.Sweep.Formats;

/// <summary>How rows are written.</summary>
internal abstract class RowFormat
{
    /// <summary>The formats' names, the default first.</summary>
    public static IReadOnlyList<string> Names { get; } = ["ndjson", "csv", "npy", "parquet"];

    /// <summary>The format's name.</summary>
    public abstract string Name { get; }

    /// <summary>Names of the files.</summary>
    public abstract IReadOnlyList<string> Files { get; }

    /// <summary>Makes a format by its name.</summary>
    public static RowFormat Create(string name, IReadOnlyList<Column> columns) => name switch
    {
        "ndjson" => new NdjsonFormat(),
        "csv" => new CsvFormat(columns),
        "npy" => new NumpyFormat(columns),
        "parquet" => new ParquetFormat(columns),
        _ => throw new RefusedException("--format", Quote.Short(name), string.Join(" | ", Names)),
    };

    /// <summary>The file of a column.</summary>
    public abstract string FileOf(Column column);

    /// <summary>The header of a file.</summary>
    /// <param name="file">Which of <see cref="Files"/>.</param>
    /// <param name="rows">Rows that will follow.</param>
    public abstract byte[] Header(int file, long rows);

    /// <summary>How many rows a thread makes and writes at a time: about a megabyte, and at most 4 096.</summary>
    /// <param name="bytes">Bytes of a row.</param>
    public virtual int RowsAtOnce(int bytes) => Math.Clamp((1 << 20) / bytes, 1, 4096);

    /// <summary>The footer of a complete file.</summary>
    /// <param name="file">Which of <see cref="Files"/>.</param>
    /// <param name="parts">Rows of each part that the file was put together of: one, but for merged shards.</param>
    public virtual byte[] Footer(int file, IReadOnlyList<long> parts) => [];

    /// <summary>The total size of all files in bytes; null if it is unknown before they are written.</summary>
    public abstract long? Bytes(long rows);

    /// <summary>Writes rows.</summary>
    /// <param name="columns">Their values.</param>
    /// <param name="rows">How many.</param>
    /// <param name="to">One for each of <see cref="Files"/>.</param>
    public abstract void Write(IReadOnlyList<ColumnData> columns, int rows, IReadOnlyList<ArrayBufferWriter<byte>> to);
}
