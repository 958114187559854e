using System.Text.Json;
using System.Text.RegularExpressions;
using System.Xml;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Fit.Reading;

/// <summary>
/// Reads tracker files that are not CSV: TRACAB's lines of frames, the XML of Sportec and the DFL, and JSON as SkillCorner and data frames write it.
/// </summary>
internal static partial class TrackLayouts
{
    /// <summary>The maximum nesting of objects that are read.</summary>
    private const int Deepest = 4;

    /// <summary>The maximum number of different members of all moments. Each member is a column with a cell for every moment.</summary>
    private const int MostColumns = 1000;

    /// <summary>Returns the table of a file; null if it has none of these layouts.</summary>
    public static TrackTable? Find(string text, Action<string> report)
    {
        string start = text.AsSpan(0, Math.Min(text.Length, 400)).TrimStart().ToString();
        try
        {
            return start.StartsWith('<') ? Sportec(text, report)
                : start.StartsWith('{') || start.StartsWith('[') ? Json(text, report)
                : TracabFrame().IsMatch(start) ? Tracab(text, report)
                : null;
        }
        catch (Exception e) when (e is JsonException or XmlException or InvalidOperationException)
        {
            throw new RefusedException($"TRACK is not valid {(e is XmlException ? "XML" : "JSON")} ({Quote.Short(e.Message)}). Write it anew, or as CSV with a header t,x,y,z.");
        }
    }

    /// <summary>Reads frame:player;player;…:x,y,z,speed,team,status;: in centimetres.</summary>
    private static TrackTable Tracab(string text, Action<string> report)
    {
        report("guessed: TRACAB's layout, in centimetres; the ball is in the third part of each line.");
        var table = new TrackTable { Header = ["frame", "ball_x", "ball_y", "ball_z"], Unit = "cm" };
        long number = 0;
        foreach (string line in text.Split('\n'))
        {
            number++;
            string[] parts = line.Trim().Split(':');
            if (parts.Length >= 3)
            {
                string[] ball = parts[2].Split(';')[0].Split(',');
                table.Lines.Add(new TrackLine(number, ball.Length >= 3 ? [parts[0], ball[0], ball[1], ball[2]] : [parts[0]]));
            }
            else if (line.Trim().Length > 0)
            {
                throw new RefusedException(FormattableString.Invariant($"line {number} is not a frame of TRACAB. Its parts are frame:players:ball:."));
            }
        }

        return table;
    }

    /// <summary>Reads the frames with T, X, Y, Z in the FrameSet of the ball.</summary>
    private static TrackTable? Sportec(string text, Action<string> report)
    {
        var table = new TrackTable { Header = ["time", "x", "y", "z", "section"], Unit = "m" };
        using var reader = XmlReader.Create(new StringReader(text), new XmlReaderSettings { DtdProcessing = DtdProcessing.Prohibit });
        bool isBall = false;
        string section = "";
        while (reader.Read())
        {
            if (reader.NodeType == XmlNodeType.Element && reader.Name == "FrameSet")
            {
                isBall = reader.GetAttribute("TeamId") is "BALL" or "Ball" || reader.GetAttribute("PersonId")?.StartsWith("DFL-OBJ", StringComparison.Ordinal) == true;
                section = reader.GetAttribute("GameSection") ?? "";
            }
            else if (isBall && reader.NodeType == XmlNodeType.Element && reader.Name == "Frame")
            {
                long line = reader is IXmlLineInfo info ? info.LineNumber : 0;
                table.Lines.Add(new TrackLine(line, [reader.GetAttribute("T") ?? "", reader.GetAttribute("X") ?? "", reader.GetAttribute("Y") ?? "", reader.GetAttribute("Z") ?? "", section]));
            }
        }

        if (table.Lines.Count == 0)
        {
            throw new RefusedException("TRACK is XML without a FrameSet whose TeamId is BALL. Give the positions file of Sportec or the DFL, or CSV with a header t,x,y,z.");
        }

        report("guessed: the layout of Sportec and the DFL, in metres.");
        return table;
    }

