namespace FootballPhysics;

/// <summary>The normal distribution: its integral, numbers drawn from it, and the chance of a rectangle in two dimensions.</summary>
internal static class NormalDistribution
{
    /// <summary>Beyond this many standard deviations there is nothing.</summary>
    private const double Farthest = 8;

    /// <summary>Intervals of Simpson's rule, even.</summary>
    private const int Intervals = 200;

    /// <summary>½ ln 2π.</summary>
    private const double HalfLogTwoPi = 0.91893853320467274178;

    /// <summary>Φ(x), by Φ = ½ + φ(x)(x + x³/3 + x⁵/(3·5) + …), to about 1e-15.</summary>
    public static double Integral(double x)
    {
        if (!(Math.Abs(x) < Farthest))
        {
            return x > 0 ? 1 : 0;
        }

        // Each term is the last times x²/n: all of one sign, so that nothing cancels.
        double sum = x;
        double term = x;
        double square = x * x;
        for (double n = 3; Math.Abs(term) > 1e-17 * Math.Abs(sum); n += 2)
        {
            term *= square / n;
            sum += term;
        }

        return 0.5 + (sum * Elementary.Exp((-0.5 * square) - HalfLogTwoPi));
    }

    /// <summary>Two independent numbers, from two that are uniform in 0 … 1 (Box and Muller).</summary>
    public static void Draw(double first, double second, out double a, out double b)
    {
        // 1 − u is never 0, whose logarithm there is none of.
        double radius = Math.Sqrt(-2.0 * Elementary.Log(1.0 - first));
        Elementary.SinCos(2.0 * Math.PI * second, out double sine, out double cosine);
        a = radius * cosine;
        b = radius * sine;
    }

    /// <summary>The chance that x is within x₀ … x₁ and y within y₀ … y₁: ∫ φ(x) (Φ((y₁ − μ(x))/s) − Φ((y₀ − μ(x))/s)) dx by Simpson's rule.</summary>
    /// <param name="meanX">Mean of x.</param>
    /// <param name="meanY">Mean of y.</param>
    /// <param name="deviationX">Standard deviation of x.</param>
    /// <param name="deviationY">That of y.</param>
    /// <param name="correlation">Their correlation.</param>
    /// <param name="x0">x₀.</param>
    /// <param name="x1">x₁.</param>
    /// <param name="y0">y₀.</param>
    /// <param name="y1">y₁.</param>
    public static double Rectangle(
        double meanX, double meanY, double deviationX, double deviationY, double correlation, double x0, double x1, double y0, double y1)
    {
        if (!(x1 > x0) || !(y1 > y0))
        {
            return 0;
        }

        // A deviation of 0 is a very small one: the rectangle is then hit or not.
        double spread = Math.Max(deviationX, 1e-12);

        // Only where the density is not nothing.
        double low = Math.Max((x0 - meanX) / spread, -Farthest);
        double high = Math.Min((x1 - meanX) / spread, Farthest);
        if (!(high > low))
        {
            return 0;
        }

        // Given x, y is normal about μ_y + ρ σ_y x with deviation σ_y √(1 − ρ²).
        double rest = Math.Max(1e-12, deviationY * Math.Sqrt(Math.Max(0, 1.0 - (correlation * correlation))));
        double width = (high - low) / Intervals;
        double sum = 0;
        for (int i = 0; i <= Intervals; i++)
        {
            double x = low + (i * width);
            double middle = meanY + (correlation * deviationY * x);
            double inside = Integral((y1 - middle) / rest) - Integral((y0 - middle) / rest);

            // Simpson: 1, 4, 2, 4, …, 4, 1.
            double weight = i == 0 || i == Intervals ? 1 : (i & 1) != 0 ? 4 : 2;
            sum += weight * inside * Elementary.Exp((-0.5 * x * x) - HalfLogTwoPi);
        }

        return width / 3.0 * sum;
    }
}
