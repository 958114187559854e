namespace FootballPhysics.Labs.Queries;

/// <summary>Fits flights of random kicks from pixels, seen by fixed cameras at 50 Hz with a noise of one pixel, and measures the errors.</summary>
/// <param name="cameras">The number of cameras.</param>
/// <param name="fromGround">True if the fit assumes that the ball starts on the ground.</param>
/// <param name="inPlay">The share of flights that begin in the air.</param>
/// <param name="longest">The longest time for which a flight is seen, s.</param>
internal sealed class CameraCheck(int cameras, bool fromGround, double inPlay = 0, double longest = CameraCheck.Longest)
{
    /// <summary>The longest time for which a flight is seen, s.</summary>
    public const double Longest = 3;

    private const double Interval = 0.02;
    private const double Noise = 1;

    /// <summary>The largest spin that is drawn, and the standard deviation of its components, which is the prior of the fits, rad/s.</summary>
    private const double MostSpin = 60;
    private const double SpinDeviation = 20;

    /// <summary>The standard deviation of the height of a launch on the ground, and the scale of the height of any other launch seen from one viewpoint, m: the prior of the fits.</summary>
    private const double Ground = 0.01;
    private const double Reach = 1;

    private const double Width = 1920;
    private const double Height = 1080;
    private const double FocalLength = 3000;

    private static readonly Vector3d[] s_places = [new(60, 25, 0), new(0, 25, 60)];
    private static readonly Vector3d s_target = new(0, 2, 0);
    private static readonly TrackCamera[] s_cameras = [.. s_places.Select(place => TrackCamera.LookingAt(place, s_target, FocalLength, Width, Height))];
    private static readonly Pinhole[] s_pinholes = [.. s_places.Select(place => new Pinhole(place, s_target, FocalLength))];

    private readonly TrackCamera[] _cameras = s_cameras[..cameras];
    private readonly double _contact = new Simulator(Scene.Measured).ContactHeight;

    /// <summary>Draws a kick, computes its pixels and fits them. Thread-safe.</summary>
    public CameraFlight Run(SeededRandom random)
    {
        // 1. The kick: before the centre of the image, with its first bounces. 2. The pixels, until the ball leaves the image. 3. The fit, the bound, the errors.
        double[] truth = Draw(random);
        int count = 1 + (int)(longest / Interval);
        Vector3d[] path = Path(truth, count, out _);
        List<PixelPoint> seen = [];
        List<(int, Pinhole)> pixels = [];
        double cost = Known(truth);
        int last = 0;
        for (int i = 0; i < count; i++)
        {
            for (int camera = 0; camera < _cameras.Length; camera++)
            {
                if (_cameras[camera].TryProject(path[i], out double u, out double v) && u >= 0 && u <= Width && v >= 0 && v <= Height)
                {
                    var point = new PixelPoint(i * Interval, camera, random.Normal(u, Noise), random.Normal(v, Noise), Noise);
                    cost += (((point.U - u) * (point.U - u)) + ((point.V - v) * (point.V - v))) / (Noise * Noise);
                    seen.Add(point);
                    pixels.Add((i, s_pinholes[camera]));
                    last = i;
                }
            }
        }

        path = Path(truth, last + 1, out bool bounces);
        TrackFitResult found = new TrackFit(Scene.Measured).Find(_cameras, [.. seen], new TrackFitRequest { FromGround = fromGround, SpinDeviation = SpinDeviation });
        double least = CameraBound.Squares(launch => Path(launch, last + 1, out _), truth, pixels, Noise, HeightVariance, SpinDeviation * SpinDeviation);
        return Judge(found, truth, path, bounces, least, cost);
    }

    /// <summary>The prior variance of the height; for a Cauchy distribution, the inverse of its information.</summary>
    private double HeightVariance => fromGround ? Ground * Ground : _cameras.Length == 1 ? 2 * Reach * Reach : double.PositiveInfinity;

    /// <summary>Draws a launch: position, velocity, spin. From the ground, or by foot, head or hand.</summary>
    private double[] Draw(SeededRandom random)
    {
        bool isInPlay = inPlay > 0 && random.Chance(inPlay);
        double height = isInPlay ? random.Uniform(0.3, 2.2) : 0.11;
        Vector3d velocity = isInPlay ? random.Velocity(10, 26, -5, 35) : random.Velocity(14, 28, 8, 35);
        Vector3d spin = random.Uniform(0, MostSpin) * random.Direction();
        var ahead = new Vector3d(velocity.X, 0, velocity.Z);
        Vector3d from = (-random.Uniform(6, 12) / ahead.Length * ahead) + new Vector3d(random.Uniform(-3, 3), height, random.Uniform(-3, 3));
        return [from.X, from.Y, from.Z, velocity.X, velocity.Y, velocity.Z, spin.X, spin.Y, spin.Z];
    }

