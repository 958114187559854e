using System.Buffers;
using System.Buffers.Binary;
using System.Text;
using FootballPhysics.Tool.Sweep.Columns;

namespace FootballPhysics.Tool.Sweep.Formats;

/// <summary>
/// One Parquet file. Each element of a row has a column; words are text with a dictionary. Values are not compressed, and row groups have a fixed
/// number of rows. So the number of rows determines all lengths and the footer with all offsets, and rows can be appended.
/// </summary>
/// <remarks>
/// Format: parquet.apache.org/docs/file-format. A row group has one page per column: DOUBLE and INT64 as PLAIN, words as RLE_DICTIONARY in one
/// bit-packed run of eight bits, after the page of their dictionary. Nothing is compressed, and a missing number is NaN. A column that can miss words is
/// OPTIONAL: one bit per row says whether the row has a word, and the words that exist are stored densely. The run keeps its full length, so that the
/// number of rows alone determines the length; readers stop after the last word. The metadata contain schema.json. Parquet.Net 6.1.0 does not fit here. It writes the metadata of all row groups when its writer ends. It refuses to append to a file
/// whose writer was killed ("not a parquet file"). Its writer takes row groups from one thread only. This class writes row groups of several threads,
/// and continues a file from any checkpoint. It computes the length of a file before the first row, and merges shards without reading their rows.
/// Snappy would save 7 % of random doubles.
/// </remarks>
internal sealed class ParquetFormat(IReadOnlyList<Column> columns) : RowFormat
{
    /// <summary>The number of rows in a row group.</summary>
    public const int GroupRows = 32_768;

    private const int TypeWhole = 2;
    private const int TypeReal = 5;
    private const int TypeBytes = 6;
    private const int EncodingPlain = 0;
    private const int EncodingLevels = 3;
    private const int EncodingDictionary = 8;
    private const int PageData = 0;
    private const int PageDictionary = 2;
    private const int LongestRunHeader = 5;

    /// <summary>The metadata key of the schema with units and meanings (schema.json).</summary>
    private const string SchemaKey = "schema";

    private readonly IReadOnlyList<Column> _columns = columns;
    private readonly List<Leaf> _leaves = [.. columns.SelectMany((column, c) => column.Labels.Select((label, i) => new Leaf(label, column, c, i, Dictionary(column))))];

    public override string Name => "parquet";

    public override IReadOnlyList<string> Files { get; } = ["rows.parquet"];

    public override int RowsAtOnce(int bytes) => GroupRows;

    public override string FileOf(Column column) => Files[0];

    public override byte[] Header(int file, long rows) => Magic.ToArray();

    public override long? Bytes(long rows) => Magic.Length + Groups([rows]).Sum(group => Body(group)) + Footer(0, [rows]).Length;

    public override void Write(IReadOnlyList<ColumnData> columns, int rows, IReadOnlyList<ArrayBufferWriter<byte>> to)
    {
        ArrayBufferWriter<byte> file = to[0];
        foreach (Leaf leaf in _leaves)
        {
            ColumnData column = columns[leaf.Index];
            int size = leaf.Column.Size;
            file.Write(leaf.Dictionary);
            file.Write(PageHeader(leaf, rows));
            Span<byte> page = file.GetSpan(PageBytes(leaf, rows))[..PageBytes(leaf, rows)];
            page.Clear();
            switch (leaf.Column.Kind)
            {
                case ColumnKind.Word:
                    int levels = leaf.Column.CanMiss ? LevelsBegin(page, rows) : 0;
                    int begin = WordsBegin(page, leaf.Column, rows);
                    for (int row = 0; row < rows; row++)
                    {
                        byte word = column.Words[(row * size) + leaf.Place];
                        if (leaf.Column.CanMiss && word == Column.Missing)
                        {
                            continue;
                        }

                        page[begin++] = word;
                        if (leaf.Column.CanMiss)
                        {
                            page[levels + (row / 8)] |= (byte)(1 << (row % 8));
                        }
                    }

                    break;
                case ColumnKind.Whole:
                    for (int row = 0; row < rows; row++)
                    {
                        BinaryPrimitives.WriteInt64LittleEndian(page[(8 * row)..], column.Wholes[(row * size) + leaf.Place]);
                    }

                    break;
                default:
                    for (int row = 0; row < rows; row++)
                    {
                        BinaryPrimitives.WriteDoubleLittleEndian(page[(8 * row)..], column.Reals[(row * size) + leaf.Place]);
                    }

                    break;
            }

            file.Advance(page.Length);
        }
    }

