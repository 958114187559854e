using System.Globalization;

namespace FootballPhysics.Batch;

/// <summary>Many requests for kicks, as arrays of numbers; points are for the ball's centre. All with the low arc and targets at rest.</summary>
public sealed class BatchAims
{
    /// <summary>Makes room for requests; all zero until set.</summary>
    /// <param name="capacity">How many; not negative.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="capacity"/> is negative.</exception>
    public BatchAims(int capacity)
    {
        Check.AtLeast(nameof(capacity), capacity, 0);
        From = new Vector3dColumns(capacity);
        Target = new Vector3dColumns(capacity);
        Speed = new double[capacity];
        TopSpin = new double[capacity];
        SideSpin = new double[capacity];
    }

    /// <summary>How many there is room for.</summary>
    public int Capacity => Speed.Length;

    /// <summary>Where the balls are, m; components within ±1e6. A place in the ground is raised straight up out of it.</summary>
    public Vector3dColumns From { get; }

    /// <summary>Where they are to go, m; components within ±1e6.</summary>
    public Vector3dColumns Target { get; }

    /// <summary>Speeds of the kicks, m/s. Above 0, at most 1000.</summary>
    public double[] Speed { get; }

    /// <summary>Topspins, rad/s. Within ±10 000.</summary>
    public double[] TopSpin { get; }

    /// <summary>Sidespins, rad/s. Within ±10 000.</summary>
    public double[] SideSpin { get; }

    /// <summary>Lowest elevation, degrees. −90 … 90; default 0.</summary>
    public double MinimumElevationDegrees { get; init; }

    /// <summary>Highest elevation, degrees. At least the lowest, at most 90; default 45.</summary>
    public double MaximumElevationDegrees { get; init; } = 45;

    /// <summary>How close to the target is a hit, m. Above 0; default 0.01.</summary>
    public double Tolerance { get; init; } = 0.01;

    /// <summary>Sets a request.</summary>
    /// <param name="index">Which; 0 … <see cref="Capacity"/> − 1.</param>
    /// <param name="from">Where the ball is, m.</param>
    /// <param name="target">Where it is to go, m.</param>
    /// <param name="speed">Speed of the kick, m/s.</param>
    /// <param name="topSpin">Topspin, rad/s.</param>
    /// <param name="sideSpin">Sidespin, rad/s.</param>
    /// <exception cref="IndexOutOfRangeException"><paramref name="index"/> is out of range.</exception>
    public void Set(int index, Vector3d from, Vector3d target, double speed, double topSpin = 0, double sideSpin = 0)
    {
        From[index] = from;
        Target[index] = target;
        Speed[index] = speed;
        TopSpin[index] = topSpin;
        SideSpin[index] = sideSpin;
    }

    /// <summary>One of them for the single aimer.</summary>
    internal AimRequest Request(int index) => new()
    {
        From = From[index],
        Target = Target[index],
        Speed = Speed[index],
        TopSpin = TopSpin[index],
        SideSpin = SideSpin[index],
        MinimumElevationDegrees = MinimumElevationDegrees,
        MaximumElevationDegrees = MaximumElevationDegrees,
        Tolerance = Tolerance,
    };

    /// <summary>Checks a request.</summary>
    internal void Validate(int index)
    {
        double speed = Speed[index];
        Vector3d from = From[index];
        Vector3d target = Target[index];
        double size = Math.Abs(from.X) + Math.Abs(from.Y) + Math.Abs(from.Z) + Math.Abs(target.X) + Math.Abs(target.Y) + Math.Abs(target.Z);
        double spins = Math.Abs(TopSpin[index]) + Math.Abs(SideSpin[index]);
        if (speed > 0 && speed <= Limits.Speed && size <= Limits.Length && spins <= Limits.Spin)
        {
            return;
        }

        string at = string.Format(CultureInfo.InvariantCulture, "[{0}]", index);
        Check.Place("aim.from" + at, from);
        Check.Place("aim.target" + at, target);
        Check.Within("aim.speed" + at, speed, 0, Limits.Speed, exclusiveLow: true);
        Check.Within("aim.spin.top" + at, TopSpin[index], -Limits.Spin, Limits.Spin);
        Check.Within("aim.spin.side" + at, SideSpin[index], -Limits.Spin, Limits.Spin);
    }
}