    /// <summary>Returns the positions of a ball at the times of the images, and whether it bounces among them.</summary>
    private static Vector3d[] Path(double[] launch, int count, out bool bounces)
    {
        var simulator = new Simulator(Scene.Measured);
        BallState ball = simulator.Launch(
            new Vector3d(launch[0], launch[1], launch[2]), new Vector3d(launch[3], launch[4], launch[5]), new Vector3d(launch[6], launch[7], launch[8]));
        var log = new StepLog();
        var path = new Vector3d[count];
        bounces = false;
        for (int i = 0; i < count; i++)
        {
            path[i] = ball.Position;
            log.Clear();
            if (i + 1 < count)
            {
                simulator.Run(ref ball, Interval, Interval, StopAt.Time, log);
                bounces |= log.Events.Impacts > 0;
            }
        }

        return path;
    }

    /// <summary>Returns the cost of the prior.</summary>
    private double Known(double[] launch)
    {
        double off = launch[1] - _contact;
        double height = fromGround ? off * off / (Ground * Ground) : _cameras.Length == 1 ? 2 * Math.Log(1 + (off * off / (Reach * Reach))) : 0;
        return height + (((launch[6] * launch[6]) + (launch[7] * launch[7]) + (launch[8] * launch[8])) / (SpinDeviation * SpinDeviation));
    }

    private CameraFlight Judge(TrackFitResult found, double[] truth, Vector3d[] path, bool bounces, double least, double cost)
    {
        double[] launch = [.. Enumerable.Range(0, truth.Length).Select(found.Value)];
        double squares = Path(launch, path.Length, out _).Zip(path, (a, b) => (a - b).LengthSquared).Sum();
        return new CameraFlight(
            squares, least, path.Length, bounces, (found.Spin - new Vector3d(truth[6], truth[7], truth[8])).Length, found.Verdict, found.Unidentified,
            Enumerable.Range(0, truth.Length).Count(i => found.IsIdentified(i) && Math.Abs(launch[i] - truth[i]) > 4 * found.StandardError(i)),
            found.ChiSquared + Known(launch) - cost);
    }
}

/// <summary>The fit of a flight.</summary>
/// <param name="Squares">The sum of the squared distances between the fitted and the true path, m².</param>
/// <param name="Least">The least expected value of this sum, m²: <see cref="CameraBound"/>.</param>
/// <param name="Points">The number of distances.</param>
/// <param name="Bounces">True if the pixels include a bounce.</param>
/// <param name="Spin">The error of the spin, rad/s.</param>
/// <param name="Verdict">The fit's verdict.</param>
/// <param name="Unidentified">The quantities that the fit does not report as results.</param>
/// <param name="Wrong">The number of reported results that are off by more than four standard errors.</param>
/// <param name="Excess">The cost above the cost of the true launch; negative if the fit found a lower one.</param>
internal sealed record CameraFlight(
    double Squares, double Least, int Points, bool Bounces, double Spin, TrackVerdict Verdict, IReadOnlyList<string> Unidentified, int Wrong, double Excess)
{
    /// <summary>True if the fit reports the depth, both at the launch and along the path.</summary>
    public bool HasDepth => !Unidentified.Contains("position.depth") && !Unidentified.Contains("path.depth");

    /// <summary>True if the fit's verdict reports a problem.</summary>
    public bool IsDoubtful => Verdict is not (TrackVerdict.AsExpected or TrackVerdict.NoiseOverestimated);

    /// <summary>True if the fit reports the depth and its verdict reports no problem.</summary>
    public bool IsGood => HasDepth && !IsDoubtful;

    /// <summary>Returns the root mean square of the distances of some flights, m.</summary>
    public static double Rms(IEnumerable<CameraFlight> flights) => Root(flights, flight => flight.Squares);

    /// <summary>Returns the bound of this root mean square, m.</summary>
    public static double Bound(IEnumerable<CameraFlight> flights) => Root(flights, flight => flight.Least);

    private static double Root(IEnumerable<CameraFlight> flights, Func<CameraFlight, double> squares) =>
        Math.Sqrt(flights.Sum(squares) / Math.Max(1, flights.Sum(flight => flight.Points)));
}

/// <summary>The least variance that pixels allow: the Cramér–Rao bound at the true launch, with the fit's prior (van Trees).</summary>
/// <remarks>
/// It uses neither the fit nor the library's cameras: differences of simulated paths, its own pinhole, its own inversion. It ignores that no launch is
/// below the ground, and the prior of the launch is unbiased. So a fit may be below the bound.
/// </remarks>
internal static class CameraBound
{
    private const int Launch = 9;
    private const int Height = 1;
    private const int FirstSpin = 6;

    /// <summary>Half the widths of the differences, m, m/s, rad/s; and the height by which the launch is raised for them, m.</summary>
    private static readonly double[] s_steps = [1e-3, 5e-4, 1e-3, 1e-3, 1e-3, 1e-3, 1e-2, 1e-2, 1e-2];
    private const double Raised = 1e-3;

