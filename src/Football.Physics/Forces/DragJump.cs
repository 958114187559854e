using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>
/// The two surfaces at which the published drag law jumps, as functions of |u|² and (r|ω|)²: G = |u|² − v_c² and
/// S = 400 (r|ω|)² − |u|² (Sp = 0.05). The law with spin holds where both are positive.
/// </summary>
internal readonly struct DragJump
{
    private const double CriticalSpeedSquared = FittedDrag.CriticalSpeed * FittedDrag.CriticalSpeed;
    private const double SpinScale = 1.0 / (FittedDrag.CriticalSpin * FittedDrag.CriticalSpin);
    private const int Samples = 16;

    /// <summary>G, m²/s².</summary>
    public readonly double Speed;

    /// <summary>S, m²/s².</summary>
    public readonly double Spin;

    /// <param name="speedSquared">|u|², or its rate of change.</param>
    /// <param name="surfaceSpeedSquared">(r|ω|)², or its rate of change.</param>
    /// <param name="critical">v_c², or 0 for rates of change.</param>
    private DragJump(double speedSquared, double surfaceSpeedSquared, double critical)
    {
        Speed = speedSquared - critical;
        Spin = (SpinScale * surfaceSpeedSquared) - speedSquared;
    }

    /// <summary>Positive where the law with spin holds.</summary>
    public double Least => Speed < Spin ? Speed : Spin;

    /// <summary>Whether the ball is nearer to the critical speed than to the critical spin parameter.</summary>
    public bool NearerToSpeed => Math.Abs(Speed) < Math.Abs(Spin);

    /// <summary>The branch that holds here.</summary>
    public DragBranch Branch => Least > 0 ? DragBranch.Spinning : DragBranch.NoSpin;

    /// <summary>The surfaces' functions at a state.</summary>
    public static DragJump At(double speedSquared, double surfaceSpeedSquared) => new(speedSquared, surfaceSpeedSquared, CriticalSpeedSquared);

    /// <summary>Their rates of change.</summary>
    public static DragJump Rate(double speedSquaredRate, double surfaceSpeedSquaredRate) => new(speedSquaredRate, surfaceSpeedSquaredRate, 0);

    /// <summary>Whether a step may have crossed a surface: a quick test that errs towards yes.</summary>
    /// <param name="branch">The branch of the step.</param>
    /// <param name="from">At the step's start.</param>
    /// <param name="rate">Rates there.</param>
    /// <param name="to">At the step's end.</param>
    /// <param name="h">Length of the step, s.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool MayCross(DragBranch branch, in DragJump from, in DragJump rate, in DragJump to, double h)
    {
        double speedAhead = from.Speed + (h * rate.Speed);
        double spinAhead = from.Spin + (h * rate.Spin);
        return branch == DragBranch.Spinning
            ? !(to.Speed > 0 && to.Spin > 0 && speedAhead > 0 && spinAhead > 0)
            : (to.Speed > 0 || speedAhead > 0) && (to.Spin > 0 || spinAhead > 0);
    }

    /// <summary>The first crossing on the cubic Hermite interpolants of |u|² and |ω|², as a fraction of the step; above 1 where there is none.</summary>
    public static double FirstCrossing(DragBranch branch, in DragJump from, in DragJump fromRate, in DragJump to, in DragJump toRate, double h)
    {
        bool inside = branch == DragBranch.Spinning;
        double low = 0;
        for (int i = 1; i <= Samples; i++)
        {
            double high = (double)i / Samples;
            if (Interpolate(in from, in fromRate, in to, in toRate, h, high) > 0 != inside)
            {
                for (int k = 0; k < 50; k++)
                {
                    double middle = 0.5 * (low + high);
                    if (Interpolate(in from, in fromRate, in to, in toRate, h, middle) > 0 != inside)
                    {
                        high = middle;
                    }
                    else
                    {
                        low = middle;
                    }
                }

                return high;
            }

            low = high;
        }

        return 2.0;
    }

    private static double Interpolate(in DragJump from, in DragJump fromRate, in DragJump to, in DragJump toRate, double h, double s)
    {
        double speed = Hermite(from.Speed, h * fromRate.Speed, to.Speed, h * toRate.Speed, s);
        double spin = Hermite(from.Spin, h * fromRate.Spin, to.Spin, h * toRate.Spin, s);
        return speed < spin ? speed : spin;
    }

    private static double Hermite(double f0, double d0, double f1, double d1, double s)
    {
        double rise = f1 - f0;
        return f0 + (s * (d0 + (s * ((3.0 * rise) - (2.0 * d0) - d1 + (s * (d0 + d1 - (2.0 * rise)))))));
    }
}
