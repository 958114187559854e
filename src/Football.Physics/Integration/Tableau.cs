using FootballPhysics.Simulation;

namespace FootballPhysics.Integration;

/// <summary>The coefficients of a one-step method whose stages each start from the rates of the previous stage.</summary>
/// <remarks>
/// kᵢ = f(y + cᵢ h kᵢ₋₁) and y' = y + h Σ bᵢ kᵢ, with c₁ = 0. The steps that write a motion out in other variables read them from here:
/// <see cref="FlatSurfaceStep"/>.
/// </remarks>
/// <param name="offsets">cᵢ.</param>
/// <param name="weights">bᵢ.</param>
/// <param name="movesWithEnd">True if the position advances with the velocity at the end, as in a symplectic method.</param>
internal sealed class Tableau(double[] offsets, double[] weights, bool movesWithEnd = false)
{
    /// <summary>cᵢ.</summary>
    public double[] Offsets { get; } = offsets;

    /// <summary>bᵢ.</summary>
    public double[] Weights { get; } = weights;

    /// <summary>True if the position advances with the velocity at the end.</summary>
    public bool MovesWithEnd { get; } = movesWithEnd;
}
