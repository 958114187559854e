namespace FootballPhysics.Tracks;

/// <summary>The height at which a ball's centre is on the ground, from where a track has it bounce, roll and lie.</summary>
internal static class GroundHeight
{
    /// <summary>Height above the lowest point, m, from which a point is not on the ground: a crowned pitch, and a camera that is off.</summary>
    private const double Band = 0.35;

    /// <summary>The share of what is lowest that counts as the lowest: below it are points that are wrong.</summary>
    private const double Lowest = 0.1;

    /// <summary>MAD to standard deviation.</summary>
    private const double Scatter = 1.4826;

    /// <summary>Finds it.</summary>
    /// <param name="heights">Heights of bounces, and of a ball that neither rises nor falls.</param>
    /// <param name="height">The height, m.</param>
    /// <param name="deviation">Its standard deviation, m.</param>
    /// <returns>False where there is nothing to tell.</returns>
    public static bool Find(List<double> heights, out double height, out double deviation)
    {
        (height, deviation) = (0, double.PositiveInfinity);
        if (heights.Count == 0)
        {
            return false;
        }

        // The median of those within a band over the lowest tenth.
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
