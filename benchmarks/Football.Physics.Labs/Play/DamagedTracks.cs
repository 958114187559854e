using System.Globalization;
using System.Text;
using FootballPhysics.Labs.Fuzz;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Fit;
using FootballPhysics.Tool.Fit.Reading;

namespace FootballPhysics.Labs.Play;

/// <summary>Damages files of tracks. The reader returns a track or throws its own exception with one sentence, and the fit of a track that was read has finite numbers.</summary>
internal sealed class DamagedTracks
{
    private static readonly InputFields s_noFields = new(System.Text.Json.JsonDocument.Parse("{}").RootElement);

    private int _files;

    /// <summary>The files that were read and fitted, those that the reader rejected, and those that were read and that the fit rejected.</summary>
    public LabCounts Counts { get; } = new();

    /// <summary>The longest processor time that a file took, s, and the index of that file, from 0.</summary>
    public Peak<double, int> Slowest { get; } = new(0);

    /// <summary>The faults that were found.</summary>
    public List<string> Faults { get; } = [];

    /// <summary>Damages a track, reads it and fits it.</summary>
    public void Run(SeededRandom random, SyntheticMatch match)
    {
        int layout = random.Below(TrackLayoutText.Count);
        byte[] file = Damage(random, match, layout);
        TrackFormat format = random.Chance(0.1) ? new TrackFormat { Rate = 25, IsYDown = true, Unit = random.Any("m", "cm", "ft") } : new TrackFormat { Rate = TrackLayoutText.HasFrames(layout) ? 50 : null };
        double start = Environment.CpuUsage.UserTime.TotalSeconds;
        try
        {
            if (Read(file, format) is { } track)
            {
                Fit(track);
            }
        }
        catch (Exception fault)
        {
            Faults.Add($"{fault.GetType().Name}: {fault.Message} {fault.StackTrace?.Split('\n')[0].Trim()}");
        }

        Slowest.See(Environment.CpuUsage.UserTime.TotalSeconds - start, _files++);
    }

    private TrackPoint[]? Read(byte[] file, TrackFormat format)
    {
        try
        {
            return TrackReader.Read(new MemoryStream(file), MustBeSentence, format);
        }
        catch (RefusedException refusal)
        {
            Counts.Add("refused by the reader");
            MustBeSentence(refusal.Message);
            return null;
        }
    }

    private void Fit(TrackPoint[] track)
    {
        try
        {
            MatchFitResult fit = new MatchFit().Find(track);
            Counts.Add("fitted");
            bool isFinite = double.IsFinite(fit.Rms) && fit.Pieces.All(piece => double.IsFinite(piece.Velocity.Length + piece.Spin.Length + piece.Position.Length + piece.Rms))
                && Enumerable.Range(0, fit.Names.Count).All(i => double.IsFinite(fit.Value(i)));
            if (!isFinite)
            {
                Faults.Add("a number that is not finite");
            }
        }
        catch (ArgumentException rejection) when (LibraryRefusal.Of(rejection, s_noFields) is not null)
        {
            Counts.Add("refused by the fit");
            MustBeSentence(LibraryRefusal.Sentence(rejection));
        }
    }

    private void MustBeSentence(string message)
    {
        if (message.Length < 2 || message[^1] is not ('.' or '?') || message.Any(char.IsControl))
        {
            Faults.Add($"not one sentence: {message}");
        }
    }

    private static byte[] Damage(SeededRandom random, SyntheticMatch match, int layout)
    {
        // A few seconds of a match in a layout; then up to four damages of its lines, and in a third of the files also of its bytes.
        int count = random.Below(250) + 1;
        int from = random.Below(Math.Max(1, match.Seen.Count - count));
        char separator = TrackLayoutText.Separator(layout);
        List<string> lines = TrackLayoutText.Write(layout, [.. match.Seen.Skip(from).Take(count)], random);
        for (int damages = random.Below(5); damages > 0; damages--)
        {
            lines = Damaged(random, match, lines, random.Below(lines.Count), separator, from);
        }

        string text = string.Join(random.Any("\n", "\r\n", "\r"), lines);
        byte[] bytes = random.Chance(0.1) ? [.. Encoding.Unicode.GetPreamble(), .. Encoding.Unicode.GetBytes(text)] : Encoding.UTF8.GetBytes(text);
        return random.Chance(1.0 / 3) ? FuzzBytes.Changed(random, bytes, 1 + random.Below(6)) : bytes;
    }

