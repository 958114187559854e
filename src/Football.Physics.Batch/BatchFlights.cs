namespace FootballPhysics.Batch;

/// <summary>Where the flights of many balls ended, as arrays of numbers.</summary>
public sealed class BatchFlights
{
    /// <summary>Makes room for flights.</summary>
    /// <param name="capacity">How many; not negative.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="capacity"/> is negative.</exception>
    public BatchFlights(int capacity)
    {
        Check.AtLeast(nameof(capacity), capacity, 0);
        Position = new Vector3dColumns(capacity);
        Velocity = new Vector3dColumns(capacity);
        Spin = new Vector3dColumns(capacity);
        VelocityAfter = new Vector3dColumns(capacity);
        SpinAfter = new Vector3dColumns(capacity);
        End = new BatchEnd[capacity];
        Time = new double[capacity];
        Apex = new double[capacity];
    }

    /// <summary>How many there is room for.</summary>
    public int Capacity => Time.Length;

    /// <summary>How the flights ended.</summary>
    public BatchEnd[] End { get; }

    /// <summary>When, s after the launch.</summary>
    public double[] Time { get; }

    /// <summary>Positions of the centres then, m.</summary>
    public Vector3dColumns Position { get; }

    /// <summary>Velocities then, m/s; before the impact.</summary>
    public Vector3dColumns Velocity { get; }

    /// <summary>Spins then, rad/s, world frame; before the impact.</summary>
    public Vector3dColumns Spin { get; }

    /// <summary>Velocities just after the impact, m/s; the same as before where there was none.</summary>
    public Vector3dColumns VelocityAfter { get; }

    /// <summary>Spins just after the impact, rad/s; the same as before where there was none.</summary>
    public Vector3dColumns SpinAfter { get; }

    /// <summary>The greatest heights of the centres, m, where <see cref="BatchSettings.FindApex"/> asks for them; else 0.</summary>
    public double[] Apex { get; }
}
