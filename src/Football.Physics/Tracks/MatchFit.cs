namespace Football.Physics;

/// <summary>Finds what a whole track of a match tells: its flights, impacts, touches and ground, with one wind, one ball and one surface for all of it.</summary>
/// <remarks>
/// The track is divided by dynamic programming, the flights found in it are fitted by least squares at once, each with its launch and spin, all with one wind and one drag
/// (Gauss and Newton, damped); impacts tell of the surface. A seam or a touch spoils its own piece alone. The same track gives the same numbers. Its memory is its own:
/// one a thread.
/// </remarks>
public sealed class MatchFit
{
    /// <summary>What the laws of flight do not know, m: gusts, how a ball wobbles, where a camera thinks that its centre is.</summary>
    private const double LawError = 0.01;

    /// <summary>A flight that fits worse than this, m, is tried from other spins of this size, rad/s.</summary>
    private const double Poor = 0.03;
    private const double OtherSpin = 90;

    /// <summary>Shorter flights tell of the others nothing, s.</summary>
    internal const double Told = 0.3;

    private readonly Scene _scene;

    /// <summary>Prepares for tracks of balls in a scene.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public MatchFit(Scene? scene = null)
    {
        _scene = scene ?? Scene.Default;
        _scene.Validate();
    }

    internal List<FlightPath> Flights(TrackPoint[] track, MatchFitRequest request, CancellationToken cancellation, out SharedFit fit, out TrackRuns runs, out FlightFinder finder)
    {
        runs = new TrackRuns(track);
        double deviation = Math.Sqrt((runs.Noise * runs.Noise) + (LawError * LawError));
        var system = new FlightEquations(runs.Points, deviation, request.SpinDeviation);
        finder = new FlightFinder(runs, _scene, system);
        List<FlightPath> flights = finder.Find(cancellation);
        TrackPoint[] points = runs.Points;
        List<FlightPath> Long(List<FlightPath> all) => all.FindAll(f => points[f.End - 1].Time - points[f.First].Time >= Told);
        List<FlightPath> told = Long(flights);
        double[] shares = SharedFit.Shares(told);
        fit = Best(system, new MatchModel(_scene, request), told, shares, cancellation);
        finder.JoinBy(fit, flights, cancellation);
        told = Long(flights);
        TryOtherSpins(fit, system, told, cancellation);
        shares = SharedFit.Shares(told);
        fit.Descend(told, shares, cancellation);
        fit.MeasureUncertainty(told, shares);
        return flights;
    }

    /// <summary>Flights that fit poorly are tried from other spins: a heavily spun ball and a hardly spun one slow down alike in different air.</summary>
    private static void TryOtherSpins(SharedFit fit, FlightEquations system, List<FlightPath> flights, CancellationToken cancellation)
    {
        var alone = new SharedFit(system, new MatchModel(fit.At.Scene, new MatchFitRequest { Wind = false, Drag = false }));
        foreach (FlightPath flight in flights)
        {
            if (flight.Rms < Poor)
            {
                continue;
            }

            Vector3d v = flight.Velocity;
            Vector3d across = Vector3d.Cross(Vector3d.Up, new Vector3d(v.X, 0, v.Z));
            across = across.Length > 0 ? across / across.Length : Vector3d.Zero;
            double[] best = flight.Values;
            double least = flight.Rms;
            double[] begin = flight.Values;
            for (int i = 0; i < 4; i++)
            {
                Vector3d spin = (i % 2 == 0 ? OtherSpin : -OtherSpin) * (i < 2 ? across : Vector3d.Up);
                double[] start = (double[])begin.Clone();
                (start[6], start[7], start[8]) = (spin.X, spin.Y, spin.Z);
                flight.Values = start;
                alone.Descend([flight], [1], cancellation);
                if (flight.Rms < least)
                {
                    least = flight.Rms;
                    best = (double[])flight.Values.Clone();
                }
            }

            flight.Values = best;
            system.Measure(fit.At, flight);
        }
    }

    /// <summary>The best of fits from several crises: with its drag crisis on either side of a flight's speeds a ball may slow down alike.</summary>
    private static SharedFit Best(FlightEquations system, MatchModel model, List<FlightPath> flights, double[] shares, CancellationToken cancellation)
    {
        SharedFit? best = null;
        var launches = new double[flights.Count][];
        for (int i = 0; i < flights.Count; i++)
        {
            launches[i] = flights[i].Values;
        }

        double[][]? found = null;
        foreach (double[] start in model.Starts)
        {
            for (int i = 0; i < flights.Count; i++)
            {
                flights[i].Values = (double[])launches[i].Clone();
            }

            var fit = new SharedFit(system, model, start);
            fit.Descend(flights, shares, cancellation);
            if (best is null || fit.Cost < best.Cost)
            {
                best = fit;
                found = flights.ConvertAll(f => f.Values).ToArray();
            }
        }

        for (int i = 0; i < flights.Count; i++)
        {
            flights[i].Values = found![i];
            system.Measure(best!.At, flights[i]);
        }

        return best!;
    }
}
