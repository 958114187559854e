namespace FootballPhysics.Tracks;

/// <summary>Restores rounded times: 29.97 frames per second, rounded to 10 ms, are wrong by up to 5 ms. In this time, a ball at 20 m/s moves 10 cm.</summary>
internal static class TrackTiming
{
    /// <summary>The units to which times may be rounded, in s. Finer rounding moves a ball by less than its noise.</summary>
    private static readonly double[] s_units = [0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001];

    /// <summary>The maximum unit as a share of the shortest wait, and the tolerance of whole multiples, in units.</summary>
    private const double MostShare = 0.6;
    private const double Whole = 1e-4;

    /// <summary>The maximum deviation of times from equal steps, in units: half a unit plus a tolerance.</summary>
    private const double MostOff = 0.52;

    /// <summary>The number of steps from which a wait separates two parts, and the minimum number of points of a part that is restored.</summary>
    private const int LongWait = 40;
    private const int LeastPoints = 12;

    /// <summary>Returns the track with equal steps that round to its times; the track itself if there are none.</summary>
    public static TrackPoint[] Unrounded(TrackPoint[] track)
    {
        double unit = Unit(track);
        if (unit == 0)
        {
            return track;
        }

        var restored = (TrackPoint[])track.Clone();
        double step = Step(track, unit);
        bool isRestored = false;
        for (int from = 0, to; from < track.Length; from = to)
        {
            to = from + 1;
            while (to < track.Length && track[to].Time - track[to - 1].Time < LongWait * step)
            {
                to++;
            }

            isRestored |= to - from >= LeastPoints && Restore(track, restored, from, to, step, unit);
        }

        return isRestored ? restored : track;
    }

    /// <summary>Returns the largest unit of which all times are whole multiples, if waits differ by one unit; otherwise 0.</summary>
    private static double Unit(TrackPoint[] track)
    {
        double wait = double.PositiveInfinity;
        for (int i = 1; i < track.Length; i++)
        {
            wait = Math.Min(wait, track[i].Time - track[i - 1].Time);
        }

        foreach (double unit in s_units)
        {
            if (unit <= MostShare * wait && Array.TrueForAll(track, point => Math.Abs((point.Time / unit) - Math.Round(point.Time / unit)) < Whole))
            {
                for (int i = 1; i < track.Length; i++)
                {
                    double more = track[i].Time - track[i - 1].Time - wait;
                    if (Math.Abs(more - unit) < 2 * Whole * unit)
                    {
                        return unit;
                    }
                }

                return 0;
            }
        }

        return 0;
    }

    /// <summary>Returns the mean of the waits that equal the shortest wait or exceed it by one unit.</summary>
    private static double Step(TrackPoint[] track, double unit)
    {
        double least = double.PositiveInfinity;
        for (int i = 1; i < track.Length; i++)
        {
            least = Math.Min(least, track[i].Time - track[i - 1].Time);
        }

        double sum = 0;
        int count = 0;
        for (int i = 1; i < track.Length; i++)
        {
            double wait = track[i].Time - track[i - 1].Time;
            if (wait < least + (1.5 * unit))
            {
                sum += wait;
                count++;
            }
        }

        return sum / count;
    }

    /// <summary>Replaces the times of a part if equal steps round to all of them.</summary>
    private static bool Restore(TrackPoint[] track, TrackPoint[] restored, int from, int to, double step, double unit)
    {
        // Predict the step number of each point from the points before it. Then fit start and step to all points up to it by least squares.
        double first = track[from].Time;
        double start = 0;
        double n = 0;
        double sumK = 0;
        double sumT = 0;
        double sumKk = 0;
        double sumKt = 0;
        int[] steps = new int[to - from];
        for (int i = from; i < to; i++)
        {
            double time = track[i].Time - first;
            double k = Math.Round((time - start) / step);
            steps[i - from] = (int)k;
            n++;
            sumK += k;
            sumT += time;
            sumKk += k * k;
            sumKt += k * time;
            double spread = (n * sumKk) - (sumK * sumK);
            if (i - from >= LeastPoints && spread > 0)
            {
                step = ((n * sumKt) - (sumK * sumT)) / spread;
                start = (sumT - (step * sumK)) / n;
            }
        }

        double low = double.PositiveInfinity;
        double high = double.NegativeInfinity;
        for (int i = from; i < to; i++)
        {
            double off = track[i].Time - first - (start + (steps[i - from] * step));
            low = Math.Min(low, off);
            high = Math.Max(high, off);
        }

        if (high - low > 2 * MostOff * unit)
        {
            return false;
        }

        // Truncated times all have the same offset. The offset does not matter, so use the middle.
        double middle = 0.5 * (low + high);
        for (int i = from; i < to; i++)
        {
            restored[i] = new TrackPoint(first + start + middle + (steps[i - from] * step), track[i].Position, track[i].Noise);
        }

        return true;
    }
}
