namespace FootballPhysics;

/// <summary>The effect of the air on the ball at one instant: a = Lift (ω × u) − Drag u + Acceleration, ω̇ = −Decay ω + SpinAcceleration.</summary>
internal struct AirFactors
{
    /// <summary>u, the velocity relative to the air at the ball, in m/s.</summary>
    public Vector3d AirVelocity;

    /// <summary>|u|, in m/s, if the air needs the distance flown; otherwise 0.</summary>
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
}
