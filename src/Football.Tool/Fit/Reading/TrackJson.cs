using System.Text.Json;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Fit.Reading;

/// <summary>
/// Reads JSON with an object for each moment: one per line, in an array, or in a list of a larger document. The names of nested members are joined.
/// </summary>
internal static class TrackJson
{
    /// <summary>The maximum nesting of objects that are read.</summary>
    private const int Deepest = 4;

    /// <summary>The maximum number of different members of all moments. Each member is a column with a cell for every moment.</summary>
    private const int MostColumns = 1000;

    /// <summary>The maximum number of lists that a refusal names.</summary>
    private const int MostNamed = 12;

    /// <summary>The lists of known layouts: of TRACAB's JSON, of Hawk-Eye's samples of the ball, and the usual names.</summary>
    private static readonly string[] s_lists = ["FrameData", "samples.ball", "data", "frames", "track"];

    public static TrackTable Read(string text, TrackFormat format, Action<string> report)
    {
        string trimmed = text.Trim();
        bool isLines = trimmed.StartsWith('{') && trimmed.IndexOf('\n', StringComparison.Ordinal) is > 0 and { } end && trimmed[..end].TrimEnd().EndsWith('}');
        var records = new List<(long Line, Dictionary<string, string> Cells)>();
        string list = "";
        string[] parts = [];
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
            (list, JsonElement items, parts) = ListIn(document.RootElement, format);
            long number = 0;
            foreach (JsonElement record in items.EnumerateArray())
            {
                records.Add((++number, Flat(record)));
            }
        }

        string[] names = [.. records.SelectMany(record => record.Cells.Keys).Distinct().Take(MostColumns + 1)];
        if (names.Length > MostColumns)
        {
            throw new RefusedException("TRACK", FormattableString.Invariant($"JSON with more than {MostColumns} different members"), FormattableString.Invariant($"at most {MostColumns}"));
        }

        // TRACAB's JSON counts frames and centimetres, as its lines do.
        bool isTracab = list == "FrameData" && names.Contains("FrameCount");
        report(isTracab ? "guessed: TRACAB's JSON, in centimetres." : $"guessed: JSON, an object for each moment{(list.Length > 0 ? $", in the list {Quote.Short(list)}" : "")}.");
        var table = new TrackTable { Header = names, Unit = isTracab ? "cm" : null };
        table.Parts.AddRange(parts.Length > 0 ? parts : [FormattableString.Invariant($"JSON: {records.Count} objects")]);
        table.Lines.AddRange(records.Select(record => new TrackLine(record.Line, [.. names.Select(name => record.Cells.GetValueOrDefault(name, ""))])));
        return table;
    }

    /// <summary>Returns the list of moments in a document, and a description of every list.</summary>
    private static (string Name, JsonElement List, string[] Parts) ListIn(JsonElement root, TrackFormat format)
    {
        if (root.ValueKind == JsonValueKind.Array)
        {
            return ("", root, []);
        }

        List<(string Name, JsonElement List)> lists = [];
        Collect(root, "", 0, lists);
        string[] parts = [.. lists.Select(item => FormattableString.Invariant($"list {item.Name}: {item.List.GetArrayLength()} objects"))];
        string seen = parts.Length == 0 ? "no list of objects" : string.Join("; ", parts.Take(MostNamed)) + (parts.Length > MostNamed ? FormattableString.Invariant($"; {parts.Length - MostNamed} more") : "");
        IEnumerable<string> names = format.Records is { } given ? [given] : s_lists;
        foreach (string name in names)
        {
            int at = lists.FindIndex(item => item.Name == name);
            if (at >= 0)
            {
                return (name, lists[at].List, parts);
            }
        }

        if (format.Records is null && lists.Count == 1)
        {
            return (lists[0].Name, lists[0].List, parts);
        }

        throw format.Records is { } missing
            ? new RefusedException("--records", Quote.Short(missing), $"the name of a list in TRACK, which contains {seen}")
            : new RefusedException($"TRACK is JSON without a known list of moments: it contains {seen}. Give --records with the name of the list, or write an array of objects with t, x, y and z.");
    }

    private static void Collect(JsonElement item, string name, int depth, List<(string Name, JsonElement List)> lists)
    {
        if (item.ValueKind == JsonValueKind.Object && depth < Deepest)
        {
            foreach (JsonProperty member in item.EnumerateObject())
            {
                Collect(member.Value, name.Length > 0 ? $"{name}.{member.Name}" : member.Name, depth + 1, lists);
            }
        }
        else if (item.ValueKind == JsonValueKind.Array && item.GetArrayLength() > 0 && item[0].ValueKind == JsonValueKind.Object)
        {
            lists.Add((name, item));
        }
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
            AddList(item, name, depth, cells);
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

    private static void AddList(JsonElement item, string name, int depth, Dictionary<string, string> cells)
    {
        JsonElement[] parts = [.. item.EnumerateArray()];
        if (parts.Length == 3 && parts.All(part => part.ValueKind == JsonValueKind.Number))
        {
            for (int axis = 0; axis < 3; axis++)
            {
                cells[name + "_" + "xyz"[axis]] = parts[axis].GetRawText();
            }

            return;
        }

        // The first of a list of balls is the ball in play; the others lie beside the pitch. In another list, the only object with a height is the ball.
        bool isBalls = name.StartsWith("ball", StringComparison.OrdinalIgnoreCase);
        bool isPeople = name.Contains("player", StringComparison.OrdinalIgnoreCase) || name.Contains("person", StringComparison.OrdinalIgnoreCase);
        JsonElement[] high = isPeople ? [] : [.. parts.Where(HasHeight)];
        if (high.Length == 1 || (isBalls && high.Length > 1))
        {
            Add(high[0], "ball", depth + 1, cells);
        }
    }

    private static bool HasHeight(JsonElement part) =>
        part.ValueKind == JsonValueKind.Object && (part.TryGetProperty("z", out JsonElement z) || part.TryGetProperty("Z", out z)) && z.ValueKind == JsonValueKind.Number;
}
