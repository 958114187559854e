using System.Runtime.CompilerServices;

namespace FootballPhysics.Numerics;

/// <summary>ln x by table lookup, for use in every stage of a step.</summary>
/// <remarks>
/// The exponent bits of x select a constant, its top mantissa bits a cubic. The absolute error is below 1e-11 for all positive normal x; no division, no branch.
/// </remarks>
internal static class LogarithmTable
{
    private const int SegmentBits = 7;
    private const double Ln2 = 0.69314718055994530942;

    private static readonly Cubic[] Segments = Make();

    /// <summary>Returns ln x.</summary>
    /// <param name="x">The argument, positive and normal.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Of(double x)
    {
        // x = 2^e m with 1 ≤ m < 2: ln x = e ln 2 + ln m.
        long bits = BitConverter.DoubleToInt64Bits(x);
        ref readonly Cubic c = ref Segments[(int)(bits >> (52 - SegmentBits)) & ((1 << SegmentBits) - 1)];
        double m = BitConverter.Int64BitsToDouble((bits & 0x000FFFFFFFFFFFFFL) | 0x3FF0000000000000L);
        return (((bits >> 52) - 1023L) * Ln2) + c.At(m, m * m);
    }

    private static Cubic[] Make()
    {
        var segments = new Cubic[1 << SegmentBits];
        for (int i = 0; i < segments.Length; i++)
        {
            segments[i] = Cubic.Through(Elementary.Log, 1.0 + ((double)i / segments.Length), 1.0 + ((i + 1.0) / segments.Length));
        }

        return segments;
    }
}
