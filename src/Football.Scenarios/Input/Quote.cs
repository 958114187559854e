using System.Globalization;
using System.Text;

namespace FootballPhysics.Scenarios.Input;

/// <summary>Converts foreign text for a message: one line, printable, short.</summary>
public static class Quote
{
    /// <summary>Returns the text on one line, truncated if it is long.</summary>
    /// <param name="text">The text.</param>
    /// <param name="longest">The maximum number of characters to show.</param>
    public static string Short(string text, int longest = 60)
    {
        var line = new StringBuilder();
        foreach (Rune rune in text.AsSpan(0, Math.Min(text.Length, longest + 1)).EnumerateRunes())
        {
            bool printable = Rune.GetUnicodeCategory(rune) is not (UnicodeCategory.Control or UnicodeCategory.Format or UnicodeCategory.LineSeparator
                or UnicodeCategory.ParagraphSeparator or UnicodeCategory.PrivateUse or UnicodeCategory.OtherNotAssigned);
            line.Append(printable ? rune.ToString() : $"\\u{rune.Value:x4}");
        }

        return line.Append(text.Length > longest + 1 ? "…" : "").ToString();
    }

    /// <summary>Returns the name of a file in quotes, so that an empty name is visible too.</summary>
    public static string File(string name) => $"\"{Short(name)}\"";
}
