using FootballPhysics.Tracks;

namespace FootballPhysics.Live;

/// <summary>A pixel of a camera.</summary>
internal readonly record struct Pixel(double U, double V);

/// <summary>A moment of the feed. Trackers do not have <paramref name="Truth"/> and <paramref name="Kicked"/>; the page draws them for comparison.</summary>
/// <param name="Time">The time, in s.</param>
/// <param name="Pixels">The pixel of each camera; null if the camera does not see the ball.</param>
/// <param name="Truth">The true ball.</param>
/// <param name="Kicked">The time of the last true kick, in s; −∞ before the first.</param>
internal sealed record Picture(double Time, Pixel?[] Pixels, BallState Truth, double Kicked);

/// <summary>Simulates two calibrated cameras that look at a ball, with noise, wrong pixels, occlusions, and kicks that nobody announces.</summary>
internal sealed class Feed(int seed)
{
    /// <summary>The time between two pictures, in s: 50 Hz.</summary>
    public const double Interval = 0.02;

    /// <summary>The standard deviation of a pixel coordinate.</summary>
    public const double Noise = 1;

    private const double Width = 1920;
    private const double Height = 1080;
    private const double Focus = 1500;

    /// <summary>The half size of the area in which players keep the ball, in m.</summary>
    private const double HalfLength = 15;
    private const double HalfWidth = 9;

    private const double WrongShare = 0.01;
    private const double WrongPixels = 150;

    /// <summary>Occlusions per second: of one camera, and of all at once.</summary>
    private const double HidesOne = 0.2;
    private const double HidesAll = 0.12;

    private readonly Random _random = new(seed);
    private readonly Simulator _simulator = new();
    private readonly StepLog _log = new();
    private readonly double[] _hiddenUntil = new double[Cameras.Count];
    private BallState _ball;
    private double _nextKick = 0.8;
    private double _kicked = double.NegativeInfinity;
    private int _pictures;

    public static IReadOnlyList<TrackCamera> Cameras { get; } =
    [
        TrackCamera.LookingAt(new Vector3d(-22, 12, 36), new Vector3d(0, 1, 0), Focus, Width, Height),
        TrackCamera.LookingAt(new Vector3d(22, 12, 36), new Vector3d(0, 1, 0), Focus, Width, Height),
    ];

    /// <summary>Takes the next picture.</summary>
    public Picture Next()
    {
        if (_pictures == 0)
        {
            _ball = _simulator.Launch(new Vector3d(-4, _simulator.ContactHeight, 2), Vector3d.Zero, Vector3d.Zero);
        }

        double time = _pictures++ * Interval;
        while (_nextKick <= time)
        {
            Run(_nextKick);
            Kick();
        }

        Run(time);
        bool isFar = Math.Abs(_ball.Position.X) > HalfLength || Math.Abs(_ball.Position.Z) > HalfWidth;
        if (isFar && time - _kicked > 0.5)
        {
            // A player at the edge of the area returns the ball.
            _nextKick = Math.Min(_nextKick, time + Between(0, Interval));
        }

        Hide(time);
        var pixels = new Pixel?[Cameras.Count];
        for (int i = 0; i < pixels.Length; i++)
        {
            pixels[i] = See(i, time);
        }

        return new Picture(time, pixels, _ball, _kicked);
    }

    private void Run(double time)
    {
        if (time > _ball.Time)
        {
            _log.Clear();
            _simulator.Run(ref _ball, Interval, time - _ball.Time, StopAt.Time, _log);
        }
    }

    /// <summary>Kicks the ball to a random position of the area.</summary>
    private void Kick()
    {
        Vector3d to;
        do
        {
            to = new Vector3d(Between(-HalfLength, HalfLength), 0, Between(-HalfWidth, HalfWidth));
        }
        while ((to - _ball.Position).Horizontal.Length < HalfWidth);

        Vector3d way = (to - _ball.Position).Horizontal;
        double elevation = Between(4, 38) * Math.PI / 180;
        double speed = Math.Clamp(Between(0.9, 1.2) * Math.Sqrt(9.81 * way.Length / Math.Sin(2 * elevation)), 7, 24);
        (double up, double along) = Math.SinCos(elevation);
        var spin = new Vector3d(Between(-30, 30), Between(-40, 40), Between(-30, 30));
        _simulator.Kick(ref _ball, (speed * along / way.Length * way) + (speed * up * Vector3d.Up), spin);
        _kicked = _nextKick;
        _nextKick += Between(1, 3.5);
    }

    private void Hide(double time)
    {
        bool hidesAll = _random.NextDouble() < HidesAll * Interval;
        double until = time + Between(0.2, 0.5);
        for (int i = 0; i < _hiddenUntil.Length; i++)
        {
            bool hides = _random.NextDouble() < HidesOne * Interval;
            _hiddenUntil[i] = hides || hidesAll ? Math.Max(_hiddenUntil[i], until) : _hiddenUntil[i];
        }
    }

    private Pixel? See(int camera, double time)
    {
        double error = _random.NextDouble() < WrongShare ? WrongPixels : Noise;
        (double right, double down) = (error * Normal(), error * Normal());
        bool isSeen = Cameras[camera].TryProject(_ball.Position, out double u, out double v) && u is >= 0 and < Width && v is >= 0 and < Height;
        return isSeen && time >= _hiddenUntil[camera] ? new Pixel(u + right, v + down) : null;
    }

    private double Between(double low, double high) => low + ((high - low) * _random.NextDouble());

    private double Normal() => Math.Sqrt(-2 * Math.Log(1 - _random.NextDouble())) * Math.Cos(2 * Math.PI * _random.NextDouble());
}
