namespace FootballPhysics.Tracks;

/// <summary>Estimates the height of a ball's centre on the ground, from bounces and phases on the ground.</summary>
internal static class GroundHeight
{
    /// <summary>The height above the lowest point, in m, up to which a point may be on the ground: crowned pitches and camera errors.</summary>
    private const double Band = 0.35;

    /// <summary>The quantile that counts as the lowest; points below it are errors.</summary>
    private const double Lowest = 0.1;

    /// <summary>The factor from median absolute deviation to standard deviation.</summary>
    private const double Scatter = GroundFriction.Mad;

    /// <summary>Estimates the height.</summary>
    /// <param name="heights">The heights of bounces, and of a ball that neither rises nor falls.</param>
    /// <param name="height">The height, in m.</param>
    /// <param name="deviation">The standard deviation of the height, in m.</param>
    /// <returns>False if there are no heights.</returns>
    public static bool Find(List<double> heights, out double height, out double deviation)
    {
        (height, deviation) = (0, double.PositiveInfinity);
        if (heights.Count == 0)
        {
            return false;
        }

        // The median of the heights within a band above the lowest tenth.
        heights.Sort();
        double low = heights[(int)(Lowest * (heights.Count - 1))];
        List<double> ground = heights.FindAll(h => h <= low + Band);
        height = ground[ground.Count / 2];
        double middle = height;
        List<double> off = ground.ConvertAll(h => Math.Abs(h - middle));
        off.Sort();
        deviation = Math.Max(1e-3, Scatter * off[off.Count / 2]) / Math.Sqrt(ground.Count);
        return true;
    }
}
