using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>The air by its laws one by one: drag, Magnus force and spin decay, with one form of the fitted drag coefficient between them.</summary>
internal struct AirLaws<TFit, TDrag, TMagnus, TDecay> : ILawsAir
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

    public bool SpinDecays
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _decay.Acts;
    }

    public bool Jumps
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _fit.Jumps;
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
        where TIntegrator : struct, IIntegrator =>
        integrator.Fly<AirLaws<TFit, TDrag, TMagnus, TDecay>, PointStep>(ref this, ref motion, in wind, branch, upward, h, out step);

    public double Evaluate(in ForceInput ball, DragBranch branch, out AirFactors factors) =>
        AirRates.Evaluate(ref this, in ball, branch, out factors);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Begin(double spinRate, DragBranch branch, out PointStep step) => step.Branch = branch;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AtStart(ref PointStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay) =>
        AtStage(in step, speedSquared, spinRate, acrossSquared, out drag, out lift, out decay);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Expand(ref PointStep step, double speedChange, double spinChange)
    {
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AtStage(in PointStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay)
    {
        AirFlow flow = default;
        flow.SpeedSquared = speedSquared;
        flow.SpinRate = spinRate;
        flow.AcrossSquared = acrossSquared;
        Factors(ref flow, step.Branch, out drag, out lift, out decay);
    }

    /// <summary>Completes a flow, and asks the laws.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Factors(ref AirFlow flow, DragBranch branch, out double drag, out double lift, out double decay)
    {
        double spinRate = flow.SpinRate;
        if (_drag.NeedsSpeed || _magnus.NeedsSpeed || _decay.NeedsSpeed)
        {
            flow.Speed = Math.Sqrt(flow.SpeedSquared);
        }

        // A stage may overshoot zero spin: there the forces end, and the decay, even in ω, goes on smoothly.
        flow.SpinRate = spinRate > 0 ? spinRate : 0;
        if (flow.SpeedSquared > StillAir)
        {
            if (_drag.NeedsFit || _magnus.NeedsFit)
            {
                flow.SpinParameter = _radius * flow.SpinRate / flow.Speed;
                flow.FittedDragCoefficient = _fit.Coefficient(in flow, branch);
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
}
