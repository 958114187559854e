using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>
/// The published laws fused into one evaluation without a square root or a division on its critical path: powers of |u|² from one
/// table index, powers of |ω| once a step. It holds where <see cref="Covers"/> says so; elsewhere the laws one by one are asked. <see cref="Aerodynamics{TFit, TDrag, TMagnus, TDecay}"/> with the laws one by one is its
/// definition, and the tests compare the two over the whole domain.
/// </summary>
internal struct PublishedAir<TDrag, TMagnus, TDecay> : IAerodynamics
    where TDrag : struct, IPresence
    where TMagnus : struct, IPresence
    where TDecay : struct, IPresence
{
    /// <summary>Speeds, m/s, beyond which the tables end; a step may not come near them.</summary>
    private const double Slowest = 0.75;
    private const double Fastest = 120;

    /// <summary>How much slower a ball may become within a step, m/s²: gravity and drag at speeds where that matters.</summary>
    private const double Deceleration = 30;

    /// <summary>Up to this (r|ω|/2|u|)² (Sp 0.7) the series of the decay is good to 1e-9.</summary>
    private const double LargestRatio = 0.12;

    /// <summary>A spin may lose this share within a step, for its powers are then good to 5e-9.</summary>
    private const double LargestLoss = 0.02;

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

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Covers(double speedSquared, double spinRate, double h)
    {
        double least = Slowest + (Deceleration * h);
        return speedSquared > least * least && speedSquared < Fastest * Fastest
            && _quarterSquare * spinRate * spinRate < LargestRatio * speedSquared
            && (!default(TDecay).Is || spinRate * LargestLoss >= h * _decayScale * speedSquared || spinRate == 0);
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
        step.Decay = spinRate > 0 ? _decayScale : 0;
        step.Drag = _dragScale;
        step.Lift = 0;
        step.LiftByDrag = 0;
        if (default(TDrag).Is || default(TMagnus).Is)
        {
            SpeedTable.OfSpin(_radius * spinRate, out double powerForDrag, out double powerForLift);
            double forDrag = FittedDrag.C * powerForDrag;
            double forLift = _liftScale * powerForLift;
            step.Drag = _dragScale * forDrag;
            step.Lift = forLift;
            step.LiftByDrag = forLift * forDrag;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Evaluate(in AirStep step, double speedSquared, double spinRate, out double drag, out double lift, out double decay)
    {
        drag = 0;
        lift = 0;
        decay = 0;
        if (default(TDrag).Is || default(TMagnus).Is)
        {
            // (1 + δ)^q to third order: the spin hardly changes within a step.
            double delta = (spinRate - step.Spin) * step.PerSpin;
            double onLift = 1.0 + (delta * (EmpiricalMagnus.Beta + (delta * (LiftSecond + (delta * LiftThird)))));
            if (step.Branch == DragBranch.Spinning)
            {
                // D = k c (r|ω|)^d |u|^(1−d),  L = k' (r|ω|)^β (C_D0 |u|^(1−β) − c (r|ω|)^d |u|^(1−β−d)): above 0 up to Sp 1.88
                double onDrag = 1.0 + (delta * (FittedDrag.D + (delta * (DragSecond + (delta * DragThird)))));
                drag = step.Drag * onDrag;
                double forLift = FittedDrag.AtRest * step.Lift * onLift;
                double forBoth = step.LiftByDrag * (onLift * onDrag);
                SpeedTable.WithSpin(speedSquared, ref drag, ref forLift, ref forBoth);
                if (default(TMagnus).Is)
                {
                    lift = forLift - forBoth;
                }
            }
            else
            {
                // D = k C_D |u|,  L = k' (r|ω|)^β (C_D0 − C_D) |u|^(1−β)
                SpeedTable.WithoutSpin(speedSquared, out double byDrag, out double byLift);
                drag = _dragScale * byDrag;
                if (default(TMagnus).Is)
                {
                    lift = step.Lift * onLift * byLift;
                }
            }
        }

        if (default(TDecay).Is)
        {
            // (1 + x)^1.8 + (1 − x)^1.8 = 2 (1 + 0.72 x² + 0.0144 x⁴ + …), x = r|ω|/(2|u|)
            double x = _quarterSquare * spinRate * spinRate / speedSquared;
            decay = step.Decay * SpeedTable.Decay(speedSquared) * (1.0 + (x * (0.72 + (x * (C4 + (x * (C6 + (x * (C8 + (x * (C10 + (x * C12))))))))))));
        }
    }

    private const double DragSecond = FittedDrag.D * (FittedDrag.D - 1) / 2;
    private const double DragThird = DragSecond * (FittedDrag.D - 2) / 3;
    private const double LiftSecond = EmpiricalMagnus.Beta * (EmpiricalMagnus.Beta - 1) / 2;
    private const double LiftThird = LiftSecond * (EmpiricalMagnus.Beta - 2) / 3;

    // Binomial coefficients of (1 + x)^1.8 at even orders.
    private const double C4 = 0.72 * (1.8 - 2) * (1.8 - 3) / 12;
    private const double C6 = C4 * (1.8 - 4) * (1.8 - 5) / 30;
    private const double C8 = C6 * (1.8 - 6) * (1.8 - 7) / 56;
    private const double C10 = C8 * (1.8 - 8) * (1.8 - 9) / 90;
    private const double C12 = C10 * (1.8 - 10) * (1.8 - 11) / 132;
}
