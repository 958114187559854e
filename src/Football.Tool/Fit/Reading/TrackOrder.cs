using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Fit.Reading;

/// <summary>Brings the lines of a track into the order of time; a clock that begins again with a half or a match goes on a minute later.</summary>
internal static class TrackOrder
{
    /// <summary>Between parts whose times are shifted, s.</summary>
    private const double BetweenParts = 60;

    /// <summary>A clock begins again at most so often, and runs for so many lines.</summary>
    private const int MostParts = 40;
    private const int LeastLines = 8;

    /// <summary>More lines than this share with the time of another line and another place are another ball's.</summary>
    private const double MostRepeats = 0.02;

    /// <summary>Sorts moments.</summary>
    /// <param name="moments">Times and places, as in the file; places are NaN if the ball was not seen.</param>
    /// <param name="numbers">Their lines.</param>
    /// <param name="isPart">True for a line of another half than the one above.</param>
    /// <param name="said">Receives remarks.</param>
    public static void Sort(List<(double Time, Vector3d Place)> moments, List<long> numbers, Func<int, bool> isPart, Action<string> said)
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

        if (BeginsAgain(moments, backwards, isPart))
        {
            Shift(moments, numbers, backwards, said);
        }
        else
        {
            // A stable sort: lines of one time stay in their order.
            int[] order = [.. Enumerable.Range(0, moments.Count).OrderBy(i => moments[i].Time)];
            (double Time, Vector3d Place)[] sorted = [.. order.Select(i => moments[i])];
            long[] lines = [.. order.Select(i => numbers[i])];
            moments.Clear();
            moments.AddRange(sorted);
            numbers.Clear();
            numbers.AddRange(lines);
            said(FormattableString.Invariant($"guessed: lines are out of order; {backwards.Count} times go back, and all lines were sorted by time."));
        }

        RefuseRepeats(moments, numbers);
    }

    /// <summary>True if the times that go back are those of parts that each begin again: of halves, or where the parts share times.</summary>
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

    private static void Shift(List<(double Time, Vector3d Place)> moments, List<long> numbers, List<int> backwards, Action<string> said)
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
                said(FormattableString.Invariant($"line {numbers[i]}: the clock begins again; from here on times are {shift:0.###} s later than written."));
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
                $"line {numbers[at]}: the time is that of another line, at another place, as in {repeats} lines. Keep the lines of one ball, with times to the millisecond, or give --rate if the file has frame numbers."));
        }
    }

    private static bool IsSeen(Vector3d place) => !double.IsNaN(place.X + place.Y + place.Z);
}
