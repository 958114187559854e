using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>The results of many aiming requests, as arrays.</summary>
public sealed class BatchKicks
{
    /// <summary>Creates a set of results.</summary>
    /// <param name="capacity">The number of kicks; at least 0.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="capacity"/> is negative.</exception>
    public BatchKicks(int capacity)
    {
        Check.AtLeast(nameof(capacity), capacity, 0);
        Status = new AimStatus[capacity];
        Velocity = new Vector3dColumns(capacity);
        Spin = new Vector3dColumns(capacity);
        Miss = new double[capacity];
        Time = new double[capacity];
    }

    /// <summary>The number of kicks.</summary>
    public int Capacity => Time.Length;

    /// <summary>The outcomes of the searches.</summary>
    public AimStatus[] Status { get; }

    /// <summary>The velocities of the kicks, in m/s.</summary>
    public Vector3dColumns Velocity { get; }

    /// <summary>The spins of the kicks, in rad/s, in the world frame.</summary>
    public Vector3dColumns Spin { get; }

    /// <summary>The estimated misses, in m.</summary>
    public double[] Miss { get; }

    /// <summary>The times to the targets, in s.</summary>
    public double[] Time { get; }
}
