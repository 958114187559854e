using System.Buffers;
using System.Security.Cryptography;
using System.Text.Encodings.Web;
using System.Text.Json;
using Football.Tool.Sweep.Columns;
using Football.Tool.Sweep.Formats;

namespace Football.Tool.Sweep.Output;

/// <summary>What the columns of a data set are: names, files, types, units, words.</summary>
internal static class Schema
{
    /// <summary>Name of the file.</summary>
    public const string Name = "schema.json";

    private static readonly JsonWriterOptions s_options = new() { Indented = true, NewLine = "\n", Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    /// <summary>The file's record.</summary>
    public static FileRecord Record(byte[] text) => new(Name, text.Length, text.Length, Convert.ToHexStringLower(SHA256.HashData(text)));

    /// <summary>The file's text.</summary>
    public static byte[] Text(IReadOnlyList<Column> columns, RowFormat format)
    {
        var text = new ArrayBufferWriter<byte>();
        using (var json = new Utf8JsonWriter(text, s_options))
        {
            json.WriteStartObject();
            json.WriteStartArray("columns");
            foreach (Column column in columns)
            {
                Write(json, column, format);
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        text.Write("\n"u8);
        return text.WrittenSpan.ToArray();
    }

    private static void Write(Utf8JsonWriter json, Column column, RowFormat format)
    {
        json.WriteStartObject();
        json.WriteString("name", column.Name);
        json.WriteString("file", format.FileOf(column));
        json.WriteString("type", NumpyHeader.TypeOf(column.Kind));
        json.WriteString("unit", column.Unit);
        json.WriteString("meaning", column.Meaning);
        if (column.Axes.Count > 0)
        {
            json.WriteStartArray("axes");
            foreach (IReadOnlyList<string> axis in column.Axes)
            {
                Write(json, axis);
            }

            json.WriteEndArray();
        }

        if (column.Kind == ColumnKind.Word)
        {
            json.WritePropertyName("words");
            Write(json, column.Words);
        }

        json.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter json, IReadOnlyList<string> names)
    {
        json.WriteStartArray();
        foreach (string name in names)
        {
            json.WriteStringValue(name);
        }

        json.WriteEndArray();
    }
}
