using System.Runtime.CompilerServices;
using FootballPhysics.State;

namespace FootballPhysics.Laws;

/// <summary>The published laws with the smoothed drag coefficient, split into functions of speed and of the spin parameter.</summary>
/// <remarks>They are <see cref="RegularisedDragFit"/>, <see cref="EmpiricalMagnus"/> and <see cref="EmpiricalSpinDecay"/>.</remarks>
internal struct RegularisedLaw : ITableLaw
{
    /// <summary>Tables from 1.6 cm/s to 128 m/s, with segments from 8 to 32 m/s fine enough for the 0.25 m/s layer at the critical speed.</summary>
    private static readonly LawTables Shared = new(default(RegularisedLaw), new Octaves(-12, 14, 6), new Octaves(6, 10, 8));

    private EmpiricalSpinDecay _decay;
    private double _k; // ½ ρ A / m, 1/m
    private double _ofDrag; // 1; 0 without drag
    private double _ofLift; // 1; 0 without lift
    private double _atRest; // C_D0
    private double _plate; // torque of a plate at 1 m/s, per I

    public readonly bool NeedsSpinAcross { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => false; }

    public readonly bool Jumps { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => false; }

    public readonly double SpeedScale { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => 1; }

    public readonly LawTables Tables => Shared;

    public void Prepare(Scene scene)
    {
        _decay.Prepare(scene);
        _k = AirScale.DynamicArea(scene);
        _ofDrag = scene.Forces.Drag == ForceLaw.None ? 0 : 1;
        _ofLift = scene.Forces.Magnus == ForceLaw.None ? 0 : 1;
        _atRest = FittedDrag.AtRest;
        _plate = scene.Forces.SpinDecay == ForceLaw.None ? 0 : _decay.Plate;
    }

    // C_D without spin; the weight of the law with spin by speed; |u|^1.8.
    public readonly void OfSpeed(double speed, out LawFactors factors)
    {
        factors.First = FittedDrag.WithoutSpin(speed);
        factors.Second = RegularisedDragFit.SpeedWeight(speed);
        factors.Third = EmpiricalSpinDecay.OfSpeed(speed);
        factors.Fourth = 0;
    }

    // The weight of the law with spin, by spin parameter; this weight times c S^d; 1.15 S^β / (C_D0 − a); ((1 + S/2)^1.8 + |1 − S/2|^1.8).
    public readonly void OfSpin(double spinParameter, out LawFactors factors)
    {
        factors.First = RegularisedDragFit.SpinWeight(spinParameter);
        factors.Second = factors.First * FittedDrag.WithSpin(spinParameter);
        factors.Third = EmpiricalMagnus.OfSpin(spinParameter);
        factors.Fourth = EmpiricalSpinDecay.OfSpin(spinParameter);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Combine(
        DragBranch region, in LawFactors bySpeed, in LawFactors bySpin, double speed, double spinRate, out double drag, out double lift, out double decay)
    {
        // w is the weight of the law with spin, S the spin parameter, c and d are the constants of FittedDrag.
        // D = ½ρA/m |u| C_D,  C_D = C_D,no spin + w c S^d − w C_D,no spin
        double scale = _k * speed;
        double withoutSpin = scale * bySpeed.First;
        double gained = scale * bySpeed.Second * bySpin.Second;
        double lost = withoutSpin * bySpeed.Second * bySpin.First;
        drag = _ofDrag * ((withoutSpin + gained) - lost);

        // C_D0 is the drag coefficient at rest, a the constant of FittedDrag, and β that of EmpiricalMagnus.
        // L = ½ρA/m |u| 1.15 S^β (C_D0 − min(C_D, C_D0)) / (C_D0 − a); compute the deficit without waiting for D.
        double deficit = (((scale * _atRest) - withoutSpin) - gained) + lost;
        lift = deficit > 0 ? _ofLift * bySpin.Third * deficit : 0;

        // ω̇ = k (|u + r|ω|/2|^1.8 + |u − r|ω|/2|^1.8)
        decay = _plate * bySpeed.Third * bySpin.Fourth;
    }
}
