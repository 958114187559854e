namespace FootballPhysics;

/// <summary>State that a step of flight changes, apart from the place: a part of the ball's state, so that one step hands it to the next where it lies.</summary>
internal struct FlightMotion
{
    /// <summary>Velocity of the centre, m/s.</summary>
    public Vector3d Velocity;

    /// <summary>In flight the unit axis of rotation, which is constant there; on the ground the spin itself.</summary>
    public Vector3d Axis;

    /// <summary>In flight the size of the spin, rad/s; on the ground 1.</summary>
    public double SpinRate;
}
