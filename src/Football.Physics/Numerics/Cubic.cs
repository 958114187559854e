using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>A + B x + C x² + D x³.</summary>
internal readonly struct Cubic
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

    /// <summary>The cubic through a function at the four Chebyshev points of an interval, by divided differences.</summary>
    public static Cubic Through(Func<double, double> f, double low, double high)
    {
        const double Outer = 0.92387953251128673848; // cos(π/8)
        const double Inner = 0.38268343236508978178; // cos(3π/8)
        double mid = 0.5 * (low + high);
        double half = 0.5 * (high - low);
        double x0 = mid - (half * Outer);
        double x1 = mid - (half * Inner);
        double x2 = mid + (half * Inner);
        double x3 = mid + (half * Outer);
        double f0 = f(x0);
        double f1 = f(x1);
        double f2 = f(x2);
        double f3 = f(x3);
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

    /// <summary>Its value.</summary>
    /// <param name="x">Where.</param>
    /// <param name="squared">x².</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double At(double x, double squared) => (A + (B * x)) + (squared * (C + (D * x)));
}
