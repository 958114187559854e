using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>Fits a complete match track: flights, impacts, touches and ground, with a common wind, ball and surface.</summary>
/// <remarks>
/// Dynamic programming divides the track into pieces. All flights found in it are fitted simultaneously by least squares (damped Gauss–Newton). Each flight has
/// its own launch and spin; wind and drag are common. The impacts determine the surface. A track error or a touch affects only its own piece. The
/// result is deterministic. Not thread-safe: create one per thread.
/// </remarks>
public sealed class MatchFit
{
    /// <summary>The model error of the flight laws, in m: gusts, wobble, and the tracker's estimate of the ball's centre.</summary>
    internal const double LawError = 0.01;

    /// <summary>The minimum duration of a flight from which the shared parameters are estimated, in s.</summary>
    private const double ShortestUsed = 0.3;

    /// <summary>The height above the ground at which a point should belong to a flight, in m.</summary>
    private const double High = 0.5;

    /// <summary>The usual number of checks for a cancellation in a part of the fit, per point of the track.</summary>
    private const double ChecksPerPoint = 3;

    /// <summary>The minimum number of flights from which the shape of the drag curve is estimated.</summary>
    private const int LeastForLaw = 4;

    /// <summary>The gain, in squared standard deviations and as a share of the cost, above which the shape of the drag curve is not the ball's.</summary>
    private const double LawGain = 10;
    private const double LawShare = 0.04;

    /// <summary>The share of the flights with a misfit below which the drag curve of the ball holds.</summary>
    private const double MisfitShare = 0.15;

    private static readonly MatchFitRequest Nothing = new() { Wind = false, Drag = false };

    private readonly Scene _scene;

    /// <summary>Creates a fit for tracks of balls in a scene.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public MatchFit(Scene? scene = null)
    {
        _scene = scene ?? Scene.Default;
        _scene.Validate();
    }

    /// <summary>Fits a track.</summary>
    /// <param name="track">The observed positions, in order of time; at least eight points. The noise of a point is a minimum; the actual noise is
    /// estimated from the track.</param>
    /// <param name="request">The parameters to estimate; default: wind, drag, surface and height.</param>
    /// <param name="progress">Receives the progress, 0 … 1, at least once per flight and search step, in the calling thread. It may cancel the fit.</param>
    /// <param name="cancellation">Cancels the fit; checked after each report.</param>
    /// <exception cref="ArgumentNullException"><paramref name="track"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    /// <exception cref="OperationCanceledException">The fit was cancelled.</exception>
    public MatchFitResult Find(TrackPoint[] track, MatchFitRequest? request = null, IProgress<double>? progress = null, CancellationToken cancellation = default)
    {
        // 1. Remove spikes, and split at gaps. 2. Find the flights. 3. Fit one wind and one ball. 4. Join neighbours that are one flight of that
        // ball, and fit again. 5. Find the ground height, and the events between flights. 6. Estimate the surface from impacts, slides and rolls.
        request ??= new MatchFitRequest();
        Validate(track, request);
        var watch = new FitWatch(progress, ChecksPerPoint * track.Length, cancellation);
        watch.Start(0.4);
        var runs = new TrackRuns(track);
        var equations = new FlightEquations(runs.Points, runs.Noise, Math.Sqrt((runs.Noise * runs.Noise) + (LawError * LawError)), request.SpinDeviation);
        var finder = new FlightFinder(runs, _scene, equations);
        List<FlightPath> flights = finder.Find(watch);
        watch.Start(0.7);

        List<FlightPath> used = LongFlights(runs, flights);
        var model = new MatchModel(_scene, request);
        double[][] begin = [.. used.Select(flight => (double[])flight.Values.Clone())];
        SharedFit fit = Best(equations, model, used, SharedFit.Shares(used), watch);
        fit = WithLaw(equations, request, model, fit, begin, used, watch);
        watch.Start(0.95);
        finder.JoinBy(fit, flights, watch);
        flights.ForEach(new FlightEnds(equations, fit, watch).Trim);
        used = LongFlights(runs, flights);
        var alone = new SharedFit(equations, new MatchModel(fit.At.Scene, Nothing));
        var tried = new SpinProfile(equations, fit);
        used.ForEach(flight => tried.Search(flight, other => alone.Descend([other], [1], watch)));
        double[] shares = SharedFit.Shares(used);
        fit.Descend(used, shares, watch);
        List<FlightPath> brief = flights.FindAll(f => !used.Contains(f));
        FitShort(fit, equations, brief, watch);
        fit.MeasureUncertainty(used, shares, watch);
        double contact = Contact(request, runs, finder, flights, fit, out double heightDeviation);
        equations.Contact = contact;
        double doubt = MatchDoubts.OfSpin(fit, model);
        var profile = new SpinProfile(equations, fit);
        flights.ForEach(profile.Widen);
        new MatchPieces(runs, equations, fit.At, contact).SetPriorSpins(flights, request.SpinDeviation, doubt, flight =>
        {
            FitShort(fit, equations, [flight], watch);
            profile.Widen(flight);
        });
        fit.Descend(used, shares, watch);
        fit.MeasureUncertainty(used, shares, watch);
        FitShort(fit, equations, brief, watch);
        watch.Start(1);
        var doubts = new MatchDoubts(_scene, request, equations, runs.Points, used, shares);
        doubts.Test(fit, watch);
        doubts.Widen(brief);
        flights.ForEach(new SpinProfile(equations, doubts.Doubted ?? fit).Widen);
        MatchFitResult result = Result(request, runs, equations, finder, flights, used, model, fit, contact, heightDeviation);
        result.Verdict = new MatchVerdict(result, doubts, runs);
        watch.Finish();
        return result;
    }

