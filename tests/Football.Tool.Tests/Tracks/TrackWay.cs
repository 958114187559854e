using System.Globalization;
using System.Text;
using FootballPhysics.Tool.Fit.Reading;

namespace FootballPhysics.Tool.Tests.Tracks;

/// <summary>A way to write a track.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Write">Writes it.</param>
/// <param name="Format">Options that the user gives, or null.</param>
internal sealed record TrackWay(string Name, Func<OwnTrack, byte[]> Write, TrackFormat? Format = null)
{
    private const string Head = "t,x,y,z";

    /// <summary>All ways.</summary>
    public static IReadOnlyList<TrackWay> All { get; } = [.. Separators(), .. Numbers(), .. Times(), .. Units(), .. Frames(), .. Headers(), .. Missing(), .. Orders(), .. Layouts()];

    private static IEnumerable<TrackWay> Separators()
    {
        yield return new("commas", track => Lines(track, Head, ","));
        yield return new("quotes", track => Lines(track, "\"t\",\"x\",\"y\",\"z\"", ",", value => $"\"{Text(value)}\""));
        yield return new("semicolons", track => Lines(track, "t;x;y;z", ";"));
        yield return new("semicolons, decimal commas", track => Lines(track, "t;x;y;z", ";", Comma));
        yield return new("tabs", track => Lines(track, "t\tx\ty\tz", "\t"));
        yield return new("tabs, decimal commas", track => Lines(track, "t\tx\ty\tz", "\t", Comma));
        yield return new("bars", track => Lines(track, "t|x|y|z", "|"));
        yield return new("spaces", track => Lines(track, "t x y z", " "));
        yield return new("aligned by spaces", track => Lines(track, "       t        x        y        z", " ", value => Text(value).PadLeft(10)));
        yield return new("commas and spaces", track => Lines(track, "t, x, y, z", ", "));
        yield return new("quoted decimal commas", track => Lines(track, Head, ",", value => $"\"{Comma(value)}\""));
        yield return new("unquoted decimal commas", track => Lines(track, Head, ",", Comma));
        yield return new("only z quoted with a comma", track => Rows(track, Head, p => $"{Text(p.T)},{Text(p.X)},{Text(p.Y)},\"{Comma(p.Z)}\""));
        yield return new("a comment with commas in quotes", track => Rows(track, "t,note,x,y,z", p => $"{Text(p.T)},\"a, b; \"\"c\"\"\",{Text(p.X)},{Text(p.Y)},{Text(p.Z)}"));
        yield return new("sep=;", track => Rows(track, "sep=;\nt;x;y;z", p => Join(p, ";", Comma)));
        yield return new("CR LF", track => Bytes(Encoding.UTF8.GetString(Lines(track, Head, ",")).Replace("\n", "\r\n", StringComparison.Ordinal)));
        yield return new("CR", track => Bytes(Encoding.UTF8.GetString(Lines(track, Head, ",")).Replace('\n', '\r')));
        yield return new("BOM", track => [0xEF, 0xBB, 0xBF, .. Lines(track, Head, ",")]);
        yield return new("UTF-16", track => [0xFF, 0xFE, .. Encoding.Unicode.GetBytes(Encoding.UTF8.GetString(Lines(track, Head, ",")))]);
        yield return new("gzip", track => [0x1F, 0x8B, 8, .. Lines(track, Head, ",")]);
        yield return new("comments", track => Rows(track, "# made by hand, in May\n# t is s\nt,x,y,z", p => Join(p, ",", Text)));
        yield return new("header in a comment", track => Rows(track, "# t x y z", p => Join(p, " ", Text)));
        yield return new("a quote that is not closed", track => Rows(track, Head, p => p.T is > 1 and < 1.05 ? $"{Text(p.T)},\"{Text(p.X)},{Text(p.Y)},{Text(p.Z)}" : Join(p, ",", Text)));
    }