    public override byte[] Footer(int file, IReadOnlyList<long> parts)
    {
        long at = Magic.Length;
        byte[] metadata = new ThriftWriter()
            .Number(1, 2)
            .Structs<Leaf?>(2, [null, .. _leaves], Schema)
            .Number(3, parts.Sum())
            .Structs(4, [.. Groups(parts)], (to, rows) => Group(to, rows, ref at))
            .Structs(5, [Encoding.UTF8.GetString(Output.Schema.Text(_columns, this))], (to, schema) => to.Text(1, SchemaKey).Text(2, schema))
            .Text(6, "football sweep")
            .End();
        byte[] length = new byte[4];
        BinaryPrimitives.WriteInt32LittleEndian(length, metadata.Length);
        return [.. metadata, .. length, .. Magic];
    }

    private static ReadOnlySpan<byte> Magic => "PAR1"u8;

    /// <summary>Returns the number of rows in each row group of a merged file.</summary>
    private static IEnumerable<int> Groups(IReadOnlyList<long> parts)
    {
        foreach (long part in parts)
        {
            for (long left = part; left > 0; left -= GroupRows)
            {
                yield return (int)Math.Min(left, GroupRows);
            }
        }
    }

    /// <summary>Writes a column of the schema; null for the root.</summary>
    private void Schema(ThriftWriter to, Leaf? leaf)
    {
        if (leaf is null)
        {
            to.Text(4, "rows").Number(5, _leaves.Count);
            return;
        }

        // The repetition type REQUIRED (0) or OPTIONAL (1).
        to.Number(1, leaf.Type).Number(3, leaf.Column.CanMiss ? 1 : 0).Text(4, leaf.Name);
        if (leaf.Column.Kind == ColumnKind.Word)
        {
            // The converted type UTF8 (0).
            to.Number(6, 0);
        }
    }

    private void Group(ThriftWriter to, int rows, ref long at)
    {
        long begin = at;
        var places = new List<(Leaf Leaf, long At)>();
        foreach (Leaf leaf in _leaves)
        {
            places.Add((leaf, begin));
            begin += Length(leaf, rows);
        }

        at = begin;
        to.Structs(1, places, (chunk, place) => chunk.Number(2, place.At).Struct(3, about => Chunk(about, place.Leaf, place.At, rows)))
            .Number(2, (long)Body(rows))
            .Number(3, (long)rows);
    }

    private static void Chunk(ThriftWriter to, Leaf leaf, long at, int rows)
    {
        bool words = leaf.Column.Kind == ColumnKind.Word;
        to.Number(1, leaf.Type);
        if (words)
        {
            to.Numbers(2, EncodingPlain, EncodingLevels, EncodingDictionary);
        }
        else
        {
            to.Numbers(2, EncodingPlain, EncodingLevels);
        }

        to.Texts(3, leaf.Name).Number(4, 0).Number(5, (long)rows).Number(6, (long)Length(leaf, rows)).Number(7, (long)Length(leaf, rows)).Number(9, at + leaf.Dictionary.Length);
        if (words)
        {
            to.Number(11, at);
        }
    }

    private int Body(int rows) => _leaves.Sum(leaf => Length(leaf, rows));

    /// <summary>Returns the length of a column in a row group, in bytes.</summary>
    private static int Length(Leaf leaf, int rows) => leaf.Dictionary.Length + PageHeader(leaf, rows).Length + PageBytes(leaf, rows);

