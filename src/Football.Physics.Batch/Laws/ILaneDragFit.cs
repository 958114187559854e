namespace FootballPhysics.Batch;

/// <summary>A form of the fitted drag coefficient in lanes: it joins the branches with and without spin.</summary>
#if NET8_0_OR_GREATER
internal interface ILaneDragFit<F>
    where F : struct, ILane<F>
#else
internal interface ILaneDragFit<TLane>
#endif
{
    /// <summary>True if the coefficient jumps. Then only the branches in use are computed.</summary>
    bool Jumps { get; }

    /// <summary>Returns C_D.</summary>
    /// <param name="branch">The branches of the balls.</param>
    /// <param name="speed">|u|, m/s.</param>
    /// <param name="surfaceSpeed">r|ω|, m/s; slightly negative if a stage overshoots zero.</param>
    /// <param name="withSpin">C_D of the law with spin.</param>
    /// <param name="withoutSpin">C_D of the law without spin.</param>
    F Join<TBranch>(in TBranch branch, F speed, F surfaceSpeed, F withSpin, F withoutSpin)
        where TBranch : struct, ILaneBranch<F>;
}
