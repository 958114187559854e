namespace Football.Physics;

/// <summary>A kick that is at the target at a given time, or came close to that.</summary>
internal struct TimedKick
{
    /// <summary>The time, s after the kick.</summary>
    public double Time;

    /// <summary>Velocity of the kick, m/s.</summary>
    public Vector3d Velocity;

    /// <summary>How the ball's place at that time moves with the kick's velocity.</summary>
    public VelocityJacobian Jacobian;

    /// <summary>Velocity of the ball then, relative to the target, m/s.</summary>
    public Vector3d Arrival;

    /// <summary>Distance from the target then, m.</summary>
    public double Miss;

    /// <summary>The lowest height on the way, m.</summary>
    public double Lowest;

    /// <summary>Whether the miss is small enough.</summary>
    public bool Found;

    /// <summary>Speed of the kick, m/s; infinite where it is more than is worth knowing, not a number where it is not known.</summary>
    public double Speed;

    /// <summary>How the speed changes with the logarithm of the time, m/s, along the kicks that hit; not a number where the Jacobian is singular.</summary>
    public readonly double Slope()
    {
        // J dv/dt = −ṗ
        return Jacobian.Solve(-Arrival, out Vector3d rate) ? Time * Vector3d.Dot(in Velocity, in rate) / Velocity.Length : double.NaN;
    }

    /// <summary>The kick for a time a little later or earlier, to first order.</summary>
    public readonly TimedKick At(double time)
    {
        TimedKick next = this;
        next.Time = time;

        // p(t; v) = q(t): J dv/dt = q̇ − ṗ
        if (Jacobian.Solve(-Arrival, out Vector3d rate))
        {
            next.Velocity += (time - Time) * rate;
        }

        return next;
    }
}
