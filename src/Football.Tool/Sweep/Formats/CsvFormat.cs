using System.Buffers;
using System.Buffers.Text;
using System.Text;
using FootballPhysics.Tool.Sweep.Columns;

namespace FootballPhysics.Tool.Sweep.Formats;

/// <summary>CSV (RFC 4180): a line of names, then one line of values per row. A missing value is empty.</summary>
internal sealed class CsvFormat(IReadOnlyList<Column> columns) : RowFormat
{
    /// <summary>The maximum length of a number, in bytes.</summary>
    private const int LongestNumber = 32;

    private readonly byte[][][] _words = [.. columns.Select(column => column.Words.Select(word => Encoding.UTF8.GetBytes(Quoted(word))).ToArray())];

    public override string Name => "csv";

    public override IReadOnlyList<string> Files { get; } = ["rows.csv"];

    public override string FileOf(Column column) => Files[0];

    public override byte[] Header(int file, long rows) =>
        Encoding.UTF8.GetBytes(string.Join(',', columns.SelectMany(column => column.Labels).Select(Quoted)) + "\n");

    public override long? Bytes(long rows) => null;

    public override void Write(IReadOnlyList<ColumnData> columns, int rows, IReadOnlyList<ArrayBufferWriter<byte>> to)
    {
        ArrayBufferWriter<byte> text = to[0];
        for (int row = 0; row < rows; row++)
        {
            for (int c = 0; c < columns.Count; c++)
            {
                ColumnData column = columns[c];
                int size = column.Column.Size;
                for (int i = 0; i < size; i++)
                {
                    text.Write(c == 0 && i == 0 ? ""u8 : ","u8);
                    Write(text, column, _words[c], (row * size) + i);
                }
            }

            text.Write("\n"u8);
        }
    }

    private static void Write(ArrayBufferWriter<byte> text, ColumnData column, byte[][] words, int place)
    {
        int written = 0;
        switch (column.Column.Kind)
        {
            case ColumnKind.Word:
                text.Write(column.Column.CanMiss && column.Words[place] == Column.Missing ? [] : words[column.Words[place]]);
                return;
            case ColumnKind.Whole:
                Utf8Formatter.TryFormat(column.Wholes[place], text.GetSpan(LongestNumber), out written);
                break;
            default:
                if (double.IsFinite(column.Reals[place]))
                {
                    Utf8Formatter.TryFormat(column.Reals[place], text.GetSpan(LongestNumber), out written);
                }

                break;
        }

        text.Advance(written);
    }

    /// <summary>Returns a word as a cell. A word that a spreadsheet would read as a formula gets an apostrophe in front, as in spreadsheets.</summary>
    private static string Quoted(string word)
    {
        string text = word.Length > 0 && "=+-@\t\r".Contains(word[0], StringComparison.Ordinal) ? "'" + word : word;
        return text.AsSpan().IndexOfAny(",\"\r\n") >= 0 ? $"\"{text.Replace("\"", "\"\"")}\"" : text;
    }
}
