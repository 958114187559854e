using System.Globalization;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Fit.Reading;

namespace FootballPhysics.Tool.Follow;

/// <summary>Reads a track line by line, so that each point is available as soon as its line is.</summary>
/// <remarks>
/// The columns, units and options are those of fit --match. Guesses that need the whole track are impossible here: without an option or a unit in the header,
/// coordinates are metres, times are seconds, and z points up.
/// </remarks>
internal sealed class FollowLines(TextReader reader, TrackFormat format, Action<string> report)
{
    private static readonly char[] s_separators = ['\t', ';', ',', ' '];

    /// <summary>The distance from the origin, in m, beyond which the unit is wrong.</summary>
    private const double Farthest = 1000;

    private TrackColumns? _columns;
    private double[] _scales = [1, 1, 1];
    private double _second = 1;
    private char _separator = ',';

    /// <summary>Reads the points, each with the number of its line.</summary>
    public IEnumerable<(long Line, double Time, Vector3d Position)> Points()
    {
        long number = 0;
        while (reader.ReadLine() is { } line)
        {
            number++;
            line = line.Trim('\uFEFF', ' ', '\r');
            if (line.Length == 0 || line[0] == '#')
            {
                continue;
            }

            if (_columns is null)
            {
                bool isHeader = Begin(line);
                if (isHeader)
                {
                    continue;
                }
            }

            string[] cells = Cells(line);
            string Cell(int column) => column < cells.Length ? cells[column].Trim('"', ' ') : "";
            string[] places = [.. _columns!.Places.Select(Cell)];
            if (Array.Exists(places, TrackMissing.IsMissing))
            {
                continue;
            }

            double time = _second * Number(Cell(_columns.Time), number, "time");
            double x = _scales[0] * Number(places[0], number, "x");
            double y = _scales[1] * Number(places[1], number, "y");
            double z = _scales[2] * Number(places[2], number, "z");
            (double up, double across) = format.IsYUp == true ? (y, z) : (z, y);
            double[] metres = [x, y, z];
            int far = Array.FindIndex(metres, value => !(Math.Abs(value) <= Farthest));
            if (far >= 0)
            {
                throw new RefusedException(FormattableString.Invariant($"line {number}, {"xyz"[far]}"), Quote.Short(places[far]), "within 1 km of the origin; --unit states a unit other than metres");
            }

            bool isRight = format.IsYDown ?? format.IsYUp ?? false;
            yield return (number, time, new Vector3d(x, up, isRight ? across : -across));
        }
    }

    /// <summary>Finds the columns in the first line.</summary>
    /// <returns>True if the line is a header; false if it is a point.</returns>
    private bool Begin(string line)
    {
        _separator = s_separators.FirstOrDefault(separator => line.Contains(separator), ',');
        string[] cells = [.. Cells(line).Select(cell => cell.Trim('"', ' '))];
        _columns = TrackColumns.Find(cells, format);
        bool isHeader = _columns is not null;
        if (_columns is null)
        {
            _columns = TrackColumns.ByNumber(format, cells.Length)
                ?? throw new RefusedException("TRACK's first line", Quote.Short(line), "a header with t, x, y and z, or four columns t, x, y, z");
            isHeader = !double.TryParse(cells[_columns.Time], NumberStyles.Float, CultureInfo.InvariantCulture, out _);
            report("guessed: the columns are t, x, y, z.");
        }
        else
        {
            _columns.RefuseTwins(cells);
        }

        if (format.Unit is "pitch" or "percent")
        {
            (double length, double width) = format.Pitch ?? (105, 68);
            double share = format.Unit == "pitch" ? 1 : 0.01;
            double high = TrackFormat.Metres(_columns.Units[2] ?? "m")!.Value;
            _scales = [share * length, share * width, high];
        }
        else
        {
            _scales = [.. _columns.Units.Select(stated => TrackFormat.Metres(format.Unit ?? stated ?? "m")!.Value)];
        }

        bool isFrame = _columns.Frame == _columns.Time;
        if (isFrame && format.Rate is null)
        {
            throw new RefusedException("TRACK has frame numbers instead of times. Give the frames per second with --rate.");
        }

        _second = isFrame ? 1 / format.Rate!.Value : TrackFormat.Seconds(format.TimeUnit ?? _columns.TimeUnit ?? "s")!.Value;
        if (format.Unit is null && Array.TrueForAll(_columns.Units, unit => unit is null))
        {
            report("guessed: coordinates are metres, because a stream does not show its unit; --unit if not.");
        }

        return isHeader;
    }

    private string[] Cells(string line) => _separator == ' ' ? line.Split(' ', StringSplitOptions.RemoveEmptyEntries) : line.Split(_separator);

    private double Number(string cell, long line, string column) =>
        double.TryParse(format.Decimal == ',' ? cell.Replace(',', '.') : cell, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) && double.IsFinite(number)
            ? number
            : throw new RefusedException(FormattableString.Invariant($"line {line}, {column}"), Quote.Short(cell), "a number; empty where the ball was not seen");
}
