namespace FootballPhysics.Tracks;

/// <summary>Removes the points at the ends of a flight that lie beyond an impact: the division of a track into cubics ends up to a few points off.</summary>
/// <remarks>One such point of a slow ball changes the spin by more than all others reveal.</remarks>
internal sealed class FlightEnds(FlightEquations equations, SharedFit fit, FitWatch watch)
{
    /// <summary>The residual of an end beyond which it is no point of the flight, as a multiple of the noise and of the root mean square of the other points; and at least the error of the laws.</summary>
    private const double Far = 5;
    private const double FarShare = 3;

    /// <summary>The most points that are removed at an end, and the points that a flight keeps.</summary>
    private const int MostPoints = 2;
    private const int LeastPoints = 8;

    private readonly StepLog _log = new();
    private readonly SharedFit _alone = new(equations, new MatchModel(fit.At.Scene, new MatchFitRequest { Wind = false, Drag = false }));

    /// <summary>Removes them, and fits the rest of the flight again.</summary>
    public void Trim(FlightPath flight)
    {
        (int first, int end) = (flight.First, flight.End);
        while (flight.Count > LeastPoints)
        {
            Vector3d[] misses = equations.Misses(fit.At, flight, flight.Values);
            double before = misses[0].LengthSquared;
            double after = misses[misses.Length - 1].LengthSquared;
            double others = ((flight.Count * flight.Rms * flight.Rms) - Math.Max(before, after)) / (flight.Count - 1);
            bool isFirst = before > after;
            double most = Math.Max(MatchFit.LawError * MatchFit.LawError, Math.Max(Far * Far * 3 * equations.Noise * equations.Noise, FarShare * FarShare * others));
            if (Math.Max(before, after) < most || (isFirst ? flight.First - first : end - flight.End) == MostPoints)
            {
                return;
            }

            if (isFirst)
            {
                BallState next = fit.At.LaunchAt(flight.Position, flight.Velocity, flight.Spin, 0);
                _log.Clear();
                fit.At.Advance(ref next, equations.Point(flight.First + 1).Time - equations.Point(flight.First).Time, _log);
                flight.First++;
                flight.Values = [next.Position.X, next.Position.Y, next.Position.Z, next.Velocity.X, next.Velocity.Y, next.Velocity.Z, next.Spin.X, next.Spin.Y, next.Spin.Z];
            }
            else
            {
                flight.End--;
            }

            _alone.Descend([flight], [1], watch);
        }
    }
}
