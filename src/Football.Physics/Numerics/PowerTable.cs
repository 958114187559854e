using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>x^q for one fixed exponent q, by table: the exponent bits of x choose a scale, its top mantissa bits a cubic.</summary>
/// <remarks>Relative error below 3e-12 for 0 ≤ q ≤ 2 over all normal x ≥ 0; no division, no square root, no branch.</remarks>
internal sealed class PowerTable
{
    private const int SegmentBits = 7;
    private const int Segments = 1 << SegmentBits;

    private readonly double[] _scale = new double[2048];
    private readonly Cubic[] _segment = new Cubic[Segments];

    /// <summary>Builds the table of x^q.</summary>
    /// <param name="q">The exponent.</param>
    public PowerTable(double q)
    {
        const double Ln2 = 0.69314718055994530942;
        for (int e = 0; e < _scale.Length; e++)
        {
            _scale[e] = Elementary.Exp(q * (e - 1023) * Ln2);
        }

        // A zero or denormal argument has no leading 1: the power of anything that small is taken as zero.
        _scale[0] = q > 0 ? 0 : _scale[0];
        for (int i = 0; i < Segments; i++)
        {
            _segment[i] = Cubic.Fit(q, 1.0 + ((double)i / Segments), 1.0 + ((i + 1.0) / Segments));
        }
    }

    /// <summary>x^q for x ≥ 0.</summary>
    /// <param name="x">The argument, not negative.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double Of(double x)
    {
        long bits = BitConverter.DoubleToInt64Bits(x);
        ref readonly Cubic c = ref _segment[(int)(bits >> (52 - SegmentBits)) & (Segments - 1)];
        double m = BitConverter.Int64BitsToDouble((bits & 0x000FFFFFFFFFFFFFL) | 0x3FF0000000000000L);
        return _scale[(int)(bits >> 52) & 2047] * (c.A + (m * (c.B + (m * (c.C + (m * c.D))))));
    }

    /// <summary>A + B m + C m² + D m³.</summary>
    private readonly struct Cubic
    {
        public readonly double A;
        public readonly double B;
        public readonly double C;
        public readonly double D;

        private Cubic(double a, double b, double c, double d)
        {
            A = a;
            B = b;
            C = c;
            D = d;
        }

        /// <summary>The cubic through m^q at the four Chebyshev points of [low, high], by divided differences.</summary>
        public static Cubic Fit(double q, double low, double high)
        {
            const double Outer = 0.92387953251128673848; // cos(π/8)
            const double Inner = 0.38268343236508978178; // cos(3π/8)
            double mid = 0.5 * (low + high);
            double half = 0.5 * (high - low);
            double x0 = mid - (half * Outer);
            double x1 = mid - (half * Inner);
            double x2 = mid + (half * Inner);
            double x3 = mid + (half * Outer);
            double f0 = Elementary.Pow(x0, q);
            double f1 = Elementary.Pow(x1, q);
            double f2 = Elementary.Pow(x2, q);
            double f3 = Elementary.Pow(x3, q);
            double f01 = (f1 - f0) / (x1 - x0);
            double f12 = (f2 - f1) / (x2 - x1);
            double f23 = (f3 - f2) / (x3 - x2);
            double f012 = (f12 - f01) / (x2 - x0);
            double f123 = (f23 - f12) / (x3 - x1);
            double f0123 = (f123 - f012) / (x3 - x0);
            return new Cubic(
                f0 - (f01 * x0) + (f012 * x0 * x1) - (f0123 * x0 * x1 * x2),
                f01 - (f012 * (x0 + x1)) + (f0123 * ((x0 * x1) + (x0 * x2) + (x1 * x2))),
                f012 - (f0123 * (x0 + x1 + x2)),
                f0123);
        }
    }
}
