namespace FootballPhysics;

/// <summary>Effect of the air on the ball at one instant: a = Lift (ω × u) − Drag u + Acceleration, ω̇ = −Decay ω + SpinAcceleration.</summary>
internal struct AirFactors
{
    /// <summary>u, the velocity relative to the air here and now, m/s.</summary>
    public Vector3d AirVelocity;

    /// <summary>|u|, m/s, where the air asks for the distance flown; else 0.</summary>
    public double AirSpeed;

    /// <summary>D, 1/s.</summary>
    public double Drag;

    /// <summary>L; without unit.</summary>
    public double Lift;

    /// <summary>1/s; without spin the angular deceleration itself, rad/s².</summary>
    public double Decay;

    /// <summary>By forces that are neither along the motion nor along ω × u, m/s². Zero but for models whose <see cref="SceneAir.Varies"/> is true.</summary>
    public Vector3d Acceleration;

    /// <summary>By torques that are not along the spin, rad/s². Zero but for models whose <see cref="SceneAir.Varies"/> is true.</summary>
    public Vector3d SpinAcceleration;
}