    private static IEnumerable<TrackWay> Numbers()
    {
        yield return new("exponents", track => Lines(track, Head, ",", value => value.ToString("0.######e+00", CultureInfo.InvariantCulture)));
        yield return new("plus signs", track => Lines(track, Head, ",", value => value >= 0 ? "+" + Text(value) : Text(value)));
        yield return new("typographic minus", track => Lines(track, Head, ",", value => Text(value).Replace('-', '\u2212')));
        yield return new("millimetres, thousands commas in quotes", track => Rows(track, "t,x_mm,y_mm,z_mm", p => $"{Text(p.T)},\"{1000 * p.X:N2}\",\"{1000 * p.Y:N2}\",\"{1000 * p.Z:N2}\""));
        yield return new("millimetres, thousands commas, whole", track => Rows(track, "t,x_mm,y_mm,z_mm", p => $"{Text(p.T)},\"{1000 * p.X:N0}\",\"{1000 * p.Y:N0}\",\"{1000 * p.Z:N0}\""));
        yield return new("millimetres, thousands points", track => Rows(track, "t;x_mm;y_mm;z_mm", p => $"{Comma(p.T)};{German(p.X)};{German(p.Y)};{German(p.Z)}"));
        yield return new("three decimals, commas", track => Rows(track, "t;x;y;z", p => string.Join(';', Fixed(p, "0.000").Select(cell => cell.Replace('.', ',')))));
        yield return new("three decimals, commas, far from the origin", track => Rows(track, "t;x;y;z", p => $"{p.T + 10:0.000};{p.X + 200:0.000};{p.Y + 300:0.000};{p.Z + 100:0.000}".Replace('.', ',')));
        yield return new("units in the cells", track => Lines(track, Head, ",", value => Text(value) + " m"));
    }

    private static IEnumerable<TrackWay> Times()
    {
        TrackWay Clock(string name, Func<double, string> time, string head = Head) => new(name, track => Rows(track, head, p => $"{time(p.T)},{Text(p.X)},{Text(p.Y)},{Text(p.Z)}"));
        yield return Clock("milliseconds", t => Text(1000 * t));
        yield return Clock("milliseconds by name", t => Text(1000 * t), "time_ms,x,y,z");
        yield return Clock("milliseconds in brackets", t => Text(1000 * t), "Time [ms],X [m],Y [m],Z [m]");
        yield return Clock("microseconds", t => Text(1e6 * t));
        yield return Clock("nanoseconds", t => (1e9 * t).ToString("0", CultureInfo.InvariantCulture));
        yield return Clock("m:ss.cccc", t => FormattableString.Invariant($"{(int)(t / 60)}:{t % 60:00.0000}"));
        yield return Clock("hh:mm:ss.ffff", t => TimeSpan.FromSeconds(t).ToString(@"hh\:mm\:ss\.ffffff", CultureInfo.InvariantCulture));
        yield return Clock("0 days hh:mm:ss", t => "0 days " + TimeSpan.FromSeconds(t).ToString(@"hh\:mm\:ss\.ffffff", CultureInfo.InvariantCulture));
        yield return Clock("negative timedeltas", t => t - 2 >= 0 ? "0 days " + Span(t - 2) : "-1 days +" + Span(86400 + t - 2));
        yield return Clock("negative clock", t => (t < 2 ? "-" : "") + Span(Math.Abs(t - 2)));
        yield return Clock("ISO 8601", t => new DateTime(2024, 9, 22, 15, 0, 0, DateTimeKind.Utc).AddSeconds(t).ToString("yyyy-MM-ddTHH:mm:ss.ffffffZ", CultureInfo.InvariantCulture));
        yield return Clock("a date with a space", t => new DateTime(2024, 9, 22, 23, 59, 58, DateTimeKind.Utc).AddSeconds(t).ToString("yyyy-MM-dd HH:mm:ss.ffffff", CultureInfo.InvariantCulture));
        yield return Clock("ISO durations", t => FormattableString.Invariant($"PT{t:0.0000}S"));
        yield return Clock("seconds of the epoch", t => FormattableString.Invariant($"{1_727_000_000 + t:0.0000}"), "timestamp,x,y,z");
        yield return Clock("milliseconds of the epoch", t => FormattableString.Invariant($"{(1_727_000_000 + t) * 1000:0.0}"), "timestamp,x,y,z");
        yield return Clock("minutes", t => FormattableString.Invariant($"{t / 60:0.0000000}"));
        yield return Clock("minutes by name", t => FormattableString.Invariant($"{t / 60:0.0000000}"), "time_min,x,y,z");
        yield return Clock("whole seconds", t => Text(Math.Floor(t)));
        yield return Clock("clock of whole seconds", t => TimeSpan.FromSeconds(Math.Floor(t)).ToString(@"mm\:ss", CultureInfo.InvariantCulture));
        yield return new("frame numbers", track => Framed(track, "frame,x,y,z", 0));
        yield return new("frame numbers with a rate", track => Framed(track, "frame,x,y,z", 4000), new TrackFormat { Rate = 1 });
        yield return new("frame numbers named t", track => Framed(track, Head, 0));
        yield return new("timecode", track => Rows(track, Head, p => $"00:00:{(int)p.T:00}:{(int)Math.Round((p.T - (int)p.T) * track.Rate):00},{Text(p.X)},{Text(p.Y)},{Text(p.Z)}"));
    }

