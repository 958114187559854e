using FootballPhysics.Simulation;

namespace FootballPhysics;

/// <summary>The forces on a ball at one instant: those of the first evaluation of its next step, for arrows and overlays.</summary>
/// <remarks>
/// <see cref="Simulator.ForcesAt"/> returns it. A force that does not act is zero. All vectors are in world coordinates. On a surface, the forces are those that
/// the equations of the scene contain: with <see cref="GroundAerodynamics"/> that exclude the air, drag and Magnus force are zero there.
/// </remarks>
public sealed class BallForces
{
    private readonly double _mass;

    internal BallForces(Scene scene, in ForceShares perMass, in Vector3d acceleration, IReadOnlyList<ContactForce> contacts)
    {
        _mass = scene.Ball.Mass;
        Weight = _mass * scene.GravityVector;
        Buoyancy = Scenes.Buoyancy.Force(scene);
        Drag = _mass * perMass.Drag;
        Magnus = _mass * perMass.Lift;
        Knuckle = _mass * perMass.Side;
        Custom = _mass * perMass.Own;
        Nets = _mass * perMass.Nets;
        Acceleration = acceleration;
        Contacts = contacts;
        foreach (ContactForce contact in contacts)
        {
            Load += contact.Load;
            Friction += contact.Friction;
        }
    }

    /// <summary>The weight, m g, in N.</summary>
    public Vector3d Weight { get; }

    /// <summary>The buoyancy in the air, in N.</summary>
    public Vector3d Buoyancy { get; }

    /// <summary>The drag, against the motion through the air, in N.</summary>
    public Vector3d Drag { get; }

    /// <summary>The Magnus force, across spin and motion through the air, in N.</summary>
    public Vector3d Magnus { get; }

    /// <summary>The knuckle force of the seams, in N; it acts only in flight.</summary>
    public Vector3d Knuckle { get; }

    /// <summary>The sum of the custom forces, in N.</summary>
    public Vector3d Custom { get; }

    /// <summary>The sum of the forces of all nets that the ball is in, in N. On a surface, only the part along it acts.</summary>
    public Vector3d Nets { get; }

    /// <summary>The sum of the loads of all contacts, along their normals, in N.</summary>
    public Vector3d Load { get; }

    /// <summary>The sum of the friction of all contacts, in N; it includes rolling resistance, and the force that holds a ball at rest.</summary>
    public Vector3d Friction { get; }

    /// <summary>The contacts of the ball with their forces; empty in flight.</summary>
    public IReadOnlyList<ContactForce> Contacts { get; }

    /// <summary>The sum of all forces, in N.</summary>
    public Vector3d Sum => Weight + Buoyancy + Drag + Magnus + Knuckle + Custom + Nets + Load + Friction;

    /// <summary>The acceleration with which the next step begins, in m/s². It equals <see cref="Sum"/> divided by the mass, to within rounding.</summary>
    public Vector3d Acceleration { get; }
}

/// <summary>The forces of one contact on a ball.</summary>
public readonly struct ContactForce
{
    internal ContactForce(int colliderIndex, in Vector3d point, in Vector3d normal, in Vector3d load, in Vector3d friction)
    {
        ColliderIndex = colliderIndex;
        Point = point;
        Normal = normal;
        Load = load;
        Friction = friction;
    }

    /// <summary>The index of the object, for <see cref="Simulator.NameOf(int)"/>.</summary>
    public int ColliderIndex { get; }

    /// <summary>The contact point, in m.</summary>
    public Vector3d Point { get; }

    /// <summary>The normal of the surface, towards the ball.</summary>
    public Vector3d Normal { get; }

    /// <summary>The force along the normal, in N.</summary>
    public Vector3d Load { get; }

    /// <summary>The force along the surface, in N.</summary>
    public Vector3d Friction { get; }
}
