namespace Football.Physics;

/// <summary>The game's own forces, summed, per mass and per moment of inertia.</summary>
internal readonly struct OwnForces
{
    private readonly IForce[] _forces;
    private readonly double _perMass;
    private readonly double _perInertia;

    public OwnForces(Scene scene)
    {
        _forces = [.. scene.Forces.Custom];
        _perMass = 1.0 / scene.Ball.Mass;
        _perInertia = 1.0 / scene.Ball.MomentOfInertia;
    }

    /// <summary>Adds their accelerations.</summary>
    public void AddTo(in ForceInput ball, ref AirFactors factors)
    {
        ForceSum sum = default;
        foreach (IForce force in _forces)
        {
            force.Apply(in ball, ref sum);
            if (!sum.Force.IsFinite || !sum.Torque.IsFinite)
            {
                throw Check.Refusal("forces.custom, " + force.GetType().Name, sum.Force + " N, " + sum.Torque + " N m", "finite forces and torques");
            }
        }

        factors.Acceleration += sum.Force * _perMass;
        factors.SpinAcceleration += sum.Torque * _perInertia;
    }
}
