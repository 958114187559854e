using System.Runtime.CompilerServices;

namespace FootballPhysics.Laws;

/// <summary>The sum of the custom forces, per mass and per moment of inertia.</summary>
internal sealed unsafe class OwnForces
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
    /// <param name="ball">The ball.</param>
    /// <param name="factors">Receives the accelerations.</param>
    /// <param name="trace">Receives them too; null if nobody needs them.</param>
    /// <exception cref="InvalidOperationException">A force is not finite.</exception>
    public void AddTo(in ForceContext ball, ref AirFactors factors, ForceTrace* trace)
    {
        if (trace != null && trace->IsWild)
        {
            return;
        }

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

        Vector3d acceleration = sum.Force * _perMass;
        Vector3d spinAcceleration = sum.Torque * _perInertia;
        factors.Acceleration += acceleration;
        factors.SpinAcceleration += spinAcceleration;
        if (trace != null)
        {
            trace->Add(in acceleration, in spinAcceleration);
            trace->Last = new Motion(ball.Position, ball.Velocity, ball.Spin, ball.AirDistance);
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Refuse(int index, in ForceContext ball, in ForceAndTorque sum) => throw new InvalidOperationException(FormattableString.Invariant(
        $"forces.customForces[{index}] ({_forces[index].GetType().Name}) is {sum.Force} N, {sum.Torque} N m at {ball.Time} s; allowed: finite components."));
}
