using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>Estimates the launch of a ball and, on request, scene parameters, from tracked positions.</summary>
/// <remarks>
/// Least squares by the Gauss–Newton method, damped (Levenberg–Marquardt) if a step does not help. The derivatives are secants as wide as the uncertainty,
/// because paths have kinks where a ball only just stops slipping, or only just bounces once more. The uncertainty is measured by moving along each axis until
/// the cost has risen, so it is valid even if the cost is not quadratic. For example, the product of spin and lift may be accurate although neither factor is.
/// Not thread-safe: create one per thread.
/// </remarks>
public sealed class TrackFit
{
    /// <summary>The ratio of χ² to its expectation above which a fit is poor.</summary>
    private const double Poor = 1.2;

    /// <summary>The size of the spins from which a poor fit, or one with bounces, is repeated, in rad/s, and the number of these if it bounces:
    /// another bounce may fit as well.</summary>
    private const double OtherSpin = 35;
    private const int TriedIfBouncing = 3;

    /// <summary>The excess of the cost up to which a minimum is an alternative result: three standard deviations of one parameter.</summary>
    private const double AsGood = 9;

    /// <summary>The distance below which two minima are the same, in standard deviations of the spin.</summary>
    private const double Apart = 3;

    /// <summary>The usual number of simulated paths in a part of the fit.</summary>
    private const double Checks = 300;

    /// <summary>From one viewpoint, the scale of the prior of the launch's height, in m: balls are played by feet, heads and hands.</summary>
    private const double Reach = 1;

    /// <summary>
    /// The ratio of χ² below which a fit with reversed cameras is the better one. The ratio is low, because a few noisy pixels can fit a little
    /// better there.
    /// </summary>
    private const double FarBetter = 0.1;

    /// <summary>The maximum number of times that another depth replaces the result.</summary>
    private const int MostDepths = 4;

    private readonly Scene _scene;

    /// <summary>Creates a fit for tracks of balls in a scene.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public TrackFit(Scene? scene = null)
    {
        _scene = scene ?? Scene.Default;
        _scene.Validate();
    }

    /// <summary>Estimates the launch of a track.</summary>
    /// <param name="track">The observed positions, in order of time; at least four points. The launch is at the first point.</param>
    /// <param name="request">Additional parameters to estimate, and prior knowledge; default none.</param>
    /// <exception cref="ArgumentNullException"><paramref name="track"/>, or a ball of the request, is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public TrackFitResult Find(TrackPoint[] track, TrackFitRequest? request = null) => Find(track, request, null, default);

    /// <summary>Estimates the launch of a track, with progress and cancellation.</summary>
    /// <param name="track">The observed positions, in order of time; at least four points. The launch is at the first point.</param>
    /// <param name="request">Additional parameters to estimate, and prior knowledge; null for none.</param>
    /// <param name="progress">Receives the progress, 0 … 1, once per simulated path, in the calling thread. It may cancel the fit. Null for none.</param>
    /// <param name="cancellation">Cancels the fit; checked after each report.</param>
    /// <exception cref="ArgumentNullException"><paramref name="track"/>, or a ball of the request, is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    /// <exception cref="OperationCanceledException">The fit was cancelled.</exception>
    public TrackFitResult Find(TrackPoint[] track, TrackFitRequest? request, IProgress<double>? progress, CancellationToken cancellation)
    {
        Check.Given(nameof(track), track);
        request ??= new TrackFitRequest();
        request.Validate();
        return Find(new PositionSightings(track), request, new FitWatch(progress, Checks, cancellation));
    }

