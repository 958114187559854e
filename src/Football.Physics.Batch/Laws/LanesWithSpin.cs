using System.Runtime.CompilerServices;

namespace FootballPhysics.Batch;

/// <summary>All balls are on the branch with spin: the stages of a step then contain no calls, and stay in registers.</summary>
#if NET8_0_OR_GREATER
internal readonly struct LanesWithSpin<F> : ILaneBranch<F>
    where F : struct, ILane<F>
#else
internal readonly struct LanesWithSpin<TLane> : ILaneBranch<TLane>
#endif
{
    public bool AllWithSpin { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => true; }

    public bool NoneWithSpin { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => false; }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public F Choose(F withSpin, F withoutSpin) => withSpin;
}
