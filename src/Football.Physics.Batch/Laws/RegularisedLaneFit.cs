using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>The fitted C_D with smoothed jumps, in lanes (<see cref="RegularisedDragFit"/>).</summary>
#if NET8_0_OR_GREATER
internal readonly struct RegularisedLaneFit<F> : ILaneDragFit<F>
    where F : struct, ILane<F>
#else
internal readonly struct RegularisedLaneFit<TLane> : ILaneDragFit<TLane>
#endif
{
    /// <summary>The |u|, in m/s, below which the spin parameter stays constant: the law with spin has no weight there.</summary>
    private const float Slowest = 1e-3f;

    public bool Jumps
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    // w = σ((|u| − v_c)/0.25) · σ((Sp − 0.05)/0.0025),  C_D = w c Sp^d + (1 − w) C_D,no spin
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public F Join<TBranch>(in TBranch branch, F speed, F surfaceSpeed, F withSpin, F withoutSpin)
        where TBranch : struct, ILaneBranch<F> => F.Plus(withoutSpin, Weight(speed, surfaceSpeed), withSpin - withoutSpin);

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static F Weight(F speed, F surfaceSpeed)
    {
        F one = F.Of(1f);
        F parameter = F.AtLeast(surfaceSpeed, default) / F.AtLeast(speed, F.Of(Slowest));
        F bySpeed = (F.Of((float)FittedDrag.CriticalSpeed) - speed) * F.Of((float)(Elementary.Log2E / RegularisedDragFit.SpeedWidth));
        F bySpin = (F.Of((float)FittedDrag.CriticalSpin) - parameter) * F.Of((float)(Elementary.Log2E / RegularisedDragFit.SpinWidth));
        F low = F.Of(-100f);
        F high = F.Of(60f);
        return one / ((one + LaneMath<F>.Exp2(F.AtMost(F.AtLeast(bySpeed, low), high)))
            * (one + LaneMath<F>.Exp2(F.AtMost(F.AtLeast(bySpin, low), high))));
    }
}