    /// <summary>Returns the lines with one damage, at a line or all over.</summary>
    private static List<string> Damaged(SeededRandom random, SyntheticMatch match, List<string> lines, int at, char separator, int from)
    {
        return random.Below(17) switch
        {
            0 => With(at, ""),
            1 => With(at, lines[at].Replace('.', random.Any('x', ',', ';', '-'))),
            2 => With(at, lines[at] + random.Any(",", ",1,2", ",\"", "\0")),
            3 => [.. lines.Take(at), .. lines.Skip(at + random.Below(40) + 1), "9999,1,1,1"],
            4 => [.. lines.Take(at), lines[random.Below(lines.Count)], .. lines.Skip(at)],
            5 => [.. lines.Select((line, i) => i == at ? lines[^1] : i == lines.Count - 1 ? lines[at] : line)],
            6 => With(at, random.Any("nan,nan,nan,nan", "1e308,1e308,1e308,1e308", "0,0,0,0", "-1,-1,-1", "inf,1,2,3", ",,,")),
            7 => lines.ConvertAll(line => string.Join(separator, line.Split(separator).Reverse())),
            8 => lines.ConvertAll(line => IsHeader(line) ? line : Scaled(line, random.Any(0.0, 1e-9, 100.0, 1e4, -1.0))),
            9 => With(0, random.Any("", "t,x,y", "T;X;Y;Z", "timestamp,ball_x,ball_y,ball_z_cm", "a,b,c,d")),
            10 => lines.ConvertAll(line => random.Chance(0.3) ? line[..random.Below(line.Length + 1)] : line),
            11 => lines.ConvertAll(line => IsHeader(line) || random.Chance(0.8) ? line : Jump(line, random)),
            12 => [.. lines.Where(_ => !random.Chance(0.5)), "t,x,y,z"],
            13 => WithTwice(random.Below(4)),

            // Reorder or repeat all lines.
            14 => random.Chance(0.5) ? [.. lines.OrderBy(_ => random.Next())] : [.. lines, .. lines],

            // Mix two layouts in a file.
            15 => [.. lines, .. TrackLayoutText.Write(random.Below(TrackLayoutText.Count), [.. match.Seen.Skip(from).Take(20)], random)],
            _ => With(at, Encoding.Latin1.GetString([.. Encoding.Latin1.GetBytes(lines[at]).Select(b => random.Chance(0.2) ? (byte)random.Below(256) : b)])),
        };

        static bool IsHeader(string line) => line.Contains('t', StringComparison.Ordinal);

        List<string> With(int at, string text) => [.. lines.Take(at), text, .. lines.Skip(at + 1)];

        // Repeat a column.
        List<string> WithTwice(int column) =>
            lines.ConvertAll(line => string.Join(separator, line.Split(separator).SelectMany((cell, i) => i == column ? (string[])[cell, cell] : [cell])));
    }

    private static string Scaled(string line, double factor)
    {
        string[] cells = line.Split(',');
        return cells.Length == 4 && double.TryParse(cells[0], out _) ? $"{cells[0]},{Times(cells[1], factor)},{Times(cells[2], factor)},{Times(cells[3], factor)}" : line;
    }

    private static string Jump(string line, SeededRandom random)
    {
        string[] cells = line.Split(',');
        return cells.Length == 4 ? FormattableString.Invariant($"{cells[0]},{random.Uniform(-200, 200)},{cells[2]},{random.Uniform(-5, 50)}") : line;
    }

