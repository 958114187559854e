namespace FootballPhysics.Batch;

/// <summary>
/// Polynomials near to functions: through their values at the Chebyshev points of an interval, where the error is nearly the least that
/// a polynomial of the degree can have (Numerical Recipes, "Chebyshev approximation").
/// </summary>
internal static class ChebyshevFit
{
    /// <summary>The coefficients, that of x⁰ first, each rounded to double.</summary>
    /// <param name="function">The function.</param>
    /// <param name="low">Lower end of the interval.</param>
    /// <param name="high">Upper end of the interval.</param>
    /// <param name="degree">Degree of the polynomial.</param>
    public static double[] Polynomial(Func<DoubleDouble, DoubleDouble> function, DoubleDouble low, DoubleDouble high, int degree)
    {
        int count = degree + 1;
        var points = new DoubleDouble[count];
        var differences = new DoubleDouble[count];
        DoubleDouble middle = 0.5 * (low + high);
        DoubleDouble half = 0.5 * (high - low);
        for (int i = 0; i < count; i++)
        {
            points[i] = middle - (half * DoubleDouble.Cos(DoubleDouble.Pi * ((2.0 * i) + 1.0) / (2.0 * count)));
            differences[i] = function(points[i]);
        }

        // Newton's divided differences: f[x₀ … x_k] = (f[x₁ … x_k] − f[x₀ … x_(k−1)]) / (x_k − x₀)
        for (int order = 1; order < count; order++)
        {
            for (int i = degree; i >= order; i--)
            {
                differences[i] = (differences[i] - differences[i - 1]) / (points[i] - points[i - order]);
            }
        }

        // Newton's form, f₀ + (x − x₀)(f₀₁ + (x − x₁)(…)), multiplied out from within.
        var powers = new DoubleDouble[count];
        for (int k = degree; k >= 0; k--)
        {
            for (int i = degree - k; i >= 1; i--)
            {
                powers[i] = powers[i - 1] - (points[k] * powers[i]);
            }

            powers[0] = differences[k] - (points[k] * powers[0]);
        }

        double[] coefficients = new double[count];
        for (int i = 0; i < count; i++)
        {
            coefficients[i] = powers[i].High;
        }

        return coefficients;
    }
}
