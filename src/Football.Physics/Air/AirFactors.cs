namespace Football.Physics;

/// <summary>What the air does to the ball at one instant: a = −Drag · u + Lift · (ω̂ × u) + Side, ω̇ = −Decay · ω̂.</summary>
internal struct AirFactors
{
    /// <summary>D, 1/s.</summary>
    public double Drag;

    /// <summary>L, 1/s.</summary>
    public double Lift;

    /// <summary>Angular deceleration, rad/s²; at zero spin its limit.</summary>
    public double Decay;

    /// <summary>Acceleration by a force that is neither along the motion nor along ω̂ × u, m/s². Only of models whose <see cref="IAir.Varies"/> is true.</summary>
    public Vector3d Side;
}
