using System.Globalization;
using System.Xml;
using System.Xml.Linq;

namespace FootballPhysics.Drawing;

/// <summary>Makes SVG elements.</summary>
public static class Svg
{
    /// <summary>Pixels that a letter of the drawings' font takes on average, per pixel of its size.</summary>
    private const double LetterWidth = 0.56;

    private static readonly XNamespace Namespace = "http://www.w3.org/2000/svg";

    /// <summary>An element with attributes given as name and value, and with children.</summary>
    public static XElement Element(string name, (string Name, object Value)[] attributes, params object?[] content)
    {
        var element = new XElement(Namespace + name);
        foreach ((string attribute, object value) in attributes)
        {
            element.SetAttributeValue(attribute, value switch { double number => Number(number), string text => Plain(text), _ => value });
        }

        foreach (object? item in content)
        {
            element.Add(item is string text ? Plain(text) : item);
        }

        return element;
    }

    /// <summary>The style of a page that turns the drawings inside an element dark if the reader prefers that.</summary>
    /// <param name="scope">The selector of the element.</param>
    /// <param name="dark">The dark colour for each light one.</param>
    public static string DarkStyle(string scope, IEnumerable<(string Light, string Dark)> dark) => StyleOf(dark, scope + " ");

    /// <summary>A drawing that stands for itself: with a title for those who do not see it, and dark where that is preferred.</summary>
    public static XElement Standing(string title, XElement drawing) => Standing(title, drawing, Palette.Dark);

    /// <summary>The same with dark colours of its own.</summary>
    public static XElement Standing(string title, XElement drawing, IEnumerable<(string Light, string Dark)> dark)
    {
        drawing.SetAttributeValue("role", "img");
        drawing.SetAttributeValue("aria-label", Plain(title));
        drawing.AddFirst(Element("title", [], title), Element("style", [], StyleOf(dark)));
        return drawing;
    }

    /// <summary>The outermost element of a drawing, or of a part of one.</summary>
    public static XElement Root(double width, double height, params object?[] content) => Element(
        "svg",
        [
            ("viewBox", $"0 0 {Number(width)} {Number(height)}"), ("width", width), ("height", height),
            ("font-family", "system-ui, 'Segoe UI', Helvetica, Arial, sans-serif"), ("font-size", 11.0), ("fill", Palette.Ink),
        ],
        content);

    public static XElement Line(double x1, double y1, double x2, double y2, string colour, double width = 1, string dash = "none") =>
        Element("line", [("x1", x1), ("y1", y1), ("x2", x2), ("y2", y2), ("stroke", colour), ("stroke-width", width), ("stroke-dasharray", dash)]);

    public static XElement Text(double x, double y, string text, string anchor = "start", double size = 11, string? colour = null, bool bold = false) => Element(
        "text",
        [("x", x), ("y", y), ("text-anchor", anchor), ("font-size", size), ("fill", colour ?? Palette.Ink), ("font-weight", bold ? "600" : "400")],
        text);

    /// <summary>About how wide a text is.</summary>
    public static double WidthOf(string text, double size = 11) => text.Length * size * LetterWidth;

    /// <summary>A text in lines that are not wider than a width; at least one.</summary>
    public static IEnumerable<string> Lines(string text, double width, double size)
    {
        string line = "";
        foreach (string word in text.Split(' '))
        {
            string longer = line.Length > 0 ? $"{line} {word}" : word;
            if (line.Length > 0 && WidthOf(longer, size) > width)
            {
                yield return line;
                longer = word;
            }

            line = longer;
        }

        yield return line;
    }

    public static string Number(double value) => Math.Round(value, 2).ToString(CultureInfo.InvariantCulture);

    /// <summary>The text with U+FFFD in place of the control characters that XML does not allow.</summary>
    private static string Plain(string text) =>
        string.Create(text.Length, text, (plain, from) =>
        {
            for (int i = 0; i < plain.Length; i++)
            {
                plain[i] = XmlConvert.IsXmlChar(from[i]) || char.IsSurrogate(from[i]) ? from[i] : '\uFFFD';
            }
        });

    /// <summary>Selects each colour by its value, so that programs without style sheets show the light drawing.</summary>
    private static string StyleOf(IEnumerable<(string Light, string Dark)> colours, string scope = "") => "@media (prefers-color-scheme: dark) { "
        + string.Concat(colours.Select(pair => $"{scope}[fill=\"{pair.Light}\"] {{ fill: {pair.Dark} }} {scope}[stroke=\"{pair.Light}\"] {{ stroke: {pair.Dark} }} ")) + "}";
}
