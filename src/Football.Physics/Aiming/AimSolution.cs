namespace Football.Physics;

/// <summary>The kick that a method found, in its own estimate.</summary>
internal struct AimSolution
{
    public AimStatus Status;
    public Kick Kick;

    /// <summary>Horizontal unit direction of the target, from which the kick's azimuth counts.</summary>
    public Vector3d Forward;

    /// <summary>Speed of the kick, m/s.</summary>
    public double Speed;

    /// <summary>Miss distance at the target, m.</summary>
    public double Miss;

    /// <summary>Miss distance at the point on the way, m.</summary>
    public double ThroughMiss;

    /// <summary>Time to the target, s.</summary>
    public double Time;

    /// <summary>Iterations, where the method counts its own; else 0.</summary>
    public int Iterations;

    /// <summary>Which of the two kicks of its speed it is; null where that is not known yet.</summary>
    public AimArc? Arc;

    /// <summary>Velocity and spin of the kick.</summary>
    public readonly void Vectors(out Vector3d velocity, out Vector3d spin) => Kick.Vectors(Speed, in Forward, out velocity, out spin);
}
