using System.Globalization;
using System.Text;
using System.Xml.Linq;
using Football.Physics.Headless.Drawing;
using Football.Physics.Headless.Simulate;

namespace Football.Physics.Headless.Lab;

/// <summary>What the experiments showed, as table, JSON, CSV and drawing.</summary>
internal sealed class AimReport(int seed, IReadOnlyList<AimSection> sections, AimVerdicts verdicts)
{
    /// <summary>Prints the tables.</summary>
    public void Print(TextWriter to)
    {
        foreach (AimSection section in sections)
        {
            to.WriteLine(section.Title);
            List<IReadOnlyList<string>> lines = [AimRow.Columns, .. section.Rows.Select(row => row.Cells)];
            int[] widths = [.. Enumerable.Range(0, AimRow.Columns.Count).Select(column => lines.Max(line => line[column].Length))];
            foreach (IReadOnlyList<string> line in lines)
            {
                IEnumerable<string> cells = line.Select((cell, i) => i is 0 or >= 14 ? cell.PadRight(widths[i]) : cell.PadLeft(widths[i]));
                to.WriteLine("  " + string.Join("  ", cells).TrimEnd());
            }

            if (section.Remark.Length > 0)
            {
                to.WriteLine("  " + section.Remark);
            }

            to.WriteLine();
        }

        AimVerdicts v = verdicts;
        to.WriteLine("Random requests (5 to 40 m/s, spins, winds, laws, 1 to 70 m, heights, elevation bounds; 1 mm), direct");
        to.WriteLine(string.Create(CultureInfo.InvariantCulture, $"  {v.Requests} requests: {v.Hits} hit, {v.OutOfReach} out of reach, {v.NotConverged} not converged or degenerate; {v.WithoutAnswer} without an answer."));
        to.WriteLine(string.Create(CultureInfo.InvariantCulture, $"  Hits: worst true miss {1e3 * v.WorstHit:0.000} mm, {Mean(v.HitSimulations, v.Hits):0.00} simulations; the others: {Mean(v.OtherSimulations, v.Requests - v.Hits):0.0} simulations."));
        to.WriteLine(string.Create(CultureInfo.InvariantCulture, $"  Dense scan of {v.Scanned} that were not hit ({AimVerdicts.Elevations} elevations each): {v.Wrong} can be hit, {v.NotClosest} can be missed by less (by more than 1 % and 1 cm)."));
        foreach (string example in v.Examples)
        {
            to.WriteLine("    " + example);
        }
    }

    /// <summary>Everything as one JSON object.</summary>
    public ReadOnlyMemory<byte> Json() => ResultWriter.Line(json =>
    {
        json.WriteString("experiment", "aim");
        json.WriteNumber("seed", seed);
        json.WriteStartArray("sections");
        foreach (AimSection section in sections)
        {
            json.WriteStartObject();
            json.WriteString("title", section.Title);
            json.WriteString("remark", section.Remark);
            json.WriteStartArray("rows");
            foreach (AimRow row in section.Rows)
            {
                row.Write(json);
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteStartObject("verdicts");
        json.WriteNumber("requests", verdicts.Requests);
        json.WriteNumber("hits", verdicts.Hits);
        json.WriteNumber("outOfReach", verdicts.OutOfReach);
        json.WriteNumber("notConverged", verdicts.NotConverged);
        json.WriteNumber("withoutAnswer", verdicts.WithoutAnswer);
        json.WriteNumber("scanned", verdicts.Scanned);
        json.WriteNumber("wrong", verdicts.Wrong);
        json.WriteNumber("notClosest", verdicts.NotClosest);
        json.WriteNumber("worstHit", verdicts.WorstHit);
        json.WriteEndObject();
    });

    /// <summary>Every kick as a line.</summary>
    public string Csv()
    {
        var text = new StringBuilder("section,method,distance,speed,status,miss,throughMiss,elevation,top,side,iterations,simulations,microseconds\n");
        foreach (AimSection section in sections)
        {
            foreach (AimRow row in section.Rows)
            {
                foreach (AimShot shot in row.Shots)
                {
                    AimResult r = shot.Result;
                    text.Append(CultureInfo.InvariantCulture, $"\"{section.Title}\",\"{row.Name}\",{shot.Distance},{shot.Request.Speed},{Aim.AimWriter.Word(r.Status)},{shot.Miss},{r.ThroughMiss},")
                        .Append(CultureInfo.InvariantCulture, $"{shot.Elevation},{shot.TopSpin},{shot.SideSpin},{r.Iterations},{r.Simulations},{shot.Microseconds}\n");
                }
            }
        }

        return text.ToString();
    }

    /// <summary>All charts in one drawing.</summary>
    public XElement Plot() => Figure.Stack(
        "Aiming",
        [.. sections.Where(section => section.Charts.Count > 0).Select(section => Figure.Stack(section.Title, section.Charts))]);

    /// <summary>Whether everything that was to be reached was.</summary>
    public bool Reached => verdicts.Wrong == 0 && verdicts.NotClosest == 0 && verdicts.WithoutAnswer == 0 && verdicts.NotConverged == 0 && sections.All(section => section.Rows.All(row => row.Reach?.Reached ?? true));

    private static double Mean(long sum, int count) => count > 0 ? (double)sum / count : 0;
}
