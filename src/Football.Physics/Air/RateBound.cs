namespace Football.Physics;

/// <summary>An upper bound for how fast a law changes the motion: PerSpeed · |u| + PerSpin · |ω| + Constant, in 1/s.</summary>
internal readonly struct RateBound
{
    public readonly double PerSpeed;
    public readonly double PerSpin;
    public readonly double Constant;

    public RateBound(double perSpeed, double perSpin, double constant)
    {
        PerSpeed = perSpeed;
        PerSpin = perSpin;
        Constant = constant;
    }

    /// <summary>The bound, 1/s, at a speed relative to the air, m/s, and a spin, rad/s.</summary>
    public double At(double speed, double spinRate) => (PerSpeed * speed) + (PerSpin * spinRate) + Constant;

    public static RateBound operator +(in RateBound a, in RateBound b) =>
        new(a.PerSpeed + b.PerSpeed, a.PerSpin + b.PerSpin, a.Constant + b.Constant);
}
