using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Queries;

/// <summary>Flights of random kicks, seen by fixed cameras at 50 Hz with a noise of one pixel, and how well fits of the pixels find them.</summary>
internal sealed class CameraCheck
{
    private const double Interval = 0.02;
    private const double Noise = 1;

    /// <summary>The deviation of a spin's component that a request has by default, rad/s.</summary>
    private const double SpinDeviation = 60;
    private const double Longest = 3;
    private const double Width = 1920;
    private const double Height = 1080;
    private const double FocalLength = 3000;

    private static readonly TrackCamera[] s_cameras =
    [
        TrackCamera.LookingAt(new Vector3d(60, 25, 0), new Vector3d(0, 2, 0), FocalLength, Width, Height),
        TrackCamera.LookingAt(new Vector3d(0, 25, 60), new Vector3d(0, 2, 0), FocalLength, Width, Height),
    ];

    private readonly TrackFit _fit = new(Scene.Measured);
    private readonly TrackCamera[] _cameras;
    private readonly double _longest;
    private readonly bool _fromGround;
    private double _squares;
    private long _points;

    /// <summary>Prepares.</summary>
    /// <param name="cameras">The number of cameras.</param>
    /// <param name="longest">The time for which a flight is seen, s.</param>
    /// <param name="fromGround">Whether the fit is told that the ball starts on the ground.</param>
    public CameraCheck(int cameras, bool fromGround, double longest = Longest)
    {
        _cameras = s_cameras[..cameras];
        _longest = longest;
        _fromGround = fromGround;
    }

    /// <summary>The results, flight by flight.</summary>
    public List<CameraFlight> Flights { get; } = [];

    /// <summary>The root mean square of the distances of all points, m.</summary>
    public double Rms => Math.Sqrt(_squares / _points);

    /// <summary>Draws a kick, sees it, fits it.</summary>
    public void Run(SeededRandom random)
    {
        // The kick begins on the ground before the centre of the image and is seen until it leaves the image.
        var simulator = new Simulator(Scene.Measured);
        Vector3d velocity = random.Velocity(14, 28, 8, 35);
        Vector3d spin = random.Uniform(0, 60) * random.Direction();
        var ahead = new Vector3d(velocity.X, 0, velocity.Z);
        Vector3d from = (-random.Uniform(6, 12) / ahead.Length * ahead) + new Vector3d(random.Uniform(-3, 3), 0.11, random.Uniform(-3, 3));
        BallState ball = simulator.Launch(from, velocity, spin);
        var log = new StepLog();
        List<PixelPoint> seen = [];
        List<Vector3d> truth = [];
        int last = 0;
        double noise = spin.LengthSquared / (SpinDeviation * SpinDeviation);
        for (int i = 0; i * Interval <= _longest; i++)
        {
            for (int camera = 0; camera < _cameras.Length; camera++)
            {
                if (_cameras[camera].TryProject(ball.Position, out double u, out double v) && u >= 0 && u <= Width && v >= 0 && v <= Height)
                {
                    var point = new PixelPoint(i * Interval, camera, Normal(random, u), Normal(random, v), Noise);
                    noise += (((point.U - u) * (point.U - u)) + ((point.V - v) * (point.V - v))) / (Noise * Noise);
                    seen.Add(point);
                    last = i;
                }
            }

            truth.Add(ball.Position);
            log.Clear();
            simulator.Run(ref ball, Interval, Interval, StopAt.Time, log);
        }

        TrackFitResult found = _fit.Find(_cameras, [.. seen], new TrackFitRequest { FromGround = _fromGround });
        Judge(found, [.. truth.Take(last + 1)], from, velocity, spin, noise);
    }

    private static double Normal(SeededRandom random, double mean) =>
        mean + (Noise * Math.Sqrt(-2 * Math.Log(1 - random.Next())) * Math.Cos(2 * Math.PI * random.Next()));

    private void Judge(TrackFitResult found, Vector3d[] truth, Vector3d from, Vector3d velocity, Vector3d spin, double cost)
    {
        var simulator = new Simulator(Scene.Measured);
        BallState ball = simulator.Launch(found.Position, found.Velocity, found.Spin);
        var log = new StepLog();
        double squares = 0;
        foreach (Vector3d place in truth)
        {
            squares += (place - ball.Position).LengthSquared;
            log.Clear();
            simulator.Run(ref ball, Interval, Interval, StopAt.Time, log);
        }

        _squares += squares;
        _points += truth.Length;
        Vector3d along = velocity / velocity.Length;
        Vector3d off = found.Spin - spin;
        double offAlong = Vector3d.Dot(in off, in along);
        double[] errors = [.. new[] { found.Position - from, found.Velocity - velocity, off }.SelectMany(v => new[] { v.X, v.Y, v.Z })];
        Flights.Add(new CameraFlight(
            Math.Sqrt(squares / truth.Length), off.Length, (off - (offAlong * along)).Length, offAlong, found.SpinAlongVelocityError, (found.Position - from).Length,
            found.DepthError ?? 0, found.Converged, found.Verdict, found.Unidentified,
            Enumerable.Range(0, 9).Count(i => found.IsIdentified(i) && Math.Abs(errors[i]) > 4 * found.StandardError(i)), found.Iterations,
            found.ChiSquared + (found.Spin.LengthSquared / (SpinDeviation * SpinDeviation)) - cost));
    }
}

/// <summary>A fit of a flight.</summary>
internal sealed record CameraFlight(
    double Rms, double Spin, double SpinAcross, double SpinAlong, double SpinAlongError, double Position, double DepthError, bool Converged, TrackVerdict Verdict, IReadOnlyList<string> Unidentified, int Wrong, int Steps, double Cost);
