namespace Football.Physics;

/// <summary>The elevations that a kick may have, rad.</summary>
internal readonly struct ElevationBounds
{
    private const double Degree = Math.PI / 180.0;

    public readonly double Lowest;
    public readonly double Highest;

    public ElevationBounds(double lowest, double highest)
    {
        Lowest = lowest;
        Highest = highest;
    }

    /// <summary>Those of a request.</summary>
    public static ElevationBounds Of(AimRequest request) => OfDegrees(request.MinimumElevationDegrees, request.MaximumElevationDegrees);

    /// <summary>Those of two angles in degrees.</summary>
    public static ElevationBounds OfDegrees(double lowest, double highest) => new(lowest * Degree, highest * Degree);

    /// <summary>The nearest elevation within the bounds.</summary>
    public double Clamp(double elevation) => Math.Min(Math.Max(elevation, Lowest), Highest);

    /// <summary>Whether an elevation lies within the bounds.</summary>
    public bool Contain(double elevation) => !(elevation < Lowest || elevation > Highest);
}
