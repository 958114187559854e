using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>
/// The fused laws where they hold, point by point, and the laws one by one elsewhere: for motions that no constant axis or no bound of
/// a step describes.
/// </summary>
/// <typeparam name="TFast">The fused laws.</typeparam>
/// <typeparam name="TLaws">The laws one by one.</typeparam>
internal struct EitherAir<TFast, TLaws> : IAerodynamics
    where TFast : struct, IFusedAir
    where TLaws : struct, IAerodynamics
{
    private TFast _fast;
    private TLaws _laws;

    public bool Drags
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _laws.Drags;
    }

    public bool Lifts
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _laws.Lifts;
    }

    public bool NeedsSpinAcross
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _laws.NeedsSpinAcross;
    }

    public bool Jumps
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _laws.Jumps;
    }

    public bool SpinDecays
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _laws.SpinDecays;
    }

    public RateBound Bound => _laws.Bound;

    public void Prepare(Scene scene)
    {
        _fast = default;
        _laws = default;
        _fast.Prepare(scene);
        _laws.Prepare(scene);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Covers(double speedSquared, double spinRate, double h) => true;

    public double WholeUpTo(in RateBound bound) => 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Begin(double spinRate, DragBranch branch, out AirStep step)
    {
        step = default;
        step.Branch = branch;
    }

    // Never inlined: one body for all the callers, who are not the hot path.
    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Evaluate(in AirStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay)
    {
        if (!_fast.EvaluateAt(step.Branch, speedSquared, spinRate, acrossSquared, out drag, out lift, out decay))
        {
            EvaluateLaws(in step, speedSquared, spinRate, acrossSquared, out drag, out lift, out decay);
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void EvaluateLaws(in AirStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay) =>
        _laws.Evaluate(in step, speedSquared, spinRate, acrossSquared, out drag, out lift, out decay);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void EvaluateStart(ref AirStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay) =>
        Evaluate(in step, speedSquared, spinRate, acrossSquared, out drag, out lift, out decay);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Expand(in AirStep step, double speedChange, double spinChange, out AirSeries series)
    {
        Unsafe.SkipInit(out series);
        return false;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void EvaluateNear(in AirSeries series, double speedSquared, double spinRate, out double drag, out double lift, out double decay)
    {
        drag = 0;
        lift = 0;
        decay = 0;
    }
}
