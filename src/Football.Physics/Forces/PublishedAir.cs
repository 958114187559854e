using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>
/// The published laws fused into one evaluation without a square root or a division on its critical path: powers of |u|² from one
/// table index, powers of |ω| once a step. <see cref="Aerodynamics{TFit, TDrag, TMagnus, TDecay}"/> with the laws one by one is its
/// definition, and the tests compare the two over the whole domain.
/// </summary>
internal struct PublishedAir<TDrag, TMagnus, TDecay> : IAerodynamics
    where TDrag : struct, IPresence
    where TMagnus : struct, IPresence
    where TDecay : struct, IPresence
{
    /// <summary>Below this |u|² there is no drag and no lift.</summary>
    private const double StillAir = 1e-18;

    private static readonly PowerTable SpinForDrag = new(FittedDrag.D);
    private static readonly PowerTable SpinForLift = new(EmpiricalMagnus.Beta);

    private EmpiricalDrag _drag;
    private EmpiricalMagnus _magnus;
    private EmpiricalSpinDecay _decay;
    private double _dragScale;   // ½ ρ A / m
    private double _liftScale;   // ½ ρ A / m · 1.15/(C_D0 − a)
    private double _decayScale;  // torque of the plates at |u| = 1 without spin, per I
    private double _radius;
    private double _quarterSquare; // r²/4

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

    public bool Jumps
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => default(TDrag).Is || default(TMagnus).Is;
    }

    public bool SpinDecays
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => default(TDecay).Is;
    }

    public RateBound Bound => (Drags ? _drag.Bound : default) + (Lifts ? _magnus.Bound : default) + (SpinDecays ? _decay.Bound : default);

    public void Prepare(Scene scene)
    {
        _drag.Prepare(scene);
        _magnus.Prepare(scene);
        _decay.Prepare(scene);
        _radius = scene.Ball.Radius;
        _quarterSquare = 0.25 * _radius * _radius;
        _dragScale = AirScale.DynamicArea(scene);
        _liftScale = _dragScale * EmpiricalMagnus.Scale;
        AirFlow unit = default;
        unit.Speed = 1;
        _decayScale = _decay.Factor(in unit);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Begin(double spinRate, DragBranch branch, out AirStep step)
    {
        step.Branch = branch;
        step.Spin = spinRate;
        step.PerSpin = spinRate > 0 ? 1.0 / spinRate : 0;
        step.Drag = _dragScale;
        step.Lift = 0;
        step.LiftByDrag = 0;
        if (default(TDrag).Is || default(TMagnus).Is)
        {
            double surface = _radius * spinRate;
            double forDrag = FittedDrag.C * SpinForDrag.Of(surface);
            step.Drag = _dragScale * forDrag;
            if (default(TMagnus).Is)
            {
                double forLift = _liftScale * SpinForLift.Of(surface);
                step.Lift = forLift;
                step.LiftByDrag = forLift * forDrag;
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Evaluate(in AirStep step, double speedSquared, double spinRate, out double drag, out double lift, out double decay)
    {
        drag = 0;
        lift = 0;
        decay = 0;
        if ((default(TDrag).Is || default(TMagnus).Is) && speedSquared > StillAir)
        {
            // (1 + δ)^q to third order: the spin hardly changes within a step. A stage that overshoots zero spin has none.
            double delta = (spinRate - step.Spin) * step.PerSpin;
            if (delta < 5e-3 && delta > -5e-3)
            {
                double onDrag = 1.0 + (delta * (FittedDrag.D + (delta * (DragSecond + (delta * DragThird)))));
                double onLift = 1.0 + (delta * (EmpiricalMagnus.Beta + (delta * (LiftSecond + (delta * LiftThird)))));
                Forces(step.Branch, speedSquared, step.Drag * onDrag, step.Lift * onLift, step.LiftByDrag * (onLift * onDrag), out drag, out lift);
            }
            else
            {
                Begin(spinRate > 0 ? spinRate : 0, step.Branch, out AirStep fresh);
                Forces(step.Branch, speedSquared, fresh.Drag, fresh.Lift, fresh.LiftByDrag, out drag, out lift);
            }
        }

        if (default(TDecay).Is)
        {
            // (1 + x)^1.8 + (1 − x)^1.8 = 2 (1 + 0.72 x² + 0.0144 x⁴ + …), x = r|ω|/(2|u|)
            double plate = _quarterSquare * spinRate * spinRate;
            if (plate < LargestRatio * speedSquared)
            {
                double x = plate / speedSquared;
                decay = _decayScale * SpeedTable.Decay(speedSquared)
                    * (1.0 + (x * (0.72 + (x * (C4 + (x * (C6 + (x * (C8 + (x * (C10 + (x * C12))))))))))));
            }
            else
            {
                AirFlow flow = default;
                flow.Speed = Math.Sqrt(speedSquared);
                flow.SpinRate = Math.Abs(spinRate);
                decay = _decay.Factor(in flow);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Forces(DragBranch branch, double speedSquared, double forDrag, double forLift, double forLiftByDrag, out double drag, out double lift)
    {
        if (branch == DragBranch.Spinning)
        {
            // D = k c (r|ω|)^d |u|^(1−d),  L = k' (r|ω|)^β (C_D0 |u|^(1−β) − c (r|ω|)^d |u|^(1−β−d)), not below 0
            SpeedTable.WithSpin(speedSquared, out double byDrag, out double byLift, out double byBoth);
            drag = forDrag * byDrag;
            lift = default(TMagnus).Is ? (FittedDrag.AtRest * forLift * byLift) - (forLiftByDrag * byBoth) : 0;
            lift = lift > 0 ? lift : 0;
        }
        else
        {
            // D = k C_D |u|,  L = k' (r|ω|)^β (C_D0 − C_D) |u|^(1−β)
            SpeedTable.WithoutSpin(speedSquared, out double byDrag, out double byLift);
            drag = _dragScale * byDrag;
            lift = default(TMagnus).Is ? forLift * byLift : 0;
        }
    }

    private const double DragSecond = FittedDrag.D * (FittedDrag.D - 1) / 2;
    private const double DragThird = DragSecond * (FittedDrag.D - 2) / 3;
    private const double LiftSecond = EmpiricalMagnus.Beta * (EmpiricalMagnus.Beta - 1) / 2;
    private const double LiftThird = LiftSecond * (EmpiricalMagnus.Beta - 2) / 3;

    /// <summary>Up to this x² (Sp 0.8) the series below is good to 1e-9.</summary>
    private const double LargestRatio = 0.16;

    // Binomial coefficients of (1 + x)^1.8 at even orders.
    private const double C4 = 0.72 * (1.8 - 2) * (1.8 - 3) / 12;
    private const double C6 = C4 * (1.8 - 4) * (1.8 - 5) / 30;
    private const double C8 = C6 * (1.8 - 6) * (1.8 - 7) / 56;
    private const double C10 = C8 * (1.8 - 8) * (1.8 - 9) / 90;
    private const double C12 = C10 * (1.8 - 10) * (1.8 - 11) / 132;
}
