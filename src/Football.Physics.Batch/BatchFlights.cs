using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>The ends of many flights, as arrays.</summary>
public sealed class BatchFlights
{
    /// <summary>Creates a set of results.</summary>
    /// <param name="capacity">The number of flights; at least 0.</param>
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

    /// <summary>The number of flights.</summary>
    public int Capacity => Time.Length;

    /// <summary>The way in which each flight ended.</summary>
    public BatchEnd[] End { get; }

    /// <summary>The end times, in s since the launch.</summary>
    public double[] Time { get; }

    /// <summary>The positions of the centres at the end, in m.</summary>
    public Vector3dColumns Position { get; }

    /// <summary>The velocities at the end, before the impact, in m/s.</summary>
    public Vector3dColumns Velocity { get; }

    /// <summary>The spins at the end, before the impact, in rad/s, in the world frame.</summary>
    public Vector3dColumns Spin { get; }

    /// <summary>The velocities just after the impact, in m/s; without an impact, the same as before.</summary>
    public Vector3dColumns VelocityAfter { get; }

    /// <summary>The spins just after the impact, in rad/s; without an impact, the same as before.</summary>
    public Vector3dColumns SpinAfter { get; }

    /// <summary>The greatest heights of the centres, in m, if <see cref="BatchSettings.FindApex"/> is true; otherwise 0.</summary>
    public double[] Apex { get; }
}
