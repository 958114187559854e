using System.Runtime.CompilerServices;
using FootballPhysics.State;

namespace FootballPhysics.Laws;

/// <summary>The published laws, split into functions of speed and of the spin parameter.</summary>
/// <remarks>
/// They are <see cref="EmpiricalDrag"/>, <see cref="EmpiricalMagnus"/> and <see cref="EmpiricalSpinDecay"/>. The drag coefficient jumps: it depends on speed in the region
/// without spin, and on spin in the region with spin (<see cref="FittedDrag"/>).
/// </remarks>
internal struct PublishedLaw : ITableLaw
{
    /// <summary>Tables from 1.6 cm/s to 128 m/s, with finer segments from 2.8 to 32 m/s, around the drag crisis.</summary>
    private static readonly LawTables Shared = new(default(PublishedLaw), new Octaves(-12, 14, 6), new Octaves(3, 10, 7));

    private EmpiricalSpinDecay _decay;
    private double _ofDrag; // ½ ρ A / m, 1/m; 0 without drag
    private double _ofLift; // the same; 0 without lift
    private double _atRest; // C_D0
    private double _plate; // torque of a plate at 1 m/s, per I

    public readonly bool NeedsSpinAcross { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => false; }

    public readonly bool Jumps { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => true; }

    public readonly double SpeedScale { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => 1; }

    public readonly LawTables Tables => Shared;

    public void Prepare(Scene scene)
    {
        _decay.Prepare(scene);
        double dynamic = AirScale.DynamicArea(scene);
        _ofDrag = scene.Forces.Drag == ForceLaw.None ? 0 : dynamic;
        _ofLift = scene.Forces.Magnus == ForceLaw.None ? 0 : dynamic;
        _atRest = FittedDrag.AtRest;
        _plate = scene.Forces.SpinDecay == ForceLaw.None ? 0 : _decay.Plate;
    }

    // C_D without spin; C_D0 − C_D, tabulated separately because it vanishes at low airspeed; |u|^1.8.
    public readonly void OfSpeed(double speed, out LawFactors factors)
    {
        factors.First = FittedDrag.WithoutSpin(speed);
        factors.Second = FittedDrag.AtRest - factors.First;
        factors.Third = EmpiricalSpinDecay.OfSpeed(speed);
        factors.Fourth = 0;
    }

    // c S^d, 1.15 S^β / (C_D0 − a), ((1 + S/2)^1.8 + |1 − S/2|^1.8)
    public readonly void OfSpin(double spinParameter, out LawFactors factors)
    {
        factors.First = FittedDrag.WithSpin(spinParameter);
        factors.Second = EmpiricalMagnus.OfSpin(spinParameter);
        factors.Third = EmpiricalSpinDecay.OfSpin(spinParameter);
        factors.Fourth = 0;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Combine(
        DragBranch region, in LawFactors bySpeed, in LawFactors bySpin, double speed, double spinRate, out double drag, out double lift, out double decay)
    {
        // C_D = c S^d with spin, C_D(|u|) without.
        double coefficient = bySpeed.First;
        double deficit = bySpeed.Second;
        if (region == DragBranch.Spinning)
        {
            coefficient = bySpin.First;
            deficit = _atRest - coefficient;
        }

        // S is the spin parameter, C_D0 the drag coefficient at rest, a the constant of FittedDrag, and β that of EmpiricalMagnus.
        // D = ½ρA/m |u| C_D,  L = ½ρA/m |u| 1.15 S^β (C_D0 − min(C_D, C_D0)) / (C_D0 − a)
        drag = _ofDrag * speed * coefficient;
        lift = deficit > 0 ? _ofLift * speed * bySpin.Second * deficit : 0;

        // ω̇ = k (|u + r|ω|/2|^1.8 + |u − r|ω|/2|^1.8)
        decay = _plate * bySpeed.Third * bySpin.Third;
    }
}
