using System.Buffers;
using System.Text.Encodings.Web;
using System.Text.Json;
using FootballPhysics.Tool.Sweep.Columns;

namespace FootballPhysics.Tool.Sweep.Formats;

/// <summary>JSON: one object per line. A missing value is null.</summary>
internal sealed class NdjsonFormat : RowFormat
{
    private static readonly JsonWriterOptions s_options = new() { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    public override string Name => "ndjson";

    public override IReadOnlyList<string> Files { get; } = ["rows.ndjson"];

    public override string FileOf(Column column) => Files[0];

    public override byte[] Header(int file, long rows) => [];

    public override long? Bytes(long rows) => null;

    public override void Write(IReadOnlyList<ColumnData> columns, int rows, IReadOnlyList<ArrayBufferWriter<byte>> to)
    {
        using var json = new Utf8JsonWriter(to[0], s_options);
        for (int row = 0; row < rows; row++)
        {
            json.WriteStartObject();
            foreach (ColumnData column in columns)
            {
                json.WritePropertyName(column.Column.Name);
                int place = row * column.Column.Size;
                Write(json, column, 0, ref place);
            }

            json.WriteEndObject();
            json.Flush();
            json.Reset();
            to[0].Write("\n"u8);
        }
    }

    private static void Write(Utf8JsonWriter json, ColumnData column, int axis, ref int place)
    {
        if (axis == column.Column.Axes.Count)
        {
            WriteValue(json, column, place++);
            return;
        }

        json.WriteStartArray();
        for (int i = 0; i < column.Column.Axes[axis].Count; i++)
        {
            Write(json, column, axis + 1, ref place);
        }

        json.WriteEndArray();
    }

    private static void WriteValue(Utf8JsonWriter json, ColumnData column, int place)
    {
        switch (column.Column.Kind)
        {
            case ColumnKind.Word when column.Column.CanMiss && column.Words[place] == Column.Missing:
                json.WriteNullValue();
                break;
            case ColumnKind.Word:
                json.WriteStringValue(column.Column.Words[column.Words[place]]);
                break;
            case ColumnKind.Whole:
                json.WriteNumberValue(column.Wholes[place]);
                break;
            default:
                if (double.IsFinite(column.Reals[place]))
                {
                    json.WriteNumberValue(column.Reals[place]);
                }
                else
                {
                    json.WriteNullValue();
                }

                break;
        }
    }
}
