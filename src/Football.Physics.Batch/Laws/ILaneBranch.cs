namespace FootballPhysics.Batch;

/// <summary>On which branch of a drag law that jumps the balls of a register are.</summary>
#if NET8_0_OR_GREATER
internal interface ILaneBranch<F>
    where F : struct, ILane<F>
#else
internal interface ILaneBranch<TLane>
#endif
{
    /// <summary>True when all are on the branch with spin: a constant of the type, for which the common case is compiled by itself.</summary>
    bool AllWithSpin { get; }

    /// <summary>True when none is.</summary>
    bool NoneWithSpin { get; }

    /// <summary>For each ball what holds on its branch.</summary>
    F Choose(F withSpin, F withoutSpin);
}
