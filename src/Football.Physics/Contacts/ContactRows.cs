using System.Runtime.CompilerServices;

namespace FootballPhysics.Contacts;

/// <summary>The linear system of the forces of a contact set: G x = b, with a few unknowns.</summary>
/// <remarks>
/// If the solution is not unique, as for a ball that sticks to both sides of a gutter, it takes the one with the least sum of squares
/// (contact.md, Several contacts).
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
        // Eliminate G with b as another column.
        int width = size + 1;
        double* work = stackalloc double[size * width];
        double largest = 0;
        for (int i = 0; i < size; i++)
        {
            double* row = work + (i * width);
            for (int j = 0; j < size; j++)
            {
                row[j] = g[(i * size) + j];
                double entry = Math.Abs(row[j]);
                largest = entry > largest ? entry : largest;
            }

            row[size] = b[i];
        }

        if (!Eliminate(work, size, width, ContactTolerances.Singular * largest))
        {
            LeastSquares(g, b, size);
            return false;
        }

        for (int i = 0; i < size; i++)
        {
            b[i] = work[(i * width) + size];
        }

        return true;
    }

    /// <summary>Solves G x = b if the conditions of two sticking contacts are dependent: yᵀ G = 0 and yᵀ b = 0 for a known vector
    /// y.</summary>
    /// <remarks>
    /// G + y yᵀ is invertible. Its inverse also maps y to z, the forces without effect (G z = 0). The least x has no component along z.
    /// </remarks>
    /// <param name="g">G, row by row. G is unchanged.</param>
    /// <param name="b">b; replaced by x.</param>
    /// <param name="y">y; replaced by z.</param>
    /// <param name="size">Number of unknowns.</param>
    /// <returns>False if more than this one force is undetermined: b and y are then unchanged.</returns>
    [SkipLocalsInit]
    public static bool SolveBraced(double* g, double* b, double* y, int size)
    {
        int width = size + 2;
        double* work = stackalloc double[size * width];
        double largest = 0;
        for (int i = 0; i < size; i++)
        {
            double* row = work + (i * width);
            for (int j = 0; j < size; j++)
            {
                row[j] = g[(i * size) + j] + (y[i] * y[j]);
                double entry = Math.Abs(row[j]);
                largest = entry > largest ? entry : largest;
            }

            row[size] = b[i];
            row[size + 1] = y[i];
        }

        if (!Eliminate(work, size, width, ContactTolerances.Singular * largest))
        {
            return false;
        }

        double along = 0;
        double square = 0;
        for (int i = 0; i < size; i++)
        {
            double* solved = work + (i * width) + size;
            along += solved[0] * solved[1];
            square += solved[1] * solved[1];
        }

        double share = along / square;
        for (int i = 0; i < size; i++)
        {
            double* solved = work + (i * width) + size;
            b[i] = solved[0] - (share * solved[1]);
            y[i] = solved[1];
        }

        return true;
    }

    /// <summary>Gaussian elimination with partial pivoting.</summary>
    /// <param name="a">The matrix, row by row, with the right-hand sides as further columns; these are replaced by the solutions.</param>
    /// <param name="size">Number of unknowns.</param>
    /// <param name="width">Number of columns.</param>
    /// <param name="least">Minimum pivot.</param>
    /// <returns>False if a pivot is too small.</returns>
    private static bool Eliminate(double* a, int size, int width, double least)
    {
        for (int column = 0; column < size; column++)
        {
            double* own = a + (column * width);
            double* best = own;
            double most = Math.Abs(own[column]);
            for (double* row = own + width; row < a + (size * width); row += width)
            {
                double entry = Math.Abs(row[column]);
                best = entry > most ? row : best;
                most = entry > most ? entry : most;
            }

            if (!(most > least))
            {
                return false;
            }

            for (int j = column; j < width && best != own; j++)
            {
                (own[j], best[j]) = (best[j], own[j]);
            }

            // Divide the pivot's row once, so that the substitution below needs no division.
            double inverse = 1.0 / own[column];
            for (int j = column + 1; j < width; j++)
            {
                own[j] *= inverse;
            }

            for (double* row = own + width; row < a + (size * width); row += width)
            {
                double factor = row[column];
                for (int j = column + 1; j < width && factor != 0; j++)
                {
                    row[j] -= factor * own[j];
                }
            }
        }

        for (int i = size - 2; i >= 0; i--)
        {
            double* row = a + (i * width);
            for (int j = i + 1; j < size; j++)
            {
                for (int side = size; side < width; side++)
                {
                    row[side] -= row[j] * a[(j * width) + side];
                }
            }
        }

        return true;
    }

    /// <summary>Computes x = Gᵀ (G Gᵀ + ε)⁻¹ b with refinements, and replaces b by x. The null space of G is unaffected.</summary>
    [SkipLocalsInit]
    private static void LeastSquares(double* g, double* b, int size)
    {
        int width = size + 1;
        double* square = stackalloc double[size * width];
        double* factor = stackalloc double[size * width];
        double* x = stackalloc double[size];
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

                square[(i * width) + j] = sum;
                square[(j * width) + i] = sum;
            }

            trace = Math.Max(trace, square[(i * width) + i]);
            x[i] = 0;
        }

        for (int i = 0; i < size; i++)
        {
            square[(i * width) + i] += ContactTolerances.Ridge * trace;
        }

        for (int round = 0; round < Refinements; round++)
        {
            // The residual b − G x is the right-hand side.
            new Span<double>(square, size * width).CopyTo(new Span<double>(factor, size * width));
            for (int i = 0; i < size; i++)
            {
                double sum = b[i];
                for (int k = 0; k < size; k++)
                {
                    sum -= g[(i * size) + k] * x[k];
                }

                factor[(i * width) + size] = sum;
            }

            Eliminate(factor, size, width, 0);
            for (int i = 0; i < size; i++)
            {
                for (int k = 0; k < size; k++)
                {
                    x[k] += g[(i * size) + k] * factor[(i * width) + size];
                }
            }
        }

        for (int i = 0; i < size; i++)
        {
            b[i] = x[i];
        }
    }
}
