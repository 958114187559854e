using System.Xml.Linq;

namespace Football.Physics.Headless.Drawing;

/// <summary>Charts one above the other in one drawing.</summary>
internal static class Figure
{
    /// <summary>Stacks drawings; a title above all of them can be left empty.</summary>
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
}
