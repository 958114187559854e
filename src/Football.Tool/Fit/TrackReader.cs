using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Fit.Reading;

namespace FootballPhysics.Tool.Fit;

/// <summary>Reads the track of a ball in many formats, and converts it to the library's coordinates: metres with y up.</summary>
/// <remarks>
/// CSV with any separator and decimal mark, with or without a header, and the layouts of <see cref="TrackLayouts"/>. Each guess is reported as one
/// line. The reader throws if a number is ambiguous. A line without a position is a gap.
/// </remarks>
internal static class TrackReader
{
    /// <summary>The minimum noise of a point, in m: written numbers are rounded.</summary>
    private const double LeastNoise = 1e-4;

    /// <summary>The maximum distance of a ball from the origin, in m.</summary>
    private const double Farthest = 1e5;

    private const double Gravity = 9.81;

    /// <summary>Reads a track.</summary>
    /// <param name="stream">The file.</param>
    /// <param name="report">Receives guesses and remarks.</param>
    /// <param name="format">The given properties of the file.</param>
    /// <param name="gravity">The gravity g, in m/s², for the check of the unit.</param>
    /// <exception cref="RefusedException">The file is not a track. The message names the line and the value, or an option to pass.</exception>
    public static TrackPoint[] Read(Stream stream, Action<string> report, TrackFormat? format = null, double gravity = Gravity) => Reading(stream, report, format, gravity).Points;

    /// <summary>Reads a track, and also returns how certain the unit is.</summary>
    /// <inheritdoc cref="Read"/>
    public static TrackReading Reading(Stream stream, Action<string> report, TrackFormat? format = null, double gravity = Gravity)
    {
        // 1. Read text and cells. 2. Find the columns. 3. Read the numbers. 4. Convert times to seconds, and sort. 5. Convert to metres.
        format ??= new TrackFormat();
        string text = TrackText.Read(stream);
        TrackTable table = TrackLayouts.Find(text, format, report) ?? CsvTable.Read(text, format, report);
        TrackColumns columns = Columns(table, format, report);
        KeepBall(table, columns, format, report);
        double[][] places = Places(table, columns, format, report);
        var reader = new TrackClock(table, columns, format, report);
        double[] clock = reader.Seconds(places);

        List<(double Time, Vector3d Place)> moments = [];
        List<int> rows = [];
        for (int i = 0; i < clock.Length; i++)
        {
            if (!double.IsNaN(clock[i]))
            {
                moments.Add((clock[i], new Vector3d(places[0][i], places[1][i], places[2][i])));
                rows.Add(i);
            }
        }

        List<long> numbers = [.. rows.Select(row => table.Lines[row].Number)];
        string Half(int at) => table.Lines[rows[at]][columns.Period];
        TrackOrder.Sort(moments, numbers, at => columns.Period >= 0 && Half(at) != Half(at - 1), reader.IsAbsolute, report);
        moments.RemoveAll(moment => double.IsNaN(moment.Place.X + moment.Place.Y + moment.Place.Z));
        if (moments.Count < 8)
        {
            throw new RefusedException("TRACK", FormattableString.Invariant($"{moments.Count} points"), "at least 8 lines with a time and a place");
        }

        double[] times = [.. moments.Select(moment => moment.Time)];
        double[][] seen = [[.. moments.Select(moment => moment.Place.X)], [.. moments.Select(moment => moment.Place.Y)], [.. moments.Select(moment => moment.Place.Z)]];
        string?[] stated = table.Unit is { } unit ? [unit, unit, unit] : columns.Units;
        TrackReading reading = TrackUnits.Convert(format, stated, times, seen, gravity, report);
        int far = Array.FindIndex(reading.Places, place => !(Math.Max(Math.Abs(place.X), Math.Max(Math.Abs(place.Y), Math.Abs(place.Z))) <= Farthest));
        return far < 0
            ? reading with { Points = [.. reading.Places.Select((place, i) => new TrackPoint(times[i], place, LeastNoise))] }
            : throw new RefusedException(FormattableString.Invariant($"The position at {times[far]} s in TRACK is more than 100 km off. Leave cells empty if the ball was not seen, or give --unit."));
    }

    /// <summary>Describes a file: its lists, its columns with their first values, and the columns that are read.</summary>
    /// <param name="stream">The file.</param>
    /// <param name="format">The given properties of the file.</param>
    /// <param name="report">Receives guesses and remarks.</param>
    /// <exception cref="RefusedException">The file is not text, or its lists cannot be read.</exception>
    public static IEnumerable<string> Describe(Stream stream, TrackFormat format, Action<string> report)
    {
        string text = TrackText.Read(stream);
        TrackTable table = TrackLayouts.Find(text, format, report) ?? CsvTable.Read(text, format, report);
        string[] header = table.Header ?? [.. Enumerable.Range(1, table.Lines.Select(line => line.Cells.Length).DefaultIfEmpty().Max()).Select(number => FormattableString.Invariant($"{number}"))];
        List<string> lines = [.. table.Parts, FormattableString.Invariant($"{table.Lines.Count} lines of {header.Length} columns{(table.Header is null ? ", without a header" : "")}")];
        for (int column = 0; column < header.Length; column++)
        {
            string[] cells = [.. table.Lines.Select(line => line[column]).Where(cell => !TrackMissing.IsMissing(cell))];
            string[] words = [.. cells.Distinct().Take(3)];
            lines.Add(FormattableString.Invariant($"column {column + 1}: {Quote.Short(header[column])}, {cells.Length} values{(words.Length > 0 ? ", such as " + string.Join(", ", words.Select(word => Quote.Short(word, 24))) : "")}"));
        }

        try
        {
            TrackColumns columns = Columns(table, format, _ => { });
            lines.Add($"read as t, x, y, z: {string.Join(", ", columns.Places.Prepend(columns.Time).Select(column => Quote.Short(header[column])))}");
        }
        catch (RefusedException refusal)
        {
            lines.Add($"cannot be read yet: {refusal.Message}");
        }

        return lines;
    }

