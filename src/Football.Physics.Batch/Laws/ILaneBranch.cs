namespace FootballPhysics.Batch;

/// <summary>The branches of a drag law with a jump on which the balls of a register are.</summary>
#if NET8_0_OR_GREATER
internal interface ILaneBranch<F>
    where F : struct, ILane<F>
#else
internal interface ILaneBranch<TLane>
#endif
{
    /// <summary>True if all are on the branch with spin. A constant of the type, so that this common case is compiled separately.</summary>
    bool AllWithSpin { get; }

    /// <summary>True if none is on the branch with spin.</summary>
    bool NoneWithSpin { get; }

    /// <summary>Selects the value of each ball's branch.</summary>
    F Choose(F withSpin, F withoutSpin);
}
