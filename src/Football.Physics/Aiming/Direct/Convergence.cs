namespace Football.Physics;

/// <summary>When a quasi-Newton iteration need not fly its last kick.</summary>
internal static class Convergence
{
    /// <summary>
    /// The last correction shrank the miss by a factor, and the next one will by no less. Where that is plenty, the corrected kick needs no
    /// flight to show that it hits.
    /// </summary>
    /// <param name="miss">The miss now, m.</param>
    /// <param name="before">The miss before the last correction, m; infinite before there was one.</param>
    /// <param name="tolerance">The tolerance, m.</param>
    /// <param name="contraction">The factor.</param>
    public static bool IsPlenty(double miss, double before, double tolerance, out double contraction)
    {
        contraction = miss / before;
        return contraction > 0 && contraction < 0.1 && contraction * miss < 0.1 * tolerance;
    }
}
