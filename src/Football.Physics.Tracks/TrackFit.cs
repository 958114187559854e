using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

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
    /// <summary>The time span of the points that determine the initial velocity, in s.</summary>
    private const double Beginning = 0.25;

    /// <summary>The ratio of χ² to its expectation above which a fit is poor.</summary>
    private const double Poor = 1.2;

    /// <summary>The spins from which a poor fit, or one with bounces, is repeated, in rad/s, and their number; another bounce may fit as
    /// well.</summary>
    private const double OtherSpin = 35;
    private const int OtherStarts = 5;

    /// <summary>The excess of the cost up to which a minimum is an alternative result: three standard deviations of one parameter.</summary>
    private const double AsGood = 9;

    /// <summary>The distance below which two minima are the same, in standard deviations of the spin.</summary>
    private const double Apart = 3;

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
    public TrackFitResult Find(TrackPoint[] track, TrackFitRequest? request = null)
    {
        // 1. Start from the first points; minimise over the launch, then over the factors too; repeat from other spins if the fit is poor or the ball
        // bounces. 2. Measure the uncertainty. 3. Fit the other balls of the request.
        request ??= new TrackFitRequest();
        Validate(track, request);
        TrackSearch best = Search(track, request, out double[] values, out TrackSearch? rival, out double[]? rivals, out int steps);
        bool converged = best.Measure(values);
        return new TrackFitResult(
            best.Model, values, best.Covariance, track[0].Time, best.ChiSquared(values), FreedomOf(track, best), steps + best.Steps, converged)
        {
            OtherSpin = rival is not null && rivals is not null && rival.Cost - best.Cost < AsGood && AreApart(values, rivals, best.Covariance)
                ? new Vector3d(rivals[6], rivals[7], rivals[8])
                : null,
            ByBall = WithOtherBalls(track, request, best.Cost),
        };
    }

    private static int FreedomOf(TrackPoint[] track, TrackSearch search) => (3 * track.Length) - search.Model.Count;

    /// <summary>Searches from the start that the first points give, and from other spins if the fit is poor or the ball bounces.</summary>
    /// <returns>The best fit with its parameters and, if others were tried, the second best with its own.</returns>
    private TrackSearch Search(TrackPoint[] track, TrackFitRequest request, out double[] values, out TrackSearch? rival, out double[]? rivals, out int steps)
    {
        TrackFitRequest launch = request with { Drag = false, Lift = false, Restitution = false, Friction = false };
        steps = 0;
        values = Start(track, launch);
        TrackSearch best = Descend(track, launch, request, ref values, ref steps);
        int freedom = FreedomOf(track, best);
        Vector3d across = Vector3d.Cross(Vector3d.Up, new Vector3d(values[3], 0, values[5]));
        across = across.Length > 0 ? across / across.Length : Vector3d.Zero;
        bool bounces = Bounces(values, track[track.Length - 1].Time - track[0].Time);
        rival = null;
        rivals = null;
        for (int i = 0; i < OtherStarts && (best.ChiSquared(values) > Poor * freedom || (bounces && i < 3)); i++)
        {
            double[] other = Start(track, launch);
            Vector3d spin = OtherSpinOf(i, values, request, across);
            (other[6], other[7], other[8]) = (spin.X, spin.Y, spin.Z);
            TrackSearch found = Descend(track, launch, request, ref other, ref steps);
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

    /// <summary>Returns another initial spin: the spin found with reversed topspin, then strong topspin and backspin, then strong sidespin each
    /// way.</summary>
    private static Vector3d OtherSpinOf(int i, double[] values, TrackFitRequest request, in Vector3d across)
    {
        var found = new Vector3d(values[6], values[7], values[8]);
        return i switch
        {
            0 => found - (2.0 * Vector3d.Dot(in found, in across) * across),
            1 => request.Spin + (OtherSpin * across),
            2 => request.Spin - (OtherSpin * across),
            3 => request.Spin + (OtherSpin * Vector3d.Up),
            _ => request.Spin - (OtherSpin * Vector3d.Up),
        };
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
    private List<TrackFitByBall> WithOtherBalls(TrackPoint[] track, TrackFitRequest request, double cost)
    {
        var all = new List<TrackFitByBall>();
        foreach (BallProperties ball in request.OtherBalls)
        {
            TrackSearch other = new TrackFit(_scene with { Ball = ball }).Search(track, request, out double[] found, out _, out _, out _);
            all.Add(new TrackFitByBall(ball, found, other.ChiSquared(found), other.Cost - cost));
        }

        return all;
    }

    /// <summary>Minimises over the launch only, and then over the factors too.</summary>
    private TrackSearch Descend(TrackPoint[] track, TrackFitRequest launch, TrackFitRequest request, ref double[] values, ref int steps)
    {
        var search = new TrackSearch(track, launch, new TrackModel(_scene, launch));
        search.Descend(values);
        if (request != launch)
        {
            steps += search.Steps;
            search = new TrackSearch(track, request, new TrackModel(_scene, request));
            double[] all = new double[search.Model.Count];
            all.AsSpan().Fill(1);
            Array.Copy(values, all, values.Length);
            values = all;
            search.Descend(values);
        }

        return search;
    }

    private static void Validate(TrackPoint[] track, TrackFitRequest request)
    {
        Check.Given(nameof(track), track);
        request.Validate();
        Check.AtLeast("track's points", track.Length, 4);
        for (int i = 0; i < track.Length; i++)
        {
            string at = Check.Item("track", i);
            Check.Within(at + ".time", track[i].Time, i > 0 ? track[i - 1].Time : -Limits.Time, Limits.Time);
            Check.Place(at + ".position", track[i].Position);
            Check.Positive(at + ".noise", track[i].Noise);
        }

        Check.Within("track's last time", track[track.Length - 1].Time - track[0].Time, 0, 600, exclusiveLow: true);
    }

    /// <summary>Returns the initial values: v = Σ t (p − p₀ + ½ g t² ŷ)/Σ t² over the first points.</summary>
    private double[] Start(TrackPoint[] track, TrackFitRequest request)
    {
        double[] values = new double[TrackModel.Launch];
        Vector3d first = track[0].Position;
        Vector3d sum = Vector3d.Zero;
        double squares = 0;
        double upward = Weight.UpwardAcceleration(_scene);
        for (int i = 1; i < track.Length && (i < 4 || track[i].Time - track[0].Time <= Beginning); i++)
        {
            double t = track[i].Time - track[0].Time;
            sum += t * (track[i].Position - first - new Vector3d(0, 0.5 * upward * t * t, 0));
            squares += t * t;
        }

        Vector3d velocity = request.Velocity ?? (squares > 0 ? sum / squares : Vector3d.Zero);
        Vector3d spin = request.Spin;
        (values[0], values[1], values[2]) = (first.X, first.Y, first.Z);
        (values[3], values[4], values[5]) = (velocity.X, velocity.Y, velocity.Z);
        (values[6], values[7], values[8]) = (spin.X, spin.Y, spin.Z);
        return values;
    }
}
