using System.Buffers;
using System.Security.Cryptography;
using System.Text.Encodings.Web;
using System.Text.Json;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Sweep.Columns;
using FootballPhysics.Tool.Sweep.Formats;

namespace FootballPhysics.Tool.Sweep.Output;

/// <summary>The schema of a data set: the names, files, types, units and words of its columns.</summary>
internal static class Schema
{
    /// <summary>The name of the file.</summary>
    public const string Name = "schema.json";

    private static readonly JsonWriterOptions s_options = new() { Indented = true, NewLine = "\n", Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    public static FileRecord Record(byte[] text) => new(Name, text.Length, text.Length, Convert.ToHexStringLower(SHA256.HashData(text)));

    /// <summary>Returns the text of the file.</summary>
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

    /// <summary>Reads the columns of a schema file.</summary>
    /// <exception cref="RefusedException">The file is not a schema.</exception>
    public static IReadOnlyList<Column> Read(string path)
    {
        try
        {
            using var document = JsonDocument.Parse(File.ReadAllBytes(path));
            return [.. document.RootElement.GetProperty("columns").EnumerateArray().Select(Column)];
        }
        catch (Exception e) when (e is IOException or JsonException or InvalidOperationException or KeyNotFoundException)
        {
            throw new RefusedException($"{Quote.File(path)} is not the schema of a sweep. Use one that football sweep wrote.");
        }
    }

    private static Column Column(JsonElement from)
    {
        ColumnKind kind = Enum.GetValues<ColumnKind>().First(kind => NumpyHeader.TypeOf(kind) == from.GetProperty("type").GetString());
        IReadOnlyList<string>[] axes = from.TryGetProperty("axes", out JsonElement along) ? [.. along.EnumerateArray().Select(Names)] : [];
        var column = new Column(from.GetProperty("name").GetString()!, kind, from.GetProperty("unit").GetString()!, from.GetProperty("meaning").GetString()!)
        {
            Words = from.TryGetProperty("words", out JsonElement words) ? Names(words) : [],
            CanMiss = from.TryGetProperty("missing", out _),
        };
        return axes.Reverse().Aggregate(column, (inner, axis) => inner.Along(axis));
    }

    private static IReadOnlyList<string> Names(JsonElement from) => [.. from.EnumerateArray().Select(name => name.GetString()!)];

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
            if (column.CanMiss)
            {
                json.WriteNumber("missing", Columns.Column.Missing);
            }
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
