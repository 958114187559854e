using System.Runtime.CompilerServices;
using FootballPhysics.State;

namespace FootballPhysics.Laws;

/// <summary>The measured laws: <see cref="ReynoldsDrag"/> and <see cref="SpinDrag"/>, <see cref="SaturatingLift"/>, <see cref="ProportionalSpinDecay"/>.</summary>
/// <remarks>
/// Functions of the Reynolds number replace functions of speed, so that a ball has the same tables in any weather.
/// </remarks>
internal struct MeasuredLaw : ITableLaw
{
    /// <summary>The tables of each drag curve, kept while the curve is reachable.</summary>
    private static readonly ConditionalWeakTable<DragCurve, LawTables> Shared = new();

    /// <summary>Reynolds numbers from 128 to 4.2e6.</summary>
    private static readonly Octaves Reynolds = new(14, 44, 6);

    /// <summary>Reynolds numbers from 65 000 to 740 000, in segments fine enough for the narrowest drag crisis.</summary>
    private static readonly Octaves Crisis = new(32, 39, 7);

    private DragCurve _curve;
    private ReynoldsDrag _drag;
    private ProportionalSpinDecay _decay;
    private double _ofDrag; // ½ ρ A / m, 1/m; 0 without drag
    private double _ofLift; // ½ ρ A r / m; 0 without lift
    private double _radius;
    private double _reverseLift; // Λ
    private double _perSpeed; // 2r/ν, s/m

    /// <summary>The Reynolds number above which C_D stays constant, at twice the speed of any kick, so that C_D is bounded.</summary>
    private double _largest;

    public readonly bool NeedsSpinAcross { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => true; }

    public readonly bool Jumps { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => false; }

    public readonly double SpeedScale { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => _perSpeed; }

    // The tables depend only on the curve, not on a scene's cut-off.
    public readonly LawTables Tables => Shared.GetValue(_curve, curve => new MeasuredLaw { _largest = double.PositiveInfinity }.TablesOf(curve));

    /// <summary>A bound on the lift: C_L is between −Λ and L.</summary>
    public readonly RateBound LiftBound => new(_ofLift / _radius * Math.Max(SaturatingLift.Limit, _reverseLift), 0, 0);

    /// <summary>Returns a bound on the drag up to a speed, in m/s.</summary>
    public readonly RateBound DragBound(double fastest) => new(_ofDrag * (_drag.Largest(_perSpeed * fastest) + SpinDrag.Limit), 0, 0);

    public void Prepare(Scene scene)
    {
        ForceSet forces = scene.Forces;
        _curve = Canonical(scene.Ball.DragCurve);
        _drag = new ReynoldsDrag(_curve);
        _radius = scene.Ball.Radius;
        _reverseLift = scene.Ball.ReverseLift;
        _perSpeed = 2.0 * _radius / scene.Air.KinematicViscosity;
        _largest = _perSpeed * (2.0 * Limits.Speed);
        double dynamic = AirScale.DynamicArea(scene);
        _ofDrag = forces.Drag == ForceLaw.None ? 0 : dynamic;
        _ofLift = forces.Magnus == ForceLaw.None ? 0 : dynamic * _radius;
        _decay.Prepare(scene);
    }

    private LawTables TablesOf(DragCurve curve)
    {
        _drag = new ReynoldsDrag(curve);
        return new LawTables(this, Reynolds, Crisis);
    }

    /// <summary>Returns one shared instance for equal generic curves, so that their tables are built only once.</summary>
    private static DragCurve Canonical(DragCurve curve) => curve == DragCurve.Generic ? DragCurve.Generic : curve;

    // Compute C_D without spin, the reduction of drag due to spin, the reduction of lift below the crisis, and the share of subcritical flow.
    public readonly void OfSpeed(double speed, out LawFactors factors)
    {
        double share = _drag.SubcriticalShare(speed);
        factors.First = _drag.Coefficient(Math.Min(speed, _largest));
        factors.Second = SpinDrag.OfShare(share);
        factors.Third = SaturatingLift.OfShare(share);
        factors.Fourth = share;
    }

    // C_D by spin above the crisis, and C_L/S above the crisis.
    public readonly void OfSpin(double spinParameter, out LawFactors factors)
    {
        factors.First = SpinDrag.OfSpin(spinParameter);
        factors.Second = SaturatingLift.PerSpin(spinParameter);
        factors.Third = 0;
        factors.Fourth = 0;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Combine(
        DragBranch region, in LawFactors bySpeed, in LawFactors bySpin, double speed, double spinRate, out double drag, out double lift, out double decay)
    {
        // D = ½ρA/m |u| C_D
        double scale = _ofDrag * speed;
        drag = (scale * bySpeed.First) + (scale * bySpeed.Second * bySpin.First);

        // C_L is the lift coefficient, S the spin parameter, and sin that of the angle between ω and u.
        // L = ½ρA/m |u|² C_L/(|u| sin) = ½ρA/m r|ω| C_L/S, for S|u| = r|ω| sin and |ω̂ × u| = |u| sin
        lift = _ofLift * spinRate * bySpeed.Third * bySpin.Second;

        // k is the decay per metre of air, and ε the decay per second in air of 1.2 kg/m³.
        // |ω|˙ = −(k |u| + ε ρ/1.2) |ω|
        decay = _decay.PerSpin(speed) * spinRate;
    }

    /// <summary>Computes the factors in a flow with non-zero speed.</summary>
    public readonly void At(in AirFlow flow, out double drag, out double lift, out double decay)
    {
        // S = r|ω × u|/|u|²
        OfSpeed(_perSpeed * flow.Speed, out LawFactors bySpeed);
        OfSpin(_radius * flow.SpinRate * Math.Sqrt(flow.AcrossSquared) / flow.SpeedSquared, out LawFactors bySpin);
        Combine(DragBranch.Unknown, in bySpeed, in bySpin, flow.Speed, flow.SpinRate, out drag, out lift, out decay);
    }
}

/// <summary>The drag of the measured laws alone, F_D = −½ ρ A C_D |u| u by <see cref="ReynoldsDrag"/> and <see cref="SpinDrag"/>.</summary>
internal struct MeasuredDrag : IAirLaw
{
    private MeasuredLaw _law;

    public readonly RateBound Bound => _law.DragBound(2.0 * Limits.Speed);

    public void Prepare(Scene scene) => _law.Prepare(scene);

    public readonly double Factor(in AirFlow flow)
    {
        _law.At(in flow, out double drag, out _, out _);
        return drag;
    }
}

/// <summary>The lift of the measured laws alone, by <see cref="SaturatingLift"/> and <see cref="ReverseLift"/>.</summary>
internal struct MeasuredMagnus : IAirLaw
{
    private MeasuredLaw _law;
    private ReverseLift _reverse;

    public readonly RateBound Bound => _law.LiftBound;

    public void Prepare(Scene scene)
    {
        _law.Prepare(scene);
        _reverse.Prepare(scene);
    }

    public readonly double Factor(in AirFlow flow)
    {
        _law.At(in flow, out _, out double lift, out _);
        return _reverse.Acts ? lift + _reverse.Factor(flow.Speed, flow.SpinRate, flow.AcrossSquared) : lift;
    }
}
