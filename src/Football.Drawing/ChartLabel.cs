namespace FootballPhysics.Drawing;

/// <summary>A label next to a point of a chart. The chart chooses the exact position, so that the label covers no curve.</summary>
/// <param name="X">The point, in pixels from the left of the plot.</param>
/// <param name="Y">The point, in pixels from the top of the plot.</param>
/// <param name="Text">The text.</param>
/// <param name="Colour">The colour of the text.</param>
public readonly record struct ChartLabel(double X, double Y, string Text, string Colour);
