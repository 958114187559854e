using System.Globalization;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Fit;

/// <summary>Reads the track of a ball from CSV as trackers write it: a header, then a line a moment; positions in the frame of a pitch, z up, become those of the library, y up.</summary>
/// <remarks>
/// Columns by name, in any order, others ignored: time t, time or timestamp (seconds, [days ]hh:mm:ss, or a date and time of ISO 8601), place x, y, z or ball_x, ball_y, ball_z
/// as kloppy writes them, each also with _m, _cm or _mm behind it. A line without a place (empty, nan, null, none) is a gap.
/// </remarks>
internal static class TrackReader
{
    private const long LongestFile = 1L << 30;

    /// <summary>The maximum absolute coordinate, m.</summary>
    private const double Farthest = 1e5;

    /// <summary>The least noise that a point is taken for, m: what is written has a last digit.</summary>
    private const double LeastNoise = 1e-4;

    /// <summary>A clock that goes back by more than this has restarted, s.</summary>
    private const double Restart = 1;

    /// <summary>Between parts whose times are shifted, s.</summary>
    private const double BetweenParts = 60;

    private static readonly string[] Times = ["t", "time", "timestamp", "time_s", "seconds"];

    private static readonly (string Suffix, double Metres)[] Units = [("", 1), ("_m", 1), ("_cm", 0.01), ("_mm", 0.001)];

    /// <summary>Reads it.</summary>
    /// <param name="stream">The file.</param>
    /// <param name="said">Told what a person should know.</param>
    /// <exception cref="RefusedException">The file is not a track; the message names the line, the value and the allowed values.</exception>
    public static TrackPoint[] Read(Stream stream, Action<string> said)
    {
        if (stream.CanSeek && stream.Length > LongestFile)
        {
            throw new RefusedException("TRACK", FormattableString.Invariant($"{stream.Length} bytes"), FormattableString.Invariant($"at most {LongestFile} bytes"));
        }

        using var reader = new StreamReader(stream, leaveOpen: true);
        string[] header = Split(reader.ReadLine() ?? throw new RefusedException("TRACK", "empty", "a header and lines of t, x, y, z"));
        int time = Column(header, Times, [("", 1)], "t | time | timestamp", out _);
        int x = Column(header, ["x", "ball_x"], Units, "x | ball_x", out double perX);
        int y = Column(header, ["y", "ball_y"], Units, "y | ball_y", out double perY);
        int z = Column(header, ["z", "ball_z"], Units, "z | ball_z", out double perZ);
        var points = new List<TrackPoint>();
        DateTimeOffset? first = null;
        double shift = 0;
        double last = double.NegativeInfinity;
        for (long line = 2; reader.ReadLine() is { } text; line++)
        {
            if (string.IsNullOrWhiteSpace(text))
            {
                continue;
            }

            string[] cells = Split(text);
            string Cell(int at) => at < cells.Length ? cells[at] : "";
            if (IsMissing(Cell(time)))
            {
                continue;
            }

            double t = Time(Cell(time), line, ref first) + shift;
            if (t < last - Restart)
            {
                // The clock restarts with each half or match: the following points are placed a minute later.
                shift += last + BetweenParts - t;
                t = last + BetweenParts;
                said(FormattableString.Invariant($"line {line}: the clock begins anew; from here on times are {shift:0.###} s later than written."));
            }
            else if (t < last)
            {
                throw Refused(line, header[time], Cell(time), "a time that is not before the one above; a clock that begins anew goes back by more than a second");
            }

            last = t;
            if (IsMissing(Cell(x)) || IsMissing(Cell(y)) || IsMissing(Cell(z)))
            {
                continue;
            }

            double px = perX * Place(Cell(x), line, header[x]);
            double py = perY * Place(Cell(y), line, header[y]);
            double pz = perZ * Place(Cell(z), line, header[z]);
            points.Add(new TrackPoint(t, new Vector3d(px, pz, -py), LeastNoise));
        }

        return points.Count >= 8
            ? [.. points]
            : throw new RefusedException("TRACK", FormattableString.Invariant($"{points.Count} points"), "at least 8 lines with a time and a position");
    }

    private static string[] Split(string line) => [.. line.Split(line.Contains(';', StringComparison.Ordinal) && !line.Contains(',', StringComparison.Ordinal) ? ';' : ',').Select(cell => cell.Trim().Trim('"', '\uFEFF').Trim())];

    private static int Column(string[] header, string[] names, (string Suffix, double Metres)[] units, string wanted, out double metres)
    {
        foreach (string name in names)
        {
            foreach ((string suffix, double unit) in units)
            {
                int at = Array.FindIndex(header, column => column.Equals(name + suffix, StringComparison.OrdinalIgnoreCase));
                if (at >= 0)
                {
                    metres = unit;
                    return at;
                }
            }
        }

        throw new RefusedException("TRACK's header", Quote.Short(string.Join(',', header)), $"a column {wanted}");
    }

    private static bool IsMissing(string cell) =>
        cell.Length == 0 || cell.Equals("nan", StringComparison.OrdinalIgnoreCase) || cell.Equals("null", StringComparison.OrdinalIgnoreCase)
        || cell.Equals("none", StringComparison.OrdinalIgnoreCase) || cell.Equals("na", StringComparison.OrdinalIgnoreCase);

    /// <summary>Seconds; of a date and time those since the first.</summary>
    private static double Time(string cell, long line, ref DateTimeOffset? first)
    {
        if (double.TryParse(cell, NumberStyles.Float, CultureInfo.InvariantCulture, out double seconds))
        {
            return Math.Abs(seconds) <= 1e10 ? seconds : throw Refused(line, "time", cell, "seconds up to 1e10");
        }

        // "0 days 00:00:00.040000", as pandas writes a time
        string clock = cell.Replace(" days ", ".", StringComparison.Ordinal);
        if (TimeSpan.TryParse(clock, CultureInfo.InvariantCulture, out TimeSpan span))
        {
            return span.TotalSeconds;
        }

        if (DateTimeOffset.TryParse(cell, CultureInfo.InvariantCulture, DateTimeStyles.AssumeUniversal, out DateTimeOffset date))
        {
            first ??= date;
            return (date - first.Value).TotalSeconds;
        }

        throw Refused(line, "time", cell, "seconds, hh:mm:ss, or a date and time of ISO 8601");
    }

    private static double Place(string cell, long line, string column) =>
        double.TryParse(cell, NumberStyles.Float, CultureInfo.InvariantCulture, out double place) && Math.Abs(place) <= Farthest
            ? place
            : throw Refused(line, column, cell, "a number of metres, within ±100 km; empty where the ball was not seen");

    private static RefusedException Refused(long line, string column, string value, string allowed) =>
        new(FormattableString.Invariant($"line {line}, {Quote.Short(column)}"), Quote.Short(value), allowed);
}
