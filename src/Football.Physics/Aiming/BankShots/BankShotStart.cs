namespace Football.Physics;

/// <summary>A kick that was flown, and how close it comes after what it is to meet.</summary>
internal struct BankShotStart
{
    public Kick Kick;

    /// <summary>Whether it meets what it is to meet.</summary>
    public bool Meets;

    /// <summary>Whether it was flown in short steps.</summary>
    public bool IsFine;

    /// <summary>Closest approach, m.</summary>
    public double Miss;

    /// <summary>When, s.</summary>
    public double Time;

    /// <summary>Where, m.</summary>
    public Vector3d Position;

    /// <summary>How fast, m/s.</summary>
    public Vector3d Velocity;

    /// <summary>Whether it does what is asked.</summary>
    public readonly bool IsHit(AimRequest request) => IsFine && Miss <= request.Tolerance;
}
