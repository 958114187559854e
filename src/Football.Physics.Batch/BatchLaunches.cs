namespace FootballPhysics.Batch;

/// <summary>The launches of many balls, as arrays.</summary>
public sealed class BatchLaunches
{
    /// <summary>Creates a set of launches; all numbers are 0 until set.</summary>
    /// <param name="capacity">The number of launches; at least 0.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="capacity"/> is negative.</exception>
    public BatchLaunches(int capacity)
    {
        Position = new Vector3dColumns(capacity);
        Velocity = new Vector3dColumns(capacity);
        Spin = new Vector3dColumns(capacity);
    }

    /// <summary>The number of launches.</summary>
    public int Capacity => Position.Length;

    /// <summary>The positions of the centres, in m; components within ±1e6.</summary>
    /// <remarks>A ball below the surface of the ground is raised vertically until it touches the ground.</remarks>
    public Vector3dColumns Position { get; }

    /// <summary>The velocities, in m/s; at most 1000.</summary>
    public Vector3dColumns Velocity { get; }

    /// <summary>The spins, in rad/s, in the world frame; at most 10 000.</summary>
    public Vector3dColumns Spin { get; }

    /// <summary>Sets a launch.</summary>
    /// <param name="index">The index, 0 … <see cref="Capacity"/> − 1.</param>
    /// <param name="position">The position of the centre, in m.</param>
    /// <param name="velocity">The velocity, in m/s.</param>
    /// <param name="spin">The spin, in rad/s.</param>
    /// <exception cref="IndexOutOfRangeException"><paramref name="index"/> is out of range.</exception>
    public void Set(int index, Vector3d position, Vector3d velocity, Vector3d spin)
    {
        Position[index] = position;
        Velocity[index] = velocity;
        Spin[index] = spin;
    }
}
