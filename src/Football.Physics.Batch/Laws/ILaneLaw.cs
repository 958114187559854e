namespace FootballPhysics.Batch;

/// <summary>
/// How drag, lift and spin decay follow from speed and spin, for several balls side by side: the aerodynamics that a flight in lanes is
/// compiled for.
/// </summary>
/// <remarks>
/// It must hold wherever <see cref="LaneDomain"/> lets a ball fly, and be finite below. A law whose coefficients change smoothly does not
/// read the branch. The properties are constants of the type, so that the compiler removes what a law does not need.
/// </remarks>
#if NET8_0_OR_GREATER
internal interface ILaneLaw<F>
    where F : struct, ILane<F>
#else
internal interface ILaneLaw<TLane>
#endif
{
    /// <summary>True when there is air at all.</summary>
    bool Acts { get; }

    /// <summary>True when the drag coefficient jumps where <see cref="LaneJump"/> says: steps are then locked to a branch, and cut at the jump.</summary>
    bool Jumps { get; }

    /// <summary>True when the law goes by the spin across the motion.</summary>
    bool NeedsSpinAcross { get; }

    /// <summary>Reads the law's numbers from the scene.</summary>
    void Prepare(Scene scene);

    /// <summary>Computes what a step needs of the spin at its start.</summary>
    /// <param name="spin">|ω|, rad/s.</param>
    /// <param name="step">What <see cref="Evaluate"/> is handed.</param>
    void Begin(F spin, out LaneSpin<F> step);

    /// <summary>The factors of a = −drag · u + lift · (ω̂ × u) and ω̇ = −decay.</summary>
    /// <param name="step">From <see cref="Begin"/>.</param>
    /// <param name="branch">On which branch of the drag law the balls are.</param>
    /// <param name="speedSquared">|u|², m²/s².</param>
    /// <param name="acrossSquared">|ω̂ × u|², m²/s², where <see cref="NeedsSpinAcross"/>; else nothing.</param>
    /// <param name="spin">|ω|, rad/s; slightly negative in a stage that overshoots zero.</param>
    /// <param name="drag">1/s.</param>
    /// <param name="lift">1/s.</param>
    /// <param name="decay">rad/s².</param>
    void Evaluate<TBranch>(
        in LaneSpin<F> step, in TBranch branch, F speedSquared, F acrossSquared, F spin, out F drag, out F lift, out F decay)
        where TBranch : struct, ILaneBranch<F>;
}
