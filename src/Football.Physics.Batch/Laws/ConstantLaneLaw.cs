using System.Runtime.CompilerServices;

namespace FootballPhysics.Batch;

/// <summary>The laws with constant coefficients in lanes: drag depends on the speed, lift and spin decay on the spin.</summary>
#if NET8_0_OR_GREATER
internal struct ConstantLaneLaw<F> : ILaneLaw<F>
    where F : struct, ILane<F>
#else
internal struct ConstantLaneLaw<TLane> : ILaneLaw<TLane>
#endif
{
    private float _drag;  // ½ ρ C_D A / m, 1/m
    private float _lift;  // C_M π ρ r³ / m
    private float _decay; // k / I, 1/s

    public readonly bool Acts { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => true; }

    public readonly bool Jumps { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => false; }

    public readonly bool NeedsSpinAcross { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => false; }

    public void Prepare(Scene scene)
    {
        AirFlow unit = default;
        unit.Speed = 1;
        unit.SpinRate = 1;
        _drag = (float)SceneLaws.Drag(scene).Factor(in unit);
        _lift = (float)SceneLaws.Magnus(scene).Factor(in unit);
        _decay = (float)SceneLaws.SpinDecay(scene).Factor(in unit);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Begin(F spin, out LaneSpin<F> step) => step = default;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Evaluate<TBranch>(
        in LaneSpin<F> step, in TBranch branch, F speedSquared, F acrossSquared, F spin, out F drag, out F lift, out F decay)
        where TBranch : struct, ILaneBranch<F>
    {
        drag = _drag * F.Sqrt(speedSquared);
        lift = _lift * spin;
        decay = _decay * spin;
    }
}
