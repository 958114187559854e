namespace FootballPhysics.Native;

/// <summary>The visible state of a ball. Right-handed, y up, SI units.</summary>
internal unsafe struct NativeBall
{
    /// <summary>Position of the centre, m.</summary>
    public fixed double Position[3];

    /// <summary>Velocity, m/s.</summary>
    public fixed double Velocity[3];

    /// <summary>Angular velocity in the world frame, rad/s.</summary>
    public fixed double Spin[3];

    /// <summary>Orientation, body to world, a unit quaternion x, y, z, w.</summary>
    public fixed double Orientation[4];

    /// <summary>Time since the launch, s.</summary>
    public double Time;

    /// <summary>The motion, one of fp_motion.</summary>
    public int Motion;

    /// <summary>0.</summary>
    public int Reserved;
}
