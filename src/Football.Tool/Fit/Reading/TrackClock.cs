using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Fit.Reading;

/// <summary>Reads the times of a track's lines, in seconds.</summary>
internal sealed class TrackClock(TrackTable table, TrackColumns columns, TrackFormat format, Action<string> report)
{
    /// <summary>If the first time exceeds this, in s, times are counted from it: large times lose precision.</summary>
    private const double Epoch = 1e7;

    private static readonly double[] s_rates = [5, 10, 12.5, 15, 20, 24, 25, 29.97, 30, 48, 50, 59.94, 60, 90, 100, 120, 150, 200, 240, 250, 300, 500, 1000];

    /// <summary>True if the times are dates with a time of day.</summary>
    public bool IsAbsolute { get; private set; }

    /// <summary>Returns the time of each line, in s; NaN if it has none.</summary>
    /// <param name="places">The columns of positions as written; used to suggest a frame rate.</param>
    public double[] Seconds(double[][] places)
    {
        int column = format.Rate is not null && columns.Frame >= 0 ? columns.Frame : columns.Time;
        string[] cells = [.. table.Lines.Select(line => line[column])];
        string first = Array.Find(cells, cell => !TrackMissing.IsMissing(cell)) ?? throw new RefusedException("TRACK", "0 points", "at least 8 lines with a time and a place");
        bool isClock = TrackTimes.Clock(first) is not null || TrackTimes.Date(first) is not null || TrackTimes.IsTimecode(first);
        double[] times = isClock ? Clocks(cells) : Numbers(column, cells, places);
        double start = times.Where(double.IsFinite).DefaultIfEmpty(0).Min();
        if (Math.Abs(start) > Epoch)
        {
            report(FormattableString.Invariant($"guessed: times count from {start:0.###} s, the first."));
            times = [.. times.Select(time => time - start)];
        }

        return times;
    }

    private double[] Clocks(string[] cells)
    {
        if (format.Rate is not null && !TrackTimes.IsTimecode(Array.Find(cells, cell => !TrackMissing.IsMissing(cell))!))
        {
            throw new RefusedException("--rate needs a column of frame numbers, and TRACK has times. Leave --rate out, or name that column with --columns.");
        }

        DateTimeOffset? first = null;
        double[] times = new double[cells.Length];
        for (int i = 0; i < cells.Length; i++)
        {
            string cell = cells[i];
            if (TrackMissing.IsMissing(cell))
            {
                times[i] = double.NaN;
            }
            else if (TrackTimes.Clock(cell) is { } clock)
            {
                times[i] = clock;
            }
            else if (TrackTimes.IsTimecode(cell))
            {
                times[i] = TrackTimes.Timecode(cell, format.Rate ?? throw new RefusedException($"{Where(i)} is {Quote.Short(cell)}, a timecode that ends with a frame. Give --rate with the frames a second."))!.Value;
            }
            else if (TrackTimes.Date(cell) is { } date)
            {
                first ??= date;
                times[i] = (date - first.Value).TotalSeconds;
            }
            else
            {
                throw Refused(i, cell);
            }
        }

        IsAbsolute = first is not null;
        return times;
    }

    private double[] Numbers(int column, string[] cells, double[][] places)
    {
        TrackNumbers numbers = TrackNumbers.Of(table, [column], format.Decimal ?? (table.Separator == 0 ? '.' : null), report: _ => { })[0];
        double[] times = new double[cells.Length];
        for (int i = 0; i < cells.Length; i++)
        {
            times[i] = TrackMissing.IsMissing(cells[i]) ? double.NaN : numbers.Read(cells[i]) is { } time && Math.Abs(time) < 1e20 ? time : throw Refused(i, cells[i]);
        }

        double wait = TrackTimes.UsualWait(times);
        RefuseUnsorted(times);
        double seconds = Unit(column, wait, times, places);
        return [.. times.Select(time => time * seconds)];
    }

    /// <summary>Returns the duration of a time unit, in s.</summary>
    private double Unit(int column, double wait, double[] times, double[][] places)
    {
        if (format.Rate is { } rate)
        {
            bool isWhole = times.All(time => double.IsNaN(time) || time == Math.Round(time));
            return isWhole ? 1 / rate : throw new RefusedException("--rate needs a column of frame numbers, and TRACK has times. Leave --rate out, or name that column with --columns.");
        }

        if (format.TimeUnit is { } given)
        {
            return TrackFormat.Seconds(given)!.Value;
        }

        if (column == columns.Frame)
        {
            throw new RefusedException("TRACK has frame numbers and no times. Give --rate with the frames a second" + Likely(times, places) + ".");
        }

        if (columns.TimeUnit is { } stated)
        {
            return TrackFormat.Seconds(stated)!.Value;
        }

        string? unit;
        try
        {
            unit = TrackTimes.Unit(wait);
        }
        catch (RefusedException refusal) when (wait is >= 0.99 and <= 1.01)
        {
            throw new RefusedException(refusal.Message.TrimEnd('.') + Likely(times, places) + ".");
        }

        if (unit is not null)
        {
            report($"guessed: times are {unit}, because they go up by {wait.ToString("0.###", System.Globalization.CultureInfo.InvariantCulture)}; --time-unit gives another unit.");
        }

        return unit is null ? 1 : TrackFormat.Seconds(unit)!.Value;
    }

    /// <summary>Suggests a frame rate: the one at which the ball falls with g if positions are in metres.</summary>
    private string Likely(double[] frames, double[][] places)
    {
        double metres = table.Unit is { } unit ? TrackFormat.Metres(unit)!.Value : 1;
        int[] seen = [.. Enumerable.Range(0, frames.Length).Where(i => !double.IsNaN(frames[i] + places[2][i])).OrderBy(i => frames[i])];
        TrackFall fall = TrackFall.Of([.. seen.Select(i => frames[i])], [.. seen.Select(i => places[2][i])]);
        if (!fall.IsSure || !(fall.Fall > 0))
        {
            return "";
        }

        double rate = Math.Sqrt(9.81 / (metres * fall.Fall));
        double usual = s_rates.MinBy(likely => Math.Abs(Math.Log(likely / rate)));
        return FormattableString.Invariant($"; by the fall of the ball it is about {usual}, if heights are {table.Unit ?? "m"}");
    }

    /// <summary>Throws if a file without a header has a first column that does not increase, because it is then not a time.</summary>
    private void RefuseUnsorted(double[] times)
    {
        double[] seen = [.. times.Where(double.IsFinite)];
        int forwards = Enumerable.Range(1, Math.Max(0, seen.Length - 1)).Count(i => seen[i] >= seen[i - 1]);
        if (table.Header is null && format.Columns is null && forwards < 0.9 * (seen.Length - 1))
        {
            throw new RefusedException("TRACK has no header, and its first column does not go up as times do. Write a header t,x,y,z, or give --columns with the numbers of t, x, y and z.");
        }
    }

    private string Where(int i) => FormattableString.Invariant($"line {table.Lines[i].Number}, time");

    private RefusedException Refused(int i, string cell) => new(Where(i), Quote.Short(cell), "seconds, milliseconds, m:ss.cc, hh:mm:ss, a duration, or a date and time of ISO 8601, the same way in all lines");
}
