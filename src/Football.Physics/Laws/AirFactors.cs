using System.Runtime.CompilerServices;

namespace FootballPhysics.Laws;

/// <summary>The effect of the air on the ball at one instant: a = Lift (ω × u) − Drag u + Acceleration, ω̇ = −Decay ω + SpinAcceleration.</summary>
internal struct AirFactors
{
    /// <summary>u, the velocity relative to the air at the ball, in m/s.</summary>
    public Vector3d AirVelocity;

    /// <summary>|u|, in m/s, if an air force depends on the distance flown; otherwise 0.</summary>
    public double AirSpeed;

    /// <summary>D, in 1/s.</summary>
    public double Drag;

    /// <summary>L, dimensionless.</summary>
    public double Lift;

    /// <summary>The decay rate, in 1/s; without spin, the angular deceleration itself, in rad/s².</summary>
    public double Decay;

    /// <summary>The acceleration by forces along neither u nor ω × u, in m/s². Zero unless <see cref="SceneAir.Varies"/> is true.</summary>
    public Vector3d Acceleration;

    /// <summary>The angular acceleration by torques that are not along the spin, in rad/s². Zero unless <see cref="SceneAir.Varies"/> is true.</summary>
    public Vector3d SpinAcceleration;

    /// <summary>The rates of velocity and spin for these factors and a constant acceleration.</summary>
    /// <param name="spin">ω, rad/s.</param>
    /// <param name="constant">The acceleration that acts in addition to the air, m/s².</param>
    /// <param name="varies">True to add <see cref="Acceleration"/> and <see cref="SpinAcceleration"/>: <see cref="SceneAir.Varies"/>.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly MotionRates Rates(in Vector3d spin, in Vector3d constant, bool varies)
    {
        // u is the velocity through the air; L and D are the factors of lift and drag, and g is the constant acceleration.
        // a = L (ω × u) − D u + g,  ω̇ = −decay ω
        Vector3d acceleration = (Lift * Vector3d.Cross(in spin, in AirVelocity)) - (Drag * AirVelocity) + constant;
        Vector3d spinAcceleration = -Decay * spin;
        if (varies)
        {
            acceleration += Acceleration;
            spinAcceleration += SpinAcceleration;
        }

        return new MotionRates(in acceleration, in spinAcceleration, AirSpeed);
    }
}
