using System.Xml;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Fit.Reading;

/// <summary>Reads the positions of Sportec and the DFL: a FrameSet for each object and half, with T, X, Y and Z of each Frame.</summary>
internal static class TrackXml
{
    /// <summary>The id of the ball. The ids of players also begin with DFL-OBJ.</summary>
    public const string BallId = "DFL-OBJ-0000XT";

    /// <summary>The maximum number of sets that a refusal names.</summary>
    private const int MostNamed = 8;

    public static TrackTable Read(string text, Action<string> report)
    {
        List<TrackLine> byTeam = [];
        List<TrackLine> byId = [];
        List<TrackLine>? lines = null;
        var sets = new List<(string Name, int Frames)>();
        string section = "";
        string root = "";
        using var reader = XmlReader.Create(new StringReader(text), new XmlReaderSettings { DtdProcessing = DtdProcessing.Prohibit });
        while (reader.Read())
        {
            if (reader.NodeType != XmlNodeType.Element)
            {
                continue;
            }

            root = root.Length > 0 ? root : reader.Name;
            if (reader.Name == "FrameSet")
            {
                string team = reader.GetAttribute("TeamId") ?? "";
                string id = reader.GetAttribute("PersonId") ?? "";
                section = reader.GetAttribute("GameSection") ?? "";
                lines = team.Equals("BALL", StringComparison.OrdinalIgnoreCase) ? byTeam : id == BallId ? byId : null;
                sets.Add(($"{section} {team} {id}", 0));
            }
            else if (reader.Name == "Frame" && sets.Count > 0)
            {
                sets[^1] = (sets[^1].Name, sets[^1].Frames + 1);
                long line = reader is IXmlLineInfo info ? info.LineNumber : 0;
                lines?.Add(new TrackLine(line, [reader.GetAttribute("T") ?? "", reader.GetAttribute("X") ?? "", reader.GetAttribute("Y") ?? "", reader.GetAttribute("Z") ?? "", section]));
            }
        }

        var table = new TrackTable { Header = ["time", "x", "y", "z", "section"], Unit = "m" };
        table.Lines.AddRange(byTeam.Count > 0 ? byTeam : byId);
        table.Parts.AddRange(sets.Select(set => FormattableString.Invariant($"FrameSet {set.Name}: {set.Frames} frames")));
        if (table.Lines.Count == 0)
        {
            string seen = sets.Count == 0 ? $"only {Quote.Short(root)} without a FrameSet"
                : string.Join("; ", table.Parts.Take(MostNamed)) + (sets.Count > MostNamed ? FormattableString.Invariant($"; {sets.Count - MostNamed} more") : "");
            throw new RefusedException($"TRACK is XML without frames of the ball: it contains {seen}. Give the positions file of Sportec or the DFL, with a FrameSet whose TeamId is BALL, or CSV with a header t,x,y,z.");
        }

        report("guessed: the layout of Sportec and the DFL, in metres.");
        return table;
    }
}
