namespace FootballPhysics.Tool.Fit.Reading;

/// <summary>The acceleration with which one coordinate of a track falls in flight: the median over short parabolas that describe it.</summary>
/// <param name="Fall">Median acceleration downwards, in the units of the file; negative if the coordinate falls upwards.</param>
/// <param name="Spread">Distance of the quartiles by the median.</param>
/// <param name="Windows">The number of parabolas; 0 if they bend both ways.</param>
internal readonly record struct TrackFall(double Fall, double Spread, int Windows)
{
    /// <summary>A parabola takes this time, s, if that is between so many points.</summary>
    private const double Span = 0.36;
    private const int LeastPoints = 7;
    private const int MostPoints = 24;

    /// <summary>A parabola describes a flight if its sag is so many times its residual, and this share of the heights.</summary>
    private const double SagShare = 8;
    private const double HeightShare = 0.004;

    /// <summary>A flight is higher than this share of the heights.</summary>
    private const double GroundShare = 0.05;

    private const int LeastWindows = 6;
    private const double MostSpread = 0.7;

    /// <summary>The least share of parabolas that bend the same way.</summary>
    private const double LeastAgreement = 0.9;

    /// <summary>True if the parabolas agree, so that the coordinate is a height.</summary>
    public bool IsSure => Windows >= LeastWindows && Spread < MostSpread;

    /// <summary>Measures a coordinate.</summary>
    public static TrackFall Of(double[] times, double[] values)
    {
        double wait = TrackTimes.UsualWait(times);
        int points = wait > 0 ? (int)Math.Clamp(Math.Round(Span / wait), LeastPoints, MostPoints) : LeastPoints;
        double[] sorted = [.. values.Order()];
        double low = sorted.Length > 0 ? sorted[(sorted.Length - 1) / 20] : 0;
        double range = sorted.Length > 0 ? sorted[99 * (sorted.Length - 1) / 100] - low : 0;
        List<double> falls = [];
        for (int from = 0; from + points <= times.Length; from += Math.Max(1, points / 3))
        {
            double span = times[from + points - 1] - times[from];
            if (span > 2 * points * wait || span <= 0)
            {
                continue;
            }

            // A ball on the ground does not fall.
            if (Lowest(values.AsSpan(from, points)) < low + (GroundShare * range))
            {
                continue;
            }

            double acceleration = Parabola(times.AsSpan(from, points), values.AsSpan(from, points), out double residual);
            double sag = Math.Abs(acceleration) * span * span / 8;
            if (sag > SagShare * residual && sag > HeightShare * range && sag > 0)
            {
                falls.Add(-acceleration);
            }
        }

        falls.Sort();
        if (falls.Count == 0)
        {
            return new TrackFall(0, double.PositiveInfinity, 0);
        }

        double median = falls[falls.Count / 2];
        bool agree = falls.Count(fall => fall > 0 == median > 0) >= LeastAgreement * falls.Count;
        return new TrackFall(median, (falls[3 * (falls.Count - 1) / 4] - falls[(falls.Count - 1) / 4]) / Math.Abs(median), agree ? falls.Count : 0);
    }

    private static double Lowest(ReadOnlySpan<double> values)
    {
        double lowest = double.PositiveInfinity;
        foreach (double value in values)
        {
            lowest = Math.Min(lowest, value);
        }

        return lowest;
    }

    /// <summary>Second derivative of the parabola through some points, and the root of the mean square of their distances from it.</summary>
    private static double Parabola(ReadOnlySpan<double> times, ReadOnlySpan<double> values, out double residual)
    {
        // Orthogonal polynomials on these times: 1, u = t − mean, q = u² − b u − c
        int n = times.Length;
        double middle = 0;
        double mean = 0;
        for (int i = 0; i < n; i++)
        {
            middle += times[i] / n;
            mean += values[i] / n;
        }

        double u2 = 0;
        double u3 = 0;
        double vu = 0;
        for (int i = 0; i < n; i++)
        {
            double u = times[i] - middle;
            u2 += u * u;
            u3 += u * u * u;
            vu += (values[i] - mean) * u;
        }

        double slope = vu / u2;
        double b = u3 / u2;
        double c = u2 / n;
        double qq = 0;
        double vq = 0;
        for (int i = 0; i < n; i++)
        {
            double u = times[i] - middle;
            double q = (u * u) - (b * u) - c;
            qq += q * q;
            vq += (values[i] - mean) * q;
        }

        double bend = qq > 0 ? vq / qq : 0;
        double squares = 0;
        for (int i = 0; i < n; i++)
        {
            double u = times[i] - middle;
            double off = values[i] - mean - (slope * u) - (bend * ((u * u) - (b * u) - c));
            squares += off * off;
        }

        residual = Math.Sqrt(squares / n);
        return 2 * bend;
    }
}
