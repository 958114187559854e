using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Fit.Reading;

/// <summary>
/// Sorts the lines of a track by time. If the clock restarts with a half or a match, the later part is shifted to a minute after the earlier one.
/// </summary>
internal static class TrackOrder
{
    /// <summary>The time between parts whose times are shifted, in s.</summary>
    private const double BetweenParts = 60;

    /// <summary>The maximum number of restarts of a clock, and the minimum number of lines in a part.</summary>
    private const int MostParts = 40;
    private const int LeastLines = 8;

    /// <summary>The maximum share of lines with the time of another line but another position. More such lines belong to several balls.</summary>
    private const double MostRepeats = 0.02;

    /// <summary>Sorts the moments.</summary>
    /// <param name="moments">The times and positions as in the file; positions are NaN if the ball was not seen.</param>
    /// <param name="numbers">The line numbers of the moments.</param>
    /// <param name="isPart">True if the half of a line differs from that of the line before.</param>
    /// <param name="isAbsolute">True if the times are dates with a time of day: such a clock never restarts.</param>
    /// <param name="report">Receives remarks.</param>
    public static void Sort(List<(double Time, Vector3d Place)> moments, List<long> numbers, Func<int, bool> isPart, bool isAbsolute, Action<string> report)
    {
        List<int> backwards = [];
        for (int i = 1; i < moments.Count; i++)
        {
            if (moments[i].Time < moments[i - 1].Time)
            {
                backwards.Add(i);
            }
        }

        if (backwards.Count == 0)
        {
            RefuseRepeats(moments, numbers);
            return;
        }

        if (!isAbsolute && BeginsAgain(moments, backwards, isPart))
        {
            Shift(moments, numbers, backwards, report);
        }
        else
        {
            // The sort is stable: lines with equal times keep their order.
            int[] order = [.. Enumerable.Range(0, moments.Count).OrderBy(i => moments[i].Time)];
            (double Time, Vector3d Place)[] sorted = [.. order.Select(i => moments[i])];
            long[] lines = [.. order.Select(i => numbers[i])];
            moments.Clear();
            moments.AddRange(sorted);
            numbers.Clear();
            numbers.AddRange(lines);
            report(FormattableString.Invariant($"guessed: lines are out of order; {backwards.Count} times go back, and all lines were sorted by time."));
        }

        RefuseRepeats(moments, numbers);
    }

    /// <summary>True if the clock restarts: at each step back a new half starts, or the parts overlap in time.</summary>
    private static bool BeginsAgain(List<(double Time, Vector3d Place)> moments, List<int> backwards, Func<int, bool> isPart)
    {
        if (backwards.All(isPart))
        {
            return true;
        }

        int from = 0;
        var parts = new List<(double First, double Last)>();
        foreach (int end in backwards.Append(moments.Count))
        {
            if (end - from < LeastLines || parts.Count > MostParts)
            {
                return false;
            }

            parts.Add((moments[from].Time, moments[end - 1].Time));
            from = end;
        }

        parts.Sort();
        return Enumerable.Range(1, parts.Count - 1).Any(i => parts[i].First < parts[i - 1].Last);
    }

    private static void Shift(List<(double Time, Vector3d Place)> moments, List<long> numbers, List<int> backwards, Action<string> report)
    {
        double shift = 0;
        int next = 0;
        for (int i = 0; i < moments.Count; i++)
        {
            double time = moments[i].Time + shift;
            if (next < backwards.Count && backwards[next] == i)
            {
                double last = moments[i - 1].Time;
                shift += last + BetweenParts - time;
                time = last + BetweenParts;
                next++;
                report(FormattableString.Invariant($"line {numbers[i]}: the clock begins again; from here on times are {shift:0.###} s later than written."));
            }

            moments[i] = (time, moments[i].Place);
        }
    }

    private static void RefuseRepeats(List<(double Time, Vector3d Place)> moments, List<long> numbers)
    {
        int repeats = 0;
        int at = 0;
        for (int i = 1; i < moments.Count; i++)
        {
            if (moments[i].Time == moments[i - 1].Time && IsSeen(moments[i].Place) && IsSeen(moments[i - 1].Place) && moments[i].Place != moments[i - 1].Place)
            {
                repeats++;
                at = i;
            }
        }

        if (repeats > MostRepeats * moments.Count && repeats > 2)
        {
            throw new RefusedException(FormattableString.Invariant(
                $"line {numbers[at]}: the time is that of another line, at another place, as in {repeats} lines. Keep the lines of one ball, or name the column of the objects, such as --object COLUMN=ball; write times to the millisecond, or give --rate if the file has frame numbers."));
        }
    }

    private static bool IsSeen(Vector3d place) => !double.IsNaN(place.X + place.Y + place.Z);
}
