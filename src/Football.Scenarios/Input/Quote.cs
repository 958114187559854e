using System.Globalization;
using System.Text;

namespace FootballPhysics.Scenarios.Input;

/// <summary>Makes foreign text fit for a message: one line, printable, short.</summary>
public static class Quote
{
    /// <summary>The text on one line, cut where it gets long.</summary>
    /// <param name="text">The text.</param>
    /// <param name="longest">Characters that a message shows of it.</param>
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

    /// <summary>The name of a file in quotes, so that an empty one is seen too.</summary>
    public static string File(string name) => $"\"{Short(name)}\"";
}
