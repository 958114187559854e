using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>Many aiming requests, as arrays. All points refer to the ball's centre.</summary>
/// <remarks>All requests use the low arc and a target at rest.</remarks>
public sealed class BatchAims
{
    /// <summary>Creates a set of requests; all numbers are 0 until set.</summary>
    /// <param name="capacity">The number of requests; at least 0.</param>
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

    /// <summary>The number of requests.</summary>
    public int Capacity => Speed.Length;

    /// <summary>The positions of the balls, in m; components within ±1e6.</summary>
    /// <remarks>If the ball would overlap the ground there, the position is raised vertically onto it.</remarks>
    public Vector3dColumns From { get; }

    /// <summary>The targets, in m; components within ±1e6.</summary>
    public Vector3dColumns Target { get; }

    /// <summary>The speeds of the kicks, in m/s. Above 0, at most 1000.</summary>
    public double[] Speed { get; }

    /// <summary>The topspins, in rad/s; within ±10 000.</summary>
    public double[] TopSpin { get; }

    /// <summary>The sidespins, in rad/s; within ±10 000.</summary>
    public double[] SideSpin { get; }

    /// <summary>The lowest elevation, in degrees. −90 … 90; default 0.</summary>
    public double MinimumElevationDegrees { get; init; }

    /// <summary>The highest elevation, in degrees. At least the lowest, at most 90; default 45.</summary>
    public double MaximumElevationDegrees { get; init; } = 45;

    /// <summary>The maximum distance from the target for a hit, in m. Above 0; default 0.01.</summary>
    public double Tolerance { get; init; } = 0.01;

    /// <summary>Sets a request.</summary>
    /// <param name="index">The index, 0 … <see cref="Capacity"/> − 1.</param>
    /// <param name="from">The position of the ball, in m.</param>
    /// <param name="target">The target, in m.</param>
    /// <param name="speed">The speed of the kick, in m/s.</param>
    /// <param name="topSpin">The topspin, in rad/s.</param>
    /// <param name="sideSpin">The sidespin, in rad/s.</param>
    /// <exception cref="IndexOutOfRangeException"><paramref name="index"/> is out of range.</exception>
    public void Set(int index, Vector3d from, Vector3d target, double speed, double topSpin = 0, double sideSpin = 0)
    {
        From[index] = from;
        Target[index] = target;
        Speed[index] = speed;
        TopSpin[index] = topSpin;
        SideSpin[index] = sideSpin;
    }

    /// <summary>Returns one request for the single aimer.</summary>
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

        Check.Place(Check.Item("aim.from", index), from);
        Check.Place(Check.Item("aim.target", index), target);
        Check.Within(Check.Item("aim.speed", index), speed, 0, Limits.Speed, exclusiveLow: true);
        Check.Within(Check.Item("aim.spin.top", index), TopSpin[index], -Limits.Spin, Limits.Spin);
        Check.Within(Check.Item("aim.spin.side", index), SideSpin[index], -Limits.Spin, Limits.Spin);
    }
}
