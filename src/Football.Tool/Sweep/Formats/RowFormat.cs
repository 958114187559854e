using System.Buffers;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Sweep.Columns;

namespace FootballPhysics.Tool.Sweep.Formats;

/// <summary>A file format for rows.</summary>
internal abstract class RowFormat
{
    /// <summary>The names of the formats; the first is the default.</summary>
    public static IReadOnlyList<string> Names { get; } = ["ndjson", "csv", "npy", "parquet"];

    public abstract string Name { get; }

    /// <summary>The names of the files.</summary>
    public abstract IReadOnlyList<string> Files { get; }

    /// <summary>Creates a format by its name.</summary>
    public static RowFormat Create(string name, IReadOnlyList<Column> columns) => name switch
    {
        "ndjson" => new NdjsonFormat(),
        "csv" => new CsvFormat(columns),
        "npy" => new NumpyFormat(columns),
        "parquet" => new ParquetFormat(columns),
        _ => throw new RefusedException("--format", Quote.Short(name), string.Join(" | ", Names)),
    };

    /// <summary>Returns the name of the file that contains a column.</summary>
    public abstract string FileOf(Column column);

    /// <summary>Returns the header of a file.</summary>
    /// <param name="file">The index in <see cref="Files"/>.</param>
    /// <param name="rows">The number of rows that will follow.</param>
    public abstract byte[] Header(int file, long rows);

    /// <summary>Returns the number of rows that a thread computes and writes at a time: about one megabyte, at most 4096 rows.</summary>
    /// <param name="bytes">The size of a row, in bytes.</param>
    public virtual int RowsAtOnce(int bytes) => Math.Clamp((1 << 20) / bytes, 1, 4096);

    /// <summary>Returns the footer of a complete file.</summary>
    /// <param name="file">The index in <see cref="Files"/>.</param>
    /// <param name="parts">The number of rows in each part of a merged file; one part if the file is not merged.</param>
    public virtual byte[] Footer(int file, IReadOnlyList<long> parts) => [];

    /// <summary>Returns the total size of all files, in bytes; null if it is unknown before they are written.</summary>
    public abstract long? Bytes(long rows);

    /// <summary>Writes rows.</summary>
    /// <param name="columns">The values.</param>
    /// <param name="rows">The number of rows.</param>
    /// <param name="to">The buffer of each of <see cref="Files"/>.</param>
    public abstract void Write(IReadOnlyList<ColumnData> columns, int rows, IReadOnlyList<ArrayBufferWriter<byte>> to);
}
