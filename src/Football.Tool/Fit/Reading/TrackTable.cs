namespace FootballPhysics.Tool.Fit.Reading;

/// <summary>A line of a track: its number in the file, and its cells.</summary>
internal readonly record struct TrackLine(long Number, string[] Cells)
{
    /// <summary>Returns a cell; empty if the line is shorter.</summary>
    public string this[int column] => column >= 0 && column < Cells.Length ? Cells[column] : "";
}

/// <summary>The cells of a track file, independent of its notation.</summary>
internal sealed class TrackTable
{
    /// <summary>The names of the columns; null if the file has none.</summary>
    public string[]? Header { get; set; }

    /// <summary>Descriptions of the lists of the file, such as the sets of frames in XML.</summary>
    public List<string> Parts { get; } = [];

    /// <summary>The lines below the header.</summary>
    public List<TrackLine> Lines { get; } = [];

    /// <summary>The separator; 0 if the file is not CSV.</summary>
    public char Separator { get; init; }

    /// <summary>The unit of the coordinates in the file's layout; null if the layout does not define one.</summary>
    public string? Unit { get; init; }
}
