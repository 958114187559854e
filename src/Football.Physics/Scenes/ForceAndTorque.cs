namespace FootballPhysics;

/// <summary>A force and a torque on a ball: those of the air, for an engine's rigid body, or the sum to which a custom force adds its own.</summary>
public struct ForceAndTorque
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
    public Vector3d Force { readonly get; private set; }

    /// <summary>The torque about the centre, in N m.</summary>
    public Vector3d Torque { readonly get; private set; }

    /// <summary>Adds a force.</summary>
    /// <param name="force">The force, in N.</param>
    public void AddForce(in Vector3d force) => Force += force;

    /// <summary>Adds a torque.</summary>
    /// <param name="torque">The torque, in N m.</param>
    public void AddTorque(in Vector3d torque) => Torque += torque;
}
