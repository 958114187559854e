namespace FootballPhysics.Drawing;

/// <summary>A word beside a place of a chart; where exactly the chart decides, so that it is on no curve.</summary>
/// <param name="X">The place, in pixels from the left of the plot.</param>
/// <param name="Y">The place, in pixels from the top of the plot.</param>
/// <param name="Text">The word.</param>
/// <param name="Colour">Its colour.</param>
public readonly record struct ChartLabel(double X, double Y, string Text, string Colour);