    /// <summary>Reads one object per line, or an array of objects. The names of nested members are joined.</summary>
    private static TrackTable Json(string text, Action<string> report)
    {
        var records = new List<(long Line, Dictionary<string, string> Cells)>();
        string trimmed = text.Trim();
        bool isLines = trimmed.StartsWith('{') && trimmed.IndexOf('\n', StringComparison.Ordinal) is > 0 and { } end && trimmed[..end].TrimEnd().EndsWith('}');
        if (isLines)
        {
            long number = 0;
            foreach (string line in text.Split('\n'))
            {
                number++;
                if (!string.IsNullOrWhiteSpace(line))
                {
                    using JsonDocument document = JsonDocument.Parse(line);
                    records.Add((number, Flat(document.RootElement)));
                }
            }
        }
        else
        {
            using JsonDocument document = JsonDocument.Parse(trimmed);
            JsonElement root = document.RootElement;
            JsonElement? list = root.ValueKind == JsonValueKind.Array ? root
                : root.EnumerateObject().Where(member => member.Value.ValueKind == JsonValueKind.Array && member.Name is "data" or "frames" or "track").Select(member => (JsonElement?)member.Value).FirstOrDefault();
            long number = 0;
            foreach (JsonElement record in list?.EnumerateArray() ?? throw new RefusedException("TRACK is JSON without a list of moments. Write an array of objects, or an object a line, with t, x, y and z."))
            {
                records.Add((++number, Flat(record)));
            }
        }

        string[] names = [.. records.SelectMany(record => record.Cells.Keys).Distinct().Take(MostColumns + 1)];
        if (names.Length > MostColumns)
        {
            throw new RefusedException("TRACK", FormattableString.Invariant($"JSON with more than {MostColumns} different members"), FormattableString.Invariant($"at most {MostColumns}"));
        }

        report("guessed: JSON, an object for each moment.");
        var table = new TrackTable { Header = names };
        table.Lines.AddRange(records.Select(record => new TrackLine(record.Line, [.. names.Select(name => record.Cells.GetValueOrDefault(name, ""))])));
        return table;
    }

    private static Dictionary<string, string> Flat(JsonElement record)
    {
        var cells = new Dictionary<string, string>();
        Add(record, "", 0, cells);
        return cells;
    }

    private static void Add(JsonElement item, string name, int depth, Dictionary<string, string> cells)
    {
        if (item.ValueKind == JsonValueKind.Object && depth < Deepest)
        {
            foreach (JsonProperty member in item.EnumerateObject())
            {
                Add(member.Value, name.Length > 0 ? name + "_" + member.Name : member.Name, depth + 1, cells);
            }
        }
        else if (item.ValueKind == JsonValueKind.Array)
        {
            // In a list of objects, the only one with a height is the ball. Three numbers are a position.
            JsonElement[] high = [.. item.EnumerateArray().Where(part => part.ValueKind == JsonValueKind.Object && part.TryGetProperty("z", out JsonElement z) && z.ValueKind == JsonValueKind.Number)];
            JsonElement[] parts = [.. item.EnumerateArray()];
            if (high.Length == 1)
            {
                Add(high[0], "ball", depth + 1, cells);
            }
            else if (parts.Length == 3 && parts.All(part => part.ValueKind == JsonValueKind.Number))
            {
                for (int axis = 0; axis < 3; axis++)
                {
                    cells[name + "_" + "xyz"[axis]] = parts[axis].GetRawText();
                }
            }
        }
        else
        {
            cells[name] = item.ValueKind switch
            {
                JsonValueKind.String => item.GetString() ?? "",
                JsonValueKind.Number => item.GetRawText(),
                JsonValueKind.True or JsonValueKind.False => item.GetRawText(),
                _ => "",
            };
        }
    }

    [GeneratedRegex(@"^\d+:[-\d.,;]*:[-\d.]+,[-\d.]+,[-\d.]+", RegexOptions.CultureInvariant)]
    private static partial Regex TracabFrame();
}