    private static string Times(string cell, double factor) =>
        double.TryParse(cell, System.Globalization.CultureInfo.InvariantCulture, out double number) ? FormattableString.Invariant($"{number * factor}") : cell;
}

/// <summary>Writes a track as lines of text in one of the <see cref="Count"/> layouts that the reader supports.</summary>
internal static class TrackLayoutText
{
    /// <summary>The number of layouts.</summary>
    public const int Count = 9;

    /// <summary>The character between the cells of a layout; a comma for one without cells.</summary>
    public static char Separator(int layout) => layout switch { 1 => ';', 2 => '\t', 3 => ' ', _ => ',' };

    /// <summary>True if a layout has frame numbers, so that its reader needs the rate.</summary>
    public static bool HasFrames(int layout) => layout == 7;

    /// <summary>Writes the points of a track.</summary>
    /// <param name="layout">The layout, 0 … <see cref="Count"/> − 1.</param>
    /// <param name="points">The points.</param>
    /// <param name="random">The random numbers for the columns that are not about the ball.</param>
    public static List<string> Write(int layout, IReadOnlyList<TrackPoint> points, SeededRandom random)
    {
        // z is up in the file.
        double metre = layout is 2 or 7 ? 100 : 1;
        List<double[]> rows = [.. points.Select(point => (double[])[point.Time, metre * point.Position.X, -metre * point.Position.Z, metre * point.Position.Y])];
        return layout switch
        {
            0 => ["t,x,y,z", .. rows.Select(row => string.Join(',', row.Select(Number)))],
            1 => ["Zeit;x;y;z", .. rows.Select(row => string.Join(';', row.Select(number => Number(number).Replace('.', ','))))],
            2 =>
            [
                "time\tteam\tobject\tx [cm]\ty [cm]\tz [cm]",
                .. rows.SelectMany(row => (string[])
                    [$"{Number(row[0])}\thome\t7\t{random.Below(100)}\t{random.Below(100)}\t0", $"{Number(row[0])}\tball\tball\t{Number(row[1])}\t{Number(row[2])}\t{Number(row[3])}"]),
            ],
            3 => [.. rows.Select(row => string.Join(' ', row.Select(Number)))],
            4 => ["period,timestamp,ball_x,ball_y,ball_z", .. rows.Select(row => FormattableString.Invariant($"1,00:{(int)row[0] / 60:00}:{row[0] % 60:00.00},{Number(row[1])},{Number(row[2])},{Number(row[3])}"))],
            5 => ["{\"data\": [", .. rows.Select((row, i) => $"{(i > 0 ? "," : "")}{{\"t\": {Number(row[0])}, \"x\": {Number(row[1])}, \"y\": {Number(row[2])}, \"z\": {Number(row[3])}}}"), "]}"],
            6 => [.. rows.Select((row, i) => $"{{\"frameIdx\": {i}, \"gameClock\": {Number(row[0])}, \"period\": 1, \"ball\": {{\"xyz\": [{Number(row[1])}, {Number(row[2])}, {Number(row[3])}]}}}}")],
            7 => [.. rows.Select((row, i) => FormattableString.Invariant($"{i}:4,1,1,{random.Below(500)},{random.Below(500)},1.5;:{row[1]:0},{row[2]:0},{row[3]:0},12,H,Alive;:"))],
            _ =>
            [
                "<PutDataRequest><Positions><FrameSet TeamId=\"BALL\" PersonId=\"DFL-OBJ-0000XT\">",
                .. rows.Select((row, i) => FormattableString.Invariant(
                    $"<Frame N=\"{i}\" T=\"2021-05-09T15:{(int)row[0] / 60:00}:{row[0] % 60:00.000}+02:00\" X=\"{Number(row[1])}\" Y=\"{Number(row[2])}\" Z=\"{Number(row[3])}\" />")),
                "</FrameSet></Positions></PutDataRequest>",
            ],
        };
    }

    private static string Number(double number) => number.ToString("0.####", CultureInfo.InvariantCulture);
}
