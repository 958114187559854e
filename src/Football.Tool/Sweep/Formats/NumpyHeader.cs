using System.Globalization;
using System.Text;
using FootballPhysics.Tool.Sweep.Columns;

namespace FootballPhysics.Tool.Sweep.Formats;

/// <summary>The header of a .npy file, version 1.0: magic number and version in eight bytes, a length in two bytes, and a Python dictionary.</summary>
internal static class NumpyHeader
{
    /// <summary>The alignment of the data, in bytes.</summary>
    private const int Alignment = 64;

    private const string Shape = "'shape': (";

    private static ReadOnlySpan<byte> Magic => [0x93, (byte)'N', (byte)'U', (byte)'M', (byte)'P', (byte)'Y', 1, 0];

    /// <summary>Returns NumPy's name of a type, little-endian.</summary>
    public static string TypeOf(ColumnKind kind) => kind switch
    {
        ColumnKind.Real => "<f8",
        ColumnKind.Whole => "<i8",
        _ => "|u1",
    };

    /// <summary>Returns the size of a value, in bytes.</summary>
    public static int BytesOf(ColumnKind kind) => kind == ColumnKind.Word ? 1 : 8;

    /// <summary>Returns the header of a column.</summary>
    public static byte[] Of(Column column, long rows) => Of(
        $"{{'descr': '{TypeOf(column.Kind)}', 'fortran_order': False, {Shape}",
        rows,
        $",{string.Join(",", column.Axes.Select(axis => string.Create(CultureInfo.InvariantCulture, $" {axis.Count}")))}), }}");

    /// <summary>Returns the same header for another number of rows.</summary>
    public static byte[] WithRows(ReadOnlySpan<byte> header, long rows)
    {
        string text = Encoding.Latin1.GetString(header[(Magic.Length + 2)..]).TrimEnd();
        int number = text.IndexOf(Shape, StringComparison.Ordinal) + Shape.Length;
        return Of(text[..number], rows, text[text.IndexOf(',', number)..]);
    }

    private static byte[] Of(string before, long rows, string after)
    {
        string text = string.Create(CultureInfo.InvariantCulture, $"{before}{rows}{after}");
        int length = Magic.Length + 2 + text.Length + 1;
        text = text.PadRight(text.Length + ((Alignment - (length % Alignment)) % Alignment)) + "\n";
        return [.. Magic, (byte)text.Length, (byte)(text.Length >> 8), .. Encoding.Latin1.GetBytes(text)];
    }
}
