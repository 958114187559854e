namespace FootballPhysics.Batch;

/// <summary>Approximates functions by polynomials through Chebyshev points.</summary>
/// <remarks>Their error is nearly the smallest possible for the degree (Numerical Recipes, "Chebyshev approximation").</remarks>
internal static class ChebyshevFit
{
    /// <summary>Returns the coefficients, starting with that of x⁰, each rounded to double.</summary>
    /// <param name="function">The function.</param>
    /// <param name="low">The lower end of the interval.</param>
    /// <param name="high">The upper end of the interval.</param>
    /// <param name="degree">The degree of the polynomial.</param>
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

        // Expand Newton's form, f₀ + (x − x₀)(f₀₁ + (x − x₁)(…)), from the inside out.
        var powers = new DoubleDouble[count];
        for (int k = degree; k >= 0; k--)
        {
            for (int i = degree - k; i >= 1; i--)
            {
                powers[i] = powers[i - 1] - (points[k] * powers[i]);
            }

            powers[0] = differences[k] - (points[k] * powers[0]);
        }

        return Array.ConvertAll(powers, power => power.High);
    }
}
