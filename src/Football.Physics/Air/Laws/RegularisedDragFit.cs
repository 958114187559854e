using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>The fitted C_D with its jumps smoothed over 0.25 m/s and 0.0025 of spin parameter.</summary>
internal readonly struct RegularisedDragFit : IDragFit
{
    /// <summary>Width over which the jump at the critical speed is smoothed, m/s.</summary>
    public const double SpeedWidth = 0.25;

    /// <summary>Width over which the jump at the critical spin parameter is smoothed.</summary>
    public const double SpinWidth = 0.0025;

    public bool Jumps
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    // w = σ((|u| − v_c)/0.25) · σ((Sp − 0.05)/0.0025),  C_D = w c Sp^d + (1 − w) C_D,no spin
    public double Coefficient(in AirFlow flow, DragBranch branch)
    {
        double weight = SpeedWeight(flow.Speed) * SpinWeight(flow.SpinParameter);
        return (weight * FittedDrag.WithSpin(flow.SpinParameter)) + ((1.0 - weight) * FittedDrag.WithoutSpin(flow.Speed));
    }

    /// <summary>σ((|u| − v_c)/0.25), the weight of the law with spin by speed.</summary>
    public static double SpeedWeight(double speed) => Elementary.Logistic((speed - FittedDrag.CriticalSpeed) / SpeedWidth);

    /// <summary>σ((Sp − 0.05)/0.0025), the weight of the law with spin by spin.</summary>
    public static double SpinWeight(double spinParameter) => Elementary.Logistic((spinParameter - FittedDrag.CriticalSpin) / SpinWidth);
}
