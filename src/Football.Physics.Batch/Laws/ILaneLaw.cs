namespace FootballPhysics.Batch;

/// <summary>The aerodynamics for which a flight in lanes is specialized: drag, lift and spin decay of several balls at once.</summary>
/// <remarks>
/// A law must hold in all of <see cref="LaneDomain"/>, and be finite below it. A law with smooth coefficients ignores the branch. The properties are constants of
/// the type, so that the compiler removes unused parts.
/// </remarks>
#if NET8_0_OR_GREATER
internal interface ILaneLaw<F>
    where F : struct, ILane<F>
#else
internal interface ILaneLaw<TLane>
#endif
{
    /// <summary>True if there is air.</summary>
    bool Acts { get; }

    /// <summary>True if the drag coefficient jumps at <see cref="LaneJump"/>. Steps are then locked to a branch, and cut at the jump.</summary>
    bool Jumps { get; }

    /// <summary>True if the law depends on the spin across the motion.</summary>
    bool NeedsSpinAcross { get; }

    /// <summary>Reads the constants of the law from the scene.</summary>
    void Prepare(Scene scene);

    /// <summary>Computes the terms of the spin at the start of a step.</summary>
    /// <param name="spin">|ω|, rad/s.</param>
    /// <param name="step">The terms for <see cref="Evaluate"/>.</param>
    void Begin(F spin, out LaneSpin<F> step);

    /// <summary>Computes the factors of a = −drag · u + lift · (ω̂ × u) and ω̇ = −decay.</summary>
    /// <param name="step">The terms from <see cref="Begin"/>.</param>
    /// <param name="branch">The branches of the balls.</param>
    /// <param name="speedSquared">|u|², m²/s².</param>
    /// <param name="acrossSquared">|ω̂ × u|², m²/s², if <see cref="NeedsSpinAcross"/> is true; otherwise undefined.</param>
    /// <param name="spin">|ω|, rad/s; slightly negative in a stage that overshoots zero.</param>
    /// <param name="drag">D, in 1/s.</param>
    /// <param name="lift">L, in 1/s.</param>
    /// <param name="decay">The angular deceleration, in rad/s².</param>
    void Evaluate<TBranch>(
        in LaneSpin<F> step, in TBranch branch, F speedSquared, F acrossSquared, F spin, out F drag, out F lift, out F decay)
        where TBranch : struct, ILaneBranch<F>;
}
