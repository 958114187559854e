namespace FootballPhysics.Yardsticks;

/// <summary>The fitted laws of drag, lift and spin decay, implemented literally from the equations: for every yardstick, and for the tests.</summary>
public static class FittedLaws
{
    /// <summary>Drag coefficient of a fast ball without spin.</summary>
    public const double FastDrag = 0.155;

    /// <summary>The excess of the drag coefficient of a slow ball.</summary>
    public const double DragDrop = 0.346;

    /// <summary>The speed of the drop, m/s; the law with spin holds above it.</summary>
    public const double CriticalSpeed = 12.19;

    /// <summary>The width of the drop, m/s.</summary>
    public const double SpeedScale = 1.309;

    /// <summary>The spin parameter above which the law with spin holds.</summary>
    public const double CriticalSpin = 0.05;

    /// <summary>The widths of the regularised law's transition, in m/s and in the spin parameter.</summary>
    public const double RegularisedSpeed = 0.25, RegularisedSpin = 0.0025;

    /// <summary>C_D = k Sp^n of the law with spin.</summary>
    public const double SpinFactor = 0.4127, SpinPower = 0.3056;

    /// <summary>C_L = k Sp^n (…) of the Magnus force.</summary>
    public const double LiftFactor = 1.15, LiftPower = 0.83;

    /// <summary>C = k Re^n of the plates that model the spin decay.</summary>
    public const double PlateFactor = 0.0074, PlatePower = -0.2;

    /// <summary>Drag coefficient at rest.</summary>
    public static double DragAtRest { get; } = WithoutSpin(0);

    /// <summary>C_D = 0.155 + 0.346/(1 + exp((|u| − 12.19)/1.309)).</summary>
    public static double WithoutSpin(double speed) => FastDrag + (DragDrop / (1.0 + Math.Exp((speed - CriticalSpeed) / SpeedScale)));

    /// <summary>C_D = 0.4127 Sp^0.3056.</summary>
    public static double WithSpin(double sp) => SpinFactor * Math.Pow(sp, SpinPower);

    /// <summary>Returns the drag coefficient with its jump.</summary>
    public static double Published(double speed, double sp) => speed > CriticalSpeed && sp > CriticalSpin ? WithSpin(sp) : WithoutSpin(speed);

    /// <summary>Returns the drag coefficient with the jump smoothed.</summary>
    public static double Regularised(double speed, double sp)
    {
        double w = Logistic((speed - CriticalSpeed) / RegularisedSpeed) * Logistic((sp - CriticalSpin) / RegularisedSpin);
        return (w * WithSpin(sp)) + ((1.0 - w) * WithoutSpin(speed));
    }

    /// <summary>C_L = 1.15 Sp^0.83 (C_D0 − min(C_D, C_D0))/(C_D0 − 0.155).</summary>
    public static double Lift(double dragCoefficient, double sp) =>
        LiftFactor * Math.Pow(sp, LiftPower) * (DragAtRest - Math.Min(dragCoefficient, DragAtRest)) / (DragAtRest - FastDrag);

    /// <summary>U² C of a plate in a stream U, with C = 0.0074 (U 2r/ν)^(−1/5).</summary>
    /// <param name="u">U, m/s; 0 or more.</param>
    /// <param name="reynolds">2r/ν, s/m.</param>
    public static double Plate(double u, double reynolds) => u > 0 ? u * u * PlateFactor * Math.Pow(u * reynolds, PlatePower) : 0;

    private static double Logistic(double x) => 1.0 / (1.0 + Math.Exp(-x));
}
