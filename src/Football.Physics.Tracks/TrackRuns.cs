namespace FootballPhysics.Tracks;

/// <summary>A track made ready: without points that jump out and back, divided where it has gaps, and with its noise.</summary>
internal sealed class TrackRuns
{
    /// <summary>A wait of so many usual ones, and of so many seconds, is a gap.</summary>
    private const double GapShare = 3.5;
    private const double LeastGap = 0.1;

    /// <summary>If the mean wait exceeds this multiple of the median wait, single points are missing, and longer waits are not gaps.</summary>
    private const double Scattered = 1.3;
    private const double ScatteredGap = 6;

    /// <summary>The distance of a spike from the cubic through its four neighbours, in m and in standard deviations.</summary>
    /// <remarks>No impact bends a path that far.</remarks>
    private const double Spike = 0.3;
    private const double SpikeShare = 8;

    /// <summary>The median of |x| relative to the standard deviation.</summary>
    private const double Median = 0.6745;

    /// <summary>If points are missing, more differences span an impact. Differences above this many standard deviations are then left out, in several rounds.</summary>
    private const double MostDeviations = 3;
    private const int Rounds = 4;
    private const double UnequalSpans = 1.2;

    /// <summary>Waits above this multiple of the median wait do not count for the mean wait.</summary>
    private const double LongWait = 10;

    /// <summary>The share of third differences used to estimate the noise: those over the shortest times, in which a path bends least.</summary>
    private const double ShortestShare = 0.5;

    private readonly double _mean;

    public TrackRuns(TrackPoint[] seen)
    {
        TrackPoint[] track = TrackTiming.Unrounded(WithoutRepeats(seen));
        Wait = UsualWait(track, out _mean);
        Noise = NoiseOf(track);
        Points = WithoutSpikes(track);
        List<int> ends = [];
        for (int i = 1; i < Points.Length; i++)
        {
            if (IsGap(Points[i - 1].Time, Points[i].Time))
            {
                ends.Add(i);
            }
        }

        ends.Add(Points.Length);
        Ends = ends;
    }

    /// <summary>The points.</summary>
    public TrackPoint[] Points { get; }

    /// <summary>The exclusive end of each run without gaps.</summary>
    public IReadOnlyList<int> Ends { get; }

    /// <summary>The median wait between two points, in s.</summary>
    public double Wait { get; }

    /// <summary>The standard deviation of a coordinate from one point to the next, in m.</summary>
    public double Noise { get; }

    /// <summary>True if there is a gap between two times.</summary>
    public bool IsGap(double from, double to) => to - from > Math.Max((_mean > Scattered * Wait ? ScatteredGap : GapShare) * _mean, LeastGap);

    /// <summary>Removes points with the same time as the one before.</summary>
    private static TrackPoint[] WithoutRepeats(TrackPoint[] track)
    {
        List<TrackPoint> kept = [track[0]];
        for (int i = 1; i < track.Length; i++)
        {
            if (track[i].Time > track[i - 1].Time)
            {
                kept.Add(track[i]);
            }
        }

        return [.. kept];
    }

    /// <summary>The median of the waits, and their mean without long ones: larger where points are missing.</summary>
    private static double UsualWait(TrackPoint[] track, out double mean)
    {
        double[] waits = new double[track.Length - 1];
        for (int i = 1; i < track.Length; i++)
        {
            waits[i - 1] = track[i].Time - track[i - 1].Time;
        }

        Array.Sort(waits);
        double median = waits[waits.Length / 2];
        double sum = 0;
        int count = 0;
        foreach (double wait in waits)
        {
            if (wait <= LongWait * median)
            {
                sum += wait;
                count++;
            }
        }

        mean = Math.Max(median, sum / count);
        return median;
    }

