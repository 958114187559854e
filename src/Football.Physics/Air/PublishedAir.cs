using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>
/// The air by the published laws. The laws one by one are its definition; a step of flight takes the first of three forms that holds:
/// fused, for the spins of a kick; fused, for the spins of a bounce; the laws one by one.
/// </summary>
/// <typeparam name="TDrag">The published drag, or none.</typeparam>
/// <typeparam name="TMagnus">The published Magnus force, or none.</typeparam>
/// <typeparam name="TDecay">The published spin decay, or none.</typeparam>
internal struct PublishedAir<TDrag, TMagnus, TDecay> : ILawsAir
    where TDrag : struct, IAirLaw
    where TMagnus : struct, IAirLaw
    where TDecay : struct, IAirLaw
{
    private PublishedKernel<TDrag, TMagnus, TDecay> _kernel;
    private HighSpinKernel<TDrag, TMagnus, TDecay> _highSpin;
    private AirLaws<PublishedDragFit, TDrag, TMagnus, TDecay> _laws;

    public bool Drags
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => default(TDrag).Acts;
    }

    public bool Lifts
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => default(TMagnus).Acts;
    }

    public bool SpinDecays
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => default(TDecay).Acts;
    }

    public bool Jumps
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => default(TDrag).Acts || default(TMagnus).Acts;
    }

    public bool Varies
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public bool TurnsAxis
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public double FastestWind => 0;

    public RateBound Bound => _laws.Bound;

    public void Prepare(Scene scene)
    {
        _kernel = default;
        _highSpin = default;
        _laws = default;
        _kernel.Prepare(scene);
        _highSpin.Prepare(scene);
        _laws.Prepare(scene);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Covers(double speedSquared, double spinRate, double h) => _kernel.Covers(speedSquared, spinRate, h);

    public double WholeUpTo(in RateBound bound) => _kernel.WholeUpTo(in bound);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Fly<TIntegrator>(
        ref TIntegrator integrator,
        bool covered,
        double speedSquared,
        ref FlightMotion motion,
        in Vector3d wind,
        DragBranch branch,
        double upward,
        double h,
        out FlightStep step)
        where TIntegrator : struct, IIntegrator
    {
        if (covered)
        {
            integrator.Fly<PublishedKernel<TDrag, TMagnus, TDecay>, PublishedStep>(ref _kernel, ref motion, in wind, branch, upward, h, out step);
        }
        else if (_highSpin.Covers(speedSquared, motion.SpinRate, h))
        {
            integrator.Fly<HighSpinKernel<TDrag, TMagnus, TDecay>, PublishedStep>(ref _highSpin, ref motion, in wind, branch, upward, h, out step);
        }
        else
        {
            integrator.Fly<PublishedAir<TDrag, TMagnus, TDecay>, PointStep>(ref this, ref motion, in wind, branch, upward, h, out step);
        }
    }

    public double Evaluate(in ForceInput ball, DragBranch branch, out AirFactors factors) =>
        AirRates.Evaluate(ref this, in ball, branch, out factors);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Begin(double spinRate, DragBranch branch, out PointStep step) => step.Branch = branch;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AtStart(ref PointStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay) =>
        AtPoint(step.Branch, speedSquared, spinRate, out drag, out lift, out decay);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Expand(ref PointStep step, double speedChange, double spinChange)
    {
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AtStage(in PointStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay) =>
        AtPoint(step.Branch, speedSquared, spinRate, out drag, out lift, out decay);

    // Never inlined: one body for all the callers.
    [MethodImpl(MethodImplOptions.NoInlining | Hot.Path)]
    private void AtPoint(DragBranch branch, double speedSquared, double spinRate, out double drag, out double lift, out double decay)
    {
        if (!_kernel.TryAtPoint(branch, speedSquared, spinRate, out drag, out lift, out decay))
        {
            AtPointByLaws(branch, speedSquared, spinRate, out drag, out lift, out decay);
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void AtPointByLaws(DragBranch branch, double speedSquared, double spinRate, out double drag, out double lift, out double decay)
    {
        PointStep step;
        step.Branch = branch;
        _laws.AtStage(in step, speedSquared, spinRate, 0, out drag, out lift, out decay);
    }
}
