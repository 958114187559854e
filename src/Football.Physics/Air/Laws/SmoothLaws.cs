using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>A smooth law point by point, by its functions themselves, wherever the ball is.</summary>
/// <typeparam name="TLaw">The law.</typeparam>
/// <typeparam name="TDrag">Whether drag acts.</typeparam>
/// <typeparam name="TMagnus">Whether the Magnus force acts.</typeparam>
/// <typeparam name="TDecay">Whether spin decays.</typeparam>
internal struct SmoothLaws<TLaw, TDrag, TMagnus, TDecay> : IAerodynamics
    where TLaw : struct, ISmoothLaw
    where TDrag : struct, IPresence
    where TMagnus : struct, IPresence
    where TDecay : struct, IPresence
{
    /// <summary>Below this |u|, m/s, there is no drag and no lift, and the spin decays as it does there.</summary>
    private const double StillAir = 1e-9;

    private TLaw _law;
    private double _radius;

    public bool Drags
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => default(TDrag).Is;
    }

    public bool Lifts
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => default(TMagnus).Is;
    }

    public bool NeedsSpinAcross
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _law.NeedsSpinAcross;
    }

    public bool Jumps
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public bool SpinDecays
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => default(TDecay).Is;
    }

    public RateBound Bound =>
        (Drags ? _law.DragBound(2.0 * Limits.Speed) : default) + (Lifts ? _law.LiftBound : default) + (SpinDecays ? _law.DecayBound : default);

    public void Prepare(Scene scene)
    {
        _law = default;
        _law.Prepare(scene);
        _radius = scene.Ball.Radius;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Covers(double speedSquared, double spinRate, double h) => true;

    public double WholeUpTo(in RateBound bound) => 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Begin(double spinRate, DragBranch branch, out AirStep step) => step = default;

    public void Evaluate(
        in AirStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay)
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

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void EvaluateStart(
        ref AirStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay) =>
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