    /// <summary>Estimates the noise from third divided differences, which are small for a smooth path at any spacing.</summary>
    private double NoiseOf(TrackPoint[] track)
    {
        List<(double Span, int Last)> windows = [];
        for (int i = 3; i < track.Length; i++)
        {
            double span = track[i].Time - track[i - 3].Time;
            if (!IsGap(0, span - (2 * _mean)))
            {
                windows.Add((span, i));
            }
        }

        windows.Sort();
        double longest = windows.Count > 0 ? windows[(int)(ShortestShare * (windows.Count - 1))].Span * (1 + 1e-6) : 0;
        bool isUnequal = windows.Count > 0 && windows[windows.Count / 2].Span > UnequalSpans * windows[0].Span;
        double squares = 0;
        List<double> differences = [];
        for (int axis = 0; axis < 3; axis++)
        {
            differences.Clear();
            foreach ((double span, int last) in windows)
            {
                if (span <= longest)
                {
                    Vector3d third = ThirdDifference(track, last);
                    differences.Add(Math.Abs(axis == 0 ? third.X : axis == 1 ? third.Y : third.Z));
                }
            }

            differences.Sort();
            double deviation = differences.Count == 0 ? 0
                : differences[differences.Count / 2] / Median;
            for (int i = 0; isUnequal && i < Rounds && differences.Count > 0; i++)
            {
                double most = MostDeviations * deviation;
                int kept = differences.FindLastIndex(difference => difference <= most) + 1;
                deviation = differences[kept / 2] / Median;
            }

            squares += deviation * deviation;
        }

        return Math.Sqrt(squares / 3);
    }

    /// <summary>The third divided difference of four points up to one, in deviations of a point: Σ cᵢ pᵢ / √Σ cᵢ², cᵢ = 1/Π (tᵢ − tⱼ).</summary>
    private static Vector3d ThirdDifference(TrackPoint[] track, int last)
    {
        // In units of the four points' time, so that no power of it is lost.
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

    private TrackPoint[] WithoutSpikes(TrackPoint[] track)
    {
        double most = Math.Max(Spike, SpikeShare * Noise);
        List<TrackPoint> kept = [];
        for (int i = 0; i < track.Length; i++)
        {
            bool isInside = i >= 2 && i + 2 < track.Length && track[i + 2].Time - track[i - 2].Time < 5 * _mean;
            if (!isInside || Off(track, i) <= most || Off(track, i) < Math.Max(Off(track, i - 1), Off(track, i + 1)) || !IsSmoothWithout(track, i, most))
            {
                kept.Add(track[i]);
            }
        }

        return [.. kept];
    }

    /// <summary>Returns the distance of a point from the cubic through its four neighbours.</summary>
    private static double Off(TrackPoint[] track, int i)
    {
        if (i < 2 || i + 2 >= track.Length)
        {
            return 0;
        }

        Vector3d off = track[i].Position;
        for (int j = i - 2; j <= i + 2; j++)
        {
            double weight = 1;
            for (int k = i - 2; k <= i + 2; k++)
            {
                weight *= k == i || k == j ? 1 : (track[i].Time - track[k].Time) / (track[j].Time - track[k].Time);
            }

            off -= j == i ? Vector3d.Zero : weight * track[j].Position;
        }

        return off.Length;
    }

    /// <summary>True if the neighbours are nearly on a line, so that the point between them is a spike.</summary>
    private static bool IsSmoothWithout(TrackPoint[] track, int i, double most)
    {
        double wait = 0.25 * (track[i + 2].Time - track[i - 2].Time);
        Vector3d before = Step(track, i - 2, i - 1, wait);
        Vector3d after = Step(track, i + 1, i + 2, wait);
        Vector3d across = Step(track, i - 1, i + 1, wait);
        return (across - before).Length < most && (across - after).Length < most;
    }

    /// <summary>Returns the displacement in a wait at the mean velocity between two points.</summary>
    private static Vector3d Step(TrackPoint[] track, int from, int to, double wait) => wait / (track[to].Time - track[from].Time) * (track[to].Position - track[from].Position);
}
