using System.Globalization;
using System.Text;

namespace FootballPhysics.Tool.Gallery;

/// <summary>Draws a line in the dots of Braille letters: each letter has two columns and four rows of dots.</summary>
/// <param name="columns">The width in letters, without the labels.</param>
/// <param name="rows">The height in letters, without the labels.</param>
internal sealed class Sketch(int columns, int rows)
{
    /// <summary>The bit of each dot in a letter from U+2800, by row and column.</summary>
    private static readonly int[,] Dots = { { 0x01, 0x08 }, { 0x02, 0x10 }, { 0x04, 0x20 }, { 0x40, 0x80 } };

    private const int LabelWidth = 7;

    private readonly int[,] _letters = new int[rows, columns];

    /// <summary>Draws the line through points. Each axis spans the range of its values, so the two scales differ.</summary>
    /// <param name="name">The label of the vertical axis. The horizontal axis is the distance along the view.</param>
    /// <param name="x">The horizontal coordinates, in m.</param>
    /// <param name="y">The vertical coordinates, in m.</param>
    public string Draw(string name, double[] x, double[] y)
    {
        (double left, double right) = Ends(x);
        (double bottom, double top) = Ends(y);
        double AcrossOf(int i) => (x[i] - left) / (right - left) * ((2 * columns) - 1);
        double DownOf(int i) => (top - y[i]) / (top - bottom) * ((4 * rows) - 1);
        for (int i = 0; i < x.Length; i++)
        {
            int last = Math.Max(0, i - 1);
            Line(AcrossOf(last), DownOf(last), AcrossOf(i), DownOf(i));
        }

        var text = new StringBuilder();
        for (int row = 0; row < rows; row++)
        {
            string label = row == 0 ? Label(top) : row == rows - 1 ? Label(bottom) : "";
            text.Append(label.PadLeft(LabelWidth)).Append(" │");
            for (int column = 0; column < columns; column++)
            {
                int letter = _letters[row, column];
                text.Append(letter == 0 ? ' ' : (char)(0x2800 + letter));
            }

            text.Append('\n');
        }

        string below = Label(left) + " ";
        string end = $" {Label(right)} m along, {name} up";
        return text.Append("".PadLeft(LabelWidth)).Append(" └").Append('─', columns).Append('\n')
            .Append("".PadLeft(LabelWidth + 2)).Append(below).Append(end.PadLeft(Math.Max(end.Length, columns - below.Length))).Append('\n').ToString();
    }

    private static (double Low, double High) Ends(double[] values)
    {
        // If all values are equal, the line is in the middle of the range.
        double low = values.Min();
        double high = values.Max();
        return high - low > 1e-3 ? (low, high) : (low - 0.5, high + 0.5);
    }

    private static string Label(double value) => (Math.Round(value, 1) + 0.0).ToString("0.0", CultureInfo.InvariantCulture);

    private void Line(double fromX, double fromY, double toX, double toY)
    {
        int steps = (int)Math.Ceiling(Math.Max(Math.Abs(toX - fromX), Math.Abs(toY - fromY)));
        for (int i = 0; i <= steps; i++)
        {
            double share = steps == 0 ? 0 : (double)i / steps;
            int across = (int)Math.Round(fromX + (share * (toX - fromX)));
            int down = (int)Math.Round(fromY + (share * (toY - fromY)));
            _letters[down / 4, across / 2] |= Dots[down % 4, across % 2];
        }
    }
}
