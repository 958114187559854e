namespace FootballPhysics.Tool.Fit.Reading;

/// <summary>The acceleration at which a coordinate of a track falls in flight: the median over short parabolas that describe it.</summary>
/// <param name="Fall">The median downward acceleration, in units of the file; negative if the coordinate accelerates upwards.</param>
/// <param name="Spread">The interquartile range relative to the median.</param>
/// <param name="Windows">The number of parabolas; 0 if they bend both ways.</param>
internal readonly record struct TrackFall(double Fall, double Spread, int Windows)
{
    /// <summary>The duration of a parabola, in s, within limits of the number of points.</summary>
    private const double Span = 0.36;
    private const int LeastPoints = 7;
    private const int MostPoints = 24;

    /// <summary>The minimum sag of a parabola that describes a flight: as a multiple of its residual, and as a share of the range of heights.</summary>
    private const double SagShare = 8;
    private const double HeightShare = 0.004;

    /// <summary>The minimum height of a flight, as a share of the range of heights.</summary>
    private const double GroundShare = 0.05;

    private const int LeastWindows = 6;
    private const double MostSpread = 0.7;

    /// <summary>The minimum share of parabolas that bend the same way.</summary>
    private const double LeastAgreement = 0.9;

    /// <summary>True if the parabolas agree. The coordinate is then a height.</summary>
    public bool IsSure => Windows >= LeastWindows && Spread < MostSpread;

    /// <summary>Measures the fall of a coordinate.</summary>
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

            // Skip points on the ground.
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

    /// <summary>Returns the second derivative of the least-squares parabola through some points, and computes the rms of the residuals.</summary>
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