    private static IEnumerable<TrackWay> Units()
    {
        TrackWay Scaled(string name, double unit, string head = Head, TrackFormat? format = null) => new(name, track => Rows(track, head, p => $"{Text(p.T)},{Text(p.X / unit)},{Text(p.Y / unit)},{Text(p.Z / unit)}"), format);
        yield return Scaled("feet", 0.3048);
        yield return Scaled("feet by name", 0.3048, "t,x_ft,y_ft,z_ft");
        yield return Scaled("feet by option", 0.3048, Head, new TrackFormat { Unit = "ft" });
        yield return Scaled("yards", 0.9144);
        yield return Scaled("yards in brackets", 0.9144, "t (s),x (yd),y (yd),z (yd)");
        yield return Scaled("yards by option", 0.9144, Head, new TrackFormat { Unit = "yd" });
        yield return Scaled("centimetres", 0.01);
        yield return Scaled("millimetres", 0.001);
        yield return Scaled("inches", 0.0254);
        yield return new("kilometres", track => Rows(track, Head, p => FormattableString.Invariant($"{p.T:0.0000},{p.X / 1000:0.000000},{p.Y / 1000:0.000000},{p.Z / 1000:0.000000}")));
        yield return Scaled("decimetres", 0.1);
        yield return Scaled("feet, metres by option", 0.3048, Head, new TrackFormat { Unit = "m" });
        yield return Shares("0 … 1", 1, down: true, null);
        yield return Shares("0 … 1, y up", 1, down: false, null);
        yield return Shares("0 … 1 by option", 1, down: true, new TrackFormat { Unit = "pitch", IsYDown = true });
        yield return Shares("0 … 1 by option, y up", 1, down: false, new TrackFormat { Unit = "pitch", Pitch = (105, 68), IsYDown = false });
        yield return Shares("0 … 100", 100, down: false, null);
        yield return Shares("0 … 100 by option", 100, down: false, new TrackFormat { Unit = "percent" });
        yield return new("-1 … 1", track => Rows(track, Head, p => $"{Text(p.T)},{p.X / 52.5:0.000000},{p.Y / 34:0.000000},{Text(p.Z)}"));
        yield return new("x and y in centimetres, z in metres", track => Rows(track, Head, p => $"{Text(p.T)},{Text(100 * p.X)},{Text(100 * p.Y)},{Text(p.Z)}"));
        yield return new("x and y in metres, z in centimetres", track => Rows(track, Head, p => $"{Text(p.T)},{Text(p.X)},{Text(p.Y)},{Text(100 * p.Z)}"));
        yield return new("units by column", track => Rows(track, "t,x_cm,y_cm,z_m", p => $"{Text(p.T)},{Text(100 * p.X)},{Text(100 * p.Y)},{Text(p.Z)}"));
        yield return new("origin at a corner", track => Rows(track, Head, p => $"{Text(p.T)},{Text(p.X + 52.5)},{Text(p.Y + 34)},{Text(p.Z)}"));
        yield return new("origin far off", track => Rows(track, Head, p => $"{Text(p.T)},{Text(p.X + 500)},{Text(p.Y - 900)},{Text(p.Z + 30)}"));
    }

