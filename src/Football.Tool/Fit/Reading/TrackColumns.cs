using System.Globalization;
using System.Text;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Fit.Reading;

/// <summary>The columns of a track in a table, and the units that their names state.</summary>
internal sealed record TrackColumns
{
    private static readonly string[] s_times = ["t", "time", "timestamp", "seconds", "sec", "secs", "time_sec", "time_seconds", "elapsed", "elapsed_time", "game_time", "match_time", "video_time", "zeit", "temps", "tiempo", "datetime", "date_time", "milliseconds", "millis"];

    /// <summary>The clocks of trackers, from the most to the least useful, for files without one of <see cref="s_times"/>.</summary>
    private static readonly string[] s_clocks = ["game_clock", "match_clock", "period_elapsed_time", "period_game_clock_time", "video_time", "utc_time", "wall_clock"];
    private static readonly string[] s_frames = ["frame", "frames", "frame_id", "frameid", "frame_number", "frame_num", "frame_no", "frame_nr", "frame_idx", "frame_index", "frame_count", "framecount", "frame_idx", "idx"];
    private static readonly string[] s_periods = ["period", "phase", "period_id", "half", "section", "game_section", "gamesection", "period_number"];
    private static readonly string[] s_objects = ["object", "object_id", "object_type", "entity", "entity_id", "type", "team", "team_id", "team_name", "name", "player", "player_id", "group", "group_name", "track_id", "class", "label", "participation_id"];

    /// <summary>The prefixes and suffixes of x, y and z in column names of a ball, from the most to the least certain.</summary>
    private static readonly (string Before, string After)[] s_families =
    [
        ("ball_", ""), ("", "_ball"), ("ball_data_", ""), ("ball_pos_", ""), ("ball_position_", ""), ("balls_", ""), ("ball_0_", ""), ("ball_xyz_", ""), ("ball_coordinates_", ""), ("ball_center_", ""),
        ("pos_", ""), ("position_", ""), ("", "_pos"), ("", "_position"), ("coord_", ""), ("coordinates_", ""), ("p", ""), ("", "_coord"), ("", ""),
    ];

    private static readonly (string Suffix, string Unit)[] s_lengths =
    [
        ("_cm", "cm"), ("_centimetres", "cm"), ("_centimeters", "cm"), ("_mm", "mm"), ("_millimetres", "mm"), ("_millimeters", "mm"), ("_km", "km"), ("_metres", "m"), ("_meters", "m"), ("_m", "m"),
        ("_ft", "ft"), ("_feet", "ft"), ("_foot", "ft"), ("_yd", "yd"), ("_yds", "yd"), ("_yards", "yd"), ("_yard", "yd"), ("_in", "in"), ("_inches", "in"), ("_inch", "in"),
    ];

    private static readonly (string Suffix, string Unit)[] s_durations =
    [
        ("_ms", "ms"), ("_msec", "ms"), ("_millis", "ms"), ("_milliseconds", "ms"), ("_us", "us"), ("_µs", "us"), ("_microseconds", "us"), ("_ns", "ns"), ("_nanoseconds", "ns"),
        ("_s", "s"), ("_sec", "s"), ("_secs", "s"), ("_seconds", "s"), ("_min", "min"), ("_minutes", "min"),
    ];

    /// <summary>The maximum number of columns that a message names.</summary>
    private const int MostNamed = 24;

    public required int Time { get; init; }

    public required int[] Places { get; init; }

    /// <summary>The index of the column of frame numbers; −1 if there is none.</summary>
    public int Frame { get; init; } = -1;

    /// <summary>The index of the column of the half; −1 if there is none.</summary>
    public int Period { get; init; } = -1;

    /// <summary>The indices of columns that may identify the lines of the ball.</summary>
    public int[] Objects { get; init; } = [];

    /// <summary>The unit of the times; null if not stated.</summary>
    public string? TimeUnit { get; init; }

    /// <summary>The units of x, y and z; null if not stated.</summary>
    public string?[] Units { get; init; } = [null, null, null];

    /// <summary>Returns the columns of a header; null if the names are not those of a track.</summary>
    public static TrackColumns? Find(string[] header, TrackFormat format) => Search(header, format) is { } found ? found.Named(header, format) : null;

    private static TrackColumns? Search(string[] header, TrackFormat format)
    {
        string[] names = [.. header.Select(Plain)];
        if (format.Columns is { } chosen)
        {
            int[] at = [.. chosen.Select(name => Array.IndexOf(header, name) is >= 0 and { } exact ? exact : Array.IndexOf(names, Plain(name)))];
            return at.Min() < 0 ? null : Of(names, at[0], at[1..], [.. at[1..].Select(i => Unit(names[i], s_lengths))]);
        }

        int frame = Array.FindIndex(names, name => s_frames.Contains(name));
        int time = Array.FindIndex(names, name => s_times.Contains(name));
        for (int i = 0; i < s_durations.Length && time < 0; i++)
        {
            time = Array.FindIndex(names, name => s_times.Any(plain => name == plain + s_durations[i].Suffix));
        }

        for (int i = 0; i < s_clocks.Length && time < 0; i++)
        {
            time = Array.FindIndex(names, name => name == s_clocks[i] || (Unit(name, s_durations) is not null && name.StartsWith(s_clocks[i] + "_", StringComparison.Ordinal)));
        }

        // If there is no other time, use an unnamed index, as pandas writes it.
        time = time >= 0 ? time : frame >= 0 ? frame : Array.FindIndex(names, name => name is "" or "index" or "unnamed_0");
        if (time < 0)
        {
            return null;
        }

        foreach ((string before, string after) in s_families)
        {
            int[] places = new int[3];
            string?[] units = new string?[3];
            for (int axis = 0; axis < 3; axis++)
            {
                (places[axis], units[axis]) = Place(names, before, after, axis);
            }

            if (places.Min() >= 0)
            {
                return Of(names, time, places, units);
            }
        }

        return null;
    }

