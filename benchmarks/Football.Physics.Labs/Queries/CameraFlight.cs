namespace FootballPhysics.Labs.Queries;

/// <summary>The fit of a flight.</summary>
/// <param name="Squares">The sum of the squared distances between the fitted and the true path, m².</param>
/// <param name="Least">The least expected value of this sum, m²: <see cref="CameraBound"/>.</param>
/// <param name="Points">The number of distances.</param>
/// <param name="Bounces">True if the pixels include a bounce.</param>
/// <param name="Spin">The error of the spin, rad/s.</param>
/// <param name="Verdict">The fit's verdict.</param>
/// <param name="Unidentified">The quantities that the fit does not report as results.</param>
/// <param name="Wrong">The number of reported results that are off by more than four standard errors.</param>
/// <param name="Excess">The cost above the cost of the true launch; negative if the fit found a lower one.</param>
internal sealed record CameraFlight(
    double Squares, double Least, int Points, bool Bounces, double Spin, TrackVerdict Verdict, IReadOnlyList<string> Unidentified, int Wrong, double Excess)
{
    /// <summary>True if the fit reports the depth, both at the launch and along the path.</summary>
    public bool HasDepth => !Unidentified.Contains("position.depth") && !Unidentified.Contains("path.depth");

    /// <summary>True if the fit's verdict reports a problem.</summary>
    public bool IsDoubtful => Verdict is not (TrackVerdict.AsExpected or TrackVerdict.NoiseOverestimated);

    /// <summary>True if the fit reports the depth and its verdict reports no problem.</summary>
    public bool IsGood => HasDepth && !IsDoubtful;

    /// <summary>Returns the root mean square of the distances of some flights, m.</summary>
    public static double Rms(IEnumerable<CameraFlight> flights) => Root(flights, flight => flight.Squares);

    /// <summary>Returns the bound of this root mean square, m.</summary>
    public static double Bound(IEnumerable<CameraFlight> flights) => Root(flights, flight => flight.Least);

    private static double Root(IEnumerable<CameraFlight> flights, Func<CameraFlight, double> squares) =>
        Math.Sqrt(flights.Sum(squares) / Math.Max(1, flights.Sum(flight => flight.Points)));
}