    private static IEnumerable<TrackWay> Frames()
    {
        yield return new("y to the right, by option", track => Rows(track, Head, p => $"{Text(p.T)},{Text(p.X)},{Text(-p.Y)},{Text(p.Z)}"), new TrackFormat { IsYDown = true });
        yield return new("y up", track => Rows(track, Head, p => $"{Text(p.T)},{Text(p.X)},{Text(p.Z)},{Text(-p.Y)}"));
        yield return new("y up, by option", track => Rows(track, Head, p => $"{Text(p.T)},{Text(p.X)},{Text(p.Z)},{Text(-p.Y)}"), new TrackFormat { IsYUp = true });
        yield return new("y up, z to the left", track => Rows(track, Head, p => $"{Text(p.T)},{Text(p.X)},{Text(p.Z)},{Text(p.Y)}"), new TrackFormat { IsYUp = true, IsYDown = false });
        yield return new("z down", track => Rows(track, Head, p => $"{Text(p.T)},{Text(p.X)},{Text(p.Y)},{Text(-p.Z)}"));
    }

    private static IEnumerable<TrackWay> Headers()
    {
        yield return new("no header", track => Lines(track, null, ","));
        yield return new("no header, semicolons, decimal commas", track => Lines(track, null, ";", Comma));
        yield return new("no header, x first", track => Rows(track, null, p => $"{Text(p.X)},{Text(p.Y)},{Text(p.Z)},{Text(p.T)}"));
        yield return new("no header, columns by number", track => Rows(track, null, p => $"{Text(p.X)},{Text(p.Y)},{Text(p.Z)},ball,{Text(p.T)}"), new TrackFormat { Columns = ["5", "1", "2", "3"] });
        yield return new("no header, an index", track => Rows(track, null, p => $"{p.T * track.Rate:0},{Join(p, ",", Text)}"));
        yield return new("other order", track => Rows(track, "z,y,x,t", p => $"{Text(p.Z)},{Text(p.Y)},{Text(p.X)},{Text(p.T)}"));
        yield return new("names of others", track => Lines(track, "zeitpunkt,laengs,quer,hoch", ","));
        yield return new("names of others by option", track => Lines(track, "zeitpunkt,laengs,quer,hoch", ","), new TrackFormat { Columns = ["zeitpunkt", "laengs", "quer", "hoch"] });
        yield return new("a player before the ball", track => Rows(track, "timestamp,x,y,z,ball_x,ball_y,ball_z", p => $"{Text(p.T)},1.5,2.5,0,{Text(p.X)},{Text(p.Y)},{Text(p.Z)}"));
        yield return new("Ball X", track => Lines(track, "Time,Ball X,Ball Y,Ball Z", ","));
        yield return new("ball.x", track => Lines(track, "Time,ball.x,ball.y,ball.z", ","));
        yield return new("ballX", track => Lines(track, "timeS,ballX,ballY,ballZ", ","));
        yield return new("pandas index", track => Rows(track, ",t,x,y,z", p => $"{p.T * track.Rate:0},{Join(p, ",", Text)}"));
        yield return new("twin columns", track => Rows(track, "t,x,y,z,x", p => Join(p, ",", Text) + ",3"));
        yield return new("a title above", track => Rows(track, "Match of Sunday\nt,x,y,z", p => Join(p, ",", Text)));
        yield return new("without heights", track => Rows(track, "t,x,y", p => $"{Text(p.T)},{Text(p.X)},{Text(p.Y)}"));
        yield return new("a comma at the end", track => Rows(track, "t,x,y,z,", p => Join(p, ",", Text) + ","));
    }

