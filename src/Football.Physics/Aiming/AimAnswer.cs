namespace Football.Physics;

/// <summary>What a method found, in its own estimate.</summary>
internal struct AimAnswer
{
    public AimStatus Status;
    public Kick Kick;
    public Vector3d Forward;
    public double Speed;

    /// <summary>The method's own estimate of the miss, m.</summary>
    public double Miss;

    /// <summary>The method's own estimate of the miss at the point on the way, m.</summary>
    public double ThroughMiss;

    /// <summary>The method's own estimate of the time to the target, s.</summary>
    public double Time;

    public int Iterations;

    /// <summary>Velocity and spin of the kick.</summary>
    public readonly void Vectors(out Vector3d velocity, out Vector3d spin) => Kick.Vectors(Speed, in Forward, out velocity, out spin);
}
