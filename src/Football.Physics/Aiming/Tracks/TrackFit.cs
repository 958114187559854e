namespace Football.Physics;

/// <summary>Finds the launch of a ball, and on request what a scene's numbers really are, from where a camera saw it.</summary>
/// <remarks>
/// Least squares by the method of Gauss and Newton, with the derivatives by the launch through bounces and all, damped (Levenberg, Marquardt) where a step would not
/// help. Its memory is its own: one a thread.
/// </remarks>
public sealed class TrackFit
{
    private const int MostSteps = 60;

    /// <summary>The search ends where a step is shorter than this share of the uncertainty.</summary>
    private const double Shortest = 0.01;

    /// <summary>Change of a factor for a difference quotient.</summary>
    internal const double FactorWidth = 1e-3;

    private const double FirstDamping = 1e-3;
    private const double LargestDamping = 1e9;

    /// <summary>The velocity to begin with is that of the points of so many seconds.</summary>
    private const double Beginning = 0.25;

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
        var model = new TrackModel(_scene, request);
        int n = model.Count;
        double[] values = Start(track, request, n);
        var now = new TrackEquations(track, request, model);
        var next = new TrackEquations(track, request, model);
        now.Evaluate(values);
        double[] step = new double[n];
        double[] tried = new double[n];
        double damping = FirstDamping;
        bool converged = false;
        int steps = 0;
        for (; steps < MostSteps && !converged && damping < LargestDamping; steps++)
        {
            if (!now.Solve(damping, step))
            {
                damping *= 10;
                continue;
            }

            for (int i = 0; i < n; i++)
            {
                tried[i] = values[i] + step[i];
            }

            double length = now.Length(step);
            if (IsLaunch(tried) && next.Evaluate(tried) && next.Cost <= now.Cost)
            {
                converged = length < Shortest && damping < 1;
                Array.Copy(tried, values, n);
                (now, next) = (next, now);
                damping = Math.Max(1e-12, 0.1 * damping);
            }
            else
            {
                // Where rounding decides, there is nothing left to gain.
                converged = length < Shortest && damping < 1;
                damping *= 10;
            }
        }

        return new TrackFitResult(model.Names, values, now.Covariance(), track[0].Time, now.ChiSquared, (3 * track.Length) - n, steps, converged);
    }

    private static void Validate(TrackPoint[] track, TrackFitRequest request)
    {
        Check.Given(nameof(track), track);
        request.Validate();
        Check.AtLeast("track's points", track.Length, 4);
        for (int i = 0; i < track.Length; i++)
        {
            string at = FormattableString.Invariant($"track[{i}]");
            Check.Within(at + ".time", track[i].Time, i > 0 ? track[i - 1].Time : -Limits.Time, Limits.Time);
            Check.Place(at + ".position", track[i].Position);
            Check.Positive(at + ".noise", track[i].Noise);
        }

        Check.Within("track's last time", track[track.Length - 1].Time - track[0].Time, 0, 600, exclusiveLow: true);
    }

    /// <summary>Where to begin: v = Σ t (p − p₀ + ½ g t² ŷ)/Σ t² of the first points.</summary>
    private double[] Start(TrackPoint[] track, TrackFitRequest request, int n)
    {
        double[] values = new double[n];
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
        for (int i = TrackModel.Launch; i < n; i++)
        {
            values[i] = 1;
        }

        return values;
    }

    private static bool IsLaunch(double[] v) =>
        new Vector3d(v[0], v[1], v[2]).Length < Limits.Length && new Vector3d(v[3], v[4], v[5]).Length < Limits.Speed && new Vector3d(v[6], v[7], v[8]).Length < Limits.Spin;
}
