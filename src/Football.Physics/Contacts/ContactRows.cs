using System.Runtime.CompilerServices;

namespace FootballPhysics.Contacts;

/// <summary>The linear system of the forces of a contact set: G x = b, with a few unknowns.</summary>
/// <remarks>
/// If the solution is not unique, as for a ball that sticks to both sides of a gutter, it takes the one with the least sum of squares
/// (several.md, 2).
/// </remarks>
internal static unsafe class ContactRows
{
    /// <summary>Maximum number of unknowns of one ball: loads, and two friction components per sticking contact.</summary>
    public const int Most = 3 * ContactSystem.Most;

    private const int Refinements = 3;

    /// <summary>Solves G x = b. G is unchanged.</summary>
    /// <param name="g">G, row by row.</param>
    /// <param name="b">b; replaced by x.</param>
    /// <param name="size">Number of unknowns.</param>
    /// <returns>True if the solution is unique.</returns>
    [SkipLocalsInit]
    public static bool Solve(double* g, double* b, int size)
    {
        double* work = stackalloc double[size * size];
        double* x = stackalloc double[size];
        double largest = 0;
        for (int i = 0; i < size * size; i++)
        {
            work[i] = g[i];
            largest = Math.Max(largest, Math.Abs(g[i]));
        }

        for (int i = 0; i < size; i++)
        {
            x[i] = b[i];
        }

        bool isUnique = Eliminate(work, x, size, ContactTolerances.Singular * largest);
        if (!isUnique)
        {
            LeastSquares(g, b, x, size);
        }

        for (int i = 0; i < size; i++)
        {
            b[i] = x[i];
        }

        return isUnique;
    }

    /// <summary>Solves G x = b if the conditions of two sticking contacts are dependent: yᵀ G = 0 and yᵀ b = 0 for a known vector
    /// y.</summary>
    /// <remarks>
    /// G + y yᵀ is invertible. Its inverse also maps y to z, the forces without effect (G z = 0). The least x has no component along z.
    /// </remarks>
    /// <param name="g">G, row by row; overwritten.</param>
    /// <param name="b">b; replaced by x.</param>
    /// <param name="y">y; replaced by z.</param>
    /// <param name="size">Number of unknowns.</param>
    /// <returns>False if more than this one force is undetermined: b and y are then unchanged, and G is overwritten.</returns>
    [SkipLocalsInit]
    public static bool SolveBraced(double* g, double* b, double* y, int size)
    {
        double* x = stackalloc double[2 * size];
        double largest = 0;
        for (int i = 0; i < size; i++)
        {
            x[i] = b[i];
            x[size + i] = y[i];
            for (int j = 0; j < size; j++)
            {
                g[(i * size) + j] += y[i] * y[j];
                largest = Math.Max(largest, Math.Abs(g[(i * size) + j]));
            }
        }

        if (!Eliminate(g, x, size, ContactTolerances.Singular * largest, 2))
        {
            return false;
        }

        double along = 0;
        double square = 0;
        for (int i = 0; i < size; i++)
        {
            along += x[i] * x[size + i];
            square += x[size + i] * x[size + i];
        }

        for (int i = 0; i < size; i++)
        {
            b[i] = x[i] - (along / square * x[size + i]);
            y[i] = x[size + i];
        }

        return true;
    }

    /// <summary>Gaussian elimination with partial pivoting.</summary>
    /// <param name="a">The matrix; overwritten.</param>
    /// <param name="x">The right-hand sides, one after the other; replaced by the solutions.</param>
    /// <param name="size">Number of unknowns.</param>
    /// <param name="least">Minimum pivot.</param>
    /// <param name="sides">Number of right-hand sides.</param>
    /// <returns>False if a pivot is too small.</returns>
    private static bool Eliminate(double* a, double* x, int size, double least, int sides = 1)
    {
        for (int column = 0; column < size; column++)
        {
            int pivot = column;
            for (int i = column + 1; i < size; i++)
            {
                pivot = Math.Abs(a[(i * size) + column]) > Math.Abs(a[(pivot * size) + column]) ? i : pivot;
            }

            double* own = a + (column * size);
            double* best = a + (pivot * size);
            if (!(Math.Abs(best[column]) > least))
            {
                return false;
            }

            if (pivot != column)
            {
                for (int j = column; j < size; j++)
                {
                    (own[j], best[j]) = (best[j], own[j]);
                }

                for (int side = 0; side < sides * size; side += size)
                {
                    (x[side + column], x[side + pivot]) = (x[side + pivot], x[side + column]);
                }
            }

            double inverse = 1.0 / own[column];
            for (int i = column + 1; i < size; i++)
            {
                double* row = a + (i * size);
                double factor = row[column] * inverse;
                if (factor != 0)
                {
                    for (int j = column + 1; j < size; j++)
                    {
                        row[j] -= factor * own[j];
                    }

                    for (int side = 0; side < sides * size; side += size)
                    {
                        x[side + i] -= factor * x[side + column];
                    }
                }
            }
        }

        for (int side = 0; side < sides * size; side += size)
        {
            for (int i = size - 1; i >= 0; i--)
            {
                double* row = a + (i * size);
                for (int j = i + 1; j < size; j++)
                {
                    x[side + i] -= row[j] * x[side + j];
                }

                x[side + i] /= row[i];
            }
        }

        return true;
    }

    /// <summary>Computes x = Gᵀ (G Gᵀ + ε)⁻¹ b with one refinement. The null space of G is unaffected.</summary>
    [SkipLocalsInit]
    private static void LeastSquares(double* g, double* b, double* x, int size)
    {
        double* square = stackalloc double[size * size];
        double* factor = stackalloc double[size * size];
        double* left = stackalloc double[size];
        double trace = 0;
        for (int i = 0; i < size; i++)
        {
            for (int j = 0; j <= i; j++)
            {
                double sum = 0;
                for (int k = 0; k < size; k++)
                {
                    sum += g[(i * size) + k] * g[(j * size) + k];
                }

                square[(i * size) + j] = sum;
                square[(j * size) + i] = sum;
            }

            trace = Math.Max(trace, square[(i * size) + i]);
            x[i] = 0;
        }

        for (int i = 0; i < size; i++)
        {
            square[(i * size) + i] += ContactTolerances.Ridge * trace;
        }

        for (int round = 0; round < Refinements; round++)
        {
            for (int i = 0; i < size; i++)
            {
                double sum = b[i];
                for (int k = 0; k < size; k++)
                {
                    sum -= g[(i * size) + k] * x[k];
                }

                left[i] = sum;
            }

            for (int i = 0; i < size * size; i++)
            {
                factor[i] = square[i];
            }

            Eliminate(factor, left, size, 0);
            for (int i = 0; i < size; i++)
            {
                for (int k = 0; k < size; k++)
                {
                    x[k] += g[(i * size) + k] * left[i];
                }
            }
        }
    }
}
