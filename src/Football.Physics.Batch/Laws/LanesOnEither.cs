using System.Runtime.CompilerServices;

namespace FootballPhysics.Batch;

/// <summary>Some balls are on the branch with spin, others are not.</summary>
#if NET8_0_OR_GREATER
internal readonly struct LanesOnEither<F> : ILaneBranch<F>
    where F : struct, ILane<F>
#else
internal readonly struct LanesOnEither<TLane> : ILaneBranch<TLane>
#endif
{
    private readonly F _withSpin;
    private readonly bool _none;

    /// <param name="withSpin">Mask: balls on the branch with spin.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public LanesOnEither(F withSpin)
    {
        _withSpin = withSpin;
        _none = !F.Any(withSpin);
    }

    public bool AllWithSpin { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => false; }

    public bool NoneWithSpin { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => _none; }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public F Choose(F withSpin, F withoutSpin) => F.Select(_withSpin, withSpin, withoutSpin);
}