    private static IEnumerable<TrackWay> Missing()
    {
        foreach (string word in (string[])["", "nan", "NaN", "NA", "#N/A", "inf", "-inf", "null", "None", "<NA>", "-", "-9999", "9999", "1.#IND"])
        {
            yield return new(word.Length == 0 ? "empty cells" : word, track => Rows(track, Head, p => IsHidden(p.T) ? $"{Text(p.T)},{word},{word},{word}" : Join(p, ",", Text)));
        }

        yield return new("(0, 0, -10)", track => Rows(track, Head, p => IsHidden(p.T) ? $"{Text(p.T)},0,0,-10" : Join(p, ",", Text)));
        yield return new("(0, 0, 0)", track => Rows(track, Head, p => IsHidden(p.T) ? $"{Text(p.T)},0,0,0" : Join(p, ",", Text)));
        yield return new("lines left out", track => Rows(track, Head, p => IsHidden(p.T) ? null : Join(p, ",", Text)));
        yield return new("blank lines", track => Rows(track, Head, p => IsHidden(p.T) ? "" : Join(p, ",", Text)));
    }

    private static IEnumerable<TrackWay> Orders()
    {
        yield return new("reversed", track => Rows(track with { Points = [.. track.Points.Reverse()] }, Head, p => Join(p, ",", Text)));
        yield return new("shuffled", track => Rows(track with { Points = Shuffled(track.Points) }, Head, p => Join(p, ",", Text)));
        yield return new("halves swapped", track => Rows(track with { Points = [.. track.Points.Skip(100), .. track.Points.Take(100)] }, Head, p => Join(p, ",", Text)));
        yield return new("each line twice", track => Rows(track, Head, p => Join(p, ",", Text) + "\n" + Join(p, ",", Text)));
        yield return new("players among the ball", track => Rows(track, "t,object,x,y,z", p => $"{Text(p.T)},home_1,{Text(p.X + 3)},4,0\n{Text(p.T)},ball,{Text(p.X)},{Text(p.Y)},{Text(p.Z)}\n{Text(p.T)},away_7,-5,{Text(p.Y)},0"));
        yield return new("players without a name", track => Rows(track, Head, p => $"{Text(p.T)},{Text(p.X + 3)},4,0\n{Join(p, ",", Text)}"));
    }

    private static IEnumerable<TrackWay> Layouts()
    {
        yield return new("TRACAB", Tracab);
        yield return new("TRACAB with its rate", Tracab, new TrackFormat { Rate = 1 });
        yield return new("Metrica", track => Rows(track, ",,,Home,,Ball,\n,,,11,,,\nPeriod,Frame,Time [s],Player11,,Ball,", p => $"1,{p.T * track.Rate:0},{Text(p.T)},0.4,0.5,{Text((p.X + 52.5) / 105)},{Text((34 - p.Y) / 68)}"));
        yield return new("SkillCorner", track => Rows(track, null, p => $"{{\"frame\": {p.T * track.Rate:0}, \"timestamp\": \"{Span(p.T)}\", \"period\": 1, \"ball_data\": {{\"x\": {Text(p.X)}, \"y\": {Text(p.Y)}, \"z\": {Text(p.Z)}, \"is_detected\": true}}, \"player_data\": [{{\"x\": 1, \"y\": 2, \"player_id\": 7}}]}}"));
        yield return new("JSON records", track => Bytes("[" + string.Join(",\n", track.Points.Select(p => $"{{\"t\": {Text(p.T)}, \"x\": {Text(p.X)}, \"y\": {Text(p.Y)}, \"z\": {Text(p.Z)}}}")) + "]"));
        yield return new("Sportec", track => Bytes("<?xml version=\"1.0\"?><PutDataRequest><Positions><FrameSet GameSection=\"firstHalf\" TeamId=\"DFL-CLU-1\" PersonId=\"DFL-OBJ-P\"><!-- --></FrameSet><FrameSet GameSection=\"firstHalf\" TeamId=\"BALL\" PersonId=\"DFL-OBJ-0000XT\">\n"
            + string.Join("\n", track.Points.Select(p => $"<Frame N=\"{p.T * track.Rate:0}\" T=\"{new DateTime(2020, 6, 5, 18, 30, 0, DateTimeKind.Utc).AddSeconds(p.T):yyyy-MM-ddTHH:mm:ss.ffffff}+00:00\" X=\"{Text(p.X)}\" Y=\"{Text(p.Y)}\" Z=\"{Text(p.Z)}\" S=\"1\" BallStatus=\"1\"/>")) + "\n</FrameSet></Positions></PutDataRequest>"));
    }

