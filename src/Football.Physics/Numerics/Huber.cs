namespace FootballPhysics.Numerics;

/// <summary>Huber's loss: quadratic for small residuals, linear for outliers.</summary>
internal static class Huber
{
    /// <summary>Returns the weight of a residual in reweighted least squares.</summary>
    /// <param name="off">The size of the residual, in standard deviations.</param>
    /// <param name="threshold">The size beyond which it is an outlier.</param>
    public static double Weight(double off, double threshold) => off > threshold ? threshold / off : 1.0;

    /// <summary>Returns the cost of a residual.</summary>
    /// <param name="off">The size of the residual, in standard deviations.</param>
    /// <param name="threshold">The size beyond which it is an outlier.</param>
    public static double Cost(double off, double threshold) => off > threshold ? threshold * ((2 * off) - threshold) : off * off;
}
