using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>The estimate of a <see cref="BallFilter"/> at the time of its last point.</summary>
/// <remarks>The filter has one such object, and each point changes it. The y axis points up, and units are SI.</remarks>
public sealed class BallEstimate
{
    /// <summary>The number of components of the motion: position, velocity and spin.</summary>
    public const int Components = 9;

    internal BallEstimate()
    {
    }

    /// <summary>The state of the ball, whose time is that of the last point.</summary>
    public BallState State { get; internal set; }

    /// <summary>The standard deviation of a component of the position, in m: the root mean square of the three axes.</summary>
    public double PositionDeviation => Deviation(0);

    /// <summary>The standard deviation of a component of the velocity, in m/s: the root mean square of the three axes.</summary>
    public double VelocityDeviation => Deviation(3);

    /// <summary>The standard deviation of a component of the spin, in rad/s: the root mean square of the three axes.</summary>
    public double SpinDeviation => Deviation(6);

    /// <summary>The probability that the ball was kicked within the last 0.5 s, 0 … 1.</summary>
    public double KickProbability { get; internal set; }

    /// <summary>The time of that kick, in s; NaN if <see cref="KickProbability"/> is 0.</summary>
    public double KickTime { get; internal set; } = double.NaN;

    /// <summary>The standard deviation of <see cref="KickTime"/>, in s.</summary>
    public double KickDeviation { get; internal set; }

    /// <summary>True if the filter believes in the kick: the probability is at least 0.999.</summary>
    public bool HasKick => KickProbability >= Belief;

    /// <summary>True if the last point does not fit the estimated motion.</summary>
    public bool IsOutlier { get; internal set; }

    /// <summary>True if the ball seems to move with a player: at least three kicks within 0.8 s.</summary>
    /// <remarks>The path ahead then has a large deviation, because another kick is likely.</remarks>
    public bool IsHeld { get; internal set; }

    /// <summary>The probability from which the filter believes in a kick.</summary>
    internal const double Belief = 0.999;

    /// <summary>The covariance of position, velocity and spin, row by row.</summary>
    internal double[] Covariances { get; } = new double[Components * Components];

    /// <summary>Returns an element of the covariance of position (0–2, in m), velocity (3–5, in m/s) and spin (6–8, in rad/s).</summary>
    /// <param name="row">0 … 8.</param>
    /// <param name="column">0 … 8.</param>
    /// <exception cref="ArgumentOutOfRangeException">An index is out of range.</exception>
    public double Covariance(int row, int column)
    {
        Check.Within(nameof(row), row, 0, Components - 1);
        Check.Within(nameof(column), column, 0, Components - 1);
        return Covariances[(row * Components) + column];
    }

    private double Deviation(int first)
    {
        double sum = 0;
        for (int i = first; i < first + 3; i++)
        {
            sum += Covariances[(i * Components) + i];
        }

        return Math.Sqrt(Math.Max(0, sum) / 3);
    }
}
