using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>
/// The published laws fused, for spins of any size, such as a bounce leaves behind: the two plates of the spin decay one by one, and a
/// lift that ends where the published one does.
/// </summary>
internal struct HighSpinKernel<TDrag, TMagnus, TDecay> : IFusedKernel<PublishedStep>
    where TDrag : struct, IAirLaw
    where TMagnus : struct, IAirLaw
    where TDecay : struct, IAirLaw
{
    private PublishedKernel<TDrag, TMagnus, NoAirLaw> _forces;
    private TDecay _decay;
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

    public bool SpinDecays
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => default(TDecay).Acts;
    }

    public void Prepare(Scene scene)
    {
        _forces = default;
        _decay = default;
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
        return _range.Holds(speedSquared, spinRate, h) && (!default(TDecay).Acts || _range.Keeps(plates, spinRate, h, _decayScale));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Begin(double spinRate, DragBranch branch, out PublishedStep step) => _forces.Begin(spinRate, branch, out step);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AtStart(ref PublishedStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay) =>
        AtStage(in step, speedSquared, spinRate, acrossSquared, out drag, out lift, out decay);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Expand(ref PublishedStep step, double speedChange, double spinChange)
    {
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AtStage(in PublishedStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay)
    {
        _forces.ByTables(in step, speedSquared, spinRate, out drag, out lift, out _);
        lift = lift > 0 ? lift : 0;
        decay = 0;
        if (default(TDecay).Acts)
        {
            AirFlow flow = default;
            flow.Speed = Math.Sqrt(speedSquared);
            flow.SpinRate = spinRate;
            decay = _decay.Factor(in flow);
        }
    }
}
