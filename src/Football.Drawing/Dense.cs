namespace FootballPhysics.Drawing;

/// <summary>Computes points along lines that are so close together that no letter fits between them.</summary>
public static class Dense
{
    private const double Step = 3;
    private const double MostSteps = 400;

    /// <summary>Returns points on the polyline through the given corners, in pixels.</summary>
    public static IEnumerable<(double X, double Y)> Line(IReadOnlyList<(double X, double Y)> corners)
    {
        for (int i = 0; i + 1 < corners.Count; i++)
        {
            (double x, double y) = corners[i];
            (double dx, double dy) = (corners[i + 1].X - x, corners[i + 1].Y - y);
            double steps = Math.Clamp(Math.Ceiling(Math.Sqrt((dx * dx) + (dy * dy)) / Step), 1, MostSteps);
            for (double k = 0; k < steps; k++)
            {
                yield return (x + (k / steps * dx), y + (k / steps * dy));
            }
        }

        if (corners.Count > 0)
        {
            yield return corners[^1];
        }
    }
}
