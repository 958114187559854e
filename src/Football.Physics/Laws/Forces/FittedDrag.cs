using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Laws;

/// <summary>The constants and branches of the drag coefficient fitted to measurements (Goff; thesis 2.6, 2.7).</summary>
internal static class FittedDrag
{
    /// <summary>C_D at high speed without spin.</summary>
    public const double A = 0.155;

    /// <summary>The drop of C_D through the drag crisis.</summary>
    public const double B = 0.346;

    /// <summary>The critical speed v_c, in m/s.</summary>
    public const double CriticalSpeed = 12.19;

    /// <summary>The width of the drag crisis v_s, in m/s.</summary>
    public const double SpeedScale = 1.309;

    /// <summary>The factor c of the law with spin.</summary>
    public const double C = 0.4127;

    /// <summary>The exponent d of the law with spin.</summary>
    public const double D = 0.3056;

    /// <summary>The spin parameter above which the law with spin applies.</summary>
    public const double CriticalSpin = 0.05;

    /// <summary>C_D at zero speed, the maximum without spin: a + b/(1 + exp(−v_c/v_s)).</summary>
    public static readonly double AtRest = A + (B / (1.0 + Elementary.Exp(-CriticalSpeed / SpeedScale)));

    private static readonly PowerTable PowerD = new(D);

    /// <summary>Returns C_D = a + b / (1 + exp((|u| − v_c)/v_s)).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double WithoutSpin(double speed) => A + (B / (1.0 + Elementary.Exp((speed - CriticalSpeed) * (1.0 / SpeedScale))));

    /// <summary>Returns C_D = c Sp^d.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double WithSpin(double spinParameter) => C * PowerD.Of(spinParameter);
}
