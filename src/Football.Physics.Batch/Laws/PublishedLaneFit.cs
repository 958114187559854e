using System.Runtime.CompilerServices;

namespace FootballPhysics.Batch;

/// <summary>The fitted C_D as published, in lanes: it jumps between branches (<see cref="FittedDrag"/>).</summary>
#if NET8_0_OR_GREATER
internal readonly struct PublishedLaneFit<F> : ILaneDragFit<F>
    where F : struct, ILane<F>
#else
internal readonly struct PublishedLaneFit<TLane> : ILaneDragFit<TLane>
#endif
{
    public bool Jumps { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => true; }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public F Join<TBranch>(in TBranch branch, F speed, F surfaceSpeed, F withSpin, F withoutSpin)
        where TBranch : struct, ILaneBranch<F> => branch.Choose(withSpin, withoutSpin);
}
