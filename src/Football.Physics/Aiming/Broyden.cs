namespace FootballPhysics.Aiming;

/// <summary>Broyden's update: the least change of a Jacobian, in units in which unknowns count alike, that agrees with what the last step did.</summary>
internal static class Broyden
{
    /// <summary>Updates a row: J += (Δr − J Δx) (W Δx)ᵀ / (Δxᵀ W Δx).</summary>
    /// <param name="j">The Jacobian.</param>
    /// <param name="row">Where the row begins.</param>
    /// <param name="count">How many unknowns its residual depends on.</param>
    /// <param name="dx">What the unknowns changed by.</param>
    /// <param name="weight">W, by unknown.</param>
    /// <param name="squared">Δxᵀ W Δx; nothing is learnt where it is not above 0.</param>
    /// <param name="dr">What the residual changed by.</param>
    public static void Update(double[] j, int row, int count, double[] dx, double[] weight, double squared, double dr)
    {
        // What an unknown that was held has in its column, from another problem, does not count.
        double error = dr;
        for (int k = 0; k < count; k++)
        {
            error -= dx[k] == 0 ? 0 : j[row + k] * dx[k];
        }

        // J += (Δr − J Δx) (W Δx)ᵀ/(Δxᵀ W Δx), row by row.
        for (int k = 0; k < count && squared > 0; k++)
        {
            j[row + k] += dx[k] == 0 ? 0 : error * weight[k] * dx[k] / squared;
        }
    }
}
