namespace Football.Physics;

/// <summary>The game's own forces, summed, per mass and per moment of inertia.</summary>
internal readonly struct CustomForces
{
    private readonly IForce[] _forces;
    private readonly double _perMass;
    private readonly double _perInertia;

    public CustomForces(Scene scene)
    {
        _forces = [.. scene.Forces.Custom];
        _perMass = 1.0 / scene.Ball.Mass;
        _perInertia = 1.0 / scene.Ball.MomentOfInertia;
    }

    /// <summary>Whether there are any.</summary>
    public bool Act => _forces.Length > 0;

    /// <summary>Their accelerations.</summary>
    public MotionRates Rates(double time, in Motion at, in Vector3d airVelocity, MotionState motion)
    {
        var input = new ForceInput(time, at.Position, at.Velocity, airVelocity, at.Spin, motion);
        ForceSum sum = default;
        foreach (IForce force in _forces)
        {
            force.Apply(in input, ref sum);
        }

        return new MotionRates(sum.Force * _perMass, sum.Torque * _perInertia);
    }
}
