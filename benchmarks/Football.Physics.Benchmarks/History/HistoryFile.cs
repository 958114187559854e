using System.Globalization;
using nietras.SeparatedValues;

namespace FootballPhysics.Benchmarks;

/// <summary>The history of the ratios: a CSV file with a line per measured version.</summary>
internal sealed class HistoryFile(string path)
{
    private static readonly string[] s_facts = ["date", "version", "commit", "runtime", "processor"];

    private readonly List<string> _columns = [.. s_facts];
    private readonly List<Dictionary<string, string>> _lines = [];

    /// <summary>The columns that are ratios, in the order of the file.</summary>
    public IEnumerable<string> Ratios => _columns.Except(s_facts);

    /// <summary>The version of each line.</summary>
    public IReadOnlyList<string> Versions => [.. _lines.Select(line => line["version"])];

    /// <summary>Reads the file if it exists.</summary>
    public static HistoryFile Read(string path)
    {
        var file = new HistoryFile(path);
        if (!File.Exists(path))
        {
            return file;
        }

        using SepReader reader = Sep.New(',').Reader(options => options with { Unescape = true }).FromFile(path);
        string[] header = [.. reader.Header.ColNames];
        file._columns.AddRange(header.Except(file._columns));
        foreach (SepReader.Row row in reader)
        {
            var line = new Dictionary<string, string>();
            foreach (string column in header)
            {
                line[column] = row[column].ToString();
            }

            file._lines.Add(line);
        }

        return file;
    }

    /// <summary>Adds a line. A ratio that the file does not contain yet becomes a new column.</summary>
    public void Add(IReadOnlyList<string> facts, IReadOnlyList<(string Name, double Ratio)> ratios)
    {
        Dictionary<string, string> line = s_facts.Zip(facts).ToDictionary(fact => fact.First, fact => fact.Second);
        foreach ((string name, double ratio) in ratios)
        {
            line[name] = ratio.ToString("G4", CultureInfo.InvariantCulture);
        }

        _columns.AddRange(ratios.Select(ratio => ratio.Name).Except(_columns));
        _lines.Add(line);
    }

    /// <summary>Returns the ratios of a column, each with the number of its line.</summary>
    public IEnumerable<(int Line, double Ratio)> Of(string column) => _lines.Index()
        .Where(line => line.Item.GetValueOrDefault(column, "").Length > 0)
        .Select(line => (line.Index, double.Parse(line.Item[column], CultureInfo.InvariantCulture)));

    /// <summary>Writes all lines.</summary>
    public void Write()
    {
        using SepWriter writer = Sep.New(',').Writer(options => options with { Escape = true }).ToFile(path);
        foreach (Dictionary<string, string> line in _lines)
        {
            using SepWriter.Row row = writer.NewRow();
            foreach (string column in _columns)
            {
                row[column].Set(line.GetValueOrDefault(column, ""));
            }
        }
    }
}