    /// <summary>Estimates the launch of a ball from pixels of one or more cameras.</summary>
    /// <remarks>
    /// The residuals are distances in the image. One camera suffices if a bounce or a launch on the ground reveals the depth. Gravity alone hardly does: the lift of a
    /// spin resembles it. <see cref="TrackFitResult.Unidentified"/> lists what the pixels do not reveal.
    /// <para>From one viewpoint, a launch near the ground is assumed to be likelier: the prior of its height is a Cauchy distribution of scale 1 m. It hardly moves a
    /// launch that the pixels reveal, even at 10 m.</para>
    /// </remarks>
    /// <param name="cameras">The cameras, at least one.</param>
    /// <param name="track">The observed pixels, in order of time; at least five points. The launch is at the first point.</param>
    /// <param name="request">Additional parameters to estimate, and prior knowledge; default none.</param>
    /// <exception cref="ArgumentNullException">An argument, a camera, or a ball of the request is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">
    /// A number is out of range, or the ball is behind a camera; the message names the field, the value and the range.
    /// </exception>
    public TrackFitResult Find(TrackCamera[] cameras, PixelPoint[] track, TrackFitRequest? request = null) => Find(cameras, track, request, null, default);

    /// <summary>Estimates the launch of a ball from pixels of one or more cameras, with progress and cancellation.</summary>
    /// <param name="cameras">The cameras, at least one.</param>
    /// <param name="track">The observed pixels, in order of time; at least five points. The launch is at the first point.</param>
    /// <param name="request">Additional parameters to estimate, and prior knowledge; null for none.</param>
    /// <param name="progress">Receives the progress, 0 … 1, once per simulated path, in the calling thread. It may cancel the fit. Null for none.</param>
    /// <param name="cancellation">Cancels the fit; checked after each report.</param>
    /// <exception cref="ArgumentNullException">An argument, a camera, or a ball of the request is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">
    /// A number is out of range, or the ball is behind a camera; the message names the field, the value and the range.
    /// </exception>
    /// <exception cref="OperationCanceledException">The fit was cancelled.</exception>
    public TrackFitResult Find(TrackCamera[] cameras, PixelPoint[] track, TrackFitRequest? request, IProgress<double>? progress, CancellationToken cancellation)
    {
        Check.Given(nameof(cameras), cameras);
        Check.Given(nameof(track), track);
        request ??= new TrackFitRequest();
        request.Validate();
        var seen = new PixelSightings(cameras, track);
        return Find(seen, seen.IsOneView ? request with { HeightScale = Reach } : request, new FitWatch(progress, Checks, cancellation));
    }

    private TrackFitResult Find(Sightings seen, TrackFitRequest request, FitWatch watch)
    {
        // 1. Start from the first points; minimise over the launch, then over the factors too; repeat from other spins if the fit is poor or the ball
        // bounces. 2. Measure the uncertainty. 3. Fit the other balls of the request.
        watch.Start(0.4);
        TrackSearch best = Search(seen, request, watch, out double[] values, out TrackSearch? rival, out double[]? rivals, out int steps);
        watch.Start(0.7);
        bool converged = best.Measure(values);
        for (int i = 0; i < MostDepths && seen.IsOneView && converged && !IsDepthMeasured(seen, request, best, values, watch); i++)
        {
            best.Descend(values);
            converged = best.Measure(values);
        }

        double growth = converged ? Grow(seen, best, values) : 1;
        bool isAmbiguous = rival is not null && rivals is not null && rival.Cost - best.Cost < AsGood && AreApart(values, rivals, best.Covariance);
        if (isAmbiguous)
        {
            AddRival(best.Covariance, values, rivals!, rival!.Cost - best.Cost);
        }

        watch.Start(1);
        var result = new TrackFitResult(
            best.Model, values, best.Covariance, seen, best.ChiSquared(values), steps + best.Steps, converged)
        {
            Growth = growth,
            OtherSpin = isAmbiguous ? new Vector3d(rivals![6], rivals[7], rivals[8]) : null,
            ByBall = WithOtherBalls(seen, request, best.Cost, watch),
            PathDepthError = seen.FirstCamera is null ? null : PathDepth.Error(seen, request, best.Model, values, best.Covariance),
        };
        RefuseBehind(seen, request, result, watch);
        watch.Finish();
        return result;
    }

