namespace FootballPhysics.Aiming;

/// <summary>Decides whether any kick of a given speed can hit: it covers all elevations with lower bounds of the miss.</summary>
/// <remarks>
/// In still air over level ground, the miss m depends on the elevation ε only. Between two flights that are Δ apart, m is at least the chord minus
/// ½ K R x (Δ − x), since m'' ≤ K R: in vacuum the range is R sin 2ε, so that K = 4. In air, K = 4.5 is measured, not proved: <c>football lab answers</c>
/// counts the known kicks that the bound denies. Beyond the outer flights, m ≥ m₁ − 2 R Δ. R is the distance
/// of the farthest closest point. Flights are added until the bound is clear everywhere.
/// </remarks>
internal sealed class ReachCover
{
    /// <summary>The bounds of m' and m'', in distances per rad and per rad².</summary>
    private const double Slope = 2;
    private const double Curvature = 4.5;

    /// <summary>The lower bound that suffices, as a share of the distance; the jump in the drag law shifts a flight by less.</summary>
    private const double Enough = 0.005;

    private const int MostAdded = 12;
    private const int Most = 96;

    private readonly double[] _elevations = new double[Most];
    private readonly double[] _misses = new double[Most];
    private int _count;
    private double _distance;

    /// <summary>Discards all flights.</summary>
    public void Begin(double distance) => (_count, _distance) = (0, distance);

    /// <summary>Adds a flight.</summary>
    /// <param name="elevation">The elevation, in rad.</param>
    /// <param name="miss">The miss, in m.</param>
    /// <param name="reach">The distance of the closest point from the ball, in m.</param>
    public void Add(double elevation, double miss, double reach)
    {
        if (_count == Most)
        {
            return;
        }

        int at = _count++;
        for (; at > 0 && _elevations[at - 1] > elevation; at--)
        {
            (_elevations[at], _misses[at]) = (_elevations[at - 1], _misses[at - 1]);
        }

        (_elevations[at], _misses[at]) = (elevation, miss);
        _distance = Math.Max(_distance, reach);
    }

    /// <summary>True if no kick between the bounds hits; it adds flights where that is not certain.</summary>
    public bool Excludes(ApproachByElevation approaches)
    {
        for (int i = 0; i <= MostAdded && !approaches.IsSpent; i++)
        {
            if (!(Uncertain(approaches.Bounds, out double elevation) < Enough * _distance))
            {
                return true;
            }

            if (i == MostAdded || !(approaches.At(elevation).Miss >= Enough * _distance))
            {
                return false;
            }
        }

        return false;
    }

    /// <summary>Returns the least lower bound, and the elevation whose flight improves it.</summary>
    private double Uncertain(in ElevationBounds bounds, out double elevation)
    {
        elevation = bounds.Lowest;
        if (_count == 0)
        {
            return 0;
        }

        double least = _misses[0] - (Slope * _distance * (_elevations[0] - bounds.Lowest));
        double last = _misses[_count - 1] - (Slope * _distance * (bounds.Highest - _elevations[_count - 1]));
        (least, elevation) = last < least ? (last, bounds.Highest) : (least, elevation);
        for (int i = 1; i < _count; i++)
        {
            double between = Between(_misses[i - 1], _misses[i], _elevations[i] - _elevations[i - 1]);
            (least, elevation) = between < least ? (between, 0.5 * (_elevations[i - 1] + _elevations[i])) : (least, elevation);
        }

        return least;
    }

    /// <summary>Returns the minimum of m₁ + s x − ½ K R x (Δ − x).</summary>
    private double Between(double one, double other, double width)
    {
        double curvature = Curvature * _distance;
        double x = width > 0 ? Math.Min(Math.Max((0.5 * width) - ((other - one) / (width * curvature)), 0), width) : 0;
        return one + (width > 0 ? (other - one) * x / width : 0) - (0.5 * curvature * x * (width - x));
    }
}
