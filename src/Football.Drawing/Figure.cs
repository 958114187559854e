using System.Xml.Linq;

namespace FootballPhysics.Drawing;

/// <summary>Combines drawings into one.</summary>
public static class Figure
{
    /// <summary>The ratio of width to height of a screen.</summary>
    private const double Screen = 1.6;

    /// <summary>Arranges drawings of one size in rows, so that the result has about the proportions of a screen.</summary>
    public static XElement Tile(string title, params IReadOnlyList<XElement> drawings)
    {
        double width = drawings.Max(drawing => (double)drawing.Attribute("width")!);
        double height = drawings.Max(drawing => (double)drawing.Attribute("height")!);
        double Shape(int columns) => columns * width / (Math.Ceiling((double)drawings.Count / columns) * height);
        int best = Enumerable.Range(1, drawings.Count).MinBy(columns => Math.Abs(Math.Log(Shape(columns) / Screen)));
        XElement[] rows = [.. drawings.Chunk(best).Select(row => Row(row, width))];
        return Stack(title, rows);
    }

    /// <summary>Stacks drawings vertically below a title. An empty title takes almost no space.</summary>
    public static XElement Stack(string title, params IReadOnlyList<XElement> drawings)
    {
        double at = title.Length > 0 ? 30 : 4;
        double width = 0;
        var content = new List<XElement>();
        foreach (XElement drawing in drawings)
        {
            drawing.SetAttributeValue("y", Svg.Number(at));
            content.Add(drawing);
            at += (double)drawing.Attribute("height")!;
            width = Math.Max(width, (double)drawing.Attribute("width")!);
        }

        return Svg.Root(
            width,
            at,
            Svg.Element("rect", [("width", width), ("height", at), ("fill", Palette.Paper)]),
            title.Length > 0 ? Svg.Text(12, 20, title, size: 15, bold: true) : null,
            content);
    }

    private static XElement Row(XElement[] drawings, double width)
    {
        for (int i = 0; i < drawings.Length; i++)
        {
            drawings[i].SetAttributeValue("x", Svg.Number(i * width));
        }

        return Svg.Root(drawings.Length * width, drawings.Max(drawing => (double)drawing.Attribute("height")!), drawings);
    }
}
