using System.Globalization;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Play;

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
