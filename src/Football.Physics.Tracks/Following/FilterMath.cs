namespace FootballPhysics.Tracks;

/// <summary>Covariances of a filter.</summary>
internal static class FilterMath
{
    private const int Motion = FilterHypothesis.Motion;
    private const int Most = FilterHypothesis.Most;

    /// <summary>Multiplies a symmetric matrix of the parameters and three rows of derivatives, one beside the other.</summary>
    public static void Multiply(ReadOnlySpan<double> matrix, ReadOnlySpan<double> rows, Span<double> products, int n)
    {
        ReadOnlySpan<double> a = rows.Slice(0, n);
        ReadOnlySpan<double> b = rows.Slice(Most, n);
        ReadOnlySpan<double> c = rows.Slice(2 * Most, n);
        for (int i = 0; i < n; i++)
        {
            ReadOnlySpan<double> line = matrix.Slice(i * Most, n);
            (double x, double y, double z) = (0, 0, 0);
            for (int j = 0; j < n; j++)
            {
                double value = line[j];
                x += value * a[j];
                y += value * b[j];
                z += value * c[j];
            }

            (products[i], products[Most + i], products[(2 * Most) + i]) = (x, y, z);
        }
    }

    /// <summary>Computes the covariance of the motion at a moment, J P Jᵀ.</summary>
    public static void Covariance(FilterMoment moment, int count, double[] covariance)
    {
        Span<double> half = stackalloc double[Motion * Most];
        for (int i = 0; i < Motion; i += 3)
        {
            Multiply(moment.Spread, moment.Jacobian.AsSpan(i * Most, 3 * Most), half.Slice(i * Most, 3 * Most), count);
        }

        for (int i = 0; i < Motion; i++)
        {
            ReadOnlySpan<double> line = half.Slice(i * Most, count);
            for (int j = 0; j <= i; j++)
            {
                ReadOnlySpan<double> by = moment.Jacobian.AsSpan(j * Most, count);
                double sum = 0;
                for (int k = 0; k < count; k++)
                {
                    sum += line[k] * by[k];
                }

                covariance[(i * Motion) + j] = sum;
                covariance[(j * Motion) + i] = sum;
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