    private static int PageBytes(Leaf leaf, int rows)
    {
        if (leaf.Column.Kind != ColumnKind.Word)
        {
            return 8 * rows;
        }

        Span<byte> header = stackalloc byte[LongestRunHeader];
        return (leaf.Column.CanMiss ? LevelsBytes(rows) : 0) + Run(header, rows) + 1 + (8 * ((rows + 7) / 8));
    }

    /// <summary>Returns the length of the bits that say which rows have a word: a length of four bytes, and one bit-packed run.</summary>
    private static int LevelsBytes(int rows)
    {
        Span<byte> header = stackalloc byte[LongestRunHeader];
        return sizeof(int) + Run(header, rows) + ((rows + 7) / 8);
    }

    /// <summary>Writes the length of these bits and the header of their run.</summary>
    /// <returns>The offset of the bits.</returns>
    private static int LevelsBegin(Span<byte> page, int rows)
    {
        BinaryPrimitives.WriteInt32LittleEndian(page, LevelsBytes(rows) - sizeof(int));
        return sizeof(int) + Run(page[sizeof(int)..], rows);
    }

    /// <summary>Writes the bit width of an index and the header of the run.</summary>
    /// <returns>The offset of the indices.</returns>
    private static int WordsBegin(Span<byte> page, Column column, int rows)
    {
        int at = column.CanMiss ? LevelsBytes(rows) : 0;
        page[at] = 8;
        return at + 1 + Run(page[(at + 1)..], rows);
    }

    /// <summary>Writes the length of a bit-packed run of all rows. The length counts groups of eight; its lowest bit marks a bit-packed run.</summary>
    /// <returns>The length of the header.</returns>
    private static int Run(Span<byte> to, int rows)
    {
        int place = 0;
        uint run = (((uint)rows + 7) / 8 << 1) | 1;
        for (; run >= 0x80; run >>= 7)
        {
            to[place++] = (byte)(run | 0x80);
        }

        to[place++] = (byte)run;
        return place;
    }

    private static byte[] PageHeader(Leaf leaf, int rows) => new ThriftWriter()
        .Number(1, PageData)
        .Number(2, PageBytes(leaf, rows))
        .Number(3, PageBytes(leaf, rows))
        .Struct(5, page => page.Number(1, rows).Number(2, leaf.Column.Kind == ColumnKind.Word ? EncodingDictionary : EncodingPlain).Number(3, EncodingLevels).Number(4, EncodingLevels))
        .End();

    /// <summary>Returns the page with the words of a column; empty for a column without words.</summary>
    private static byte[] Dictionary(Column column)
    {
        if (column.Kind != ColumnKind.Word)
        {
            return [];
        }

        var words = new ArrayBufferWriter<byte>();
        foreach (string word in column.Words)
        {
            byte[] bytes = Encoding.UTF8.GetBytes(word);
            BinaryPrimitives.WriteInt32LittleEndian(words.GetSpan(4), bytes.Length);
            words.Advance(4);
            words.Write(bytes);
        }

        byte[] header = new ThriftWriter()
            .Number(1, PageDictionary)
            .Number(2, words.WrittenCount)
            .Number(3, words.WrittenCount)
            .Struct(7, page => page.Number(1, column.Words.Count).Number(2, EncodingPlain))
            .End();
        return [.. header, .. words.WrittenSpan];
    }

    /// <summary>A column of the file: one element of a column's value.</summary>
    /// <param name="Name">The name.</param>
    /// <param name="Column">The column.</param>
    /// <param name="Index">The index of the column.</param>
    /// <param name="Place">The index of the element.</param>
    /// <param name="Dictionary">The page of the words with its header.</param>
    private sealed record Leaf(string Name, Column Column, int Index, int Place, byte[] Dictionary)
    {
        public int Type => Column.Kind switch
        {
            ColumnKind.Word => TypeBytes,
            ColumnKind.Whole => TypeWhole,
            _ => TypeReal,
        };
    }
}
