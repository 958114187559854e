namespace FootballPhysics;

/// <summary>The force and the torque of the air on a ball, as an engine's rigid body takes them.</summary>
/// <param name="Force">The force at the centre, in N.</param>
/// <param name="Torque">The torque about the centre, in N m.</param>
public readonly record struct ForceAndTorque(Vector3d Force, Vector3d Torque);
