using System.Runtime.CompilerServices;

namespace FootballPhysics.Batch;

/// <summary>The law without air.</summary>
#if NET8_0_OR_GREATER
internal struct VacuumLaneLaw<F> : ILaneLaw<F>
    where F : struct, ILane<F>
#else
internal struct VacuumLaneLaw<TLane> : ILaneLaw<TLane>
#endif
{
    public readonly bool Acts { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => false; }

    public readonly bool Jumps { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => false; }

    public readonly bool NeedsSpinAcross { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => false; }

    public readonly void Prepare(Scene scene)
    {
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Begin(F spin, out LaneSpin<F> step) => step = default;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Evaluate<TBranch>(
        in LaneSpin<F> step, in TBranch branch, F speedSquared, F acrossSquared, F spin, out F drag, out F lift, out F decay)
        where TBranch : struct, ILaneBranch<F>
    {
        drag = default;
        lift = default;
        decay = default;
    }
}
