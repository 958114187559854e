namespace FootballPhysics.Numerics;

/// <summary>The normal distribution: its integral, random samples, and the probability of a rectangle in two dimensions.</summary>
internal static class NormalDistribution
{
    /// <summary>The number of standard deviations beyond which the density counts as 0.</summary>
    private const double Farthest = 8;

    /// <summary>The number of intervals of Simpson's rule; even.</summary>
    private const int Intervals = 200;

    /// <summary>½ ln 2π.</summary>
    private const double HalfLogTwoPi = 0.91893853320467274178;

    /// <summary>Returns Φ(x) = ½ + φ(x)(x + x³/3 + x⁵/(3·5) + …), with an error of about 1e-15.</summary>
    public static double Integral(double x)
    {
        if (!(Math.Abs(x) < Farthest))
        {
            return x > 0 ? 1 : 0;
        }

        // Each term is the previous one times x²/n. All terms have the same sign, so there is no cancellation.
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

    /// <summary>Draws two independent normal numbers from two uniform ones in 0 … 1 (Box and Muller).</summary>
    public static void Draw(double first, double second, out double a, out double b)
    {
        // 1 − u is never 0, so the logarithm is finite.
        double radius = Math.Sqrt(-2.0 * Elementary.Log(1.0 - first));
        Elementary.SinCos(2.0 * Math.PI * second, out double sine, out double cosine);
        a = radius * cosine;
        b = radius * sine;
    }

    /// <summary>Returns the probability that x is within x₀ … x₁ and y within y₀ … y₁.</summary>
    /// <remarks>∫ φ(x) (Φ((y₁ − μ(x))/s) − Φ((y₀ − μ(x))/s)) dx by Simpson's rule.</remarks>
    /// <param name="meanX">The mean of x.</param>
    /// <param name="meanY">The mean of y.</param>
    /// <param name="deviationX">The standard deviation of x.</param>
    /// <param name="deviationY">The standard deviation of y.</param>
    /// <param name="correlation">The correlation of x and y.</param>
    /// <param name="x0">The lower bound x₀.</param>
    /// <param name="x1">The upper bound x₁.</param>
    /// <param name="y0">The lower bound y₀.</param>
    /// <param name="y1">The upper bound y₁.</param>
    public static double Rectangle(
        double meanX, double meanY, double deviationX, double deviationY, double correlation, double x0, double x1, double y0, double y1)
    {
        if (!(x1 > x0) || !(y1 > y0))
        {
            return 0;
        }

        // Replace a standard deviation of 0 by a tiny one: the probability is then 0 or 1.
        double spread = Math.Max(deviationX, 1e-12);

        // Restrict the integral to the range in which the density is not negligible.
        double low = Math.Max((x0 - meanX) / spread, -Farthest);
        double high = Math.Min((x1 - meanX) / spread, Farthest);
        if (!(high > low))
        {
            return 0;
        }

        // μ_y and σ_y are mean and standard deviation of y, and ρ is the correlation; x is in standard deviations from its mean.
        // For a given x, y is normal with mean μ_y + ρ σ_y x and standard deviation σ_y √(1 − ρ²).
        double rest = Math.Max(1e-12, deviationY * Math.Sqrt(Math.Max(0, 1.0 - (correlation * correlation))));
        double width = (high - low) / Intervals;
        double sum = 0;
        for (int i = 0; i <= Intervals; i++)
        {
            double x = low + (i * width);
            double middle = meanY + (correlation * deviationY * x);
            double inside = Integral((y1 - middle) / rest) - Integral((y0 - middle) / rest);

            // Simpson's weights: 1, 4, 2, 4, …, 4, 1.
            double weight = i == 0 || i == Intervals ? 1 : (i & 1) != 0 ? 4 : 2;
            sum += weight * inside * Elementary.Exp((-0.5 * x * x) - HalfLogTwoPi);
        }

        return width / 3.0 * sum;
    }
}
