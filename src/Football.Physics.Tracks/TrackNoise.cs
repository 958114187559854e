namespace FootballPhysics.Tracks;

/// <summary>Estimates the noise of a track from third divided differences, which are small for a smooth path at any spacing.</summary>
/// <remarks>
/// If the track has four successive points within a short time, few differences span an impact or a kick. The median of all differences is then
/// sufficient. If points are missing or far apart in time, many differences do. Such a difference is large along at least one axis, and is then
/// omitted along all axes.
/// </remarks>
internal static class TrackNoise
{
    /// <summary>The share of the differences that is used: those over the shortest times, in which a path bends least.</summary>
    private const double ShortestShare = 0.5;

    /// <summary>The median of |x| relative to the standard deviation.</summary>
    private const double Median = 0.6745;

    /// <summary>Points are missing if half of the differences span more than this multiple of the shortest time.</summary>
    private const double UnequalSpans = 1.2;

    /// <summary>Points are far apart in time if half of the differences span more than the first time, in s.</summary>
    /// <remarks>Above the second time, most differences span an impact: only those of a ball at rest would be left.</remarks>
    private const double SlowSpan = 0.18;
    private const double LongestSpan = 0.27;

    /// <summary>The share of the differences that is used if large ones are omitted.</summary>
    private const double TrimmedShare = 0.7;

    /// <summary>The number of standard deviations above which differences are omitted, in several rounds; and the median of |x| below it.</summary>
    private const double MostDeviations = 3;
    private const double MedianBelow = 0.67237;
    private const int Rounds = 6;

    /// <summary>
    /// The number of standard deviations below which differences are used in the last round. This round computes a root mean square, which scatters
    /// less than a median.
    /// </summary>
    private const double LastDeviations = 2.5;

    /// <summary>The variance of a standard normal variable that is truncated at c = <see cref="LastDeviations"/>: 1 − 2 c φ(c)/(2 Φ(c) − 1).</summary>
    private const double VarianceBelow = 0.91126;

    /// <summary>The minimum number of differences for a round; with fewer, the estimate of the round before is the result.</summary>
    private const int Least = 8;

    /// <summary>Returns the standard deviation of a coordinate, in m: the root mean square over the three axes.</summary>
    /// <param name="track">The points, in order of time.</param>
    /// <param name="longest">The longest time that four points may span, in s.</param>
    public static double Of(TrackPoint[] track, double longest)
    {
        List<(double Span, int Last)> windows = Windows(track, longest);
        if (windows.Count == 0)
        {
            return 0;
        }

        double middle = windows[windows.Count / 2].Span;
        bool isTrimmed = middle > UnequalSpans * windows[0].Span || middle is > SlowSpan and < LongestSpan;
        Vector3d[] differences = Differences(track, windows, isTrimmed ? TrimmedShare : ShortestShare);
        double[] deviations = Middles(differences, Median);
        if (isTrimmed)
        {
            Trim(differences, deviations);
        }

        return Math.Sqrt(((deviations[0] * deviations[0]) + (deviations[1] * deviations[1]) + (deviations[2] * deviations[2])) / 3);
    }

    /// <summary>Estimates the standard deviations again, without large differences.</summary>
    private static void Trim(Vector3d[] differences, double[] deviations)
    {
        for (int round = 0; round < Rounds; round++)
        {
            Vector3d[] kept = Array.FindAll(differences, difference => IsWithin(difference, deviations, MostDeviations));
            if (kept.Length < Least)
            {
                return;
            }

            Middles(kept, MedianBelow).CopyTo(deviations, 0);
        }

        Vector3d[] last = Array.FindAll(differences, difference => IsWithin(difference, deviations, LastDeviations));
        for (int axis = 0; axis < 3 && last.Length >= Least; axis++)
        {
            deviations[axis] = deviations[axis] > 0 ? Math.Sqrt(MeanSquare(last, axis) / VarianceBelow) : 0;
        }
    }

    /// <summary>Returns the times that four successive points span, each with the last of the points, from the shortest.</summary>
    private static List<(double Span, int Last)> Windows(TrackPoint[] track, double longest)
    {
        List<(double Span, int Last)> windows = [];
        for (int i = 3; i < track.Length; i++)
        {
            double span = track[i].Time - track[i - 3].Time;
            if (span <= longest)
            {
                windows.Add((span, i));
            }
        }

        windows.Sort();
        return windows;
    }

    /// <summary>Returns the third differences over the shortest times.</summary>
    private static Vector3d[] Differences(TrackPoint[] track, List<(double Span, int Last)> windows, double share)
    {
        double most = windows[(int)(share * (windows.Count - 1))].Span * (1 + 1e-6);
        return [.. windows.Where(window => window.Span <= most).Select(window => ThirdDifference(track, window.Last))];
    }

    /// <summary>Returns the third divided difference of the four points up to one, in standard deviations of a point.</summary>
    /// <remarks>The difference is Σ cᵢ pᵢ / √Σ cᵢ², with cᵢ = 1/Π (tᵢ − tⱼ).</remarks>
    private static Vector3d ThirdDifference(TrackPoint[] track, int last)
    {
        // Scale the times by the span of the four points, so that no power underflows.
        int first = last - 3;
        double unit = track[last].Time - track[first].Time;
        Vector3d sum = Vector3d.Zero;
        double squares = 0;
        for (int i = first; i <= last; i++)
        {
            double product = 1;
            for (int j = first; j <= last; j++)
            {
                product *= j == i ? 1 : (track[i].Time - track[j].Time) / unit;
            }

            sum += (1 / product) * (track[i].Position - track[first].Position);
            squares += 1 / (product * product);
        }

        return double.IsFinite(squares) ? (1 / Math.Sqrt(squares)) * sum : Vector3d.Zero;
    }

    /// <summary>True if a difference is small along all axes. An axis without any noise, such as a height that is always 0, does not count.</summary>
    private static bool IsWithin(in Vector3d difference, double[] deviations, double most)
    {
        for (int axis = 0; axis < 3; axis++)
        {
            if (deviations[axis] > 0 && Math.Abs(difference.Along(axis)) > most * deviations[axis])
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Returns the median size along each axis, relative to a number.</summary>
    private static double[] Middles(Vector3d[] differences, double unit)
    {
        double[] middles = new double[3];
        for (int axis = 0; axis < 3; axis++)
        {
            double[] sizes = Array.ConvertAll(differences, difference => Math.Abs(difference.Along(axis)));
            Array.Sort(sizes);
            middles[axis] = sizes[sizes.Length / 2] / unit;
        }

        return middles;
    }

    private static double MeanSquare(Vector3d[] differences, int axis)
    {
        double sum = 0;
        foreach (Vector3d difference in differences)
        {
            double along = difference.Along(axis);
            sum += along * along;
        }

        return sum / differences.Length;
    }
}