    /// <summary>Returns the sum of the variances of all positions of a path, m².</summary>
    /// <param name="path">Returns the path of a launch with this position, velocity and spin.</param>
    /// <param name="truth">The true launch.</param>
    /// <param name="seen">The index of a position and the pinhole that sees it, once per pixel.</param>
    /// <param name="noise">The standard deviation of a pixel.</param>
    /// <param name="heightVariance">The prior variance of the height.</param>
    /// <param name="spinVariance">The prior variance of each component of the spin.</param>
    public static double Squares(
        Func<double[], Vector3d[]> path, double[] truth, IEnumerable<(int Place, Pinhole Camera)> seen, double noise, double heightVariance, double spinVariance)
    {
        double[] from = [.. truth];
        from[Height] += Raised;
        Vector3d[] places = path(from);
        Vector3d[][] by = [.. s_steps.Select((step, j) => path(Moved(from, j, step)).Zip(path(Moved(from, j, -step)), (high, low) => (high - low) / (2 * step)).ToArray())];

        // The information: Σ ∇u ∇uᵀ + ∇v ∇vᵀ over the pixels, plus the prior.
        double[,] information = new double[Launch, Launch];
        information[Height, Height] = 1 / heightVariance;
        for (int i = FirstSpin; i < Launch; i++)
        {
            information[i, i] = 1 / spinVariance;
        }

        foreach ((int place, Pinhole camera) in seen)
        {
            (double U, double V)[] g = [.. by.Select(direction => camera.Change(places[place], direction[place]))];
            for (int i = 0; i < Launch; i++)
            {
                for (int j = 0; j < Launch; j++)
                {
                    information[i, j] += ((g[i].U * g[j].U) + (g[i].V * g[j].V)) / (noise * noise);
                }
            }
        }

        double[,] covariance = Inverse(information);
        double sum = 0;
        for (int k = 0; k < places.Length; k++)
        {
            for (int i = 0; i < Launch; i++)
            {
                for (int j = 0; j < Launch; j++)
                {
                    sum += covariance[i, j] * Vector3d.Dot(by[i][k], by[j][k]);
                }
            }
        }

        return sum;
    }

    private static double[] Moved(double[] from, int number, double by)
    {
        double[] moved = [.. from];
        moved[number] += by;
        return moved;
    }

    /// <summary>Returns the inverse by Gauss–Jordan elimination of the matrix scaled to a diagonal of 1.</summary>
    private static double[,] Inverse(double[,] matrix)
    {
        int n = matrix.GetLength(0);
        double[] scale = [.. Enumerable.Range(0, n).Select(i => 1 / Math.Sqrt(matrix[i, i]))];
        double[,] a = new double[n, 2 * n];
        for (int i = 0; i < n; i++)
        {
            for (int j = 0; j < n; j++)
            {
                a[i, j] = scale[i] * matrix[i, j] * scale[j];
            }

            a[i, n + i] = 1;
        }

        // The matrix is symmetric and positive definite, so no pivots are needed.
        for (int i = 0; i < n; i++)
        {
            double pivot = a[i, i];
            for (int k = 0; k < 2 * n; k++)
            {
                a[i, k] /= pivot;
            }

            for (int row = 0; row < n; row++)
            {
                double factor = row == i ? 0 : a[row, i];
                for (int k = 0; k < 2 * n && factor != 0; k++)
                {
                    a[row, k] -= factor * a[i, k];
                }
            }
        }

        double[,] inverse = new double[n, n];
        for (int i = 0; i < n * n; i++)
        {
            inverse[i / n, i % n] = a[i / n, n + (i % n)] * (scale[i / n] * scale[i % n]);
        }

        return inverse;
    }
}

/// <summary>A pinhole camera that points at a target, with a level horizon.</summary>
internal sealed class Pinhole
{
    private readonly Vector3d _position;
    private readonly Vector3d _ahead;
    private readonly Vector3d _right;
    private readonly Vector3d _down;
    private readonly double _focalLength;

    public Pinhole(in Vector3d position, in Vector3d target, double focalLength)
    {
        _position = position;
        _ahead = (target - position) / (target - position).Length;
        Vector3d right = Vector3d.Cross(_ahead, Vector3d.Up);
        _right = right / right.Length;
        _down = Vector3d.Cross(_ahead, _right);
        _focalLength = focalLength;
    }

    /// <summary>Returns the number of pixels by which a point moves in the image, per metre along a direction.</summary>
    public (double U, double V) Change(in Vector3d place, in Vector3d direction)
    {
        Vector3d from = place - _position;
        double depth = Vector3d.Dot(in from, in _ahead);
        Vector3d across = direction - (Vector3d.Dot(in direction, in _ahead) / depth * from);
        return (_focalLength / depth * Vector3d.Dot(in across, in _right), _focalLength / depth * Vector3d.Dot(in across, in _down));
    }
}
