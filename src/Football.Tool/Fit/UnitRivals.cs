using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Fit.Reading;

namespace FootballPhysics.Tool.Fit;

/// <summary>Tries the units that a fall alone does not tell from metres: yards, and shares of a pitch across it with heights in metres.</summary>
/// <remarks>Gravity, drag and lift together do: in the right unit the laws of flight describe the track to within its noise, in a wrong one they do not.</remarks>
internal static class UnitRivals
{
    /// <summary>A rival is right if its rms is this share of that in metres, and so many times the noise of three coordinates and the error of the laws, m.</summary>
    private const double Share = 0.7;
    private const double NoiseShare = 2;
    private const double LawError = 0.003;

    private const int LeastFlights = 2;
    private const double Shortest = 0.3;

    /// <summary>So many points are enough to compare.</summary>
    private const int Most = 3000;

    /// <summary>The median rms of the flights, m: one that another ball or a touch spoils does not count.</summary>
    private static double Usual(MatchFitResult fit)
    {
        double[] rms = [.. fit.Pieces.Where(piece => piece.Kind == MatchPieceKind.Flight && piece.Duration >= Shortest).Select(piece => piece.Rms).Order()];
        return rms.Length > 0 ? rms[rms.Length / 2] : double.PositiveInfinity;
    }

    /// <summary>Throws if another unit describes a track whose unit was guessed.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="request">The request.</param>
    /// <param name="reading">The track, taken for metres.</param>
    /// <param name="fit">Its fit.</param>
    /// <param name="said">Receives remarks.</param>
    /// <exception cref="RefusedException">Another unit does.</exception>
    public static void Check(Scene scene, MatchFitRequest request, TrackReading reading, MatchFitResult fit, Action<string> said)
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

            said("guessed: positions within 0 … 100 are metres from a corner, not shares of a pitch; --unit percent if they are shares.");
        }
    }
}