    /// <summary>Lets the covariance grow with a misfit that noise does not explain, by the rule of match fits.</summary>
    /// <returns>The factor of the deviations from the observations; 1 without a misfit.</returns>
    private static double Grow(Sightings seen, TrackSearch best, double[] values)
    {
        double variance = ResidualVariance.Of(best.Misses(values), seen.Rows / seen.Count, best.Model.Count, 1, out _);
        if (!(variance > 1) || !TrackFitResult.IsRare(best.ChiSquared(values), seen.Rows - best.Model.Count))
        {
            return 1;
        }

        // The observations have less weight, the prior P keeps its own: C' = (C⁻¹/v + (1 − 1/v) P)⁻¹.
        int n = best.Model.Count;
        double[] information = new double[n * n];
        Linear.Invert(best.Covariance, information, n);
        for (int i = 0; i < information.Length; i++)
        {
            double known = best.Model.KnownDeviation(i % n);
            information[i] = (information[i] / variance) + (i / n == i % n ? (1 - (1 / variance)) / (known * known) : 0);
        }

        Linear.Invert(information, best.Covariance, n);
        return Math.Sqrt(variance);
    }

    /// <summary>Measures the uncertainty of the depth.</summary>
    /// <returns>False if another depth fits better; the parameters are then those of that fit.</returns>
    private static bool IsDepthMeasured(Sightings seen, TrackFitRequest request, TrackSearch best, double[] values, FitWatch watch) =>
        DepthProfile.Widen(seen, request, best.Model, values, best.Cost, TrackFitResult.ErrorAlong(best.Covariance, values.Length, 0, seen.FirstCamera!.Forward), best.Covariance, watch);

    /// <summary>Throws if the fit is poor but becomes good with reversed cameras.</summary>
    private void RefuseBehind(Sightings seen, TrackFitRequest request, TrackFitResult result, FitWatch watch)
    {
        if (!result.IsPoor || seen.Opposite(request, _scene) is not { } opposite || opposite.Start(request, request.Spin, _scene, out _) is null)
        {
            return;
        }

        TrackSearch search = Search(opposite, request, watch, out double[] values, out _, out _, out _);
        double chiSquared = search.ChiSquared(values);
        if (chiSquared < FarBetter * result.ChiSquared && !new TrackFitResult(search.Model, values, search.Covariance, opposite, chiSquared, 0, true).IsPoor)
        {
            throw seen.Unseen(request, _scene);
        }
    }

    /// <summary>Searches from the start given by the first points, and from other spins if the fit is poor or the ball bounces.</summary>
    /// <returns>The best fit with its parameters and, if others were tried, the second best with its own.</returns>
    private TrackSearch Search(Sightings seen, TrackFitRequest request, FitWatch watch, out double[] values, out TrackSearch? rival, out double[]? rivals, out int steps)
    {
        TrackFitRequest launch = request with { Drag = false, Lift = false, Restitution = false, Friction = false };
        steps = 0;
        values = seen.Start(launch, launch.Spin, _scene, out _) ?? throw seen.Unseen(launch, _scene);
        TrackSearch best = Descend(seen, launch, request, watch, ref values, ref steps);
        bool bounces = Bounces(values, seen.Duration);
        rival = null;
        rivals = null;
        double expected = seen.Rows - best.Model.Count;
        int tried = 0;
        IEnumerable<double[]?> starts = seen.IsOneView ? OneViewStarts.Of(seen, launch, _scene, values, watch) : OtherSpins(values, launch).Select(spin => seen.Start(launch, in spin, _scene, out _));
        foreach (double[] start in starts.OfType<double[]>())
        {
            if (!seen.IsOneView && best.ChiSquared(values) <= Poor * expected && (!bounces || tried == TriedIfBouncing))
            {
                break;
            }

            tried++;
            double[] other = start;
            TrackSearch found = Descend(seen, launch, request, watch, ref other, ref steps);
            if (found.Cost < best.Cost)
            {
                (best, found) = (found, best);
                (values, other) = (other, values);
            }

            if (rival is null || found.Cost < rival.Cost)
            {
                (rival, rivals) = (found, other);
            }
        }

        return best;
    }

