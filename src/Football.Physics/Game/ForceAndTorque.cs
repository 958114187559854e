namespace FootballPhysics;

/// <summary>The force and the torque of the air on a ball, to apply to an engine's rigid body.</summary>
public readonly struct ForceAndTorque
{
    /// <summary>Creates a pair of force and torque.</summary>
    /// <param name="force">The force at the centre, in N.</param>
    /// <param name="torque">The torque about the centre, in N m.</param>
    public ForceAndTorque(Vector3d force, Vector3d torque)
    {
        Force = force;
        Torque = torque;
    }

    /// <summary>The force at the centre, in N.</summary>
    public Vector3d Force { get; }

    /// <summary>The torque about the centre, in N m.</summary>
    public Vector3d Torque { get; }
}
