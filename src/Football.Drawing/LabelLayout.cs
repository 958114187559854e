using System.Xml.Linq;

namespace FootballPhysics.Drawing;

/// <summary>Places labels where nothing else is drawn, as close to their points as possible.</summary>
/// <param name="width">Width of the plot, in pixels.</param>
/// <param name="height">Height of the plot, in pixels.</param>
/// <param name="background">The colour behind the labels. A rim in this colour keeps a label legible if it covers something.</param>
public sealed class LabelLayout(double width, double height, string background)
{
    private const double Size = 11;

    /// <summary>The cost of overlapping another label, in drawn points. It exceeds the number of points under any label.</summary>
    private const int OnAnother = 200;

    /// <summary>The offsets from a point at which a label is tried, in multiples of half its width and of its height.</summary>
    private static readonly (double Across, double Down)[] Tries =
    [
        (0, -0.9), (0, 1.2), (0.6, -0.6), (-0.6, -0.6), (0.6, 0.9), (-0.6, 0.9), (0, -2), (0, 2.3), (1, -1.6), (-1, -1.6), (1, 2), (-1, 2), (0, -3.2), (0, 3.4),
        (1.5, -0.4), (-1.5, -0.4), (1.5, 0.6), (-1.5, 0.6), (1.5, -2.4), (-1.5, -2.4), (0, -4.6), (2.4, -1), (-2.4, -1),
    ];

    private readonly List<(double X, double Y)> _ink = [];
    private readonly List<(double Left, double Top, double Right, double Bottom)> _taken = [];

    /// <summary>Registers points that labels should not cover.</summary>
    public void Draw(IEnumerable<(double X, double Y)> places) => _ink.AddRange(places);

    /// <summary>Places a label, and returns its text element.</summary>
    public XElement Place(ChartLabel label)
    {
        double half = Svg.WidthOf(label.Text, Size) / 2;
        var best = (Left: 0.0, Top: 0.0, Right: 0.0, Bottom: 0.0);
        double least = double.PositiveInfinity;
        foreach ((double across, double down) in Tries)
        {
            double middle = Math.Clamp(label.X + (across * (half + 6)), half + 2, Math.Max(half + 2, width - half - 2));
            double top = Math.Clamp(label.Y + (down * Size) - (Size / 2), 1, Math.Max(1, height - Size - 2));
            var box = (Left: middle - half, Top: top, Right: middle + half, Bottom: top + Size);
            double cost = Cost(box) + (2 * (Math.Abs(middle - label.X) + Math.Abs(top + (Size / 2) - label.Y)) / Size);
            if (cost < least)
            {
                (best, least) = (box, cost);
            }
        }

        _taken.Add(best);
        XElement text = Svg.Text((best.Left + best.Right) / 2, best.Bottom - 1.5, label.Text, "middle", Size, label.Colour);
        text.Add(new XAttribute("stroke", background), new XAttribute("stroke-width", 3), new XAttribute("stroke-linejoin", "round"), new XAttribute("paint-order", "stroke"));
        return text;
    }

    /// <summary>Returns the cost of a box: the number of drawn points that it covers, plus <see cref="OnAnother"/> for each label.</summary>
    private double Cost((double Left, double Top, double Right, double Bottom) box)
    {
        const double around = 2;
        int covered = _ink.Count(at => at.X > box.Left - around && at.X < box.Right + around && at.Y > box.Top - around && at.Y < box.Bottom + around);
        int met = _taken.Count(other => box.Left < other.Right + 4 && other.Left < box.Right + 4 && box.Top < other.Bottom && other.Top < box.Bottom);
        return covered + (OnAnother * met);
    }
}
