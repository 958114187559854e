namespace FootballPhysics.Tracks;

/// <summary>The variance of residuals that determines standard deviations: it grows with a misfit. The same rule holds for one flight and for matches.</summary>
/// <remarks>
/// White noise has no likeness from one point to the next. A misfit of the laws has, and acts alike at many points, so that more points do not reduce it.
/// </remarks>
internal static class ResidualVariance
{
    /// <summary>The share of a systematic misfit that acts alike at all points of a flight.</summary>
    private const double CommonShare = 0.3;

    /// <summary>The standard deviations beyond which the likeness of successive residuals is a misfit.</summary>
    private const double LikenessDeviations = 2;

    /// <summary>Returns the variance.</summary>
    /// <param name="misses">The residuals of all points, one after the other.</param>
    /// <param name="ofPoint">The number of residuals of a point.</param>
    /// <param name="parameters">The number of fitted parameters.</param>
    /// <param name="least">The variance of the noise.</param>
    /// <param name="misfit">The variance of a misfit of the laws, per residual; 0 if successive residuals are not alike.</param>
    public static double Of(double[] misses, int ofPoint, int parameters, double least, out double misfit)
    {
        double squares = 0;
        double products = 0;
        for (int i = 0; i < misses.Length; i++)
        {
            squares += misses[i] * misses[i];
            products += i >= ofPoint ? misses[i] * misses[i - ofPoint] : 0;
        }

        // As many residuals of the known noise as the parameters have removed: a short flight alone does not reveal its noise.
        double scatter = (squares + (parameters * least)) / misses.Length;
        double usual = squares / misses.Length;
        misfit = Math.Max(0, (products / misses.Length) - (LikenessDeviations * usual / Math.Sqrt(misses.Length)));
        return scatter + (CommonShare * misses.Length / ofPoint * misfit);
    }
}
