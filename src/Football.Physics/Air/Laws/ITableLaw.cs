namespace FootballPhysics;

/// <summary>
/// All aerodynamic laws of a scene as data for one kernel: functions of the speed alone, functions of the spin parameter alone, and how the
/// two go together to forces and spin decay. That is the law's one definition; <see cref="TableAir{TLaw}"/> asks tables of the functions where they hold,
/// and the functions themselves elsewhere.
/// </summary>
/// <remarks>
/// The spin parameter is S = r|ω⊥|/|u|, of the spin across the motion where <see cref="NeedsSpinAcross"/>, of the whole spin elsewhere. A law that jumps
/// has regions: the region is the branch that a step is locked to, and the functions of every region are smooth over the whole domain.
/// </remarks>
internal interface ITableLaw
{
    /// <summary>True when S is that of the spin across the motion, and lift and decay are proportional to the spin for one S. A constant of the type.</summary>
    bool NeedsSpinAcross { get; }

    /// <summary>True when the law has regions, so that a step is locked to one and ends where it does. A constant of the type.</summary>
    bool Jumps { get; }

    /// <summary>Reads the law's constants from the scene.</summary>
    void Prepare(Scene scene);

    /// <summary>Scale of the speed in the functions' argument, per m/s: 1 for the speed itself, 2r/ν for the Reynolds number.</summary>
    double SpeedScale { get; }

    /// <summary>Tables of the functions, the same ones for every scene with the same functions.</summary>
    LawTables Tables { get; }

    /// <summary>An upper bound for drag up to a speed, m/s.</summary>
    RateBound DragBound(double fastest);

    /// <summary>An upper bound for lift.</summary>
    RateBound LiftBound { get; }

    /// <summary>An upper bound for spin decay.</summary>
    RateBound DecayBound { get; }

    /// <summary>The functions of the speed.</summary>
    /// <param name="speed">|u| times <see cref="SpeedScale"/>, above 0.</param>
    /// <param name="factors">Their values.</param>
    void OfSpeed(double speed, out LawFactors factors);

    /// <summary>The functions of the spin parameter.</summary>
    /// <param name="spinParameter">S, not negative.</param>
    /// <param name="factors">Their values.</param>
    void OfSpin(double spinParameter, out LawFactors factors);

    /// <summary>Puts the functions together: a = −drag · u + lift · (ω̂ × u), angular deceleration decay (rad/s²).</summary>
    /// <param name="region">The region of a law that jumps.</param>
    /// <param name="bySpeed">From <see cref="OfSpeed"/>.</param>
    /// <param name="bySpin">From <see cref="OfSpin"/>.</param>
    /// <param name="speed">|u|, m/s.</param>
    /// <param name="spinRate">|ω|, rad/s.</param>
    /// <param name="drag">D, 1/s.</param>
    /// <param name="lift">L, 1/s.</param>
    /// <param name="decay">Angular deceleration.</param>
    void Combine(
        DragBranch region, in LawFactors bySpeed, in LawFactors bySpin, double speed, double spinRate, out double drag, out double lift, out double decay);
}
