namespace FootballPhysics.Batch;

/// <summary>Many kicks that were found, as arrays of numbers.</summary>
public sealed class BatchKicks
{
    /// <summary>Makes room for kicks.</summary>
    /// <param name="capacity">How many; not negative.</param>
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

    /// <summary>How many there is room for.</summary>
    public int Capacity => Time.Length;

    /// <summary>The outcomes of the searches.</summary>
    public AimStatus[] Status { get; }

    /// <summary>Velocities of the kicks, m/s.</summary>
    public Vector3dColumns Velocity { get; }

    /// <summary>Spins of the kicks, rad/s, world frame.</summary>
    public Vector3dColumns Spin { get; }

    /// <summary>The method's estimates of the misses, m.</summary>
    public double[] Miss { get; }

    /// <summary>Times to the targets, s.</summary>
    public double[] Time { get; }
}
