using System.Text;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Fit.Reading;

/// <summary>Reads the text of a track file; rejects files that are not text.</summary>
internal static class TrackText
{
    /// <summary>The maximum size of a file, in bytes: its text must fit into one string.</summary>
    private const long LongestFile = 1L << 29;

    /// <summary>The first bytes of binary files that are often passed instead of a table, with advice on conversion.</summary>
    private static readonly (byte[] First, string Kind, string Advice)[] s_others =
    [
        ([0x50, 0x4B, 3, 4], "a ZIP archive or a spreadsheet", "Unpack it, or save it as CSV"),
        ([0x1F, 0x8B], "compressed with gzip", "Unpack it with gunzip"),
        ([0x50, 0x41, 0x52, 0x31], "a Parquet file", "Write it as CSV, such as by pandas.read_parquet(…).to_csv(…)"),
        ([0x89, 0x48, 0x44, 0x46], "an HDF5 file", "Write the track as CSV"),
    ];

    /// <summary>Reads the text.</summary>
    /// <param name="stream">The file, or standard input, whose length is unknown.</param>
    /// <param name="longest">The maximum size, in bytes.</param>
    public static string Read(Stream stream, long longest = LongestFile)
    {
        if (stream.CanSeek && stream.Length > longest)
        {
            throw TooLong(FormattableString.Invariant($"{stream.Length} bytes"), longest);
        }

        using var bytes = new MemoryStream();
        byte[] part = new byte[64 * 1024];
        for (int read = stream.Read(part); read > 0; read = stream.Read(part))
        {
            bytes.Write(part, 0, read);
            if (bytes.Length > longest)
            {
                throw TooLong(FormattableString.Invariant($"more than {longest} bytes"), longest);
            }
        }

        ReadOnlySpan<byte> content = bytes.GetBuffer().AsSpan(0, (int)bytes.Length);
        foreach ((byte[] first, string kind, string advice) in s_others)
        {
            if (content.StartsWith(first))
            {
                throw new RefusedException($"TRACK is {kind}. {advice}.");
            }
        }

        bytes.Position = 0;
        using var reader = new StreamReader(bytes, Utf16(content) ?? Encoding.UTF8, detectEncodingFromByteOrderMarks: true);
        string text = reader.ReadToEnd();
        return text.Contains('\0', StringComparison.Ordinal) ? throw new RefusedException("TRACK contains zero bytes. Write it as text in UTF-8.") : text.TrimStart('\uFEFF');
    }

    private static RefusedException TooLong(string length, long longest) => new("TRACK", length, FormattableString.Invariant($"at most {longest} bytes"));

    /// <summary>Returns UTF-16 without a byte order mark if every second one of the first bytes is zero; otherwise null.</summary>
    private static UnicodeEncoding? Utf16(ReadOnlySpan<byte> content)
    {
        if (content.Length < 16)
        {
            return null;
        }

        int even = 0;
        int odd = 0;
        for (int i = 0; i < 16; i++)
        {
            (even, odd) = content[i] != 0 ? (even, odd) : i % 2 == 0 ? (even + 1, odd) : (even, odd + 1);
        }

        return (even, odd) switch
        {
            (8, 0) => new UnicodeEncoding(bigEndian: true, byteOrderMark: false),
            (0, 8) => new UnicodeEncoding(bigEndian: false, byteOrderMark: false),
            _ => null,
        };
    }
}
