namespace Football.Physics;

/// <summary>Aerodynamic laws fused into one evaluation, which holds in a part of their domain.</summary>
internal interface IFusedAir : IAerodynamics
{
    /// <summary>Evaluates all laws at one point.</summary>
    /// <param name="branch">The branch of the drag law.</param>
    /// <param name="speedSquared">|u|².</param>
    /// <param name="spinRate">|ω|.</param>
    /// <param name="acrossSquared">|ω̂ × u|².</param>
    /// <param name="drag">D.</param>
    /// <param name="lift">L.</param>
    /// <param name="decay">Angular deceleration.</param>
    /// <returns>False where the evaluation does not hold.</returns>
    bool EvaluateAt(DragBranch branch, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay);
}