    /// <summary>True if a header names x, y and z, with or without a time.</summary>
    public static bool HasPlaces(string[] header)
    {
        string[] names = [.. header.Select(Plain)];
        return s_families.Any(family => Enumerable.Range(0, 3).All(axis => Place(names, family.Before, family.After, axis).At >= 0));
    }

    /// <summary>Returns the columns of a table without a header: by number, or the four columns t, x, y and z.</summary>
    public static TrackColumns? ByNumber(TrackFormat format, int count)
    {
        if (format.Columns is { } chosen)
        {
            int[] at = [.. chosen.Select(text => int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int number) && number >= 1 && number <= count ? number - 1 : -1)];
            return at.Min() < 0 ? null : new TrackColumns { Time = at[0], Places = at[1..] };
        }

        return count == 4 ? new TrackColumns { Time = 0, Places = [1, 2, 3] } : null;
    }

    /// <summary>Returns these columns with those of the object and of the half that the user names.</summary>
    /// <exception cref="RefusedException">There is no such column.</exception>
    public TrackColumns Named(string[] header, TrackFormat format) => this with
    {
        Objects = format.Object is { } of ? [Place("--object", of.Column, header)] : Objects,
        Period = format.Period is { } period ? Place("--period", period, header) : Period,
    };

    private static int Place(string option, string name, string[] header)
    {
        int at = Array.IndexOf(header, name);
        at = at >= 0 ? at : Array.FindIndex(header, other => Plain(other) == Plain(name));
        at = at >= 0 ? at : int.TryParse(name, NumberStyles.None, CultureInfo.InvariantCulture, out int number) && number >= 1 && number <= header.Length ? number - 1 : -1;
        return at >= 0 ? at : throw new RefusedException(option, Quote.Short(name), $"a column of TRACK by name, or by number from 1; its columns are {Listed(header)}");
    }

    /// <summary>Returns the names of columns for a message: all of them, or the first ones and the number of the others.</summary>
    public static string Listed(string[] header) =>
        string.Join(", ", header.Take(MostNamed).Select(name => Quote.Short(name))) + (header.Length > MostNamed ? FormattableString.Invariant($" and {header.Length - MostNamed} more (--list prints all)") : "");

    /// <summary>Throws if the name of a used column occurs twice.</summary>
    public void RefuseTwins(string[] header)
    {
        foreach (int column in (int[])[Time, .. Places])
        {
            string name = Plain(header[column]);
            if (header.Count(other => Plain(other) == name) > 1)
            {
                throw new RefusedException($"TRACK's header has two columns {Quote.Short(header[column])}. Rename one of them, or give --columns with four numbers, from 1.");
            }
        }
    }

    private static TrackColumns Of(string[] names, int time, int[] places, string?[] units) => new()
    {
        Time = time,
        Places = places,
        Units = units,
        TimeUnit = Unit(names[time], s_durations) ?? (names[time].StartsWith("milli", StringComparison.Ordinal) ? "ms" : null),
        Frame = Array.FindIndex(names, name => s_frames.Contains(name)),
        Period = Array.FindIndex(names, name => s_periods.Contains(name)),
        Objects = [.. Enumerable.Range(0, names.Length).Where(i => s_objects.Contains(names[i]))],
    };

    private static (int At, string? Unit) Place(string[] names, string before, string after, int axis)
    {
        string[] letters = axis == 2 && before.Length + after.Length == 0 ? ["z", "height", "h"] : axis == 2 ? ["z", "height"] : [axis == 0 ? "x" : "y"];
        foreach (string letter in letters)
        {
            string name = before + letter + after;
            int at = Array.IndexOf(names, name);
            if (at >= 0)
            {
                return (at, null);
            }

            foreach ((string suffix, string unit) in s_lengths)
            {
                at = Array.IndexOf(names, name + suffix);
                if (at >= 0)
                {
                    return (at, unit);
                }
            }
        }

        return (-1, null);
    }

    private static string? Unit(string name, (string Suffix, string Unit)[] units)
    {
        foreach ((string suffix, string unit) in units)
        {
            if (name.EndsWith(suffix, StringComparison.Ordinal))
            {
                return unit;
            }
        }

        return null;
    }

    /// <summary>Returns a name in lower case with words joined by underscores: "Ball X [cm]" and "ballX_cm" become "ball_x_cm".</summary>
    private static string Plain(string name)
    {
        var text = new StringBuilder();
        for (int i = 0; i < name.Length; i++)
        {
            char c = name[i];
            bool begins = char.IsUpper(c) && i > 0 && char.IsLower(name[i - 1]);
            if (begins || !char.IsLetterOrDigit(c))
            {
                if (text.Length > 0 && text[^1] != '_')
                {
                    text.Append('_');
                }
            }

            if (char.IsLetterOrDigit(c))
            {
                text.Append(char.ToLowerInvariant(c));
            }
        }

        return text.ToString().TrimEnd('_');
    }
}
