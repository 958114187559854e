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

    public static RateBound operator +(in RateBound a, in RateBound b) =>
        new(a.PerSpeed + b.PerSpeed, a.PerSpin + b.PerSpin, a.Constant + b.Constant);
}
