using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>The results of many balls that were simulated to a plane, to rest or to a time, as arrays.</summary>
public sealed class BatchResults
{
    /// <summary>Creates a set of results.</summary>
    /// <param name="capacity">The number of balls; at least 0.</param>
    /// <param name="samples">The number of samples of each path; at least 0, default 0.</param>
    /// <param name="interval">The time between two samples, in s. Above 0; default 0.05.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public BatchResults(int capacity, int samples = 0, double interval = 0.05)
    {
        Check.AtLeast(nameof(capacity), capacity, 0);
        Check.AtLeast(nameof(samples), samples, 0);
        Check.Positive(nameof(interval), interval);
        Check.AtLeast("capacity × samples", int.MaxValue - ((double)capacity * samples), 0);
        Samples = samples;
        Interval = interval;
        Crossed = new bool[capacity];
        Rests = new bool[capacity];
        Scored = new bool[capacity];
        Bounces = new int[capacity];
        Time = new double[capacity];
        Position = new Vector3dColumns(capacity);
        Velocity = new Vector3dColumns(capacity);
        Spin = new Vector3dColumns(capacity);
        SampleCount = new int[capacity];
        Places = new Vector3dColumns(capacity * samples);
    }

    /// <summary>The number of balls.</summary>
    public int Capacity => Time.Length;

    /// <summary>The number of samples of each path.</summary>
    public int Samples { get; }

    /// <summary>The time between two samples, in s.</summary>
    public double Interval { get; }

    /// <summary>True if the ball crossed the plane. Time, position and velocity are then those of the crossing.</summary>
    public bool[] Crossed { get; }

    /// <summary>True if the ball came to rest.</summary>
    public bool[] Rests { get; }

    /// <summary>True if the ball went into a goal of the scene.</summary>
    public bool[] Scored { get; }

    /// <summary>The number of impacts.</summary>
    public int[] Bounces { get; }

    /// <summary>The end times, in s since the launch.</summary>
    public double[] Time { get; }

    /// <summary>The positions of the centres at the end, in m.</summary>
    public Vector3dColumns Position { get; }

    /// <summary>The velocities at the end, in m/s.</summary>
    public Vector3dColumns Velocity { get; }

    /// <summary>The spins at the end of the last step, in rad/s, in the world frame.</summary>
    public Vector3dColumns Spin { get; }

    /// <summary>The number of samples written for each path.</summary>
    public int[] SampleCount { get; }

    /// <summary>The sampled positions, in m. The samples of ball i start at index i × <see cref="Samples"/>.</summary>
    public Vector3dColumns Places { get; }
}
