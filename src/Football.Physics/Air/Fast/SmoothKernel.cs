using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>
/// A smooth law by the tables of its functions, where <see cref="Covers"/> says that they hold: two indices, a handful of cubics, and
/// the law's own <see cref="ISmoothLaw.Combine"/>. <see cref="SmoothAir{TLaw, TDrag, TMagnus, TDecay}"/> by functions is its definition, and the
/// tests compare the two over the whole domain.
/// </summary>
/// <typeparam name="TLaw">The law.</typeparam>
/// <typeparam name="TDrag">Whether drag acts.</typeparam>
/// <typeparam name="TMagnus">Whether the Magnus force acts.</typeparam>
/// <typeparam name="TDecay">Whether spin decays.</typeparam>
internal struct SmoothKernel<TLaw, TDrag, TMagnus, TDecay> : IFusedKernel<PointStep>
    where TLaw : struct, ISmoothLaw
    where TDrag : struct, IAirLaw
    where TMagnus : struct, IAirLaw
    where TDecay : struct, IAirLaw
{
    /// <summary>Added to (r|ω|)², m²/s², so that a ball without spin is within the tables, where they say that there is none.</summary>
    private const double NoSpin = 1e-20;

    /// <summary>The slowest speed, m/s, that is asked about.</summary>
    private const double SlowestPoint = 0.5;

    /// <summary>Steps begin so much above the slowest speed of the tables.</summary>
    private const double AboveSlowest = 1.5;

    /// <summary>And so much below the fastest.</summary>
    private const double BelowFastest = 0.9375;

    private TLaw _law;
    private FactorTable _speeds;
    private FactorTable _spins;
    private FusedRange _range;
    private double _radius;
    private double _radiusSquared;
    private double _slowestSquared; // |u|² within the tables
    private double _fastestSquared;

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

    /// <summary>The fastest spin, rad/s, that is covered at any speed.</summary>
    private double FastestSpin => FusedRange.LargestSpinParameter * FusedRange.Fastest / _radius;

    public void Prepare(Scene scene)
    {
        _law = default;
        _law.Prepare(scene);
        SmoothTables tables = _law.Tables;
        _speeds = tables.Speeds;
        _spins = tables.Spins;
        _radius = scene.Ball.Radius;
        _radiusSquared = _radius * _radius;
        double slowest = Math.Max(SlowestPoint, tables.Slowest / _law.SpeedScale);
        double fastest = Math.Min(FusedRange.Fastest, BelowFastest * tables.Fastest / _law.SpeedScale);
        _slowestSquared = slowest * slowest;
        _fastestSquared = fastest * fastest;
        _range.Prepare(scene, ForceBound(fastest), FastestSpin, AboveSlowest * slowest, fastest);
    }

    /// <inheritdoc cref="IAir.WholeUpTo"/>
    public double WholeUpTo(in RateBound bound) => 0.5 / ((bound.PerSpeed * FusedRange.Fastest) + (bound.PerSpin * FastestSpin) + bound.Constant);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Covers(double speedSquared, double spinRate, double h) =>
        _range.Holds(speedSquared, spinRate, h) && _range.HoldsSpin(speedSquared, _radiusSquared * spinRate * spinRate, h);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Begin(double spinRate, DragBranch branch, out PointStep step) => step.Branch = branch;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AtStage(
        in PointStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay)
    {
        // A stage may overshoot zero spin: there S is 0.
        double spin = spinRate > 0 ? spinRate : 0;
        double surfaceSquared = _radiusSquared * (spin * spin);
        double ofSpin;
        if (_law.NeedsSpinAcross)
        {
            // S² = (r|ω|)² |ω̂ × u|²/|u|⁴
            double perSpeedSquared = 1.0 / speedSquared;
            ofSpin = ((surfaceSquared * acrossSquared) + (NoSpin * speedSquared)) * perSpeedSquared * perSpeedSquared;
        }
        else
        {
            // 1/S² = |u|²/(r|ω|)²: the division does not wait for the speed
            ofSpin = speedSquared * (1.0 / (surfaceSquared + NoSpin));
        }

        _speeds.Evaluate(speedSquared * (_law.SpeedScale * _law.SpeedScale), out LawFactors bySpeed);
        _spins.Evaluate(ofSpin, out LawFactors bySpin);
        _law.Combine(in bySpeed, in bySpin, Math.Sqrt(speedSquared), spinRate, out drag, out lift, out decay);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AtStart(ref PointStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay) =>
        AtStage(in step, speedSquared, spinRate, acrossSquared, out drag, out lift, out decay);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Expand(ref PointStep step, double speedChange, double spinChange)
    {
    }

    /// <summary>The factors at a point by itself.</summary>
    /// <returns>False where the tables do not hold.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool TryAtPoint(
        in PointStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay)
    {
        const double Largest = FusedRange.LargestSpinParameter * FusedRange.LargestSpinParameter;
        if (!(speedSquared > _slowestSquared && speedSquared < _fastestSquared && _radiusSquared * spinRate * spinRate < Largest * speedSquared))
        {
            drag = 0;
            lift = 0;
            decay = 0;
            return false;
        }

        AtStage(in step, speedSquared, spinRate, acrossSquared, out drag, out lift, out decay);
        return true;
    }

    private RateBound ForceBound(double fastest) => (Drags ? _law.DragBound(fastest) : default) + (Lifts ? _law.LiftBound : default);
}
