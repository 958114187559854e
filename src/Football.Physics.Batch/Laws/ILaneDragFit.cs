namespace FootballPhysics.Batch;

/// <summary>A form of the fitted drag coefficient, for several balls side by side: how its branches with and without spin come together.</summary>
#if NET8_0_OR_GREATER
internal interface ILaneDragFit<F>
    where F : struct, ILane<F>
#else
internal interface ILaneDragFit<TLane>
#endif
{
    /// <summary>True when the coefficient jumps: then no more of the branches is computed than the balls are on.</summary>
    bool Jumps { get; }

    /// <summary>C_D.</summary>
    /// <param name="branch">On which branch the balls are.</param>
    /// <param name="speed">|u|, m/s.</param>
    /// <param name="surfaceSpeed">r|ω|, m/s; slightly negative where a stage overshoots zero.</param>
    /// <param name="withSpin">C_D by the law with spin.</param>
    /// <param name="withoutSpin">C_D by the law without.</param>
    F Join<TBranch>(in TBranch branch, F speed, F surfaceSpeed, F withSpin, F withoutSpin)
        where TBranch : struct, ILaneBranch<F>;
}
