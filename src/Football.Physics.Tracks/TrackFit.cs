namespace FootballPhysics.Tracks;

/// <summary>Finds the launch of a ball, and on request what a scene's numbers really are, from where a camera saw it.</summary>
/// <remarks>
/// Least squares by the method of Gauss and Newton, damped (Levenberg, Marquardt) where a step would not help, with secants as wide as the uncertainty for derivatives, as
/// paths have kinks where a ball just slips, or just hops once more. The uncertainty is measured by going out to where the misses grow, so it holds where they do not
/// grow with the square: a spin times a lift may be known well of which neither is. Its memory is its own: one a thread.
/// </remarks>
public sealed class TrackFit
{
    /// <summary>The velocity to begin with is that of the points of so many seconds.</summary>
    private const double Beginning = 0.25;

    /// <summary>χ² by its expectation from which on a fit is poor.</summary>
    private const double Poor = 1.2;

    /// <summary>Spins, rad/s, from which a poor fit is tried again, and one in which the ball bounces: another bounce may fit as well.</summary>
    private const double OtherSpin = 35;
    private const int OtherStarts = 5;

    /// <summary>Largest excess of the cost at which a minimum is another answer to the track: three deviations of one number.</summary>
    private const double AsGood = 9;

    /// <summary>Minima that are closer than this, in deviations of the spin, are one.</summary>
    private const double Apart = 3;

    private readonly Scene _scene;

    /// <summary>Prepares for tracks of balls in a scene.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public TrackFit(Scene? scene = null)
    {
        _scene = scene ?? Scene.Default;
        _scene.Validate();
    }

    /// <summary>Finds the launch that a track tells of.</summary>
    /// <param name="track">Where the ball was seen, in order of time; at least four points. The launch is at the first of them.</param>
    /// <param name="request">What to find beside the launch, and what is known before; default nothing.</param>
    /// <exception cref="ArgumentNullException"><paramref name="track"/> is null, or a ball of the request.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public TrackFitResult Find(TrackPoint[] track, TrackFitRequest? request = null)
    {
        // 1. A start by the first points; downhill for the launch, then for the factors too; from other spins where that fits poorly, or the ball bounces.
        // 2. The uncertainty, measured. 3. With other balls, where it may have been one.
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

    /// <summary>Searches from the start that the first points suggest, and from other spins where that fits poorly, or the ball bounces.</summary>
    /// <returns>The best, with its numbers; and the next best, with its, where others were tried.</returns>
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

    /// <summary>A spin to begin with again: that found with its topspin the other way, then much of it each way, then much about the vertical.</summary>
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

    /// <summary>True when two answers differ in the spin by more than their uncertainty.</summary>
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

    /// <summary>True when the ball bounces in the time of the track.</summary>
    private bool Bounces(double[] values, double duration)
    {
        var simulator = new Simulator(_scene with { Bodies = null, EngineColliders = null });
        var log = new StepLog();
        BallState state = simulator.LaunchAt(
            new Vector3d(values[0], values[1], values[2]), new Vector3d(values[3], values[4], values[5]), new Vector3d(values[6], values[7], values[8]), 0);
        simulator.RunChecked(ref state, 0.02, duration, StopAt.Impact, log, null);
        return log.Events.Impacts > 0;
    }

    /// <summary>Fits with other balls, each from the start: the numbers that fit a wrong ball best may lie in another valley of the right one.</summary>
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

    /// <summary>Goes downhill from a launch: with the launch alone, then with the factors too.</summary>
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

    /// <summary>Where to begin: v = Σ t (p − p₀ + ½ g t² ŷ)/Σ t² of the first points.</summary>
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
