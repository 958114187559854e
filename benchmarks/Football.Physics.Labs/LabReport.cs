using System.Xml.Linq;

namespace FootballPhysics.Labs;

/// <summary>What an experiment has to say: tables, and pictures if asked for.</summary>
internal sealed class LabReport
{
    public required string Name { get; init; }

    public required long Seed { get; init; }

    public List<LabTable> Tables { get; } = [];

    /// <summary>Lines below the tables.</summary>
    public List<string> Notes { get; } = [];

    /// <summary>What the CSV has instead of the tables; null where it has the tables.</summary>
    public LabTable? Rows { get; set; }

    /// <summary>Draws the picture.</summary>
    public Func<XElement>? Picture { get; set; }

    /// <summary>Whether a case failed.</summary>
    public bool Failed { get; set; }
}