    private static TrackColumns Columns(TrackTable table, TrackFormat format, Action<string> report)
    {
        if (table.Header is { } header)
        {
            TrackColumns? named = TrackColumns.Find(header, format) ?? (format.Columns is null ? null : TrackColumns.ByNumber(format, header.Length)?.Named(header, format));
            named?.RefuseTwins(header);
            return named ?? throw Unknown(header, format);
        }

        int count = table.Lines.Count > 0 ? table.Lines[0].Cells.Length : 0;
        TrackColumns columns = TrackColumns.ByNumber(format, count)?.Named([.. Enumerable.Range(1, count).Select(number => FormattableString.Invariant($"{number}"))], format)
            ?? throw new RefusedException(FormattableString.Invariant($"TRACK has no header, and {count} columns. Write a header t,x,y,z, or give the columns of t, x, y and z by number, such as --columns 1,3,4,5."));
        TrackLine? other = table.Lines.Where(line => line.Cells.Length > count && line.Cells.Skip(count).Any(cell => cell.Length > 0)).Select(line => (TrackLine?)line).FirstOrDefault();
        if (other is { } longer)
        {
            throw new RefusedException(FormattableString.Invariant($"line {longer.Number} has {longer.Cells.Length} cells, the first line has {count}. Put cells that contain a comma in quotes, or separate cells by semicolons."));
        }

        if (format.Columns is null)
        {
            report("guessed: there is no header; the columns are t, x, y, z.");
        }

        return columns;
    }

    private static RefusedException Unknown(string[] header, TrackFormat format)
    {
        string names = TrackColumns.Listed(header);
        if (format.Columns is { } chosen)
        {
            return new RefusedException("--columns", Quote.Short(string.Join(',', chosen)), $"four names of TRACK's columns, which are {names}, or four numbers from 1");
        }

        if (TrackColumns.HasPlaces(header))
        {
            return new RefusedException($"TRACK has positions but no clock: its columns are {names}. Name the column of times with --columns T,X,Y,Z, or give frame numbers with --rate.");
        }

        bool hasHeight = header.Any(name => name.Contains('z', StringComparison.OrdinalIgnoreCase) || name.Contains("height", StringComparison.OrdinalIgnoreCase));
        return new RefusedException(
            "TRACK's columns", names,
            "a column t | time | timestamp | frame, and x, y, z or ball_x, ball_y, ball_z" + (hasHeight ? "; --columns T,X,Y,Z names others" : "; without heights there are no flights to fit, and --columns T,X,Y,Z names a column of them"));
    }

    /// <summary>Keeps only the lines of the ball.</summary>
    private static void KeepBall(TrackTable table, TrackColumns columns, TrackFormat format, Action<string> report)
    {
        bool IsBall(string cell) => cell.Equals(format.Object?.Ball ?? "ball", StringComparison.OrdinalIgnoreCase) || (format.Object is null && cell == TrackXml.BallId);
        foreach (int column in columns.Objects)
        {
            int balls = table.Lines.Count(line => IsBall(line[column]));
            if (balls > 0 && balls < table.Lines.Count)
            {
                report(FormattableString.Invariant($"guessed: the ball's lines are the {balls} whose {Quote.Short(NameOf(table, column))} is {Quote.Short(table.Lines.First(line => IsBall(line[column]))[column])}."));
                table.Lines.RemoveAll(line => !IsBall(line[column]));
                return;
            }

            if (balls == 0 && format.Object is { } named)
            {
                string[] words = [.. table.Lines.Select(line => line[column]).Distinct()];
                throw new RefusedException("--object", Quote.Short($"{named.Column}={named.Ball}"), $"COLUMN=VALUE with a value of that column, such as {TrackColumns.Listed(words)}");
            }
        }
    }

    private static string NameOf(TrackTable table, int column) => table.Header?[column] ?? FormattableString.Invariant($"column {column + 1}");

    private static double[][] Places(TrackTable table, TrackColumns columns, TrackFormat format, Action<string> report)
    {
        char? mark = format.Decimal ?? (table.Separator == 0 ? '.' : null);
        TrackNumbers[] numbers = TrackNumbers.Of(table, columns.Places, mark, report);
        double[][] places = [new double[table.Lines.Count], new double[table.Lines.Count], new double[table.Lines.Count]];
        for (int i = 0; i < table.Lines.Count; i++)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                string cell = table.Lines[i][columns.Places[axis]];
                places[axis][i] = TrackMissing.IsMissing(cell) ? double.NaN
                    : numbers[axis].Read(cell) is { } number && double.IsFinite(number) ? number
                    : throw new RefusedException(
                        FormattableString.Invariant($"line {table.Lines[i].Number}, {Quote.Short(table.Header?[columns.Places[axis]] ?? "xyz"[axis].ToString())}"), Quote.Short(cell),
                        "a number, without thousands separators or units; empty where the ball was not seen");
            }
        }

        TrackMissing.Remove(places, report);
        return places;
    }
}
