using System.Runtime.CompilerServices;

namespace FootballPhysics.Laws;

/// <summary>The sum of the custom forces, per mass and per moment of inertia.</summary>
internal sealed class OwnForces
{
    private readonly IForce[] _forces;
    private readonly double _perMass;
    private readonly double _perInertia;

    public OwnForces(Scene scene)
    {
        _forces = [.. scene.Forces.CustomForces];
        _perMass = 1.0 / scene.Ball.Mass;
        _perInertia = 1.0 / scene.Ball.MomentOfInertia;
    }

    /// <summary>Adds the accelerations of the custom forces.</summary>
    /// <exception cref="InvalidOperationException">A force is not finite.</exception>
    public void AddTo(in ForceContext ball, ref AirFactors factors)
    {
        // Pass the air-relative velocity, with the local wind, to the forces.
        ForceAndTorque sum = default;
        ForceContext seen = ball.In(in factors.AirVelocity);
        for (int i = 0; i < _forces.Length; i++)
        {
            _forces[i].Apply(in seen, ref sum);
            if (!(sum.Force.IsFinite && sum.Torque.IsFinite))
            {
                Refuse(i, in seen, in sum);
            }
        }

        factors.Acceleration += sum.Force * _perMass;
        factors.SpinAcceleration += sum.Torque * _perInertia;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Refuse(int index, in ForceContext ball, in ForceAndTorque sum) => throw new InvalidOperationException(FormattableString.Invariant(
        $"forces.customForces[{index}] ({_forces[index].GetType().Name}) is {sum.Force} N, {sum.Torque} N m at {ball.Time} s; allowed: finite components."));
}
