namespace Football.Physics;

/// <summary>The running sum of forces and torques.</summary>
public struct ForceSum
{
    /// <summary>Sum of the forces, N.</summary>
    public Vector3d Force { get; private set; }

    /// <summary>Sum of the torques, N m.</summary>
    public Vector3d Torque { get; private set; }

    /// <summary>Adds a force.</summary>
    /// <param name="force">Force, N.</param>
    public void AddForce(in Vector3d force) => Force += force;

    /// <summary>Adds a torque.</summary>
    /// <param name="torque">Torque, N m.</param>
    public void AddTorque(in Vector3d torque) => Torque += torque;
}
