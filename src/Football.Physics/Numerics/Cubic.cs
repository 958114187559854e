using System.Runtime.CompilerServices;

namespace FootballPhysics.Numerics;

/// <summary>The cubic polynomial A + B x + C x² + D x³.</summary>
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

    /// <summary>Returns the cubic through a function at the four Chebyshev points of an interval.</summary>
    public static Cubic Through(Func<double, double> f, double low, double high)
    {
        var at = new ChebyshevPoints(low, high);
        return Through(in at, f(at.X0), f(at.X1), f(at.X2), f(at.X3));
    }

    /// <summary>Returns the cubic through values at four Chebyshev points, by divided differences.</summary>
    public static Cubic Through(in ChebyshevPoints at, double f0, double f1, double f2, double f3)
    {
        double x0 = at.X0;
        double x1 = at.X1;
        double x2 = at.X2;
        double x3 = at.X3;

        // Newton's table: compute each column from the previous one.
        double f01 = (f1 - f0) / (x1 - x0);
        double f12 = (f2 - f1) / (x2 - x1);
        double f23 = (f3 - f2) / (x3 - x2);
        double f012 = (f12 - f01) / (x2 - x0);
        double f123 = (f23 - f12) / (x3 - x1);
        double f0123 = (f123 - f012) / (x3 - x0);

        // Expand f₀ + (x − x₀)(f₀₁ + (x − x₁)(f₀₁₂ + (x − x₂) f₀₁₂₃)).
        return new Cubic(
            f0 - (f01 * x0) + (f012 * x0 * x1) - (f0123 * x0 * x1 * x2),
            f01 - (f012 * (x0 + x1)) + (f0123 * ((x0 * x1) + (x0 * x2) + (x1 * x2))),
            f012 - (f0123 * (x0 + x1 + x2)),
            f0123);
    }

    /// <summary>Evaluates the cubic.</summary>
    /// <param name="x">The argument.</param>
    /// <param name="squared">x².</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double At(double x, double squared) => (A + (B * x)) + (squared * (C + (D * x)));
}
