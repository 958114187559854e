using System.Runtime.CompilerServices;
using FootballPhysics.State;

namespace FootballPhysics.Laws;

/// <summary>The two surfaces at which the published drag law jumps, as functions of |u|² and (r|ω|)².</summary>
/// <remarks>G = |u|² − v_c² and S = 400 (r|ω|)² − |u|² (Sp = 0.05). The law with spin holds where both are positive.</remarks>
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
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private DragJump(double speedSquared, double surfaceSpeedSquared, double critical)
    {
        Speed = speedSquared - critical;
        Spin = (SpinScale * surfaceSpeedSquared) - speedSquared;
    }

    /// <summary>The smaller of G and S; positive if the law with spin applies.</summary>
    public double Least => Speed < Spin ? Speed : Spin;

    /// <summary>True if the critical speed is nearer than the critical spin parameter.</summary>
    public bool NearerToSpeed => Math.Abs(Speed) < Math.Abs(Spin);

    /// <summary>The branch of the law at this state.</summary>
    public DragBranch Branch => Least > 0 ? DragBranch.Spinning : DragBranch.NoSpin;

    /// <summary>Returns the surface functions at a state.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static DragJump At(double speedSquared, double surfaceSpeedSquared) => new(speedSquared, surfaceSpeedSquared, CriticalSpeedSquared);

    /// <summary>Chooses the branch for a piece: the previous one if the law does not jump, or if the jump is located and that branch is known.</summary>
    /// <param name="jumps">True if the law jumps.</param>
    /// <param name="locates">True if pieces end at the jump, so that they keep their branch.</param>
    /// <param name="last">The previous branch.</param>
    /// <param name="speedSquared">|u|².</param>
    /// <param name="surfaceSpeedSquared">(r|ω|)².</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static DragBranch Choose(bool jumps, bool locates, DragBranch last, double speedSquared, double surfaceSpeedSquared) =>
        !jumps || (locates && last != DragBranch.Unknown) ? last : At(speedSquared, surfaceSpeedSquared).Branch;

    /// <summary>Returns the branch at a state; unknown if the law does not jump.</summary>
    public static DragBranch BranchAt(bool jumps, double speedSquared, double surfaceSpeedSquared) =>
        Choose(jumps, locates: false, DragBranch.Unknown, speedSquared, surfaceSpeedSquared);

    /// <summary>Returns the rates of the surface functions.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static DragJump Rate(double speedSquaredRate, double surfaceSpeedSquaredRate) => new(speedSquaredRate, surfaceSpeedSquaredRate, 0);

    /// <summary>Returns the surface functions for a general motion.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static DragJump At(in Motion at, in Vector3d wind, double radius) =>
        At((at.Velocity - wind).LengthSquared, radius * radius * at.Spin.LengthSquared);

    /// <summary>Returns the rates: d|u|²/dt = 2 u·a, d(r|ω|)²/dt = 2 r² ω·ω̇.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static DragJump Rate(in Motion at, in MotionRates rates, in Vector3d wind, double radius) => Rate(
        2.0 * Vector3d.Dot(at.Velocity - wind, rates.Acceleration), 2.0 * radius * radius * Vector3d.Dot(at.Spin, rates.SpinAcceleration));

    /// <summary>Returns a bound on both rates for vectors of these lengths: 2 |u| |a| + 2 r² |ω| |ω̇| / 0.05².</summary>
    public static double RateScale(in Motion at, in MotionRates rates, in Vector3d wind, double radius) => 2.0 * (
        Math.Sqrt((at.Velocity - wind).LengthSquared * rates.Acceleration.LengthSquared)
        + (SpinScale * radius * radius * Math.Sqrt(at.Spin.LengthSquared * rates.SpinAcceleration.LengthSquared)));

    /// <summary>Returns true if a step may have crossed a surface: a quick, conservative test.</summary>
    /// <param name="branch">The branch of the step.</param>
    /// <param name="from">The surface functions at the start of the step.</param>
    /// <param name="rate">Their rates at the start.</param>
    /// <param name="to">The surface functions at the end of the step.</param>
    /// <param name="h">The length of the step, in s.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool MayCross(DragBranch branch, in DragJump from, in DragJump rate, in DragJump to, double h)
    {
        // Also extrapolate from the start, because a step may cross a surface and return.
        double speedAhead = from.Speed + (h * rate.Speed);
        double spinAhead = from.Spin + (h * rate.Spin);
        if (branch == DragBranch.Spinning)
        {
            return !(to.Speed > 0 && to.Spin > 0 && speedAhead > 0 && spinAhead > 0);
        }

        // Both must be positive at the same instant: both at a later time, or one before it falls and the other after it rises.
        bool speedLater = to.Speed > 0 || speedAhead > 0;
        bool spinLater = to.Spin > 0 || spinAhead > 0;
        return (speedLater && spinLater) || (spinLater && from.Speed > 0 && from.Spin <= 0) || (speedLater && from.Spin > 0 && from.Speed <= 0);
    }

    /// <summary>Returns the first crossing on the cubic Hermite interpolants, as a fraction of the step; above 1 if there is none.</summary>
    /// <param name="branch">The branch of the step.</param>
    /// <param name="from">The surface functions at the start of the step.</param>
    /// <param name="fromRate">Their rates at the start.</param>
    /// <param name="to">The surface functions at the end of the step.</param>
    /// <param name="toRate">Their rates at the end.</param>
    /// <param name="h">The length of the step, in s.</param>
    /// <param name="bySpeed">True if the step crosses the critical speed, false for the critical spin parameter.</param>
    public static double FirstCrossing(
        DragBranch branch, in DragJump from, in DragJump fromRate, in DragJump to, in DragJump toRate, double h, out bool bySpeed)
    {
        bool inside = branch == DragBranch.Spinning;
        var path = new JumpPath(in from, in fromRate, in to, in toRate, h);
        double low = 0;

        // Sample first, because a step may enter the law with spin and leave it again between its ends.
        for (int i = 1; i <= Samples; i++)
        {
            double high = (double)i / Samples;
            if (path.IsInside(high) != inside || (!inside && path.PassesThrough(low, ref high)))
            {
                path.Narrow(ref low, ref high, inside);

                // The crossed surface is the one with the smaller function value.
                bySpeed = path.Speed(high) < path.Spin(high);
                return high;
            }

            low = high;
        }

        bySpeed = false;
        return 2.0;
    }
}
