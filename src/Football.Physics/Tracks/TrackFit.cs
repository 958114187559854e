namespace Football.Physics;

/// <summary>Finds the launch of a ball, and on request what a scene's numbers really are, from where a camera saw it.</summary>
/// <remarks>
/// Least squares by the method of Gauss and Newton, with the derivatives by the launch through bounces and all, damped (Levenberg, Marquardt) where a step would not
/// help; last with secants as wide as the uncertainty, as paths have kinks where a ball just slips, or just hops once more. The uncertainty is measured by going out
/// to where the misses grow, so it holds where they do not grow with the square: a spin times a lift may be known well of which neither is. Its memory is its own:
/// one a thread.
/// </remarks>
public sealed class TrackFit
{
    private const int MostSteps = 25;

    /// <summary>The search by derivatives ends where a step is shorter than this share of the uncertainty.</summary>
    private const double Shortest = 0.01;

    /// <summary>That of the launch alone where factors are to be found too: it cannot fit well.</summary>
    private const double ShortestOfLaunch = 1.0;

    private const double FirstDamping = 1e-3;
    private const double LargestDamping = 1e9;

    /// <summary>The velocity to begin with is that of the points of so many seconds.</summary>
    private const double Beginning = 0.25;

    /// <summary>χ² by its expectation from which on a fit is poor; then it is tried from so many other spins, rad/s.</summary>
    private const double Poor = 1.2;
    private const int OtherStarts = 4;
    private const double OtherSpin = 35;

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
    /// <exception cref="ArgumentNullException"><paramref name="track"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public TrackFitResult Find(TrackPoint[] track, TrackFitRequest? request = null)
    {
        request ??= new TrackFitRequest();
        Validate(track, request);
        TrackFitRequest launch = request with { Drag = false, Lift = false, Restitution = false, Friction = false };
        var model = new TrackModel(_scene, request);
        int steps = 0;
        double[] values = Start(track, launch);
        TrackEquations best = Search(track, launch, request, model, ref values, ref steps);

        // A poor fit may be that of another bounce: from other spins.
        Vector3d across = Vector3d.Cross(Vector3d.Up, new Vector3d(values[3], 0, values[5]));
        across = across.Length > 0 ? across / across.Length : Vector3d.Zero;
        for (int i = 0; i < OtherStarts && best.ChiSquared > Poor * ((3 * track.Length) - values.Length); i++)
        {
            Vector3d spin = request.Spin + ((i % 2 == 0 ? OtherSpin : -OtherSpin) * (i < 2 ? across : Vector3d.Up));
            double[] other = Start(track, launch);
            (other[6], other[7], other[8]) = (spin.X, spin.Y, spin.Z);
            TrackEquations found = Search(track, launch, request, model, ref other, ref steps);
            if (found.Cost < best.Cost)
            {
                (best, values) = (found, other);
            }
        }

        var refinement = new TrackRefinement(new TrackPaths(track, request, model), model);
        bool converged = refinement.Run(values, best.Normal);
        double chiSquared = refinement.Cost - model.KnownCost(values);
        return new TrackFitResult(
            model, values, refinement.Covariance, track[0].Time, chiSquared, (3 * track.Length) - model.Count, steps + refinement.Steps, converged);
    }

    /// <summary>Goes downhill from a launch: with the launch alone, then with the factors too.</summary>
    private TrackEquations Search(TrackPoint[] track, TrackFitRequest launch, TrackFitRequest request, TrackModel model, ref double[] values, ref int steps)
    {
        if (request == launch)
        {
            return Search(track, launch, Shortest, values, ref steps);
        }

        Search(track, launch, ShortestOfLaunch, values, ref steps);
        double[] all = new double[model.Count];
        all.AsSpan().Fill(1);
        Array.Copy(values, all, values.Length);
        values = all;
        return Search(track, request, Shortest, values, ref steps);
    }

    /// <summary>Goes downhill from some numbers, to where a step would be shorter than a share of the uncertainty.</summary>
    private TrackEquations Search(TrackPoint[] track, TrackFitRequest request, double shortest, double[] values, ref int steps)
    {
        var model = new TrackModel(_scene, request);
        var paths = new TrackPaths(track, request, model);
        var equations = new TrackEquations(track, request, model, paths);
        equations.Evaluate(values);
        double[] step = new double[model.Count];
        double[] tried = new double[model.Count];
        double[] misses = new double[paths.Rows];
        double damping = FirstDamping;
        bool converged = false;
        for (int i = 0; i < MostSteps && !converged && damping < LargestDamping; i++, steps++)
        {
            if (!equations.Solve(damping, step))
            {
                damping *= 10;
                continue;
            }

            for (int k = 0; k < step.Length; k++)
            {
                tried[k] = values[k] + step[k];
            }

            // Where rounding decides, there is nothing left to gain. Derivatives cost more than a flight, and are taken where it was better.
            converged = equations.Length(step) < shortest && damping < 1;
            if (TrackModel.IsLaunch(tried) && paths.Follow(tried, misses) <= equations.Cost)
            {
                Array.Copy(tried, values, tried.Length);
                equations.Evaluate(values);
                damping = Math.Max(1e-12, 0.1 * damping);
            }
            else
            {
                damping *= 10;
            }
        }

        return equations;
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