    private static void Validate(TrackPoint[] track, MatchFitRequest request)
    {
        Check.Given(nameof(track), track);
        request.Validate();
        TrackPoint.Validate(track, 8, Check.NotNegative);
        Check.Within("track's last time", track[track.Length - 1].Time, track[0].Time, Limits.Time, exclusiveLow: true);
    }

    /// <summary>Returns the flights that are long enough to estimate the shared parameters.</summary>
    private static List<FlightPath> LongFlights(TrackRuns runs, List<FlightPath> flights) =>
        flights.FindAll(f => runs.Points[f.End - 1].Time - runs.Points[f.First].Time >= ShortestUsed);

    /// <summary>Fits short flights with the ball and wind from the other flights.</summary>
    private void FitShort(SharedFit fit, FlightEquations equations, List<FlightPath> flights, FitWatch watch)
    {
        var alone = new SharedFit(equations, new MatchModel(fit.At.Scene, Nothing));
        foreach (FlightPath flight in flights)
        {
            alone.Descend([flight], [1], watch);
            alone.MeasureUncertainty([flight], [1], watch);
        }
    }

    /// <summary>Returns the height of the ball's centre on the ground: from the track if requested and possible, otherwise from the scene.</summary>
    private double Contact(MatchFitRequest request, TrackRuns runs, FlightFinder finder, List<FlightPath> flights, SharedFit fit, out double deviation)
    {
        deviation = double.PositiveInfinity;
        return request.Height && GroundHeight.Find(MatchPieces.GroundHeights(runs, finder.Ends, flights, fit.At), out double height, out deviation)
            ? height
            : (_scene.Ground.IsNone ? 0 : _scene.Ground.Height) + _scene.Ball.Radius;
    }

    /// <summary>Assembles the result: pieces, shared parameters, surface and statistics.</summary>
    private MatchFitResult Result(
        MatchFitRequest request, TrackRuns runs, FlightEquations equations, FlightFinder finder, List<FlightPath> flights, List<FlightPath> used, MatchModel model, SharedFit fit,
        double contact, double heightDeviation)
    {
        List<Estimate> estimates = [];
        for (int i = 0; i < model.Count; i++)
        {
            estimates.Add(new Estimate(model.Names[i], fit.Values[i], Math.Sqrt(Math.Max(0, fit.Covariance[(i * fit.Values.Length) + i]))));
        }

        double radius = _scene.Ball.Radius;
        if (request.Height && double.IsFinite(heightDeviation))
        {
            estimates.Add(new Estimate("groundHeight", contact - radius, heightDeviation));
        }

        List<MatchPiece> pieces = new MatchPieces(runs, equations, fit.At, contact).Make(finder.Ends, flights);
        Ground ground = (_scene.Ground.IsNone ? new Ground() : _scene.Ground) with { Height = contact - radius };
        int impacts = 0;
        List<GroundWindow> windows = [];
        double rollingSpeed = 0;
        double rollingDeviation = 0;
        if (request.Surface)
        {
            var surface = new SurfaceFit(_scene.Ball, ground, pieces);
            ground = surface.Ground;
            impacts = surface.Impacts;
            estimates.AddRange(surface.Estimates);
            windows = new GroundWindows(runs, fit.At, ground).Find(pieces);
            var friction = new GroundFriction(ground, windows);
            ground = friction.Ground;
            estimates.AddRange(friction.Estimates);
            (rollingSpeed, rollingDeviation) = (friction.RollingSpeed, friction.RollingDeviation);
        }

        double squares = 0;
        int points = 0;
        foreach (FlightPath flight in used)
        {
            squares += flight.Count * flight.Rms * flight.Rms;
            points += flight.Count;
        }

        Scene at = fit.At.Scene;
        return new MatchFitResult(pieces, [.. estimates], _scene with { Air = at.Air, Ball = at.Ball, Forces = at.Forces, Ground = ground })
        {
            Rms = points > 0 ? Math.Sqrt(squares / points) : 0,
            Flights = used.Count,
            Covered = Covered(runs.Points, used, contact - radius),
            Noise = runs.Noise,
            Impacts = impacts,
            Windows = windows,
            RollingSpeed = rollingSpeed,
            RollingDeviation = rollingDeviation,
        };
    }

