using FootballPhysics.Numerics;

namespace FootballPhysics.Laws;

/// <summary>The weights that smooth the jumps in the fitted C_D over 0.25 m/s of speed and 0.0025 of spin parameter.</summary>
internal static class RegularisedDragFit
{
    /// <summary>The smoothing width at the critical speed, in m/s.</summary>
    public const double SpeedWidth = 0.25;

    /// <summary>The smoothing width at the critical spin parameter.</summary>
    public const double SpinWidth = 0.0025;

    /// <summary>Returns w c Sp^d + (1 − w) C_D,no spin with w = σ((|u| − v_c)/0.25) · σ((Sp − 0.05)/0.0025).</summary>
    public static double Coefficient(double speed, double spinParameter)
    {
        double weight = SpeedWeight(speed) * SpinWeight(spinParameter);
        return (weight * FittedDrag.WithSpin(spinParameter)) + ((1.0 - weight) * FittedDrag.WithoutSpin(speed));
    }

    /// <summary>Returns σ((|u| − v_c)/0.25), the weight of the law with spin as a function of speed.</summary>
    public static double SpeedWeight(double speed) => Elementary.Logistic((speed - FittedDrag.CriticalSpeed) / SpeedWidth);

    /// <summary>Returns σ((Sp − 0.05)/0.0025), the weight of the law with spin as a function of the spin parameter.</summary>
    public static double SpinWeight(double spinParameter) => Elementary.Logistic((spinParameter - FittedDrag.CriticalSpin) / SpinWidth);
}
