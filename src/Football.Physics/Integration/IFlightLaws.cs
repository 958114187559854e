namespace Football.Physics;

/// <summary>The laws of the air as a one-step method asks them.</summary>
internal interface IFlightLaws
{
    /// <summary>The factors at one instant: a = −drag · u + lift · (ω̂ × u), |ω|˙ = −decay.</summary>
    /// <param name="speedSquared">|u|², m²/s².</param>
    /// <param name="spinRate">|ω|, rad/s; slightly negative in a stage that overshoots zero.</param>
    /// <param name="acrossSquared">|ω̂ × u|², m²/s².</param>
    /// <param name="region">The branch of the drag law that the step is locked to.</param>
    /// <param name="drag">D, 1/s.</param>
    /// <param name="lift">L, 1/s.</param>
    /// <param name="decay">Angular deceleration, rad/s²; at zero spin its limit.</param>
    void Factors(double speedSquared, double spinRate, double acrossSquared, DragBranch region, out double drag, out double lift, out double decay);
}
