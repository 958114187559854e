using System.Globalization;
using System.Text;

namespace FootballPhysics.Tool.Commands;

/// <summary>
/// Writes text to a terminal or a log. It escapes control characters, which can come from input files, so that the terminal does not execute them.
/// </summary>
internal sealed class PersonWriter(TextWriter writer) : TextWriter(CultureInfo.InvariantCulture)
{
    public override Encoding Encoding => writer.Encoding;

    public override string NewLine => writer.NewLine;

    public override void Write(char value)
    {
        // Line breaks and tabs belong to the text.
        if (char.IsControl(value) && value is not ('\n' or '\t'))
        {
            writer.Write(string.Create(CultureInfo.InvariantCulture, $"\\u{(int)value:x4}"));
        }
        else
        {
            writer.Write(value);
        }
    }

    public override void Write(string? value)
    {
        if (value is null || !value.Any(character => char.IsControl(character) && character is not ('\n' or '\t')))
        {
            writer.Write(value);
            return;
        }

        foreach (char character in value)
        {
            Write(character);
        }
    }

    public override void Write(char[] buffer, int index, int count) => Write(new string(buffer, index, count));

    public override void WriteLine(string? value)
    {
        Write(value);
        writer.WriteLine();
    }

    public override void Flush() => writer.Flush();
}