    public static bool IsHidden(double t) => t is > 5.2 and < 5.6;

    private static TrackWay Shares(string name, double whole, bool down, TrackFormat? format) => new(
        name, track => Rows(track, Head, p => $"{Text(p.T)},{Share(whole * (p.X + 52.5) / 105)},{Share(whole * ((down ? -p.Y : p.Y) + 34) / 68)},{Text(p.Z)}"), format);

    private static (double, double, double, double)[] Shuffled((double T, double X, double Y, double Z)[] points)
    {
        (double, double, double, double)[] shuffled = [.. points];
        new Random(3).Shuffle(shuffled);
        return shuffled;
    }

    private static byte[] Tracab(OwnTrack track) => Rows(track, null, p => FormattableString.Invariant($"{1000 + (p.T * track.Rate):0}:0,1,2,-2460,4211,0.00;1,3,4,100,-200,1.25;:{100 * p.X:0},{100 * p.Y:0},{100 * p.Z:0},12.3,H,Alive;:"));

    private static byte[] Framed(OwnTrack track, string head, int from) => Rows(track, head, p => $"{from + (p.T * track.Rate):0},{Text(p.X)},{Text(p.Y)},{Text(p.Z)}");

    private static byte[] Lines(OwnTrack track, string? head, string separator, Func<double, string>? cell = null) => Rows(track, head, p => Join(p, separator, cell ?? Text));

    private static byte[] Rows(OwnTrack track, string? head, Func<(double T, double X, double Y, double Z), string?> row) =>
        Bytes(string.Join('\n', track.Points.Select(row).Where(line => line is not null).Prepend(head).Where((line, i) => i > 0 || line is not null)) + "\n");

    private static byte[] Bytes(string text) => Encoding.UTF8.GetBytes(text);

    private static string Join((double T, double X, double Y, double Z) p, string separator, Func<double, string> cell) => string.Join(separator, cell(p.T), cell(p.X), cell(p.Y), cell(p.Z));

    private static string[] Fixed((double T, double X, double Y, double Z) p, string format) => [.. new[] { p.T, p.X, p.Y, p.Z }.Select(value => value.ToString(format, CultureInfo.InvariantCulture))];

    private static string Text(double value) => value.ToString("0.0000", CultureInfo.InvariantCulture);

    private static string Share(double value) => value.ToString("0.000000", CultureInfo.InvariantCulture);

    private static string Comma(double value) => Text(value).Replace('.', ',');

    private static string German(double metres) => (1000 * metres).ToString("N2", CultureInfo.InvariantCulture).Replace(',', '_').Replace('.', ',').Replace('_', '.');

    private static string Span(double seconds) => TimeSpan.FromSeconds(seconds).ToString(@"hh\:mm\:ss\.ffffff", CultureInfo.InvariantCulture);
}
