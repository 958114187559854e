using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Queries;

/// <summary>Flights of random kicks, seen by fixed cameras at 50 Hz with a noise of one pixel, and how well fits of the pixels find them.</summary>
internal sealed class CameraCheck
{
    private const double Interval = 0.02;
    private const double Noise = 1;

    /// <summary>The largest spin that is drawn, and the deviation of its components, which the fits are told, rad/s.</summary>
    private const double MostSpin = 60;
    private const double SpinDeviation = 20;
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

    /// <summary>Draws a kick, sees it, fits it.</summary>
    public void Run(SeededRandom random)
    {
        // The kick begins on the ground before the centre of the image and is seen until it leaves the image.
        var simulator = new Simulator(Scene.Measured);
        Vector3d velocity = random.Velocity(14, 28, 8, 35);
        Vector3d spin = random.Uniform(0, MostSpin) * random.Direction();
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

        TrackFitResult found = _fit.Find(_cameras, [.. seen], new TrackFitRequest { FromGround = _fromGround, SpinDeviation = SpinDeviation });
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

        double[] errors = [.. new[] { found.Position - from, found.Velocity - velocity, found.Spin - spin }.SelectMany(v => new[] { v.X, v.Y, v.Z })];
        Flights.Add(new CameraFlight(
            squares, truth.Length, (found.Spin - spin).Length, found.Verdict, found.Unidentified,
            Enumerable.Range(0, errors.Length).Count(i => found.IsIdentified(i) && Math.Abs(errors[i]) > 4 * found.StandardError(i)),
            found.ChiSquared + (found.Spin.LengthSquared / (SpinDeviation * SpinDeviation)) - cost));
    }
}

/// <summary>A fit of a flight.</summary>
/// <param name="Squares">The sum of the squared distances between fitted and true path, m².</param>
/// <param name="Points">The number of distances.</param>
/// <param name="Spin">The error of the spin, rad/s.</param>
/// <param name="Verdict">The fit's verdict.</param>
/// <param name="Unidentified">The quantities that it does not give as results.</param>
/// <param name="Wrong">The number of given results that are off by more than four standard errors.</param>
/// <param name="Excess">The cost above that of the true launch; negative for a minimum that is as good.</param>
internal sealed record CameraFlight(double Squares, int Points, double Spin, TrackVerdict Verdict, IReadOnlyList<string> Unidentified, int Wrong, double Excess)
{
    /// <summary>Whether the fit gives a depth, and finds nothing wrong with itself.</summary>
    public bool IsGood => Verdict is TrackVerdict.AsExpected or TrackVerdict.NoiseOverestimated && !Unidentified.Contains("position.depth");

    /// <summary>The root mean square of the distances of some flights, m.</summary>
    public static double Rms(IEnumerable<CameraFlight> flights) => Math.Sqrt(flights.Sum(flight => flight.Squares) / Math.Max(1, flights.Sum(flight => flight.Points)));
}
