using System.Globalization;
using System.Text;

namespace Football.Physics.Headless.Json;

/// <summary>Makes foreign text fit for a message: one line, printable, short.</summary>
internal static class Quote
{
    /// <summary>Characters that a message shows of a value.</summary>
    public const int Longest = 60;

    /// <summary>The text on one line, cut where it gets long.</summary>
    public static string Short(string text)
    {
        string beginning = Beginning(text);
        var line = new StringBuilder();
        foreach (Rune rune in beginning.EnumerateRunes())
        {
            UnicodeCategory category = Rune.GetUnicodeCategory(rune);
            bool printable = category is not (UnicodeCategory.Control or UnicodeCategory.Format or UnicodeCategory.LineSeparator
                or UnicodeCategory.ParagraphSeparator or UnicodeCategory.PrivateUse or UnicodeCategory.OtherNotAssigned);
            if (printable)
            {
                line.Append(rune.ToString());
            }
            else
            {
                line.Append(CultureInfo.InvariantCulture, $"\\u{rune.Value:x4}");
            }
        }

        if (beginning.Length < text.Length)
        {
            line.Append('…');
        }

        return line.ToString();
    }

    /// <summary>As much of the text as a message can show.</summary>
    public static string Beginning(string text) => text.Length <= Longest + 1 ? text : text[..(Longest + 1)];
}
