namespace FootballPhysics;

/// <summary>The weights by which the jumps of the fitted C_D are smoothed over 0.25 m/s and 0.0025 of spin parameter.</summary>
internal static class RegularisedDragFit
{
    /// <summary>Width over which the jump at the critical speed is smoothed, m/s.</summary>
    public const double SpeedWidth = 0.25;

    /// <summary>Width over which the jump at the critical spin parameter is smoothed.</summary>
    public const double SpinWidth = 0.0025;

    /// <summary>w c Sp^d + (1 − w) C_D,no spin with w = σ((|u| − v_c)/0.25) · σ((Sp − 0.05)/0.0025).</summary>
    public static double Coefficient(double speed, double spinParameter)
    {
        double weight = SpeedWeight(speed) * SpinWeight(spinParameter);
        return (weight * FittedDrag.WithSpin(spinParameter)) + ((1.0 - weight) * FittedDrag.WithoutSpin(speed));
    }

    /// <summary>σ((|u| − v_c)/0.25), the weight of the law with spin by speed.</summary>
    public static double SpeedWeight(double speed) => Elementary.Logistic((speed - FittedDrag.CriticalSpeed) / SpeedWidth);

    /// <summary>σ((Sp − 0.05)/0.0025), the weight of the law with spin by spin.</summary>
    public static double SpinWeight(double spinParameter) => Elementary.Logistic((spinParameter - FittedDrag.CriticalSpin) / SpinWidth);
}
