namespace FootballPhysics.Tracks;

/// <summary>A prepared track: without spikes, split at gaps, and with an estimate of its noise.</summary>
internal sealed class TrackRuns
{
    /// <summary>The wait that counts as a gap, as a multiple of the usual one and in s.</summary>
    private const double GapShare = 3.5;
    private const double LeastGap = 0.1;

    /// <summary>The distance of a spike from the cubic through its four neighbours, in m and in standard deviations.</summary>
    /// <remarks>No impact bends a path that far.</remarks>
    private const double Spike = 0.3;
    private const double SpikeShare = 8;

    /// <summary>√20, the standard deviation of a third difference relative to a point; and the median of |x| relative to the standard
    /// deviation.</summary>
    private const double ThirdDifference = 4.47213595499958;
    private const double Median = 0.6745;

    public TrackRuns(TrackPoint[] seen)
    {
        TrackPoint[] track = WithoutRepeats(seen);
        Wait = UsualWait(track);
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

    /// <summary>The usual wait between two points, in s.</summary>
    public double Wait { get; }

    /// <summary>The standard deviation of a coordinate from one point to the next, in m.</summary>
    public double Noise { get; }

    /// <summary>True if there is a gap between two times.</summary>
    public bool IsGap(double from, double to) => to - from > Math.Max(GapShare * Wait, LeastGap);

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

    private static double UsualWait(TrackPoint[] track)
    {
        double[] waits = new double[track.Length - 1];
        for (int i = 1; i < track.Length; i++)
        {
            waits[i - 1] = track[i].Time - track[i - 1].Time;
        }

        Array.Sort(waits);
        return waits[waits.Length / 2];
    }

    /// <summary>Estimates the noise from third differences, which are small for a smooth path.</summary>
    private double NoiseOf(TrackPoint[] track)
    {
        double squares = 0;
        List<double> differences = [];
        for (int axis = 0; axis < 3; axis++)
        {
            differences.Clear();
            for (int i = 3; i < track.Length; i++)
            {
                if (!IsGap(track[i - 3].Time, track[i].Time - (2 * Wait)))
                {
                    Vector3d third = track[i].Position - track[i - 3].Position - (3 * (track[i - 1].Position - track[i - 2].Position));
                    differences.Add(Math.Abs(axis == 0 ? third.X : axis == 1 ? third.Y : third.Z));
                }
            }

            differences.Sort();
            double deviation = differences.Count > 0 ? differences[differences.Count / 2] / (Median * ThirdDifference) : 0;
            squares += deviation * deviation;
        }

        return Math.Sqrt(squares / 3);
    }

    private TrackPoint[] WithoutSpikes(TrackPoint[] track)
    {
        double most = Math.Max(Spike, SpikeShare * Noise);
        List<TrackPoint> kept = [];
        for (int i = 0; i < track.Length; i++)
        {
            bool isInside = i >= 2 && i + 2 < track.Length && track[i + 2].Time - track[i - 2].Time < 5 * Wait;
            if (!isInside || Off(track, i) <= most || Off(track, i) < Math.Max(Off(track, i - 1), Off(track, i + 1)) || !IsSmoothWithout(track, i, most))
            {
                kept.Add(track[i]);
            }
        }

        return [.. kept];
    }

    /// <summary>Returns the distance of a point from the cubic through its four neighbours.</summary>
    private static double Off(TrackPoint[] track, int i) =>
        i < 2 || i + 2 >= track.Length ? 0
        : (track[i].Position - ((4.0 / 6.0) * (track[i - 1].Position + track[i + 1].Position)) + ((1.0 / 6.0) * (track[i - 2].Position + track[i + 2].Position))).Length;

    /// <summary>True if the neighbours are nearly on a line, so that the point between them is a spike.</summary>
    private static bool IsSmoothWithout(TrackPoint[] track, int i, double most)
    {
        Vector3d before = track[i - 1].Position - track[i - 2].Position;
        Vector3d after = track[i + 2].Position - track[i + 1].Position;
        Vector3d across = 0.5 * (track[i + 1].Position - track[i - 1].Position);
        return (across - before).Length < most && (across - after).Length < most;
    }
}