    private static double Covered(TrackPoint[] track, List<FlightPath> used, double ground)
    {
        // The flights are in order of time and do not overlap.
        int high = 0;
        int covered = 0;
        int flight = 0;
        for (int i = 0; i < track.Length; i++)
        {
            while (flight < used.Count && used[flight].End <= i)
            {
                flight++;
            }

            if (track[i].Position.Y > ground + High)
            {
                high++;
                covered += flight < used.Count && used[flight].First <= i ? 1 : 0;
            }
        }

        return high > 0 ? (double)covered / high : 1;
    }

    /// <summary>
    /// Fits also the shape of the drag curve, from the fit without and from wide crises. Returns that fit if it is better by far more than the misfit of the
    /// flights explains; otherwise the fit without, because the shape makes all values less certain.
    /// </summary>
    private SharedFit WithLaw(FlightEquations equations, MatchFitRequest request, MatchModel model, SharedFit rigid, double[][] begin, List<FlightPath> flights, FitWatch watch)
    {
        var flexible = new MatchModel(_scene, request, law: true);
        if (flexible.Count == model.Count || flights.Count < LeastForLaw || flights.Count(rigid.IsMisfit) < MisfitShare * flights.Count)
        {
            return rigid;
        }

        double[] inflations = [.. flights.Select(rigid.Inflation)];
        Array.Sort(inflations);
        double least = Math.Max(LawShare * rigid.Cost, LawGain * Math.Max(1, inflations[inflations.Length / 2]));
        double[] shares = SharedFit.Shares(flights);
        double[][] launches = [.. flights.Select(flight => (double[])flight.Values.Clone())];
        double[][] found = launches;
        SharedFit best = rigid;
        bool first = true;
        foreach (double[] start in flexible.LawStarts(rigid.Values))
        {
            for (int i = 0; i < flights.Count; i++)
            {
                flights[i].Values = (double[])(first ? launches : begin)[i].Clone();
            }

            first = false;
            var fit = new SharedFit(equations, flexible, start);
            fit.Descend(flights, shares, watch);
            if (fit.Cost < (best == rigid ? rigid.Cost - least : best.Cost))
            {
                best = fit;
                found = [.. flights.Select(flight => flight.Values)];
            }
        }

        for (int i = 0; i < flights.Count; i++)
        {
            flights[i].Values = found[i];
            equations.Measure(best.At, flights[i]);
        }

        return best;
    }

    /// <summary>Returns the best of several fits from different drag crises, because a crisis on either side of the speeds can slow a ball
    /// alike.</summary>
    private static SharedFit Best(FlightEquations equations, MatchModel model, List<FlightPath> flights, double[] shares, FitWatch watch)
    {
        SharedFit? best = null;
        double[][] launches = [.. flights.Select(flight => flight.Values)];
        double[][]? found = null;
        foreach (double[] start in model.Starts)
        {
            for (int i = 0; i < flights.Count; i++)
            {
                flights[i].Values = (double[])launches[i].Clone();
            }

            var fit = new SharedFit(equations, model, start);
            fit.Descend(flights, shares, watch);
            if (best is null || fit.Cost < best.Cost)
            {
                best = fit;
                found = [.. flights.Select(flight => flight.Values)];
            }
        }

        for (int i = 0; i < flights.Count; i++)
        {
            flights[i].Values = found![i];
            equations.Measure(best!.At, flights[i]);
        }

        return best!;
    }
}
