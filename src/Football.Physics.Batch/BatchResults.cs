namespace FootballPhysics.Batch;

/// <summary>The outcome of many balls that were played to a plane, to rest or to a time, as arrays of numbers.</summary>
public sealed class BatchResults
{
    /// <summary>Makes room for balls.</summary>
    /// <param name="capacity">How many; not negative.</param>
    /// <param name="samples">Places of each path to make room for; not negative, default 0.</param>
    /// <param name="interval">Time between two of them, s. Above 0; default 0.05.</param>
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

    /// <summary>How many there is room for.</summary>
    public int Capacity => Time.Length;

    /// <summary>Places of each path that there is room for.</summary>
    public int Samples { get; }

    /// <summary>Time between two of them, s.</summary>
    public double Interval { get; }

    /// <summary>True where the ball crossed the plane; what follows is then as it was there.</summary>
    public bool[] Crossed { get; }

    /// <summary>True where the ball came to rest.</summary>
    public bool[] Rests { get; }

    /// <summary>True where the whole ball was in a goal of the scene.</summary>
    public bool[] Scored { get; }

    /// <summary>How often it hit something.</summary>
    public int[] Bounces { get; }

    /// <summary>When it ended, s after the launch.</summary>
    public double[] Time { get; }

    /// <summary>Positions of the centres then, m.</summary>
    public Vector3dColumns Position { get; }

    /// <summary>Velocities then, m/s.</summary>
    public Vector3dColumns Velocity { get; }

    /// <summary>Spins at the end of the last step, rad/s, world frame.</summary>
    public Vector3dColumns Spin { get; }

    /// <summary>How many places of each path were written.</summary>
    public int[] SampleCount { get; }

    /// <summary>Places of the paths, m: those of ball i from i × <see cref="Samples"/> on.</summary>
    public Vector3dColumns Places { get; }
}
