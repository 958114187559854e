namespace FootballPhysics.Tool.Fit.Reading;

/// <summary>Finds cells and lines in which the ball was not seen.</summary>
internal static class TrackMissing
{
    private static readonly HashSet<string> s_words = new(StringComparer.OrdinalIgnoreCase)
    {
        "", "nan", "-nan", "+nan", "null", "none", "na", "n/a", "#n/a", "#n/a n/a", "#na", "#num!", "#value!", "#div/0!", "#ref!", "#null!", "#name?", "<na>", "nat", "nil", "inf", "-inf", "+inf",
        "infinity", "-infinity", "+infinity", "∞", "-∞", "1.#ind", "-1.#ind", "1.#qnan", "-1.#qnan", "1.#inf", "-1.#inf", "-", "--", "?", ".", "missing", "undefined", "nan(ind)", "-nan(ind)",
    };

    private static readonly double[] s_codes = [-999, -9999, -99999, -999999, 9999, 99999, 999999, -32768, 32767, -2147483648, 2147483647];

    /// <summary>The minimum jump to and from a code for "not seen", as a multiple of the median step.</summary>
    private const double Jump = 10;

    /// <summary>True if a cell contains no number.</summary>
    public static bool IsMissing(string cell) => s_words.Contains(cell);

    /// <summary>Replaces positions that are a code for "not seen" by NaN.</summary>
    /// <param name="places">The three columns of numbers as written; NaN for missing numbers.</param>
    /// <param name="report">Receives remarks.</param>
    public static void Remove(double[][] places, Action<string> report)
    {
        RemoveCodes(places, report);
        RemoveParked(places, report);
    }

    private static void RemoveCodes(double[][] places, Action<string> report)
    {
        int removed = 0;
        double last = 0;
        double[] most = [.. places.Select(Largest)];
        for (int i = 0; i < places[0].Length; i++)
        {
            int codes = 0;
            bool isFar = false;
            for (int axis = 0; axis < 3; axis++)
            {
                double value = places[axis][i];
                if (Array.IndexOf(s_codes, value) >= 0)
                {
                    codes++;
                    last = value;
                    isFar |= Math.Abs(value) > 3 * most[axis];
                }
            }

            if (isFar || codes >= 2)
            {
                places[0][i] = places[1][i] = places[2][i] = double.NaN;
                removed++;
            }
        }

        if (removed > 0)
        {
            report(FormattableString.Invariant($"guessed: {last} stands for a ball that was not seen, in {removed} lines."));
        }
    }

    /// <summary>Returns the 90th percentile of the magnitudes, without codes.</summary>
    private static double Largest(double[] column)
    {
        double[] sorted = [.. column.Where(value => !double.IsNaN(value) && Array.IndexOf(s_codes, value) < 0).Select(Math.Abs).Order()];
        return sorted.Length > 0 ? sorted[9 * (sorted.Length - 1) / 10] : 0;
    }

    /// <summary>Removes positions such as (0, 0, −10) or (0, 0, 0), which some trackers write for a ball that they do not see.</summary>
    private static void RemoveParked(double[][] places, Action<string> report)
    {
        int count = places[0].Length;
        double usual = UsualStep(places);
        if (!(usual > 0))
        {
            return;
        }

        var parked = new Dictionary<(double, double, double), int>();
        for (int i = 0; i < count;)
        {
            var place = (places[0][i], places[1][i], places[2][i]);
            int end = i + 1;
            while (end < count && (places[0][end], places[1][end], places[2][end]) == place)
            {
                end++;
            }

            bool isRound = place.Item1 == Math.Round(place.Item1) && place.Item2 == Math.Round(place.Item2) && place.Item3 == Math.Round(place.Item3);
            bool isOrigin = place.Item1 == place.Item2 && Math.Abs(place.Item1) <= 1;
            bool jumps = Step(places, Previous(places, i), i) > Jump * usual && Step(places, end - 1, Next(places, end)) > Jump * usual;
            if (isRound && isOrigin && (jumps || place.Item3 <= -5))
            {
                parked[place] = parked.GetValueOrDefault(place) + end - i;
                for (int k = i; k < end; k++)
                {
                    places[0][k] = places[1][k] = places[2][k] = double.NaN;
                }
            }

            i = end;
        }

        foreach (((double x, double y, double z), int lines) in parked)
        {
            report(FormattableString.Invariant($"guessed: ({x}, {y}, {z}) stands for a ball that was not seen, in {lines} lines."));
        }
    }

    private static int Previous(double[][] places, int at)
    {
        while (--at >= 0 && double.IsNaN(places[0][at] + places[1][at] + places[2][at]))
        {
        }

        return at;
    }

    private static int Next(double[][] places, int at)
    {
        while (at < places[0].Length && double.IsNaN(places[0][at] + places[1][at] + places[2][at]))
        {
            at++;
        }

        return at < places[0].Length ? at : -1;
    }

    /// <summary>Returns the distance between two lines; 0 if one of them does not exist.</summary>
    private static double Step(double[][] places, int a, int b)
    {
        if (a < 0 || b < 0)
        {
            return 0;
        }

        double x = places[0][b] - places[0][a];
        double y = places[1][b] - places[1][a];
        double z = places[2][b] - places[2][a];
        return Math.Sqrt((x * x) + (y * y) + (z * z));
    }

    /// <summary>Returns the median step of a moving ball.</summary>
    private static double UsualStep(double[][] places)
    {
        double[] steps = [.. Enumerable.Range(1, Math.Max(0, places[0].Length - 1)).Select(i => Step(places, i - 1, i)).Where(step => step > 0).Order()];
        return steps.Length > 0 ? steps[steps.Length / 2] : 0;
    }
}
