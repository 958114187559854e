using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>
/// The published laws fused into one evaluation without a square root or a division on its critical path: powers of |u|² from one
/// table index, powers of |ω| once a step. It holds where <see cref="Covers"/> says so. <see cref="AirLaws{TFit, TDrag, TMagnus, TDecay}"/>
/// with the laws one by one is its definition, and the tests compare the two over the whole domain.
/// </summary>
internal struct PublishedKernel<TDrag, TMagnus, TDecay> : IFusedKernel<PublishedStep>
    where TDrag : struct, IAirLaw
    where TMagnus : struct, IAirLaw
    where TDecay : struct, IAirLaw
{
    private const double SlowestPoint = 0.5;

    /// <summary>Up to this (r|ω|/2|u|)², Sp 1.04, a little more than that of a ball that rolls, the polynomial of the decay is good to 5e-11; there the lift is above 0.</summary>
    private const double LargestRatio = 0.27;

    /// <summary>The series about a step's start are good to 4e-9, that of the small decay to 3e-6, for changes of |u|² by this share.</summary>
    private const double Farthest = 1.0 / 32;

    /// <summary>And for changes of |ω| by this share.</summary>
    private const double FarthestSpin = 1.0 / 1024;

    private TDrag _drag;
    private TMagnus _magnus;
    private TDecay _decay;
    private FusedRange _range;
    private double _dragScale;   // ½ ρ A / m
    private double _liftScale;   // ½ ρ A / m · 1.15/(C_D0 − a)
    private double _decayScale;  // torque of the plates at |u| = 1 without spin, per I
    private double _radius;
    private double _quarterSquare; // r²/4

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

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Covers(double speedSquared, double spinRate, double h)
    {
        return _range.Holds(speedSquared, spinRate, h)
            && _quarterSquare * spinRate * spinRate < LargestRatio * speedSquared
            && (!default(TDecay).Acts || _range.Keeps(speedSquared, spinRate, h, _decayScale));
    }

    /// <summary>The fastest spin, rad/s, that is covered at any speed.</summary>
    private double FastestSpin => Math.Sqrt(LargestRatio / _quarterSquare) * FusedRange.Fastest;

    /// <inheritdoc cref="IAir.Bound"/>
    public RateBound Bound => _drag.Bound + _magnus.Bound + _decay.Bound;

    public void Prepare(Scene scene)
    {
        _drag = default;
        _magnus = default;
        _decay = default;
        _drag.Prepare(scene);
        _magnus.Prepare(scene);
        _decay.Prepare(scene);
        SpeedTable.Make();
        PlateSeries.Make();
        _radius = scene.Ball.Radius;
        _quarterSquare = 0.25 * _radius * _radius;
        _range.Prepare(scene, _drag.Bound + _magnus.Bound, FastestSpin);
        _dragScale = AirScale.DynamicArea(scene);
        _liftScale = _dragScale * EmpiricalMagnus.Scale;
        AirFlow unit = default;
        unit.Speed = 1;
        _decayScale = _decay.Factor(in unit);
    }

    /// <inheritdoc cref="IAir.WholeUpTo"/>
    public double WholeUpTo(in RateBound bound) => 0.5 / ((bound.PerSpeed * FusedRange.Fastest) + (bound.PerSpin * FastestSpin) + bound.Constant);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Begin(double spinRate, DragBranch branch, out PublishedStep step)
    {
        Unsafe.SkipInit(out step);
        step.Branch = branch;
        step.Near = false;
        step.Spin = spinRate;
        step.PerSpin = spinRate > AirRates.NoSpin ? 1.0 / spinRate : 0;
        step.Decay = spinRate > 0 ? _decayScale : 0;
        step.Drag = _dragScale;
        step.Lift = 0;
        step.LiftByDrag = 0;
        if (default(TDrag).Acts || default(TMagnus).Acts)
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
    public void AtStage(in PublishedStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay)
    {
        if (step.Near)
        {
            BySeries(in step.Series, speedSquared, spinRate, out drag, out lift, out decay);
        }
        else
        {
            ByTables(in step, speedSquared, spinRate, out drag, out lift, out decay);
        }
    }

    /// <summary>The factors anywhere in the domain, the spin being close to that of the step's start.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void ByTables(in PublishedStep step, double speedSquared, double spinRate, out double drag, out double lift, out double decay)
    {
        drag = 0;
        lift = 0;
        decay = 0;
        if (default(TDrag).Acts || default(TMagnus).Acts)
        {
            // (1 + δ)^q to third order: the spin hardly changes within a step.
            double delta = (spinRate - step.Spin) * step.PerSpin;
            double onLift = 1.0 + (delta * (EmpiricalMagnus.Beta + (delta * (PublishedBinomials.LiftSecond + (delta * PublishedBinomials.LiftThird)))));
            if (step.Branch == DragBranch.Spinning)
            {
                // D = k c (r|ω|)^d |u|^(1−d),  L = k' (r|ω|)^β (C_D0 |u|^(1−β) − c (r|ω|)^d |u|^(1−β−d))
                double onDrag = 1.0 + (delta * (FittedDrag.D + (delta * (PublishedBinomials.DragSecond + (delta * PublishedBinomials.DragThird)))));
                drag = step.Drag * onDrag;
                double forLift = FittedDrag.AtRest * step.Lift * onLift;
                double forBoth = step.LiftByDrag * (onLift * onDrag);
                SpeedTable.WithSpin(speedSquared, ref drag, ref forLift, ref forBoth);
                drag = default(TDrag).Acts ? drag : 0;
                if (default(TMagnus).Acts)
                {
                    lift = forLift - forBoth;
                }
            }
            else
            {
                // D = k C_D |u|,  L = k' (r|ω|)^β (C_D0 − C_D) |u|^(1−β)
                SpeedTable.WithoutSpin(speedSquared, out double byDrag, out double byLift);
                drag = default(TDrag).Acts ? _dragScale * byDrag : 0;
                if (default(TMagnus).Acts)
                {
                    lift = step.Lift * onLift * byLift;
                }
            }
        }

        if (default(TDecay).Acts)
        {
            // (1 + x)^1.8 + (1 − x)^1.8 = 2 (1 + 0.72 x² + 0.0144 x⁴ + …), x = r|ω|/(2|u|)
            double x = _quarterSquare * spinRate * spinRate / speedSquared;
            decay = step.Decay * SpeedTable.Decay(speedSquared) * (1.0 + (x * PlateSeries.At(x)));
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AtStart(ref PublishedStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay)
    {
        drag = 0;
        lift = 0;
        decay = 0;
        step.SpeedSquared = speedSquared;
        if (default(TDrag).Acts || default(TMagnus).Acts)
        {
            if (step.Branch == DragBranch.Spinning)
            {
                drag = step.Drag;
                double forLift = FittedDrag.AtRest * step.Lift;
                double forBoth = step.LiftByDrag;
                SpeedTable.WithSpin(speedSquared, ref drag, ref forLift, ref forBoth);
                step.StartDrag = drag;
                drag = default(TDrag).Acts ? drag : 0;
                step.StartLift = forLift;
                step.StartLiftByDrag = forBoth;
                if (default(TMagnus).Acts)
                {
                    lift = forLift - forBoth;
                }
            }
            else
            {
                SpeedTable.WithoutSpin(speedSquared, out double byDrag, out double byLift);
                drag = default(TDrag).Acts ? _dragScale * byDrag : 0;
                if (default(TMagnus).Acts)
                {
                    lift = step.Lift * byLift;
                }
            }
        }

        if (default(TDecay).Acts)
        {
            double x = _quarterSquare * spinRate * spinRate / speedSquared;
            double withoutSpin = step.Decay * SpeedTable.Decay(speedSquared);
            step.StartRatio = x;
            step.StartDecay = withoutSpin;
            decay = withoutSpin * (1.0 + (x * PlateSeries.At(x)));
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Expand(ref PublishedStep step, double speedChange, double spinChange)
    {
        step.Near = (default(TDrag).Acts || default(TMagnus).Acts) && step.Branch == DragBranch.Spinning
            && speedChange <= Farthest * step.SpeedSquared && spinChange <= FarthestSpin * step.Spin;
        if (!step.Near)
        {
            return;
        }

        ref PublishedSeries series = ref step.Series;
        series.PerSpeedSquared = 1.0 / step.SpeedSquared;
        series.PerSpin = step.PerSpin;

        // |u|^(1−d) and so on: (1 + ε)^p with p = (1 − d)/2
        series.Drag.A = step.StartDrag;
        series.Drag.B = PublishedBinomials.OfDrag1 * step.StartDrag;
        series.Drag.C = PublishedBinomials.OfDrag2 * step.StartDrag;
        series.Drag.D = PublishedBinomials.OfDrag3 * step.StartDrag;
        series.Drag.E = PublishedBinomials.OfDrag4 * step.StartDrag;
        if (default(TMagnus).Acts)
        {
            series.Lift.A = step.StartLift - step.StartLiftByDrag;
            series.LiftByDrag1 = PublishedBinomials.OfLiftByDrag1 * step.StartLiftByDrag;
            series.LiftByDrag2 = PublishedBinomials.OfLiftByDrag2 * step.StartLiftByDrag;
            series.Lift.B = (PublishedBinomials.OfLift1 * step.StartLift) - series.LiftByDrag1;
            series.Lift.C = (PublishedBinomials.OfLift2 * step.StartLift) - series.LiftByDrag2;
            series.Lift.D = (PublishedBinomials.OfLift3 * step.StartLift) - (PublishedBinomials.OfLiftByDrag3 * step.StartLiftByDrag);
            series.Lift.E = (PublishedBinomials.OfLift4 * step.StartLift) - (PublishedBinomials.OfLiftByDrag4 * step.StartLiftByDrag);
            series.LiftByDrag0 = step.StartLiftByDrag;
        }

        if (default(TDecay).Acts)
        {
            // |u|^1.8 G(X), X = X₀ (1 + δ)²/(1 + ε): G is linear enough
            double x = step.StartRatio;
            double whole = step.StartDecay * (1.0 + (x * PlateSeries.At(x)));
            double slope = step.StartDecay * (x * PlateSeries.SlopeAt(x));
            series.Decay0 = whole;
            series.Decay1 = (PublishedBinomials.OfDecay1 * whole) - slope;
            series.Decay2 = (PublishedBinomials.OfDecay2 * whole) + ((1.0 - PublishedBinomials.OfDecay1) * slope);
            series.Decay3 = (PublishedBinomials.OfDecay3 * whole) - ((1.0 - PublishedBinomials.OfDecay1 + PublishedBinomials.OfDecay2) * slope);
            series.DecayBySpin = 2.0 * slope;
        }
    }

    /// <summary>The factors by the series about the step's start.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void BySeries(in PublishedSeries series, double speedSquared, double spinRate, out double drag, out double lift, out double decay)
    {
        double e = (speedSquared * series.PerSpeedSquared) - 1.0;
        double ee = e * e;
        double delta = (spinRate * series.PerSpin) - 1.0;
        double more = delta * (FittedDrag.D + (delta * PublishedBinomials.DragSecond)); // (1 + δ)^d − 1
        drag = default(TDrag).Acts ? series.Drag.At(e, ee) * (1.0 + more) : 0;
        lift = 0;
        decay = 0;
        if (default(TMagnus).Acts)
        {
            double byDrag = series.LiftByDrag0 + (series.LiftByDrag1 * e) + (series.LiftByDrag2 * ee);
            lift = (1.0 + (delta * (EmpiricalMagnus.Beta + (delta * PublishedBinomials.LiftSecond)))) * (series.Lift.At(e, ee) - (more * byDrag));
        }

        if (default(TDecay).Acts)
        {
            decay = series.Decay0 + (series.Decay1 * e) + (ee * (series.Decay2 + (series.Decay3 * e))) + (series.DecayBySpin * delta);
        }
    }

    /// <summary>The factors at a point by itself, at any spin.</summary>
    /// <param name="branch">The branch of the drag law.</param>
    /// <param name="speedSquared">|u|², m²/s².</param>
    /// <param name="spinRate">|ω|, rad/s.</param>
    /// <param name="drag">D, 1/s.</param>
    /// <param name="lift">L, 1/s.</param>
    /// <param name="decay">Angular deceleration, rad/s².</param>
    /// <returns>False where the tables do not hold.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool TryAtPoint(DragBranch branch, double speedSquared, double spinRate, out double drag, out double lift, out double decay)
    {
        if (!(spinRate > 0 && speedSquared > SlowestPoint * SlowestPoint && speedSquared < FusedRange.Fastest * FusedRange.Fastest))
        {
            drag = 0;
            lift = 0;
            decay = 0;
            return false;
        }

        // What Begin and AtStart do, without what only the later stages of a step need.
        drag = 0;
        lift = 0;
        decay = 0;
        if (default(TDrag).Acts || default(TMagnus).Acts)
        {
            SpeedTable.OfSpin(_radius * spinRate, out double powerForDrag, out double powerForLift);
            double forDrag = FittedDrag.C * powerForDrag;
            double forLift = _liftScale * powerForLift;
            if (branch == DragBranch.Spinning)
            {
                double forBoth = forLift * forDrag;
                drag = _dragScale * forDrag;
                forLift = FittedDrag.AtRest * forLift;
                SpeedTable.WithSpin(speedSquared, ref drag, ref forLift, ref forBoth);
                drag = default(TDrag).Acts ? drag : 0;
                lift = default(TMagnus).Acts ? forLift - forBoth : 0;
            }
            else
            {
                SpeedTable.WithoutSpin(speedSquared, out double byDrag, out double byLift);
                drag = default(TDrag).Acts ? _dragScale * byDrag : 0;
                lift = default(TMagnus).Acts ? forLift * byLift : 0;
            }
        }

        // The spin of a ball that has bounced: the lift ends at Sp 1.88, and the plates are asked one by one.
        bool spinsFast = !(_quarterSquare * spinRate * spinRate < LargestRatio * speedSquared);
        lift = spinsFast && !(lift > 0) ? 0 : lift;
        if (default(TDecay).Acts && spinsFast)
        {
            AirFlow flow = default;
            flow.Speed = Math.Sqrt(speedSquared);
            flow.SpinRate = spinRate;
            decay = _decay.Factor(in flow);
        }
        else if (default(TDecay).Acts)
        {
            double x = _quarterSquare * spinRate * spinRate / speedSquared;
            decay = _decayScale * SpeedTable.Decay(speedSquared) * (1.0 + (x * PlateSeries.At(x)));
        }

        return true;
    }
}
