using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Fit.Reading;

namespace FootballPhysics.Tool.Fit;

/// <summary>Tries the units that the fall alone does not distinguish from metres: yards, and shares of a pitch horizontally with heights in metres.</summary>
/// <remarks>Gravity, drag and lift together distinguish them: the laws of flight describe the track to within its noise only in the correct unit.</remarks>
internal static class UnitRivals
{
    /// <summary>
    /// The limits of the rms in another unit: a share of that in metres, and a multiple of the noise of three coordinates plus the error of the laws,
    /// in m.
    /// </summary>
    private const double Share = 0.7;
    private const double NoiseShare = 2;
    private const double LawError = 0.003;

    private const int LeastFlights = 2;
    private const double Shortest = 0.3;

    /// <summary>The maximum number of points that are compared.</summary>
    private const int Most = 3000;

    /// <summary>Returns the median rms of the flights, in m. A flight that a touch or another ball spoils hardly changes it.</summary>
    private static double Usual(MatchFitResult fit)
    {
        double[] rms = [.. fit.Pieces.Where(piece => piece.Kind == MatchPieceKind.Flight && piece.Duration >= Shortest).Select(piece => piece.Rms).Order()];
        return rms.Length > 0 ? rms[rms.Length / 2] : double.PositiveInfinity;
    }

    /// <summary>Throws if another unit describes a track whose unit was guessed better.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="request">The request.</param>
    /// <param name="reading">The track, read in metres.</param>
    /// <param name="fit">The fit of the track.</param>
    /// <param name="report">Receives remarks.</param>
    /// <exception cref="RefusedException">Another unit describes the track better.</exception>
    public static void Check(Scene scene, MatchFitRequest request, TrackReading reading, MatchFitResult fit, Action<string> report)
    {
        if (!reading.IsGuessed || fit.Flights < LeastFlights)
        {
            return;
        }

        MatchFitRequest flights = request with { Surface = false };
        TrackPoint[] points = reading.Points.Length > Most ? reading.Points[..Most] : reading.Points;
        MatchFitResult metres = points.Length < reading.Points.Length ? new MatchFit(scene).Find(points, flights) : fit;
        bool IsBetter(double along, double across, double up)
        {
            MatchFitResult rival = new MatchFit(scene).Find(
                [.. points.Select(point => new TrackPoint(point.Time, new Vector3d(along * point.Position.X, up * point.Position.Y, across * point.Position.Z), point.Noise))], flights);
            double most = (NoiseShare * Math.Sqrt(3) * rival.Noise) + LawError;
            return rival.Flights >= LeastFlights
                && ((rival.Rms < most && rival.Rms < Share * up * metres.Rms) || (Usual(rival) < most && Usual(rival) < Share * up * Usual(metres)));
        }

        if (IsBetter(0.9144, 0.9144, 0.9144))
        {
            throw new RefusedException("The ball flies in TRACK as one does if positions are yards, not metres. Give --unit yd, or --unit m if these are metres.");
        }

        if (reading.IsShare)
        {
            if (IsBetter(1.05, 0.68, 1))
            {
                throw new RefusedException("All positions of TRACK are within 0 … 100, and the ball flies as one does if they are shares of a pitch. Give --unit percent with --pitch and --y right or left, or --unit m if these are metres.");
            }

            report("guessed: positions within 0 … 100 are metres from a corner, not shares of a pitch; --unit percent if they are shares.");
        }
    }
}
