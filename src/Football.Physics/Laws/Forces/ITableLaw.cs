using FootballPhysics.State;

namespace FootballPhysics.Laws;

/// <summary>All aerodynamic laws of a scene in a form for tables: functions of speed, functions of the spin parameter, and their combination.</summary>
/// <remarks>
/// This is the only definition of a law. <see cref="TableAir{TLaw}"/> uses tables of the functions in their range, and the functions themselves elsewhere.
/// <para>The spin parameter is S = r|ω⊥|/|u| with the spin across the motion if <see cref="NeedsSpinAcross"/> is true, and with the total spin otherwise. A law that
/// jumps has regions, one per branch; the functions of each region are smooth on the entire domain.</para>
/// </remarks>
internal interface ITableLaw
{
    /// <summary>True if S uses the spin across the motion.</summary>
    /// <remarks>Lift and decay are then proportional to the spin at fixed S. A constant of the type.</remarks>
    bool NeedsSpinAcross { get; }

    /// <summary>True if the law has regions, so that a step is locked to one region and ends at its boundary. A constant of the type.</summary>
    bool Jumps { get; }

    /// <summary>Reads the constants of the law from the scene.</summary>
    void Prepare(Scene scene);

    /// <summary>The factor from speed to the argument of the functions: 1 for the speed itself, 2r/ν for the Reynolds number.</summary>
    double SpeedScale { get; }

    /// <summary>The tables of the functions, shared by all scenes with the same functions.</summary>
    LawTables Tables { get; }

    /// <summary>Evaluates the functions of speed.</summary>
    /// <param name="speed">|u| times <see cref="SpeedScale"/>, above 0.</param>
    /// <param name="factors">The values.</param>
    void OfSpeed(double speed, out LawFactors factors);

    /// <summary>Evaluates the functions of the spin parameter.</summary>
    /// <param name="spinParameter">S; at least 0.</param>
    /// <param name="factors">The values.</param>
    void OfSpin(double spinParameter, out LawFactors factors);

    /// <summary>Combines the functions: a = −drag · u + lift · (ω̂ × u), angular deceleration decay (rad/s²).</summary>
    /// <param name="region">The region of a law that jumps.</param>
    /// <param name="bySpeed">The values of <see cref="OfSpeed"/>.</param>
    /// <param name="bySpin">The values of <see cref="OfSpin"/>.</param>
    /// <param name="speed">|u|, m/s.</param>
    /// <param name="spinRate">|ω|, rad/s.</param>
    /// <param name="drag">D, 1/s.</param>
    /// <param name="lift">L, 1/s.</param>
    /// <param name="decay">The angular deceleration, in rad/s².</param>
    void Combine(
        DragBranch region, in LawFactors bySpeed, in LawFactors bySpin, double speed, double spinRate, out double drag, out double lift, out double decay);
}
