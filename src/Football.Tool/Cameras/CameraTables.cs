using System.CommandLine;
using System.Globalization;
using System.Text.Json.Nodes;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Commands;
using nietras.SeparatedValues;

namespace FootballPhysics.Tool.Cameras;

/// <summary>Reads CSV files of cameras and of pixels, which replace the members "cameras" and "track".</summary>
internal static class CameraTables
{
    /// <summary>The maximum number of lines; it limits the memory.</summary>
    private const int MostLines = 1_000_000;

    private static readonly string[] s_matrix = [.. from row in Enumerable.Range(1, 3) from column in Enumerable.Range(1, 4) select FormattableString.Invariant($"p{row}{column}")];

    /// <summary>Creates the option --pixels FILE.csv: the track as pixels.</summary>
    public static Option<FieldOverride[]> Pixels() => Table("--pixels", "PIXELS.csv", "Pixels of the ball instead of \"track\": CSV with the columns time, u, v and, optionally, camera (default 0) and noise (pixels).", "track", ["time", "u", "v"], Pixel);

    /// <summary>Creates the option --cameras FILE.csv: one matrix per line.</summary>
    public static Option<FieldOverride[]> Cameras() => Table("--cameras", "CAMERAS.csv", "Cameras instead of \"cameras\": CSV with the columns p11, p12, … p34, a matrix per line; the first line is camera 0.", "cameras", s_matrix, Camera);

    private static Option<FieldOverride[]> Table(string name, string file, string description, string member, string[] columns, Func<SepReader.Row, IReadOnlyList<string>, JsonObject> item) => new(name)
    {
        HelpName = file,
        Description = description,
        DefaultValueFactory = _ => [],
        CustomParser = result =>
        {
            try
            {
                JsonArray list = Read(name, result.Tokens[0].Value, columns, item);
                return [FieldOverride.Parse($"{member}={list.ToJsonString()}")!];
            }
            catch (RefusedException refusal)
            {
                result.AddError(refusal.Message);
                return [];
            }
        },
    };

    private static JsonArray Read(string name, string file, string[] columns, Func<SepReader.Row, IReadOnlyList<string>, JsonObject> item)
    {
        try
        {
            using SepReader reader = Sep.Reader(options => options with { Trim = SepTrim.All, Unescape = true }).FromFile(file);
            IReadOnlyList<string> header = reader.Header.ColNames;
            string? missing = Array.Find(columns, column => !header.Contains(column));
            if (missing is not null)
            {
                throw new RefusedException($"{name}'s header", Quote.Short(string.Join(',', header)), $"a header with {string.Join(", ", columns)}");
            }

            var list = new JsonArray();
            foreach (SepReader.Row row in reader)
            {
                if (list.Count == MostLines)
                {
                    throw new RefusedException($"{name}'s lines", "more", FormattableString.Invariant($"at most {MostLines}"));
                }

                list.Add(item(row, header));
            }

            return list;
        }
        catch (FormatException e)
        {
            throw new RefusedException($"{name} {Quote.File(file)} has a cell that is not a number ({Quote.Short(e.Message)}). Write numbers with a decimal point.");
        }
        catch (Exception e) when (OutputFile.IsFileFault(e) || e is InvalidDataException or NotSupportedException or ArgumentException)
        {
            throw new RefusedException($"{name} {Quote.File(file)} cannot be read as CSV ({Quote.Short(e.Message)}). Pass a CSV file with a header.");
        }
    }

    private static JsonObject Pixel(SepReader.Row row, IReadOnlyList<string> header)
    {
        var point = new JsonObject { ["time"] = row["time"].Parse<double>(), ["pixel"] = new JsonArray(row["u"].Parse<double>(), row["v"].Parse<double>()) };
        if (header.Contains("camera"))
        {
            point["camera"] = int.Parse(row["camera"].Span, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture);
        }

        if (header.Contains("noise"))
        {
            point["noise"] = row["noise"].Parse<double>();
        }

        return point;
    }

    private static JsonObject Camera(SepReader.Row row, IReadOnlyList<string> header)
    {
        var matrix = new JsonArray();
        for (int i = 0; i < 3; i++)
        {
            var line = new JsonArray();
            for (int j = 0; j < 4; j++)
            {
                line.Add(row[s_matrix[(4 * i) + j]].Parse<double>());
            }

            matrix.Add(line);
        }

        return new JsonObject { ["matrix"] = matrix };
    }
}
