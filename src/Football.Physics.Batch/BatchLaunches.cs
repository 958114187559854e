namespace FootballPhysics.Batch;

/// <summary>The launches of many balls, as arrays of numbers.</summary>
public sealed class BatchLaunches
{
    /// <summary>Makes room for launches; all zero until set.</summary>
    /// <param name="capacity">How many; not negative.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="capacity"/> is negative.</exception>
    public BatchLaunches(int capacity)
    {
        Position = new Vector3dColumns(capacity);
        Velocity = new Vector3dColumns(capacity);
        Spin = new Vector3dColumns(capacity);
    }

    /// <summary>How many there is room for.</summary>
    public int Capacity => Position.Length;

    /// <summary>Positions of the centres, m; components within ±1e6. A ball in the ground is raised straight up until it is not.</summary>
    public Vector3dColumns Position { get; }

    /// <summary>Velocities, m/s; speeds at most 1000.</summary>
    public Vector3dColumns Velocity { get; }

    /// <summary>Spins, rad/s, world frame; sizes at most 10 000.</summary>
    public Vector3dColumns Spin { get; }

    /// <summary>Sets a launch.</summary>
    /// <param name="index">Which; 0 … <see cref="Capacity"/> − 1.</param>
    /// <param name="position">Position of the centre, m.</param>
    /// <param name="velocity">Velocity, m/s.</param>
    /// <param name="spin">Spin, rad/s.</param>
    /// <exception cref="IndexOutOfRangeException"><paramref name="index"/> is out of range.</exception>
    public void Set(int index, Vector3d position, Vector3d velocity, Vector3d spin)
    {
        Position[index] = position;
        Velocity[index] = velocity;
        Spin[index] = spin;
    }
}
