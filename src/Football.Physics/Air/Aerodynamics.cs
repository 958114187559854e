using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>Drag, Magnus force and spin decay by one law each, with one form of the fitted drag coefficient between them.</summary>
internal struct Aerodynamics<TFit, TDrag, TMagnus, TDecay> : IAerodynamics
    where TFit : struct, IDragFit
    where TDrag : struct, IAirLaw
    where TMagnus : struct, IAirLaw
    where TDecay : struct, IAirLaw
{
    /// <summary>Below this |u|² there is no drag and no lift.</summary>
    private const double StillAir = 1e-18;

    // Not readonly, and no readonly members: a call through a type parameter would copy the law first.
    private TFit _fit;
    private TDrag _drag;
    private TMagnus _magnus;
    private TDecay _decay;
    private double _radius;

    public bool Drags
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _drag.Acts;
    }

    public bool Lifts
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _magnus.Acts;
    }

    public bool NeedsSpinAcross
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public bool Jumps
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _fit.Jumps;
    }

    public bool SpinDecays
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _decay.Acts;
    }

    public RateBound Bound => _drag.Bound + _magnus.Bound + _decay.Bound;

    public void Prepare(Scene scene)
    {
        _fit = default;
        _drag = default;
        _magnus = default;
        _decay = default;
        _drag.Prepare(scene);
        _magnus.Prepare(scene);
        _decay.Prepare(scene);
        _radius = scene.Ball.Radius;
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

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Evaluate(in AirStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay)
    {
        AirFlow flow = default;
        flow.SpeedSquared = speedSquared;
        if (_drag.NeedsSpeed || _magnus.NeedsSpeed || _decay.NeedsSpeed)
        {
            flow.Speed = Math.Sqrt(speedSquared);
        }

        // A stage may overshoot zero spin: there the forces end, and the decay, even in ω, goes on smoothly.
        flow.SpinRate = spinRate > 0 ? spinRate : 0;
        if (speedSquared > StillAir)
        {
            if (_drag.NeedsFit || _magnus.NeedsFit)
            {
                flow.SpinParameter = _radius * flow.SpinRate / flow.Speed;
                flow.FittedDragCoefficient = _fit.Coefficient(in flow, step.Branch);
            }

            drag = _drag.Factor(in flow);
            lift = _magnus.Factor(in flow);
        }
        else
        {
            drag = 0;
            lift = 0;
        }

        flow.SpinRate = Math.Abs(spinRate);
        decay = _decay.Factor(in flow);
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
