using System.Globalization;
using System.Xml;
using System.Xml.Linq;

namespace FootballPhysics.Drawing;

/// <summary>Creates SVG elements.</summary>
public static class Svg
{
    /// <summary>The average width of a letter in the drawings' font, as a fraction of the font size.</summary>
    private const double LetterWidth = 0.56;

    private static readonly XNamespace Namespace = "http://www.w3.org/2000/svg";

    /// <summary>Creates an element from attributes, given as name and value, and children.</summary>
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

    /// <summary>Returns the style of a page that shows the drawings inside an element in dark mode if the reader prefers dark mode.</summary>
    /// <param name="scope">The CSS selector of the element.</param>
    /// <param name="dark">The dark colour for each light one.</param>
    public static string DarkStyle(string scope, IEnumerable<(string Light, string Dark)> dark) => StyleOf(dark, scope + " ");

    /// <summary>Creates a stand-alone drawing, with a title for screen readers and with dark mode.</summary>
    public static XElement Standing(string title, XElement drawing) => Standing(title, drawing, Palette.Dark);

    /// <summary>Creates a stand-alone drawing with its own colours for dark mode.</summary>
    public static XElement Standing(string title, XElement drawing, IEnumerable<(string Light, string Dark)> dark)
    {
        drawing.SetAttributeValue("role", "img");
        drawing.SetAttributeValue("aria-label", Plain(title));
        drawing.AddFirst(Element("title", [], title), Element("style", [], StyleOf(dark)));
        return drawing;
    }

    /// <summary>Creates the root element of a drawing, or of a part of a drawing.</summary>
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

    /// <summary>Returns the approximate width of a text, in pixels.</summary>
    public static double WidthOf(string text, double size = 11) => text.Length * size * LetterWidth;

    /// <summary>Splits a text into lines of at most the given width, in pixels; returns at least one line.</summary>
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

    /// <summary>Replaces the control characters that XML does not allow by U+FFFD.</summary>
    private static string Plain(string text) =>
        string.Create(text.Length, text, (plain, from) =>
        {
            for (int i = 0; i < plain.Length; i++)
            {
                plain[i] = XmlConvert.IsXmlChar(from[i]) || char.IsSurrogate(from[i]) ? from[i] : '\uFFFD';
            }
        });

    /// <summary>Returns a style that selects each colour by its value. Programs without style sheets then show the light drawing.</summary>
    private static string StyleOf(IEnumerable<(string Light, string Dark)> colours, string scope = "") => "@media (prefers-color-scheme: dark) { "
        + string.Concat(colours.Select(pair => $"{scope}[fill=\"{pair.Light}\"] {{ fill: {pair.Dark} }} {scope}[stroke=\"{pair.Light}\"] {{ stroke: {pair.Dark} }} ")) + "}";
}
