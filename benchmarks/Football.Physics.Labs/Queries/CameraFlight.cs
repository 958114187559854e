namespace FootballPhysics.Labs.Queries;

/// <summary>A fit of a flight.</summary>
/// <param name="Squares">The sum of the squared distances between fitted and true path, m².</param>
/// <param name="Least">The least that can be expected of it, m²: <see cref="CameraBound"/>.</param>
/// <param name="Points">The number of distances.</param>
/// <param name="Bounces">Whether a bounce is within the pixels.</param>
/// <param name="Spin">The error of the spin, rad/s.</param>
/// <param name="Verdict">The fit's verdict.</param>
/// <param name="Unidentified">The quantities that it does not give as results.</param>
/// <param name="Wrong">The number of given results that are off by more than four standard errors.</param>
/// <param name="Excess">The cost above that of the true launch; negative for a minimum that is as good.</param>
internal sealed record CameraFlight(
    double Squares, double Least, int Points, bool Bounces, double Spin, TrackVerdict Verdict, IReadOnlyList<string> Unidentified, int Wrong, double Excess)
{
    /// <summary>Whether the fit gives the depth, at the launch and on the way.</summary>
    public bool HasDepth => !Unidentified.Contains("position.depth") && !Unidentified.Contains("path.depth");

    /// <summary>Whether the fit finds something wrong with itself.</summary>
    public bool IsDoubtful => Verdict is not (TrackVerdict.AsExpected or TrackVerdict.NoiseOverestimated);

    /// <summary>Whether the result is one.</summary>
    public bool IsGood => HasDepth && !IsDoubtful;

    /// <summary>The root mean square of the distances of some flights, m.</summary>
    public static double Rms(IEnumerable<CameraFlight> flights) => Root(flights, flight => flight.Squares);

    /// <summary>The bound of that, m.</summary>
    public static double Bound(IEnumerable<CameraFlight> flights) => Root(flights, flight => flight.Least);

    private static double Root(IEnumerable<CameraFlight> flights, Func<CameraFlight, double> squares) =>
        Math.Sqrt(flights.Sum(squares) / Math.Max(1, flights.Sum(flight => flight.Points)));
}
