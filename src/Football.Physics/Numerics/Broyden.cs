namespace FootballPhysics.Numerics;

/// <summary>Broyden's update: the smallest change of a Jacobian, in scaled unknowns, that matches the last step.</summary>
internal static class Broyden
{
    /// <summary>Updates a row: J += (Δr − J Δx) (W Δx)ᵀ / (Δxᵀ W Δx).</summary>
    /// <param name="j">The Jacobian.</param>
    /// <param name="row">The index at which the row starts.</param>
    /// <param name="count">The number of unknowns that affect the residual.</param>
    /// <param name="dx">The change of the unknowns.</param>
    /// <param name="weight">The weights W, one per unknown.</param>
    /// <param name="squared">Δxᵀ W Δx; the row is not updated if this is not above 0.</param>
    /// <param name="dr">The change of the residual.</param>
    public static void Update(double[] j, int row, int count, double[] dx, double[] weight, double squared, double dr)
    {
        // Ignore the column of a held unknown, which may be left over from another problem.
        double error = dr;
        for (int k = 0; k < count; k++)
        {
            error -= dx[k] == 0 ? 0 : j[row + k] * dx[k];
        }

        // J is the Jacobian, Δx the step, Δr the change of the residuals, and W the weights.
        // J += (Δr − J Δx) (W Δx)ᵀ/(Δxᵀ W Δx), row by row.
        for (int k = 0; k < count && squared > 0; k++)
        {
            j[row + k] += dx[k] == 0 ? 0 : error * weight[k] * dx[k] / squared;
        }
    }
}
