namespace Football.Physics.Headless.Gallery;

/// <summary>Lines of text in aligned columns: name at the left, figures at the right.</summary>
internal sealed class FigureTable
{
    private readonly int _nameWidth;

    public FigureTable(IEnumerable<string> names) => _nameWidth = names.Max(name => name.Length);

    public string Header => Line("shot", ShotFigures.Columns);

    public string Line(string name, IReadOnlyList<string> texts) =>
        name.PadRight(_nameWidth) + string.Concat(texts.Select((text, i) => "  " + text.PadLeft(ShotFigures.Columns[i].Length)));
}
