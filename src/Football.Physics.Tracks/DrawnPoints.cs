namespace FootballPhysics.Tracks;

/// <summary>Removes points that were not measured: those on straight lines between others, and repeated positions of a moving ball.</summary>
/// <remarks>
/// A tracker that loses the ball fills the gap by interpolation, or holds the last position. A flight falls by g dt²/2 between a point and the middle of
/// its neighbours, and noise moves the point further; only a drawn point lies between them to the last digit.
/// </remarks>
internal static class DrawnPoints
{
    /// <summary>The tolerance of a drawn point, in units of the last digit, and at least in m.</summary>
    private const double Digits = 1.1;
    private const double LeastTolerance = 1e-6;

    /// <summary>The share of the fall between points that the tolerance must not exceed, and the share of the median distance from a line.</summary>
    private const double MostOfFall = 0.3;
    private const double MostOfUsual = 0.3;

    /// <summary>The minimum number of successive points on a line, and of repeated positions.</summary>
    private const int LeastPoints = 2;
    private const int LeastHeld = 1;

    /// <summary>The height above the lowest tenth of the track below which a ball may roll straight, in m, and the vertical speed of a ball that does not roll, in m/s.</summary>
    private const double Low = 0.5;
    private const double LeastFallSpeed = 0.5;

    /// <summary>The distance after a held position, in m, that a ball does not move in one step unless it moved before.</summary>
    private const double LeastJump = 0.15;

    private const double Gravity = 9.81;

    /// <summary>Removes the points.</summary>
    /// <param name="track">The points.</param>
    /// <param name="lines">The number of points on straight lines.</param>
    /// <param name="held">The number of repeated positions.</param>
    public static TrackPoint[] Remove(TrackPoint[] track, out int lines, out int held)
    {
        (lines, held) = (0, 0);
        if (track.Length < 8)
        {
            return track;
        }

        bool[] gone = new bool[track.Length];
        held = MarkHeld(track, gone);
        lines = MarkLines(track, gone);
        if (lines + held == 0)
        {
            return track;
        }

        List<TrackPoint> kept = [];
        for (int i = 0; i < track.Length; i++)
        {
            if (!gone[i])
            {
                kept.Add(track[i]);
            }
        }

        return [.. kept];
    }

    private static int MarkLines(TrackPoint[] track, bool[] gone)
    {
        double[] off = new double[track.Length];
        for (int i = 1; i + 1 < track.Length; i++)
        {
            double share = (track[i].Time - track[i - 1].Time) / (track[i + 1].Time - track[i - 1].Time);
            Vector3d d = track[i].Position - track[i - 1].Position - (share * (track[i + 1].Position - track[i - 1].Position));
            off[i] = Math.Max(Math.Abs(d.X), Math.Max(Math.Abs(d.Y), Math.Abs(d.Z)));
        }

        double[] heights = Sorted(track, 1);
        double high = heights[heights.Length / 10] + Low;
        List<double> usual = [];
        for (int i = 1; i + 1 < track.Length; i++)
        {
            if (track[i].Position.Y > high)
            {
                usual.Add(off[i]);
            }
        }

        usual.Sort();
        double wait = (track[^1].Time - track[0].Time) / (track.Length - 1);
        double tolerance = Math.Max(LeastTolerance, Digits * Digit(track));
        if (usual.Count == 0 || tolerance > MostOfUsual * usual[usual.Count * 3 / 4] || tolerance > MostOfFall * 0.5 * Gravity * wait * wait)
        {
            return 0;
        }

        bool Flies(int i) => track[i].Position.Y > high
            || Math.Abs(track[i + 1].Position.Y - track[i - 1].Position.Y) > LeastFallSpeed * (track[i + 1].Time - track[i - 1].Time);
        int count = 0;
        for (int i = 1; i + 1 < track.Length;)
        {
            int end = i;
            while (end + 1 < track.Length && off[end] <= tolerance && Flies(end) && !gone[end])
            {
                end++;
            }

            if (end - i >= LeastPoints)
            {
                Array.Fill(gone, true, i, end - i);
                count += end - i;
            }

            i = Math.Max(end, i + 1);
        }

        return count;
    }

    private static int MarkHeld(TrackPoint[] track, bool[] gone)
    {
        int count = 0;
        for (int i = 1; i < track.Length;)
        {
            int end = i;
            while (end < track.Length && track[end].Position == track[i - 1].Position)
            {
                end++;
            }

            bool moves = i >= 2 && end < track.Length && (track[end].Position - track[i - 1].Position).Length > LeastJump
                && (track[i - 1].Position - track[i - 2].Position).Length > 0.25 * (track[end].Position - track[i - 1].Position).Length / (end - i + 1);
            if (end - i >= LeastHeld && moves)
            {
                Array.Fill(gone, true, i, end - i);
                count += end - i;
            }

            i = Math.Max(end, i + 1);
        }

        return count;
    }

    /// <summary>Returns the unit of the last digit: the least difference between coordinates.</summary>
    private static double Digit(TrackPoint[] track)
    {
        double least = double.PositiveInfinity;
        for (int axis = 0; axis < 3; axis++)
        {
            double[] sorted = Sorted(track, axis);
            for (int i = 1; i < sorted.Length; i++)
            {
                double step = sorted[i] - sorted[i - 1];
                least = step > 1e-9 && step < least ? step : least;
            }
        }

        return double.IsFinite(least) ? least : 0;
    }

    private static double[] Sorted(TrackPoint[] track, int axis)
    {
        double[] sorted = new double[track.Length];
        for (int i = 0; i < sorted.Length; i++)
        {
            sorted[i] = track[i].Position.Along(axis);
        }

        Array.Sort(sorted);
        return sorted;
    }
}
