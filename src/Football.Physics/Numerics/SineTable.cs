using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>Sine and cosine of many angles at once, for sums of waves: by table and a short series, without a branch.</summary>
/// <remarks>Absolute error below 1e-15 for angles of less than a turn; beyond, what rounding of the angle itself adds.</remarks>
internal static class SineTable
{
    private const int Entries = 512;
    private const double TwoPi = 6.28318530717958647693;

    /// <summary>Added to a number below 2⁵¹ it leaves the nearest whole number in the low bits.</summary>
    private const double Rounder = 6755399441055744.0;

    private static readonly Entry[] Table = Make();

    /// <summary>Sine and cosine of an angle.</summary>
    /// <param name="turns">The angle over 2π; size below 4e12.</param>
    /// <param name="sin">Its sine.</param>
    /// <param name="cos">Its cosine.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void SinCos(double turns, out double sin, out double cos)
    {
        double scaled = Entries * turns;
        double rounded = scaled + Rounder;
        ref readonly Entry entry = ref Table[(int)BitConverter.DoubleToInt64Bits(rounded) & (Entries - 1)];

        // sin(a + r) = sin a cos r + cos a sin r with |r| ≤ π/512, whose series end below 1e-16
        double r = (scaled - (rounded - Rounder)) * (TwoPi / Entries);
        double z = r * r;
        double rise = r - (r * z * ((1.0 / 6.0) - (z * (1.0 / 120.0))));
        double fall = z * (0.5 - (z * (1.0 / 24.0)));
        sin = entry.Sin + ((entry.Cos * rise) - (entry.Sin * fall));
        cos = entry.Cos - ((entry.Sin * rise) + (entry.Cos * fall));
    }

    private static Entry[] Make()
    {
        var table = new Entry[Entries];
        for (int i = 0; i < table.Length; i++)
        {
            Elementary.SinCos(TwoPi * i / Entries, out table[i].Sin, out table[i].Cos);
        }

        return table;
    }

    private struct Entry
    {
        public double Sin;
        public double Cos;
    }
}
