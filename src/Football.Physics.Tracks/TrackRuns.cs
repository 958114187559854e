namespace FootballPhysics.Tracks;

/// <summary>A prepared track: without spikes, divided at gaps, and with its noise.</summary>
internal sealed class TrackRuns
{
    /// <summary>The minimum wait that is a gap: as a multiple of the mean wait, and in s.</summary>
    private const double GapShare = 3.5;
    private const double LeastGap = 0.1;

    /// <summary>The ratio of mean to median wait above which single points are missing, and the multiple of the mean wait that is then a gap.</summary>
    private const double Scattered = 1.3;
    private const double ScatteredGap = 6;

    /// <summary>The distance of a spike from the cubic through its four neighbours, in m and in standard deviations.</summary>
    /// <remarks>No impact bends a path that far.</remarks>
    private const double Spike = 0.3;
    private const double SpikeShare = 8;

    /// <summary>Waits above this multiple of the median wait do not count for the mean wait.</summary>
    private const double LongWait = 10;

    private readonly double _mean;

    public TrackRuns(TrackPoint[] seen)
    {
        TrackPoint[] track = DrawnPoints.Remove(TrackTiming.Unrounded(WithoutRepeats(seen)), out int lines, out int held);
        (OnLines, Held) = (lines, held);
        Wait = UsualWait(track, out _mean);
        Noise = TrackNoise.Of(track, (2 * _mean) + LongestWait);
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

    /// <summary>The number of points that were left out because they lie on straight lines between others.</summary>
    public int OnLines { get; }

    /// <summary>The number of points that were left out because they repeat the position of a moving ball.</summary>
    public int Held { get; }

    /// <summary>The points.</summary>
    public TrackPoint[] Points { get; }

    /// <summary>The exclusive end of each run without gaps.</summary>
    public IReadOnlyList<int> Ends { get; }

    /// <summary>The median wait between two points, in s.</summary>
    public double Wait { get; }

    /// <summary>The standard deviation of a coordinate from one point to the next, in m.</summary>
    public double Noise { get; }

    /// <summary>True if there is a gap between two times.</summary>
    public bool IsGap(double from, double to) => to - from > LongestWait;

    /// <summary>The longest wait that is not a gap, in s.</summary>
    private double LongestWait => Math.Max((_mean > Scattered * Wait ? ScatteredGap : GapShare) * _mean, LeastGap);

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

    /// <summary>Returns the median wait, and computes the mean wait without long ones. The mean is larger if points are missing.</summary>
    private static double UsualWait(TrackPoint[] track, out double mean)
    {
        double[] waits = new double[track.Length - 1];
        for (int i = 0; i < waits.Length; i++)
        {
            waits[i] = track[i + 1].Time - track[i].Time;
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
