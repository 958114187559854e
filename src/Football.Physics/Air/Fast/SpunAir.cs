using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>
/// The published laws fused, for spins of any size, such as a bounce leaves behind: the two plates of the spin decay one by one, and a
/// lift that ends where the published one does.
/// </summary>
internal struct SpunAir<TDrag, TMagnus, TDecay> : IAerodynamics
    where TDrag : struct, IPresence
    where TMagnus : struct, IPresence
    where TDecay : struct, IPresence
{
    private PublishedAir<TDrag, TMagnus, Absent> _forces;
    private EmpiricalSpinDecay _decay;
    private FusedRange _range;
    private double _decayScale; // torque of the plates at |u| = 1 without spin, per I
    private double _quarterSquare; // r²/4

    public bool Drags
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _forces.Drags;
    }

    public bool Lifts
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _forces.Lifts;
    }

    public bool NeedsSpinAcross
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public bool Jumps
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _forces.Jumps;
    }

    public bool SpinDecays
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => default(TDecay).Is;
    }

    public RateBound Bound => _forces.Bound + (SpinDecays ? _decay.Bound : default);

    public void Prepare(Scene scene)
    {
        _forces.Prepare(scene);
        _decay.Prepare(scene);
        _range.Prepare(scene, _forces.Bound, double.PositiveInfinity);
        _quarterSquare = 0.25 * scene.Ball.Radius * scene.Ball.Radius;
        AirFlow unit = default;
        unit.Speed = 1;
        _decayScale = _decay.Factor(in unit);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Covers(double speedSquared, double spinRate, double h)
    {
        // (|u| + r|ω|/2)² ≤ 2 (|u|² + (r|ω|/2)²) bounds the sum of the plates.
        double plates = 2.0 * (speedSquared + (_quarterSquare * spinRate * spinRate));
        return _range.Holds(speedSquared, spinRate, h) && (!default(TDecay).Is || _range.Keeps(plates, spinRate, h, _decayScale));
    }

    public double WholeUpTo(in RateBound bound) => 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Begin(double spinRate, DragBranch branch, out AirStep step) => _forces.Begin(spinRate, branch, out step);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Evaluate(in AirStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay)
    {
        _forces.Evaluate(in step, speedSquared, spinRate, acrossSquared, out drag, out lift, out _);
        lift = lift > 0 ? lift : 0;
        decay = 0;
        if (default(TDecay).Is)
        {
            AirFlow flow = default;
            flow.Speed = Math.Sqrt(speedSquared);
            flow.SpinRate = spinRate;
            decay = _decay.Factor(in flow);
        }
    }

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
