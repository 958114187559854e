using System.Buffers;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Fit.Reading;

/// <summary>Reads layouts with one frame per line, whose parts are separated by colons: TRACAB's <c>.dat</c>, and MA25 of Stats Perform.</summary>
internal static class TrackFrames
{
    /// <summary>The number of first lines from which the layout is recognised.</summary>
    private const int Sample = 20;

    /// <summary>The characters of lists of numbers.</summary>
    private static readonly SearchValues<char> s_ofNumbers = SearchValues.Create("-+.,; 0123456789");

    /// <summary>Returns the table of a file; null if it has neither layout.</summary>
    public static TrackTable? Find(string text, Action<string> report)
    {
        foreach (string line in Lines(text).Where(line => line.Length > 0).Take(Sample))
        {
            if (IsTracab(line.Split(':')))
            {
                report("guessed: TRACAB's layout, in centimetres; the ball is in the third part of each line.");
                return Read(text, new TrackTable { Header = ["frame", "ball_x", "ball_y", "ball_z"], Unit = "cm" }, "TRACAB", "frame:objects:ball:", Tracab);
            }

            if (IsMa25(line.Split(':')))
            {
                report("guessed: the layout MA25 of Stats Perform, in metres; the ball is in the third part of each line.");
                return Read(text, new TrackTable { Header = ["time_ms", "ball_x", "ball_y", "ball_z", "period"], Unit = "m" }, "MA25", "time;match time,period,status:objects:ball;", Ma25);
            }
        }

        return null;
    }

    private static IEnumerable<string> Lines(string text) => text.Split(["\r\n", "\n", "\r"], StringSplitOptions.None).Select(line => line.Trim());

    private static TrackTable Read(string text, TrackTable table, string name, string layout, Func<string[], string[]?> cells)
    {
        long number = 0;
        (int least, int most) = (int.MaxValue, 0);
        foreach (string line in Lines(text))
        {
            number++;
            if (line.Length == 0)
            {
                continue;
            }

            string[] parts = line.Split(':');
            table.Lines.Add(new TrackLine(number, cells(parts) ?? throw new RefusedException(FormattableString.Invariant(
                $"line {number} of TRACK begins with {Quote.Short(line)}, which is not a frame of {name}. Write all lines as {layout}, with x, y and z of the ball."))));
            int objects = parts[1].Split(';', StringSplitOptions.RemoveEmptyEntries).Length;
            (least, most) = (Math.Min(least, objects), Math.Max(most, objects));
        }

        table.Parts.Add(FormattableString.Invariant($"{name}: {table.Lines.Count} frames with {least} to {most} objects besides the ball"));
        return table;
    }

    /// <summary>frame:team,id,number,x,y,speed;…:x,y,z,speed,team,status[,set mark];: in centimetres. In some frames, the ball is missing.</summary>
    private static string[]? Tracab(string[] parts)
    {
        if (parts.Length < 2 || !IsWhole(parts[0]) || !AreNumbers(parts[1]))
        {
            return null;
        }

        string[] ball = parts.Length < 3 ? [] : parts[2].Split(';')[0].Split(',');
        return ball.Length >= 3 ? [parts[0], ball[0], ball[1], ball[2]] : ball is [] or [""] ? [parts[0]] : null;
    }

    /// <summary>time in ms;match time in ms,period,status:team,id,number,x,y;…:x,y,z; in metres. In some frames, the ball is missing.</summary>
    private static string[]? Ma25(string[] parts)
    {
        string[] head = parts[0].Split(';');
        string[] clock = head.Length > 1 ? head[1].Split(',') : [];
        if (parts.Length < 2 || clock.Length < 3 || !IsWhole(head[0]) || !IsWhole(clock[0]) || !IsWhole(clock[1]))
        {
            return null;
        }

        string[] ball = parts.Length < 3 ? [] : parts[2].Split(';')[0].Split(',');
        return ball.Length >= 3 ? [head[0], ball[0], ball[1], ball[2], clock[1]] : ball is [] or [""] ? [head[0], "", "", "", clock[1]] : null;
    }

    /// <summary>True if a line is a frame of TRACAB with a ball. A clock in a CSV file has colons too, but neither commas nor semicolons between them.</summary>
    private static bool IsTracab(string[] parts) =>
        parts.Length >= 3 && (parts[1].Length == 0 || parts[1].AsSpan().IndexOfAny(",;") >= 0) && Tracab(parts) is { Length: > 1 } cells && cells[1..].All(IsNumber);

    private static bool IsMa25(string[] parts) => parts.Length >= 2 && Ma25(parts) is not null;

    private static bool IsWhole(string text) => text.Length > 0 && text.AsSpan().IndexOfAnyExceptInRange('0', '9') < 0;

    private static bool AreNumbers(string text) => text.AsSpan().IndexOfAnyExcept(s_ofNumbers) < 0;

    private static bool IsNumber(string text) => double.TryParse(text, System.Globalization.NumberStyles.Float, System.Globalization.CultureInfo.InvariantCulture, out _);
}
