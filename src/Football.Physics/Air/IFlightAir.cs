namespace FootballPhysics;

/// <summary>The laws of the air as the hot step of flight asks them: one compiled body of the step for each type.</summary>
internal interface IFlightAir : IFlightLaws
{
    /// <summary>True when anything acts at all. A fact of the type but in <see cref="SceneAir"/>, as the next one.</summary>
    bool Acts { get; }

    /// <summary>True when the drag coefficient jumps, so that a step is locked to a branch and ends where the branch does.</summary>
    bool Jumps { get; }

    /// <summary>True when the fast form of the laws holds along a step from here.</summary>
    /// <param name="speedSquared">|u|² at its start, m²/s².</param>
    /// <param name="spinRate">|ω| there, rad/s.</param>
    /// <param name="h">Length of the step, s.</param>
    bool Covers(double speedSquared, double spinRate, double h);

    /// <summary>The factors of a = L (ω × u) − D u, ω̇ = −decay ω: per unit of spin. Without spin the decay is the angular deceleration itself, rad/s².</summary>
    /// <param name="speedSquared">|u|², m²/s².</param>
    /// <param name="spinSquared">|ω|², rad²/s².</param>
    /// <param name="crossSquared">|ω × u|², m²/s⁴.</param>
    /// <param name="region">The branch of the drag law.</param>
    /// <param name="drag">D, 1/s.</param>
    /// <param name="lift">L.</param>
    /// <param name="decay">1/s, or rad/s².</param>
    /// <returns>Whether there is a spin.</returns>
    bool FactorsPerSpin(double speedSquared, double spinSquared, double crossSquared, DragBranch region, out double drag, out double lift, out double decay);

    /// <summary>Up to which length, s, no step that is covered changes the motion too much to be taken whole, whatever its speed and spin; 0 where that is not known.</summary>
    /// <param name="bound">How fast the air and all else can change the motion.</param>
    double WholeUpTo(in RateBound bound);
}
