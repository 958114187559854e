namespace FootballPhysics.State;

/// <summary>The part of the state, apart from the position, that a flight step changes.</summary>
/// <remarks>It is stored inside <see cref="BallState"/>, so that consecutive steps need no copies.</remarks>
internal struct FlightMotion
{
    /// <summary>The velocity of the centre, in m/s.</summary>
    public Vector3d Velocity;

    /// <summary>In flight, the constant unit axis of rotation; on the ground, the spin itself.</summary>
    public Vector3d Axis;

    /// <summary>In flight, the magnitude of the spin, in rad/s; on the ground, 1.</summary>
    public double SpinRate;
}
