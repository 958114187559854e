using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>
/// The air by a smooth law. The law's functions, asked point by point, are its definition; a step of flight takes them from tables where
/// those hold.
/// </summary>
/// <typeparam name="TLaw">The law.</typeparam>
/// <typeparam name="TDrag">Its drag, or none.</typeparam>
/// <typeparam name="TMagnus">Its Magnus force, or none.</typeparam>
/// <typeparam name="TDecay">Its spin decay, or none.</typeparam>
internal struct SmoothAir<TLaw, TDrag, TMagnus, TDecay> : ILawsAir
    where TLaw : struct, ISmoothLaw
    where TDrag : struct, IAirLaw
    where TMagnus : struct, IAirLaw
    where TDecay : struct, IAirLaw
{
    /// <summary>Below this |u|, m/s, there is no drag and no lift, and the spin decays as it does there.</summary>
    private const double StillAir = 1e-9;

    private SmoothKernel<TLaw, TDrag, TMagnus, TDecay> _kernel;
    private TLaw _law;
    private double _radius;

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
        get => false;
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

    public RateBound Bound =>
        (Drags ? _law.DragBound(2.0 * Limits.Speed) : default) + (Lifts ? _law.LiftBound : default) + (SpinDecays ? _law.DecayBound : default);

    public void Prepare(Scene scene)
    {
        _kernel = default;
        _kernel.Prepare(scene);
        _law = default;
        _law.Prepare(scene);
        _radius = scene.Ball.Radius;
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
            integrator.Fly<SmoothKernel<TLaw, TDrag, TMagnus, TDecay>, PointStep>(ref _kernel, ref motion, in wind, branch, upward, h, out step);
        }
        else
        {
            integrator.Fly<SmoothAir<TLaw, TDrag, TMagnus, TDecay>, PointStep>(ref this, ref motion, in wind, branch, upward, h, out step);
        }
    }

    public double Evaluate(in ForceInput ball, DragBranch branch, out AirFactors factors) =>
        AirRates.Evaluate(ref this, in ball, branch, out factors);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Begin(double spinRate, DragBranch branch, out PointStep step) => step.Branch = branch;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AtStart(ref PointStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay) =>
        AtPoint(step, speedSquared, spinRate, acrossSquared, out drag, out lift, out decay);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Expand(ref PointStep step, double speedChange, double spinChange)
    {
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AtStage(in PointStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay) =>
        AtPoint(step, speedSquared, spinRate, acrossSquared, out drag, out lift, out decay);

    /// <summary>The law by its functions themselves.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public void ByFunctions(double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay)
    {
        double speed = Math.Sqrt(speedSquared);
        bool moves = speed > StillAir;
        speed = moves ? speed : StillAir;
        double across = _law.NeedsSpinAcross && moves ? Math.Sqrt(acrossSquared) / speed : 1.0;

        // A stage may overshoot zero spin: there the forces end, and the decay goes on.
        double spin = spinRate > 0 ? spinRate : 0;
        _law.OfSpeed(_law.SpeedScale * speed, out LawFactors bySpeed);
        _law.OfSpin(_radius * spin * across / speed, out LawFactors bySpin);
        _law.Combine(in bySpeed, in bySpin, speed, spinRate, out drag, out lift, out decay);
        drag = moves ? drag : 0;
        lift = moves && spinRate > 0 ? lift : 0;
    }

    // Never inlined: one body for all the callers.
    [MethodImpl(MethodImplOptions.NoInlining | Hot.Path)]
    private void AtPoint(PointStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay)
    {
        if (!_kernel.TryAtPoint(in step, speedSquared, spinRate, acrossSquared, out drag, out lift, out decay))
        {
            ByFunctions(speedSquared, spinRate, acrossSquared, out drag, out lift, out decay);
        }

        drag = Drags ? drag : 0;
        lift = Lifts ? lift : 0;
        decay = SpinDecays ? decay : 0;
    }
}