    /// <summary>Returns other initial spins: the spin found with reversed topspin, then strong topspin and backspin, then strong sidespin each
    /// way.</summary>
    internal static Vector3d[] OtherSpins(double[] values, TrackFitRequest request)
    {
        var found = new Vector3d(values[6], values[7], values[8]);
        Vector3d across = Vector3d.Cross(Vector3d.Up, new Vector3d(values[3], 0, values[5]));
        across = across.Length > 0 ? across / across.Length : Vector3d.Zero;
        return
        [
            found - (2.0 * Vector3d.Dot(in found, in across) * across),
            request.Spin + (OtherSpin * across),
            request.Spin - (OtherSpin * across),
            request.Spin + (OtherSpin * Vector3d.Up),
            request.Spin - (OtherSpin * Vector3d.Up),
        ];
    }

    /// <summary>Adds the other launch, by its probability p: C += p d dᵀ, with d its distance.</summary>
    private static void AddRival(double[] covariance, double[] values, double[] others, double excess)
    {
        double probability = 1 / (1 + Elementary.Exp(0.5 * Math.Max(0, excess)));
        for (int i = 0; i < values.Length; i++)
        {
            for (int j = 0; j < values.Length; j++)
            {
                covariance[(i * values.Length) + j] += probability * (others[i] - values[i]) * (others[j] - values[j]);
            }
        }
    }

    /// <summary>True if the spins of two results differ by more than their uncertainty.</summary>
    private static bool AreApart(double[] values, double[] others, double[] covariance)
    {
        int n = values.Length;
        for (int i = 6; i < 9; i++)
        {
            double off = values[i] - others[i];
            if (off * off > Apart * Apart * covariance[(i * n) + i])
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>True if the ball bounces within the time of the track.</summary>
    private bool Bounces(double[] values, double duration)
    {
        var simulator = new Simulator(_scene with { Bodies = null, EngineColliders = null });
        var log = new StepLog();
        BallState state = simulator.LaunchAt(
            new Vector3d(values[0], values[1], values[2]), new Vector3d(values[3], values[4], values[5]), new Vector3d(values[6], values[7], values[8]), 0);
        simulator.RunChecked(ref state, 0.02, duration, StopAt.Impact, log, null);
        return log.Events.Impacts > 0;
    }

    /// <summary>Fits the other balls, each from the start: the best parameters of a wrong ball may lie near another minimum of the right
    /// one.</summary>
    private List<TrackFitByBall> WithOtherBalls(Sightings seen, TrackFitRequest request, double cost, FitWatch watch)
    {
        var all = new List<TrackFitByBall>();
        foreach (BallProperties ball in request.OtherBalls)
        {
            TrackSearch other = new TrackFit(_scene with { Ball = ball }).Search(seen, request, watch, out double[] found, out _, out _, out _);
            all.Add(new TrackFitByBall(ball, found, other.ChiSquared(found), other.Cost - cost));
        }

        return all;
    }

    /// <summary>Minimises over the launch only, and then over the factors too.</summary>
    private TrackSearch Descend(Sightings seen, TrackFitRequest launch, TrackFitRequest request, FitWatch watch, ref double[] values, ref int steps)
    {
        var search = new TrackSearch(seen, launch, new TrackModel(_scene, launch), watch);
        search.Descend(values);
        if (request != launch)
        {
            steps += search.Steps;
            search = new TrackSearch(seen, request, new TrackModel(_scene, request), watch);
            double[] all = new double[search.Model.Count];
            all.AsSpan().Fill(1);
            Array.Copy(values, all, values.Length);
            values = all;
            search.Descend(values);
        }

        return search;
    }
}
