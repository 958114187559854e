using System.Xml.Linq;

namespace FootballPhysics.Labs;

/// <summary>The results of an experiment: tables, and pictures on request.</summary>
internal sealed class LabReport
{
    public required string Name { get; init; }

    public required long Seed { get; init; }

    public List<LabTable> Tables { get; } = [];

    /// <summary>Lines below the tables.</summary>
    public List<string> Notes { get; } = [];

    /// <summary>The table that the CSV contains instead of the tables; null if it contains the tables.</summary>
    public LabTable? Rows { get; set; }

    /// <summary>Draws the picture.</summary>
    public Func<XElement>? Picture { get; set; }

    /// <summary>True if a case failed.</summary>
    public bool Failed { get; set; }
}
