namespace FootballPhysics.Numerics;

/// <summary>Solves small linear systems.</summary>
internal static class Linear
{
    /// <summary>Solves A x = b, and keeps A and b.</summary>
    /// <param name="a">The matrix, row by row.</param>
    /// <param name="b">The right-hand side.</param>
    /// <param name="x">The solution.</param>
    /// <param name="n">The size of the system.</param>
    /// <returns>False if the matrix is singular.</returns>
    public static bool Solve(double[] a, double[] b, double[] x, int n)
    {
        double[] system = new double[n * (n + 1)];
        for (int i = 0; i < n; i++)
        {
            Array.Copy(a, i * n, system, i * (n + 1), n);
            system[(i * (n + 1)) + n] = b[i];
        }

        return n == 0 || Solve(system, x, n);
    }

    /// <summary>Inverts a matrix column by column. The columns of a singular matrix are zero.</summary>
    /// <param name="a">The matrix, row by row; kept.</param>
    /// <param name="inverse">The inverse.</param>
    /// <param name="n">The size of the matrix.</param>
    public static void Invert(double[] a, double[] inverse, int n)
    {
        double[] unit = new double[n];
        double[] column = new double[n];
        for (int j = 0; j < n; j++)
        {
            Array.Clear(unit, 0, n);
            unit[j] = 1;
            bool solved = Solve(a, unit, column, n);
            for (int i = 0; i < n; i++)
            {
                inverse[(i * n) + j] = solved ? column[i] : 0;
            }
        }
    }

    /// <summary>Solves a system by Gaussian elimination with partial pivoting.</summary>
    /// <param name="a">n rows of n coefficients and a right-hand side; overwritten.</param>
    /// <param name="x">The solution.</param>
    /// <param name="n">The size of the system.</param>
    /// <returns>False if the system is singular.</returns>
    public static bool Solve(double[] a, double[] x, int n)
    {
        int width = n + 1;
        for (int i = 0; i < n; i++)
        {
            // Use the largest pivot in the column, because a small one would amplify rounding errors.
            int pivot = i;
            for (int k = i + 1; k < n; k++)
            {
                pivot = Math.Abs(a[(k * width) + i]) > Math.Abs(a[(pivot * width) + i]) ? k : pivot;
            }

            // The pivot is 0 or NaN, so the system is singular.
            Span<double> upper = a.AsSpan(i * width, width);
            Span<double> largest = a.AsSpan(pivot * width, width);
            if (!(Math.Abs(largest[i]) > 1e-300))
            {
                return false;
            }

            for (int k = i; k < upper.Length && pivot != i; k++)
            {
                (upper[k], largest[k]) = (largest[k], upper[k]);
            }

            for (int row = i + 1; row < n; row++)
            {
                // Eliminate the entries below the pivot. Those in its own column are not used again.
                Span<double> lower = a.AsSpan(row * width, width);
                double factor = lower[i] / upper[i];
                for (int k = i + 1; k < lower.Length; k++)
                {
                    lower[k] -= factor * upper[k];
                }
            }
        }

        // Back substitution.
        for (int i = n - 1; i >= 0; i--)
        {
            double sum = a[(i * width) + n];
            for (int k = i + 1; k < n; k++)
            {
                sum -= a[(i * width) + k] * x[k];
            }

            x[i] = sum / a[(i * width) + i];
        }

        return true;
    }
}
