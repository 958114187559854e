namespace FootballPhysics.Tracks;

/// <summary>Covariances of a filter.</summary>
internal static class FilterMath
{
    private const int Motion = FilterHypothesis.Motion;
    private const int Most = FilterHypothesis.Most;

    /// <summary>Computes the covariance of the motion at a moment, J P Jᵀ.</summary>
    public static void Covariance(FilterMoment moment, int count, double[] covariance)
    {
        Span<double> half = stackalloc double[Motion * Most];
        for (int i = 0; i < Motion; i++)
        {
            for (int j = 0; j < count; j++)
            {
                double sum = 0;
                for (int k = 0; k < count; k++)
                {
                    sum += moment.Jacobian[(i * Most) + k] * moment.Spread[(k * Most) + j];
                }

                half[(i * Most) + j] = sum;
            }
        }

        for (int i = 0; i < Motion; i++)
        {
            for (int j = 0; j < Motion; j++)
            {
                double sum = 0;
                for (int k = 0; k < count; k++)
                {
                    sum += half[(i * Most) + k] * moment.Jacobian[(j * Most) + k];
                }

                covariance[(i * Motion) + j] = sum;
            }
        }
    }

    /// <summary>Factorizes a covariance into a lower triangle; a direction without a variance becomes 0.</summary>
    public static void Factorize(double[] matrix, int n)
    {
        for (int j = 0; j < n; j++)
        {
            double pivot = matrix[(j * n) + j];
            double least = 1e-12 * pivot;
            for (int k = 0; k < j; k++)
            {
                pivot -= matrix[(j * n) + k] * matrix[(j * n) + k];
            }

            double root = pivot > least ? Math.Sqrt(pivot) : 0;
            for (int i = j; i < n; i++)
            {
                double value = matrix[(i * n) + j];
                for (int k = 0; k < j; k++)
                {
                    value -= matrix[(i * n) + k] * matrix[(j * n) + k];
                }

                matrix[(i * n) + j] = root > 0 ? value / root : 0;
                matrix[(j * n) + i] = i > j ? 0 : matrix[(j * n) + i];
            }
        }
    }
}
