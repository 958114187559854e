using FootballPhysics.State;

namespace FootballPhysics.Laws;

/// <summary>The laws of the air in the hot flight step, which is specialized for each implementing type.</summary>
internal interface IFlightAir : IFlightLaws
{
    /// <summary>True if any law acts. A constant of the type, except in <see cref="SceneAir"/>; the same holds for <see cref="Jumps"/>.</summary>
    bool Acts { get; }

    /// <summary>True if the drag coefficient jumps, so that a step is locked to a branch and ends where the branch ends.</summary>
    bool Jumps { get; }

    /// <summary>Returns true if the fast form of the laws is valid for a step from this state.</summary>
    /// <param name="speedSquared">|u|² at the start, m²/s².</param>
    /// <param name="spinRate">|ω| at the start, rad/s.</param>
    /// <param name="h">The length of the step, in s.</param>
    bool Covers(double speedSquared, double spinRate, double h);

    /// <summary>Computes the factors of a = L (ω × u) − D u, ω̇ = −decay ω. Without spin, decay is the angular deceleration itself, in rad/s².</summary>
    /// <param name="speedSquared">|u|², m²/s².</param>
    /// <param name="spinSquared">|ω|², rad²/s².</param>
    /// <param name="crossSquared">|ω × u|², m²/s⁴.</param>
    /// <param name="region">The branch of the drag law.</param>
    /// <param name="drag">D, 1/s.</param>
    /// <param name="lift">L.</param>
    /// <param name="decay">1/s, or rad/s².</param>
    /// <returns>True if the ball spins.</returns>
    bool FactorsPerSpin(double speedSquared, double spinSquared, double crossSquared, DragBranch region, out double drag, out double lift, out double decay);

    /// <summary>Returns the step length up to which a covered step never needs substeps, at any speed and spin, in s; 0 if unknown.</summary>
    /// <param name="bound">The bound on the rate at which the air and all other effects change the motion.</param>
    double WholeUpTo(in RateBound bound);
}
